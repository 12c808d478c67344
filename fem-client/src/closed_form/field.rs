//! The stand-in's strain field.
//!
//! The formulas have the shape of the real answer, not its figures. With theta the angle from the contact centre and
//! phi that from the crown, both in degrees, R the inflated outer radius
//! (which grows by 5 % per MPa) and D = asin(spacing / R) the angle between
//! stations k at theta_k = k D:
//!
//! - effective depth: p(theta) = sum_k d_k exp(-((theta - theta_k)/D)^2 / 2) / sqrt(2 pi), in mm
//! - softness: s = 2 p_0 / (p_0 + pressure) with p_0 = 0.2 MPa, so that s = 1 in the reference tire
//! - meridional strain: 0.09 s p cos(2.5 phi)
//! - displacement of the inner surface, a torus: upward by p (1 + cos phi) / 2
//! - circumferential strain: 0.04 s p (1.5 - p / mm) (1 + cos phi) / 2, which changes sign at p = 1.5 mm
//! - reaction: 13 N (d / mm)^1.3 / s with d the mean depth

use std::f64::consts::PI;

use crate::scene::{Film, Geometry, Scene};
use crate::solver::direction::PerDirection;
use crate::solver::gauge::{Gauge, GaugeReading};
use crate::solver::{
    Choice, FilmMeans, FilmSignal, Grid, Inflated, LocationStrain, MapShape, ModelSummary,
    Response, ResponseError, Ring, RingLine, Section, SolveRequest, StartState, StrainMap,
};

const REFERENCE_PRESSURE_MPA: f64 = 0.2;
/// Relative growth of the outer radius under pressure.
const INFLATION_PER_MPA: f64 = 0.05;
/// Size of the start's trace relative to the answer.
pub(super) const TRACE: f64 = 1e-12;

/// The strain field of one scene.
pub(super) struct Field {
    /// Angle and depth of each station, degrees and mm.
    stations: Vec<(f64, f64)>,
    /// Angle between stations, degrees.
    spacing_deg: f64,
    radius_mm: f64,
    softness: f64,
    /// Factor on the strains: one, up to the trace of the start.
    scale: f64,
}

impl Field {
    pub(super) fn new(scene: &Scene, start: Option<&StartState>) -> Self {
        let radius_mm = scene.geometry.outer_radius_mm
            * (1.0 + INFLATION_PER_MPA * scene.pressure.internal_mpa);
        let spacing_deg = (scene.ground.station_spacing_mm / radius_mm)
            .min(1.0)
            .asin()
            .to_degrees();
        let middle = (scene.ground.stations - 1) as f64 / 2.0;
        let stations = scene
            .ground
            .depths_mm
            .iter()
            .enumerate()
            .map(|(k, depth)| ((k as f64 - middle) * spacing_deg, *depth));
        let softness =
            2.0 * REFERENCE_PRESSURE_MPA / (REFERENCE_PRESSURE_MPA + scene.pressure.internal_mpa);
        let trace = start.map_or(0.0, |start| start.equilibrium.iter().sum::<f64>().tanh());
        Self {
            stations: stations.collect(),
            spacing_deg,
            radius_mm,
            softness,
            scale: 1.0 + TRACE * trace,
        }
    }

    fn effective_depth(&self, theta_deg: f64) -> f64 {
        let share = |centre: f64| {
            (-0.5 * ((theta_deg - centre) / self.spacing_deg).powi(2)).exp() / (2.0 * PI).sqrt()
        };
        self.stations
            .iter()
            .map(|(centre, depth)| depth * share(*centre))
            .sum()
    }

    fn strain(&self, theta_deg: f64, phi_deg: f64) -> PerDirection<f64> {
        let depth = self.effective_depth(theta_deg);
        let phi = phi_deg.to_radians();
        let size = self.scale * self.softness * depth;
        PerDirection {
            x: 0.04 * size * (1.5 - depth) * (1.0 + phi.cos()) / 2.0,
            y: 0.09 * size * (2.5 * phi).cos(),
        }
    }

    pub(super) fn response(
        &self,
        request: &SolveRequest<'_>,
        newton_iterations: usize,
    ) -> Response {
        let mean_depth =
            self.stations.iter().map(|(_, depth)| depth).sum::<f64>() / self.stations.len() as f64;
        Response {
            reaction_n: self.scale * 13.0 * mean_depth.powf(1.3) / self.softness,
            force_n: None,
            moment_nmm: None,
            depth_mm: self.stations[self.stations.len() / 2].1,
            locations: self.locations(),
            section: Section {
                crown: self.strain(0.0, 0.0),
                shoulder: self.strain(0.0, 45.0),
                sidewall: self.strain(0.0, 90.0),
            },
            inflated: Inflated {
                outer_radius_mm: self.radius_mm,
                crown_stretch: PerDirection { x: 1.01, y: 1.02 },
            },
            error: ResponseError {
                reaction_n: 0.0,
                strain: PerDirection::default(),
            },
            max_volume_change: 0.0,
            newton_iterations,
            residual_history: vec![
                (0..newton_iterations as i32)
                    .map(|i| 0.1_f64.powi(i))
                    .collect(),
            ],
            model: model(request.scene),
            map: request.readout.grid.map(|grid| self.map(grid, request)),
            rings: request
                .readout
                .rings
                .iter()
                .map(|line| self.ring(line))
                .collect(),
            gauges: request
                .readout
                .gauges
                .iter()
                .map(|gauge| self.gauge(*gauge))
                .collect(),
            films: request
                .readout
                .films
                .iter()
                .map(|film| self.film(film))
                .collect(),
            carcass: None,
            film: None,
            derivatives: Vec::new(),
        }
    }

    /// The strain tensor turned to the gauge's direction, on a tire that inflation doesn't stretch.
    fn gauge(&self, gauge: Gauge) -> GaugeReading {
        let along = self.strain(gauge.theta_deg, gauge.phi_deg);
        let (sin, cos) = gauge.angle_deg.to_radians().sin_cos();
        let strain = cos * cos * along.x + sin * sin * along.y;
        GaugeReading {
            gauge,
            strain,
            stretch: 1.0 + strain,
            green_lagrange: strain + 0.5 * strain * strain,
            von_mises_mpa: 1.08 * strain.abs(),
            error: None,
        }
    }

    /// A small film that follows the strain at its middle.
    fn film(&self, film: &Film) -> FilmSignal {
        let along = |turn_deg: f64| {
            let gauge = Gauge {
                theta_deg: film.theta_deg,
                phi_deg: film.phi_deg,
                angle_deg: film.angle_deg + turn_deg,
            };
            self.gauge(gauge).strain
        };
        let strain = [along(0.0), along(90.0)];
        let added = [strain[0], strain[1], 0.0];
        let means = FilmMeans {
            area: film.length_mm * film.width_mm,
            strain,
            added,
            total: added,
            ..FilmMeans::default()
        };
        FilmSignal::of(film, &means)
    }

    /// P1 to P5, one station's angle apart.
    fn locations(&self) -> Vec<LocationStrain> {
        let locations = (1..=5_i32).map(|k| {
            let theta_deg = f64::from(k - 3) * self.spacing_deg;
            let strain = self.strain(theta_deg, 0.0);
            let PerDirection { x, y } = strain;
            let energy = x * x + x * y + y * y;
            LocationStrain {
                name: format!("P{k}"),
                theta_deg,
                strain,
                von_mises_mpa: 1.08 * energy.sqrt(),
                error: None,
            }
        });
        locations.collect()
    }

    fn map(&self, grid: Grid, request: &SolveRequest<'_>) -> StrainMap {
        let geometry = &request.scene.geometry;
        let theta_deg = symmetric(grid.circumferential, grid.half_width_deg);
        let phi_deg = symmetric(grid.meridional, geometry.bead_angle_deg);
        let (mut strains, mut shape) = (Vec::new(), MapShape::default());
        for phi in &phi_deg {
            for theta in &theta_deg {
                strains.push(self.strain(*theta, *phi));
                shape
                    .inflated_mm
                    .push(self.inflated(geometry, *theta, *phi));
                shape.displacement_mm.push(self.displacement(*theta, *phi));
            }
        }
        StrainMap {
            strain: strains.into_iter().collect(),
            theta_deg,
            phi_deg,
            position_mm: request.readout.positions.then(|| moved(&shape)),
            shape: request.readout.shape.then_some(shape),
        }
    }

    /// Position in the inflated state, mm.
    fn inflated(&self, geometry: &Geometry, theta_deg: f64, phi_deg: f64) -> [f64; 3] {
        let (sin, cos) = theta_deg.to_radians().sin_cos();
        let (across, up) = phi_deg.to_radians().sin_cos();
        let inner = geometry.section_radius_mm - geometry.wall_mm;
        let radius = self.radius_mm - geometry.section_radius_mm + inner * up;
        [radius * sin, inner * across, -radius * cos]
    }

    /// Displacement from there, mm: upward.
    fn displacement(&self, theta_deg: f64, phi_deg: f64) -> [f64; 3] {
        let share = (1.0 + phi_deg.to_radians().cos()) / 2.0;
        [
            0.0,
            0.0,
            self.scale * self.effective_depth(theta_deg) * share,
        ]
    }

    fn ring(&self, line: &RingLine) -> Ring {
        let theta_deg: Vec<f64> = (-180..180).map(f64::from).collect();
        let strains = theta_deg
            .iter()
            .map(|theta| self.strain(*theta, line.section_deg));
        let turned = |&angle_deg: &f64| {
            let along = |&theta_deg: &f64| {
                let gauge = Gauge {
                    theta_deg,
                    phi_deg: line.section_deg,
                    angle_deg,
                };
                self.gauge(gauge).strain
            };
            theta_deg.iter().map(along).collect()
        };
        Ring {
            section_deg: line.section_deg,
            strain: strains.collect(),
            turned: line.turned_deg.iter().map(turned).collect(),
            theta_deg,
        }
    }

    pub(super) fn state(&self, scene: &Scene) -> StartState {
        StartState {
            inflated_key: "closed-form".to_owned(),
            inflated: vec![self.radius_mm],
            pressure_mpa: scene.pressure.internal_mpa,
            depths_mm: scene.ground.depths_mm.clone(),
            camber_deg: scene.ground.camber_deg,
            equilibrium: self
                .stations
                .iter()
                .map(|(_, depth)| self.scale * depth)
                .collect(),
        }
    }
}

/// Points from `-half` to `half`, both included; one point lies in the middle.
fn symmetric(points: usize, half: f64) -> Vec<f64> {
    let middle = (points.max(1) - 1) as f64 / 2.0;
    (0..points)
        .map(|i| {
            if middle == 0.0 {
                0.0
            } else {
                (i as f64 - middle) / middle * half
            }
        })
        .collect()
}

fn model(scene: &Scene) -> ModelSummary {
    ModelSummary {
        dimension: "closed-form".to_owned(),
        level: scene.model.level.as_str().to_owned(),
        elements: 0,
        dofs: 0,
        modelled: vec![Choice {
            what: "depths and pressure".to_owned(),
            why: "they enter the closed formulas".to_owned(),
            effect: None,
        }],
        left_out: vec![Choice {
            what: "mechanics".to_owned(),
            why: "closed formulas stand in for it in tests".to_owned(),
            effect: Some(1.0),
        }],
    }
}
/// Returns the places to which the points of a shape have moved.
fn moved(shape: &MapShape) -> Vec<f64> {
    let points = shape.inflated_mm.iter().zip(&shape.displacement_mm);
    points
        .flat_map(|(x, u)| [0, 1, 2].map(|i| x[i] + u[i]))
        .collect()
}
