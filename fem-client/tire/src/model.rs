//! A scene as a boundary value problem: what is modelled, and what is left out.

use fem::cell::element::Order;
use fem::cell::mesh::Mesh;
use fem::load::contact::{ContactSurface, Penalty};
use fem::load::friction::Friction;
use fem::load::obstacle::{self, HeightField};
use fem::load::pressure::PressureSurface;
use fem::problem::{Problem, State};
use fem::solid::SolidModel;
use fem::surface::chart::Chart;
use fem::surface::membrane::Membrane;
use fem::surface::surface_law::{FibreFamily, Film, SurfaceLaw};
use fem::tensor::Vector;

use crate::mesh::grid::{Extent, MeshPlan, TireGrid, TireShape};
use crate::omission::omissions;
use crate::rubber::isochoric;
use fem_client::scene::{self, Carcass, Ground, Level, Scene, StationFunctions};
use fem_client::solver::{Choice, ModelSummary};

/// Contact stiffness in units of shear modulus over wall thickness, when the scene doesn't give one. At the reference
/// tire it is 120 N/mm^3: the reaction is then 0.2 % low and the meridional strain at the centre 0.4 %; three times as
/// stiff leaves a third of that and costs a third more iterations.
const PENALTY_FACTOR: f64 = 1000.0;
/// Load steps from the inflated state to the ground's depths under friction. On the reference tire twice as many change
/// the reaction by 0.05 %, the centre's meridional strain by 0.2 % and the circumferential one by 2e-4 at most, for
/// depths up to 2 mm; the error falls with the step.
pub const FRICTION_STEPS: usize = 16;
/// Penetration over which the contact stiffness grows to its full value, relative to the wall.
const PENALTY_RAMP: f64 = 1e-4;

/// A tire scene, ready to be solved.
#[derive(Debug)]
pub struct TireModel {
    /// The boundary value problem.
    pub problem: Problem,
    /// Its grid.
    pub grid: TireGrid,
    /// Chart of the inner surface.
    pub chart: Chart,
}

impl TireModel {
    /// Builds the problem of a scene.
    pub fn new(scene: &Scene, plan: &MeshPlan, extent: Extent) -> Self {
        Self::on_grid(scene, TireGrid::new(shape(scene), plan, extent))
    }

    /// The same on a grid of its shape.
    pub fn on_grid(scene: &Scene, grid: TireGrid) -> Self {
        Self {
            problem: problem(scene, &grid),
            chart: chart(&grid),
            grid,
        }
    }

    /// Factor from the model's forces to the whole tire's.
    pub fn multiplicity(&self) -> f64 {
        match self.grid.extent {
            Extent::Full => 1.0,
            Extent::Half => 2.0,
            Extent::Quarter => 4.0,
        }
    }

    /// Radius of the crown's outer surface at the contact centre in a state without contact, mm.
    pub fn crown_radius(&self, state: &State) -> f64 {
        -state.position(&self.problem.mesh, self.grid.lowest_node())[2]
    }

    /// A flat state fitted to this mesh: its own, or a quarter's, mirrored to the half. `None` for any other length.
    pub fn fit(&self, flat: &[f64]) -> Option<State> {
        State::from_flat(&self.problem, flat)
            .or_else(|| State::from_flat(&self.problem, &self.grid.mirror_quarter(flat)?))
    }

    /// The textile layer, when the scene has one.
    pub fn carcass(&self) -> Option<&Membrane> {
        self.grid.shape.carcass.and(self.problem.membranes.first())
    }

    /// The film, when the scene has one.
    pub fn film(&self) -> Option<&Membrane> {
        let layers = usize::from(self.grid.shape.carcass.is_some());
        self.problem.membranes.get(layers)
    }

    /// What is modelled and what is left out, with reasons.
    pub fn summary(&self, scene: &Scene, dofs: usize) -> ModelSummary {
        let dimension = match self.grid.extent {
            Extent::Full => "3d",
            Extent::Half => "3d-half",
            Extent::Quarter => "3d-quarter",
        };
        ModelSummary {
            dimension: dimension.into(),
            level: scene.model.level.as_str().into(),
            elements: self.problem.mesh.brick_count(),
            dofs,
            modelled: modelled(scene, self.grid.order),
            left_out: left_out(scene, self.grid.extent),
        }
    }
}

/// The boundary value problem of a scene on a grid.
fn problem(scene: &Scene, grid: &TireGrid) -> Problem {
    let (mesh, layout) = grid.mesh();
    let supports = supports(grid, mesh.nodes.len());
    let carcass = scene.carcass.iter();
    let carcass = carcass.filter_map(|carcass| membrane(carcass, grid, &mesh));
    let film = scene.film.iter();
    let film = film.map(|film| film_membrane(film, grid, &mesh));
    let membranes = carcass.chain(film).collect();
    let mut contact = ContactSurface::new(&mesh, grid.tread_surface(), penalty(scene));
    contact.friction = friction(scene);
    let pressure = PressureSurface::new(grid.inner_surface());
    Problem {
        mesh,
        layout,
        solid: solid(scene),
        membranes,
        supports,
        pressure: Some(pressure),
        contact: Some(contact),
        dead_forces: vec![],
    }
}

/// The mesh of a level. The fine sector covers the stations and at least 18 degrees; its bricks keep their size when it
/// grows.
pub fn mesh_plan(scene: &Scene, level: Level) -> MeshPlan {
    const SMALLEST_SECTOR: f64 = 18.0;
    const LARGEST_SECTOR: f64 = 80.0;
    let ground = &scene.ground;
    let half_width = 0.5 * ground.stations as f64 * ground.station_spacing_mm;
    let sector_deg = (half_width / scene.geometry.outer_radius_mm)
        .to_degrees()
        .clamp(SMALLEST_SECTOR, LARGEST_SECTOR);
    let plan = |order, fine: f64, coarse, meridional, meridional_growth, layers| MeshPlan {
        order,
        fine_angle: sector_deg.to_radians(),
        fine: (fine * sector_deg / SMALLEST_SECTOR).ceil() as usize,
        coarse,
        meridional,
        meridional_growth,
        layers,
    };
    match level {
        Level::Draft => plan(Order::Linear, 10.0, 5, 10, 3.0, 2),
        Level::Coarse => plan(Order::Quadratic, 5.0, 3, 8, 4.0, 2),
        Level::Standard => plan(Order::Quadratic, 8.0, 5, 12, 4.0, 3),
        Level::Reference => plan(Order::Quadratic, 10.0, 6, 18, 5.0, 4),
    }
}

/// Dimensions of the uninflated tire of a scene.
pub fn shape(scene: &Scene) -> TireShape {
    let geometry = &scene.geometry;
    let inner = geometry.section_radius_mm - geometry.wall_mm;
    TireShape {
        centre_radius: geometry.outer_radius_mm - geometry.section_radius_mm,
        inner,
        outer: geometry.section_radius_mm,
        bead_angle: geometry.bead_angle_deg.to_radians(),
        carcass: scene
            .carcass
            .as_ref()
            .map(|carcass| inner + carcass.position * geometry.wall_mm),
    }
}

fn solid(scene: &Scene) -> SolidModel {
    SolidModel {
        material: isochoric(&scene.material.law),
        compliance: 0.5 * scene.material.d1_per_mpa,
    }
}

fn penalty(scene: &Scene) -> Penalty {
    let wall = scene.geometry.wall_mm;
    let scaled = PENALTY_FACTOR * scene.material.law.shear_modulus_mpa() / wall;
    Penalty {
        stiffness: scene.contact.penalty_n_per_mm3.unwrap_or(scaled),
        ramp: PENALTY_RAMP * wall,
    }
}

/// Sticking points give as little as pressed ones.
fn friction(scene: &Scene) -> Friction {
    Friction {
        coefficient: scene.contact.friction,
        stiffness: penalty(scene).stiffness,
    }
}

/// Bead clamped, symmetry planes kept plane.
fn supports(grid: &TireGrid, nodes: usize) -> Vec<[Option<f64>; 3]> {
    let mut supports = vec![[None; 3]; nodes];
    let held = grid.held_nodes();
    for node in held.middle_plane {
        supports[node as usize][1] = Some(0.0);
    }
    for node in held.cross_plane {
        supports[node as usize][0] = Some(0.0);
    }
    for node in held.bead {
        supports[node as usize] = [Some(0.0); 3];
    }
    supports
}

/// The unit vector along the circumference, in the rolling direction.
fn circumferential(position: &Vector, _normal: &Vector) -> Vector {
    let radius = position[0].hypot(position[2]);
    [-position[2] / radius, 0.0, position[0] / radius]
}

/// Both cord families, at plus and minus their angle to the circumference.
pub fn cord_families(carcass: &Carcass) -> [FibreFamily; 2] {
    [1.0, -1.0].map(|sign| FibreFamily {
        angle: sign * carcass.angle_deg.to_radians(),
        stiffness: carcass.stiffness_n_per_mm,
        compression_ratio: carcass.compression_ratio,
    })
}

fn membrane(carcass: &Carcass, grid: &TireGrid, mesh: &Mesh) -> Option<Membrane> {
    let laws = cord_families(carcass).map(|family| Box::new(family) as Box<dyn SurfaceLaw>);
    Some(Membrane::new(
        mesh,
        grid.carcass_surface()?,
        &circumferential,
        laws.into(),
    ))
}

/// The film's law.
pub fn film_law(film: &scene::Film) -> Film {
    Film {
        modulus: film.modulus_mpa,
        poisson_ratio: film.poisson_ratio,
        thickness: film.thickness_mm,
    }
}

fn film_membrane(film: &scene::Film, grid: &TireGrid, mesh: &Mesh) -> Membrane {
    let theta = 0.5 * film.length_mm / grid.crown_radius();
    let phi = 0.5 * film.width_mm / grid.shape.inner;
    let (surface, windows) = grid.inner_windows(theta, phi);
    let law: Box<dyn SurfaceLaw> = Box::new(film_law(film));
    Membrane::on_windows(mesh, surface, &windows, &circumferential, vec![law])
}

fn chart(grid: &TireGrid) -> Chart {
    let circumference = std::f64::consts::TAU * grid.crown_radius();
    let mut mirrors = Vec::new();
    if grid.extent != Extent::Full {
        mirrors.push((1, 0.0));
    }
    if grid.extent == Extent::Quarter {
        mirrors.extend([(0, 0.0), (0, 0.5 * circumference)]);
    }
    Chart {
        surface: grid.inner_surface(),
        coordinates: grid.inner_chart(),
        mirrors,
        period: (grid.extent != Extent::Quarter).then_some(circumference),
    }
}

/// The ground of a scene below a tire whose inflated outer radius is given, mm.
pub fn ground(ground: &Ground, inflated_radius: f64) -> HeightField {
    HeightField {
        base: -inflated_radius,
        spacing: ground.station_spacing_mm,
        functions: match ground.station_functions {
            StationFunctions::Bspline => obstacle::StationFunctions::BSpline,
            StationFunctions::Hat => obstacle::StationFunctions::Hat,
        },
        depths: ground.depths_mm.clone(),
    }
}

fn choice(what: &str, why: String) -> Choice {
    Choice {
        what: what.into(),
        why,
        effect: None,
    }
}

fn modelled(scene: &Scene, order: Order) -> Vec<Choice> {
    let element = match order {
        Order::Linear => "8-node bricks with one pressure each (Q1P0)",
        Order::Quadratic => "27-node bricks with a linear pressure each (Q2/P1)",
        Order::PlaneLinear => "4-node quadrilaterals in plane strain with one pressure each (Q1P0)",
        Order::PlaneQuadratic => {
            "9-node quadrilaterals in plane strain with a linear pressure each (Q2/P1)"
        }
    };
    let volume = if scene.material.d1_per_mpa == 0.0 {
        "exactly incompressible, because d1_per_mpa is 0".to_string()
    } else {
        format!(
            "bulk modulus {} MPa from d1_per_mpa",
            2.0 / scene.material.d1_per_mpa
        )
    };
    let mut list = vec![
        choice(
            "wall",
            format!(
                "three-dimensional, {element}: strains across and along the wheel are both asked for"
            ),
        ),
        choice(
            "rubber",
            format!("{}, {volume}", scene.material.law.title()),
        ),
        choice(
            "pressure",
            "live load with its tangent: it follows the deformed inner surface".into(),
        ),
        choice(
            "contact",
            "rigid ground, penalty on the vertical gap".into(),
        ),
    ];
    if scene.contact.friction > 0.0 {
        let why = format!(
            "Coulomb, coefficient {}, pressed from the inflated state in {FRICTION_STEPS} steps: the path matters",
            scene.contact.friction
        );
        list.push(choice("friction", why));
    }
    if let Some(film) = &scene.film {
        list.push(choice(
            "film",
            format!(
                "isotropic membrane in plane stress, {} x {} mm at P3, glued on before inflation",
                film.length_mm, film.width_mm
            ),
        ));
    }
    if scene.carcass.is_some() {
        list.push(choice(
            "carcass",
            "two fibre families as a membrane inside the wall, slack in compression".into(),
        ));
    }
    list
}

fn left_out(scene: &Scene, extent: Extent) -> Vec<Choice> {
    let exact = |what: &str, why: &str| Choice {
        what: what.into(),
        why: why.into(),
        effect: Some(0.0),
    };
    let mut list = Vec::new();
    if extent != Extent::Full {
        list.push(exact(
            "y < 0",
            "tire, ground and loads are symmetric about the wheel's middle plane: exact",
        ));
    }
    if extent == Extent::Quarter {
        list.push(exact(
            "x < 0",
            "the depths are symmetric about the contact centre: exact",
        ));
    }
    let omitted = omissions(scene).into_iter();
    list.extend(omitted.map(|omission| choice(omission.what, omission.why)));
    list
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_reference_tires_meshes_have_the_cells_that_the_contract_says() {
        for (_, level) in Level::NAMES {
            let cells = mesh_plan(&Scene::default(), level).cells();
            assert_eq!(cells, level.cells_of_reference_tire(), "{level:?}");
        }
    }
}
