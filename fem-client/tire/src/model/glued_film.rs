//! A film of a scene as a sheet glued to its grid.

use std::f64::consts::PI;

use fem::cell::mesh::Mesh;
use fem::surface::sheet::{Elasticity, Outline, Sheet, Underlay};
use fem_client::scene::{Film, Level, Scene};

use crate::mesh::tire_grid::{Extent, Patch, TireGrid, TireShape, turned};

/// Stiffness of the springs that hold a film without glue, in shear moduli of the rubber over the film's shorter side: it slides by 1e-4 of what the rubber under it
/// shears.
const RIGID: f64 = 1e4;
/// Fewest spans across a film.
const FEWEST_SPANS: usize = 4;

/// Place of a film: a rectangle in lengths along the circumference and the section, turned by less than an eighth of a turn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Place {
    /// Wheel and section angle of its middle, rad.
    pub(crate) middle: [f64; 2],
    /// Angle from the rectangle's first side to the circumference, rad, -pi/4 to pi/4.
    turn: f64,
    /// Half of its sides, mm.
    half: [f64; 2],
    /// Whether the film's length is the rectangle's second side.
    pub(crate) is_crosswise: bool,
    /// Lengths that are an angle of one radian, mm: around the wheel and along the section.
    radii: [f64; 2],
}

impl Place {
    pub(crate) fn of(film: &Film, shape: &TireShape) -> Self {
        let quarters = (film.angle_deg / 90.0).round();
        let is_crosswise = quarters.rem_euclid(2.0) == 1.0;
        let [length, width] = [0.5 * film.length_mm, 0.5 * film.width_mm];
        let phi = film.phi_deg.to_radians();
        Self {
            middle: [film.theta_deg.to_radians(), phi],
            turn: (film.angle_deg - 90.0 * quarters).to_radians(),
            half: if is_crosswise {
                [width, length]
            } else {
                [length, width]
            },
            is_crosswise,
            radii: [shape.centre_radius + shape.inner * phi.cos(), shape.inner],
        }
    }

    /// Half of the angles that it covers, rad.
    pub(crate) fn reach(&self) -> [f64; 2] {
        let (sin, cos) = self.turn.sin_cos();
        let [a, b] = self.half;
        [
            (a * cos + b * sin.abs()) / self.radii[0],
            (a * sin.abs() + b * cos) / self.radii[1],
        ]
    }

    /// Largest wheel angle from the contact centre that it covers, rad.
    pub(crate) fn farthest(&self) -> f64 {
        self.middle[0].abs() + self.reach()[0]
    }

    /// Whether its sides run along grid lines.
    pub(crate) fn is_straight(&self) -> bool {
        self.turn == 0.0
    }

    /// Whether it is its own mirror image about the plane x = 0 (`k` 0) or y = 0 (1).
    fn is_symmetric(&self, k: usize) -> bool {
        self.is_straight() && self.middle[k] == 0.0
    }

    /// Whether it lies clear of the middle plane, so that a half tire has it and its mirror image.
    fn is_aside(&self) -> bool {
        self.middle[1].abs() >= self.reach()[1]
    }

    /// The smallest part of the tire on which it can be modelled.
    pub(crate) fn extent(&self) -> Extent {
        let is_alike_across = self.is_symmetric(1) || self.is_aside();
        Extent::of(!(self.is_symmetric(0) && is_alike_across), !is_alike_across)
    }

    /// Whether the model of such a part of the tire has a second film, its mirror image, beyond the middle plane.
    pub(crate) fn has_twin(&self, extent: Extent) -> bool {
        !extent.is_whole_across() && !self.is_symmetric(1)
    }

    /// Wheel and section angles, rad, of a point of the rectangle.
    fn angles(&self, [s1, s2]: [f64; 2]) -> [f64; 2] {
        let (sin, cos) = self.turn.sin_cos();
        [
            self.middle[0] + (s1 * cos - s2 * sin) / self.radii[0],
            self.middle[1] + (s1 * sin + s2 * cos) / self.radii[1],
        ]
    }

    /// Returns the ends around the wheel and along the section, rad, in the part that a mesh of this extent has.
    fn ends(&self, extent: Extent) -> [[f64; 2]; 2] {
        let across = match extent.is_whole_across() {
            true => self.middle[1],
            false => self.middle[1].abs(),
        };
        let (middle, reach) = ([self.middle[0], across], self.reach());
        [0, 1].map(|k| [middle[k] - reach[k], middle[k] + reach[k]])
    }

    /// Returns what the film asks of the grid of a level: lines at its ends, and so many bricks across it.
    pub(crate) fn patch(&self, level: Level, extent: Extent) -> Patch {
        let bricks = match level {
            Level::Draft | Level::Coarse => 2.0,
            Level::Standard | Level::Reference => 4.0,
        };
        Patch {
            ends: self.ends(extent),
            most: self.reach().map(|reach| 2.0 * reach / bricks),
            is_fitted: self.is_straight(),
        }
    }

    /// Returns the outline on a grid, with spans no larger than the faces under it.
    fn outline(&self, grid: &TireGrid) -> Outline {
        let mirror = |k: usize, meshed: bool| (!meshed && self.is_symmetric(k)).then_some(k);
        let ends = self.ends(grid.extent);
        // Smallest faces, mm.
        let mut sizes = [0, 1].map(|k| {
            let edges = [&grid.theta, &grid.phi][k].windows(2);
            let is_under = |edge: &&[f64]| {
                let reaches = |[low, high]: [f64; 2]| edge[1] > low && edge[0] < high;
                turned(ends[k], k).any(reaches)
            };
            let under = edges.filter(is_under).map(|edge| edge[1] - edge[0]);
            self.radii[k] * under.fold(PI, f64::min)
        });
        if !self.is_straight() {
            sizes = [sizes[0].min(sizes[1]); 2];
        }
        Outline {
            half: self.half,
            spans: [0, 1].map(|k| {
                let spans = (self.half[k] / sizes[k] - 1e-9).ceil() as usize;
                (2 * spans).clamp(FEWEST_SPANS, MOST_SPANS)
            }),
            mirrors: [
                mirror(0, grid.extent.is_whole_along()),
                mirror(1, grid.extent.is_whole_across()),
            ],
        }
    }
}

/// Most spans along a side: those of a film around the whole wheel are 9 mm long.
const MOST_SPANS: usize = 32;

/// The film of a scene on its grid; its control points are nodes from the mesh's last on.
pub(crate) fn glued_film(scene: &Scene, grid: &TireGrid, mesh: &Mesh) -> Option<Sheet> {
    let film = scene.film.as_ref()?;
    let laminate = film.laminate();
    let shorter = film.length_mm.min(film.width_mm);
    let elasticity = Elasticity {
        membrane: laminate.membrane,
        bending: laminate.bending,
        glue: match &film.glue {
            Some(glue) => glue.shear_modulus_mpa / glue.thickness_mm,
            None => RIGID * scene.material.law.shear_modulus_mpa() / shorter,
        },
    };
    Some(sheet(film, elasticity, grid, mesh))
}

/// A film that only follows the wall.
pub(crate) fn following_film(film: &Film, grid: &TireGrid, mesh: &Mesh) -> Sheet {
    let elasticity = Elasticity {
        membrane: film.laminate().membrane,
        bending: [[0.0; 3]; 3],
        glue: 0.0,
    };
    sheet(film, elasticity, grid, mesh)
}

fn sheet(film: &Film, elasticity: Elasticity, grid: &TireGrid, mesh: &Mesh) -> Sheet {
    let place = Place::of(film, &grid.shape);
    let surface = grid.inner_surface();
    let under = |s: [f64; 2]| {
        let [theta, phi] = place.angles(s);
        let sign = |is_mirrored| if is_mirrored { -1.0 } else { 1.0 };
        let signs = [
            sign(grid.is_mirrored(theta)),
            sign(grid.is_mirrored_across(phi)),
            1.0,
        ];
        (grid.inner_point(theta, phi), signs)
    };
    let underlay = Underlay {
        mesh,
        surface: &surface,
        place: &under,
    };
    Sheet::new(
        place.outline(grid),
        elasticity,
        underlay,
        mesh.nodes.len() as u32,
    )
}
