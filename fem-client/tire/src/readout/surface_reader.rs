//! Strains of an equilibrium, read off the inner surface.

use fem::load::contact::{ContactResultant, Wrench};
use fem::load::obstacle::HeightField;
use fem::problem::{Loads, State};
use fem::surface::chart::Recovery;
use fem::tensor::Vector;

use crate::model::TireModel;
use crate::readout::probe::{Probe, States};
use crate::readout::{carcass_reading, film_reading};
use fem_client::scene::Scene;
use fem_client::solver::direction::PerDirection;
use fem_client::solver::gauge::{Gauge, GaugeError, GaugeReading};
use fem_client::solver::{
    Grid, Inflated, LocationError, LocationStrain, MapShape, ModelSummary, Position, Readout,
    Response, ResponseError, Ring, RingLine, Section, StrainMap,
};

/// Bound of the exponent n in "reaction proportional to depth^n": 1 for a membrane under pressure, 1.5 for a Hertz sphere.
const DEPTH_EXPONENT: f64 = 1.5;

/// Diagnostics that the state doesn't show: the solver's part of a response, field by field as in [`Response`].
#[derive(Default)]
pub struct Diagnostics {
    /// Largest |J - 1| of an element's mean.
    pub max_volume_change: f64,
    /// Newton iterations of all load steps.
    pub newton_iterations: usize,
    /// Residual norms, one list per load step.
    pub residual_history: Vec<Vec<f64>>,
    /// Model that was solved.
    pub model: ModelSummary,
    /// Friction's force and moment on the meshed part.
    pub friction: Wrench,
}

/// Reads one equilibrium.
pub struct Reader<'m> {
    scene: &'m Scene,
    model: &'m TireModel,
    inflated: Recovery<'m>,
    current: Recovery<'m>,
    inflated_state: &'m State,
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
        let inflated_radius = model.crown_radius(inflated);
        Self {
            scene,
            model,
            inflated: recover(inflated),
            current: recover(equilibrium),
            inflated_state: inflated,
            equilibrium,
            loads,
            inflated_radius,
        }
    }

    /// The response, with what its solver says of the way there.
    pub fn response(&self, readout: &Readout, diagnostics: Diagnostics) -> Response {
        let locations = self.locations();
        let states = [self.inflated_state, self.equilibrium];
        let pressing = self.pressing();
        let whole = self.of_whole_tire([pressing.wrench, diagnostics.friction]);
        Response {
            reaction_n: self.model.multiplicity() * pressing.load,
            force_n: Some(whole.force),
            moment_nmm: Some(whole.moment),
            depth_mm: self.depth(),
            error: self.error(&locations),
            locations,
            section: Section {
                crown: self.strain(0.0, Position::Crown.angle_deg().to_radians()),
                shoulder: self.strain(0.0, Position::Shoulder.angle_deg().to_radians()),
                sidewall: self.strain(0.0, Position::Sidewall.angle_deg().to_radians()),
            },
            inflated: self.inflated_summary(),
            max_volume_change: diagnostics.max_volume_change,
            newton_iterations: diagnostics.newton_iterations,
            residual_history: diagnostics.residual_history,
            model: diagnostics.model,
            map: readout.grid.as_ref().map(|grid| StrainMap {
                shape: readout.shape.then(|| self.shape(grid)),
                position_mm: readout.positions.then(|| self.positions(grid)),
                ..self.map(grid)
            }),
            rings: readout.rings.iter().map(|line| self.ring(line)).collect(),
            gauges: readout
                .gauges
                .iter()
                .map(|&gauge| self.gauge(gauge))
                .collect(),
            films: readout
                .films
                .iter()
                .map(|film| film_reading::following(film, self.model, states))
                .collect(),
            derivatives: Vec::new(),
            carcass: carcass_reading::carcass(self.scene, self.model, self.equilibrium),
            film: film_reading::glued(self.scene, self.model, states),
        }
    }

    /// Returns what presses on the meshed part, without friction.
    fn pressing(&self) -> ContactResultant {
        let (Some(contact), Some(ground)) = (&self.model.problem.contact, &self.loads.ground)
        else {
            return ContactResultant::default();
        };
        let mesh = &self.model.problem.mesh;
        contact.resultant(ground, |node| self.equilibrium.position(mesh, node))
    }

    /// Sum of forces on the meshed part and on its mirror images; what these cancel is nothing.
    fn of_whole_tire(&self, parts: [Wrench; 2]) -> Wrench {
        let all = self.model.multiplicity();
        let extent = self.model.grid.extent;
        let (along, across) = (extent.is_whole_along(), extent.is_whole_across());
        let sum = |part: fn(&Wrench) -> &Vector, is_there: [bool; 3]| {
            let [a, b] = parts.each_ref().map(part);
            [0, 1, 2].map(|i| {
                if is_there[i] {
                    all * (a[i] + b[i])
                } else {
                    0.0
                }
            })
        };
        Wrench {
            force: sum(|part| &part.force, [along, across, true]),
            moment: sum(|part| &part.moment, [across, along, along && across]),
        }
    }

    /// Returns the depth of the ground at the contact centre, mm.
    fn depth(&self) -> f64 {
        let ground = self.loads.ground.as_ref();
        ground.map_or(0.0, HeightField::depth)
    }

    fn locations(&self) -> Vec<LocationStrain> {
        let ground = &self.scene.ground;
        let centre = (ground.stations as f64 - 1.0) / 2.0;
        (0..ground.stations)
            .map(|k| {
                let theta = (k as f64 - centre) * ground.station_spacing_mm / self.inflated_radius;
                let probe = self.probe(theta, 0.0);
                let strain = PerDirection::of(|direction| {
                    probe.estimate(|states| states.signal_in(direction))
                });
                let von_mises = probe.estimate(|states| self.von_mises(states));
                LocationStrain {
                    name: format!("P{}", k + 1),
                    theta_deg: theta.to_degrees(),
                    strain: strain.map(|strain| strain.value),
                    von_mises_mpa: von_mises.value,
                    error: Some(LocationError {
                        strain: strain.map(|strain| strain.error),
                        von_mises_mpa: von_mises.error,
                    }),
                }
            })
            .collect()
    }

    fn gauge(&self, gauge: Gauge) -> GaugeReading {
        let probe = self.probe(gauge.theta_deg.to_radians(), gauge.phi_deg.to_radians());
        // Beyond a symmetry plane of the mesh directions are mirrored.
        let angle = self.mirrored_angle(&gauge);
        let strain = probe.estimate(|states| states.signal(angle));
        let stretch = probe.estimate(|states| states.current.along(angle));
        let green_lagrange = probe.estimate(|states| states.current.green_lagrange_along(angle));
        let von_mises = probe.estimate(|states| self.von_mises(states));
        GaugeReading {
            gauge,
            strain: strain.value,
            stretch: stretch.value,
            green_lagrange: green_lagrange.value,
            von_mises_mpa: von_mises.value,
            error: Some(GaugeError {
                strain: strain.error,
                stretch: stretch.error,
                green_lagrange: green_lagrange.error,
                von_mises_mpa: von_mises.error,
            }),
        }
    }

    /// The gauge's angle in the meshed part, rad.
    fn mirrored_angle(&self, gauge: &Gauge) -> f64 {
        let angle = gauge.angle_deg.to_radians();
        let theta = gauge.theta_deg.to_radians();
        let grid = &self.model.grid;
        let across = grid.is_mirrored_across(gauge.phi_deg);
        if across != grid.is_mirrored(theta) {
            -angle
        } else {
            angle
        }
    }

    fn probe(&self, theta: f64, phi: f64) -> Probe {
        Probe::new(
            &self.current,
            &self.inflated,
            self.model.grid.inner_point(theta, phi),
        )
    }

    /// The inner surface carries only pressure, so the wall's normal is a principal direction there and the in-plane
    /// stretches with det F = 1 give all of the isochoric deformation.
    fn von_mises(&self, states: &States) -> f64 {
        let (l1, l2) = states.current.principal();
        self.model
            .problem
            .solid
            .material
            .von_mises([l1, l2, 1.0 / (l1 * l2)])
    }

    fn error(&self, locations: &[LocationStrain]) -> ResponseError {
        let errors = locations.iter().filter_map(|location| location.error);
        let strain = errors.fold(PerDirection::default(), |largest, error| {
            largest.zip(error.strain).map(|(a, b): (f64, f64)| a.max(b))
        });
        let pressing = self.pressing();
        let reaction = self.model.multiplicity() * pressing.load;
        let depths = self.loads.ground.iter().flat_map(|ground| &ground.depths);
        let depth = depths.copied().fold(0.0, f64::max);
        let by_depth = self.scene.ground.load_n.is_none();
        ResponseError {
            reaction_n: if by_depth && depth > 0.0 {
                DEPTH_EXPONENT * reaction * pressing.mean_penetration / depth
            } else {
                0.0
            },
            strain,
        }
    }

    fn inflated_summary(&self) -> Inflated {
        let stretch = self.inflated.at(self.model.grid.inner_point(0.0, 0.0));
        Inflated {
            outer_radius_mm: self.inflated_radius,
            crown_stretch: [stretch.s1, stretch.s2].into(),
        }
    }

    /// Strains at wheel and section angles, rad.
    fn strain(&self, theta: f64, phi: f64) -> PerDirection<f64> {
        let states = self.states(theta, phi);
        PerDirection::of(|direction| states.signal_in(direction))
    }

    /// Stretches in both states at wheel and section angles, rad.
    fn states(&self, theta: f64, phi: f64) -> States {
        let point = self.model.grid.inner_point(theta, phi);
        States {
            current: self.current.at(point),
            inflated: self.inflated.at(point),
        }
    }

    /// Angles of the columns and of the rows of a map, degrees.
    fn map_lines(&self, grid: &Grid) -> (Vec<f64>, Vec<f64>) {
        let bead = self.scene.geometry.bead_angle_deg;
        let theta_deg = spread(grid.half_width_deg, grid.circumferential);
        (theta_deg, spread(bead, grid.meridional))
    }

    fn map(&self, grid: &Grid) -> StrainMap {
        let (theta_deg, phi_deg) = self.map_lines(grid);
        let points = phi_deg
            .iter()
            .flat_map(|phi| theta_deg.iter().map(move |theta| (theta, phi)));
        let strains = points.map(|(theta, phi)| self.strain(theta.to_radians(), phi.to_radians()));
        StrainMap {
            strain: strains.collect(),
            theta_deg,
            phi_deg,
            shape: None,
            position_mm: None,
        }
    }

    /// Returns the places of a map's points in the equilibrium.
    fn positions(&self, grid: &Grid) -> Vec<f64> {
        let (theta_deg, phi_deg) = self.map_lines(grid);
        let points = phi_deg
            .iter()
            .flat_map(|phi| theta_deg.iter().map(move |theta| (theta, phi)));
        let position = |(theta, phi): (&f64, &f64)| {
            self.position(&self.current, theta.to_radians(), phi.to_radians())
        };
        points.flat_map(position).map(to_picometre).collect()
    }

    fn shape(&self, grid: &Grid) -> MapShape {
        let (theta_deg, phi_deg) = self.map_lines(grid);
        let mut shape = MapShape::default();
        for phi in &phi_deg {
            for theta in &theta_deg {
                let (theta, phi) = (theta.to_radians(), phi.to_radians());
                let inflated = self.position(&self.inflated, theta, phi);
                let current = self.position(&self.current, theta, phi);
                let displacement = [0, 1, 2].map(|i| current[i] - inflated[i]);
                shape.inflated_mm.push(inflated.map(to_picometre));
                shape.displacement_mm.push(displacement.map(to_picometre));
            }
        }
        shape
    }

    /// Position in a state at wheel and section angles (rad), beyond the symmetry planes too.
    fn position(&self, state: &Recovery<'_>, theta: f64, phi: f64) -> Vector {
        let grid = &self.model.grid;
        let [x, y, z] = state.position(grid.inner_point(theta, phi));
        let mirrored = |is_mirrored, value: f64| if is_mirrored { -value } else { value };
        [
            mirrored(grid.is_mirrored(theta), x),
            mirrored(grid.is_mirrored_across(phi), y),
            z,
        ]
    }

    fn ring(&self, line: &RingLine) -> Ring {
        let theta_deg: Vec<f64> = (-180..180).map(f64::from).collect();
        let phi = line.section_deg.to_radians();
        let strains = theta_deg
            .iter()
            .map(|theta| self.strain(theta.to_radians(), phi));
        let turned = |&angle_deg: &f64| {
            let along = |&theta_deg: &f64| {
                let gauge = Gauge {
                    theta_deg,
                    phi_deg: line.section_deg,
                    angle_deg,
                };
                let angle = self.mirrored_angle(&gauge);
                self.states(theta_deg.to_radians(), phi).signal(angle)
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
}

/// Rounds to a picometre, far below the solver's tolerance: the text of a map is shorter by a third of its shape.
fn to_picometre(length_mm: f64) -> f64 {
    (length_mm * 1e9).round() / 1e9
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
