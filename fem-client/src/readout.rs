//! Strains of an equilibrium, read off the inner surface.

use fem::mesh::SurfacePoint;
use fem::problem::{Loads, State};
use fem::surface::{Recovery, Stretch};

use crate::scene::Scene;
use crate::solver::{
    Grid, Inflated, LocationStrain, ModelSummary, Position, Readout, Response, ResponseError, Ring,
    Section, StrainMap, StrainPair,
};
use crate::tire::TireModel;

/// Bound of the exponent n in "reaction proportional to depth^n": 1 for a membrane under pressure, 1.5 for a Hertz sphere.
const DEPTH_EXPONENT: f64 = 1.5;

/// Reads one equilibrium.
pub struct Reader<'m> {
    scene: &'m Scene,
    model: &'m TireModel,
    inflated: Recovery<'m>,
    current: Recovery<'m>,
    equilibrium: &'m State,
    loads: &'m Loads,
    inflated_radius: f64,
}

impl<'m> Reader<'m> {
    /// Recovers the stretches of the inflated state and of the equilibrium.
    pub fn new(
        scene: &'m Scene,
        model: &'m TireModel,
        inflated: &'m State,
        equilibrium: &'m State,
        loads: &'m Loads,
    ) -> Self {
        let mesh = &model.problem.mesh;
        let recover =
            |state: &'m State| Recovery::new(&model.chart, mesh, |node| state.position(mesh, node));
        let inflated_radius = -inflated.position(mesh, model.grid.lowest_node())[2];
        Self {
            scene,
            model,
            inflated: recover(inflated),
            current: recover(equilibrium),
            equilibrium,
            loads,
            inflated_radius,
        }
    }

    /// The response without its solver diagnostics, which the caller fills in.
    pub fn response(&self, readout: &Readout) -> Response {
        let locations = self.locations();
        Response {
            reaction_n: self.reaction().0,
            error: self.error(&locations),
            locations,
            section: Section {
                crown: self.pair(0.0, Position::Crown.angle_deg().to_radians()),
                shoulder: self.pair(0.0, Position::Shoulder.angle_deg().to_radians()),
                sidewall: self.pair(0.0, Position::Sidewall.angle_deg().to_radians()),
            },
            inflated: self.inflated_summary(),
            max_volume_change: 0.0,
            newton_iterations: 0,
            residual_history: Vec::new(),
            model: ModelSummary::default(),
            map: readout.grid.as_ref().map(|grid| self.map(grid)),
            rings: readout
                .rings
                .iter()
                .map(|&position| self.ring(position))
                .collect(),
        }
    }

    /// Vertical force on the whole tire and the pressure-weighted mean penetration.
    fn reaction(&self) -> (f64, f64) {
        let (Some(contact), Some(ground)) = (&self.model.problem.contact, &self.loads.ground)
        else {
            return (0.0, 0.0);
        };
        let mesh = &self.model.problem.mesh;
        let resultant = contact.resultant(ground, |node| self.equilibrium.position(mesh, node));
        (
            self.model.multiplicity() * resultant.force[2],
            resultant.mean_penetration,
        )
    }

    fn locations(&self) -> Vec<LocationStrain> {
        let ground = &self.scene.ground;
        let centre = (ground.stations as f64 - 1.0) / 2.0;
        (0..ground.stations)
            .map(|k| {
                let theta = (k as f64 - centre) * ground.station_spacing_mm / self.inflated_radius;
                let pair = self.pair(theta, 0.0);
                LocationStrain {
                    name: format!("P{}", k + 1),
                    theta_deg: theta.to_degrees(),
                    strain_x: pair.strain_x,
                    strain_y: pair.strain_y,
                    von_mises_mpa: self.von_mises(self.model.grid.inner_point(theta, 0.0)),
                }
            })
            .collect()
    }

    /// The inner surface carries only pressure, so the wall's normal is a principal direction there and the in-plane
    /// stretches with det F = 1 give all of the isochoric deformation.
    fn von_mises(&self, point: SurfacePoint) -> f64 {
        let (l1, l2) = self.current.at(point).principal();
        self.model
            .problem
            .solid
            .material
            .von_mises([l1, l2, 1.0 / (l1 * l2)])
    }

    fn error(&self, locations: &[LocationStrain]) -> ResponseError {
        let raw = |theta_deg: f64| {
            let point = self.model.grid.inner_point(theta_deg.to_radians(), 0.0);
            relative(self.current.raw_at(point), self.inflated.raw_at(point))
        };
        let largest = |difference: &dyn Fn(&LocationStrain) -> f64| {
            locations.iter().map(difference).fold(0.0, f64::max)
        };
        let (reaction, penetration) = self.reaction();
        let depth = self
            .scene
            .ground
            .depths_mm
            .iter()
            .copied()
            .fold(0.0, f64::max);
        ResponseError {
            reaction_n: if depth > 0.0 {
                DEPTH_EXPONENT * reaction * penetration / depth
            } else {
                0.0
            },
            strain_x: largest(&|l| (l.strain_x - raw(l.theta_deg).strain_x).abs()),
            strain_y: largest(&|l| (l.strain_y - raw(l.theta_deg).strain_y).abs()),
        }
    }

    fn inflated_summary(&self) -> Inflated {
        let stretch = self.inflated.at(self.model.grid.inner_point(0.0, 0.0));
        Inflated {
            outer_radius_mm: self.inflated_radius,
            crown_stretch_x: stretch.s1,
            crown_stretch_y: stretch.s2,
        }
    }

    /// Strains at wheel and section angles, rad.
    fn pair(&self, theta: f64, phi: f64) -> StrainPair {
        let point = self.model.grid.inner_point(theta, phi);
        relative(self.current.at(point), self.inflated.at(point))
    }

    fn map(&self, grid: &Grid) -> StrainMap {
        let bead = self.scene.geometry.bead_angle_deg;
        let theta_deg = spread(grid.half_width_deg, grid.circumferential);
        let phi_deg = spread(bead, grid.meridional);
        let (mut strain_x, mut strain_y) = (Vec::new(), Vec::new());
        for phi in &phi_deg {
            for theta in &theta_deg {
                let pair = self.pair(theta.to_radians(), phi.to_radians());
                strain_x.push(pair.strain_x);
                strain_y.push(pair.strain_y);
            }
        }
        StrainMap {
            theta_deg,
            phi_deg,
            strain_x,
            strain_y,
        }
    }

    fn ring(&self, position: Position) -> Ring {
        let theta_deg: Vec<f64> = (-180..180).map(f64::from).collect();
        let phi = position.angle_deg().to_radians();
        let pairs: Vec<StrainPair> = theta_deg
            .iter()
            .map(|theta| self.pair(theta.to_radians(), phi))
            .collect();
        Ring {
            position,
            theta_deg,
            strain_x: pairs.iter().map(|pair| pair.strain_x).collect(),
            strain_y: pairs.iter().map(|pair| pair.strain_y).collect(),
        }
    }
}

/// What a film glued on in the inflated state feels.
fn relative(current: Stretch, inflated: Stretch) -> StrainPair {
    StrainPair {
        strain_x: current.s1 / inflated.s1 - 1.0,
        strain_y: current.s2 / inflated.s2 - 1.0,
    }
}

/// `n` angles from -half to half, exactly symmetric.
fn spread(half: f64, n: usize) -> Vec<f64> {
    let middle = (n as f64 - 1.0) / 2.0;
    (0..n)
        .map(|i| {
            if n == 1 {
                0.0
            } else {
                half * (i as f64 - middle) / middle
            }
        })
        .collect()
}
