//! A boundary value problem, its loads and its state.

use crate::cell::mesh::{Mesh, Surface};
use crate::load::contact::ContactSurface;
use crate::load::obstacle::{GroundAxes, HeightField};
use crate::load::pressure::PressureSurface;
use crate::solid::SolidModel;
use crate::surface::membrane::Membrane;
use crate::surface::sheet::Sheet;
use crate::tensor::Vector;

/// Problem: a body, how it is held, and where it can be loaded.
#[derive(Debug)]
pub struct Problem {
    /// The solid's mesh.
    pub mesh: Mesh,
    /// Position of each brick in a chart where the mesh is regular, in bricks; guides the elimination order.
    pub layout: Vec<[f64; 3]>,
    /// Law of the solid.
    pub solid: SolidModel,
    /// Reinforcement.
    pub membranes: Vec<Membrane>,
    /// A sheet glued on; its control points are the mesh's last nodes.
    pub sheet: Option<Sheet>,
    /// Held displacements per node and axis, at support factor 1; `None` is free.
    pub supports: Vec<[Option<f64>; 3]>,
    /// Surface under live pressure.
    pub pressure: Option<PressureSurface>,
    /// Surface that may touch the ground.
    pub contact: Option<ContactSurface>,
    /// Dead forces on nodes at traction factor 1, N: they keep their direction as the body moves.
    pub dead_forces: Vec<(u32, Vector)>,
}

impl Problem {
    /// Whether another problem has the same elements, held alike: states of one are states of the other.
    pub fn has_elements_of(&self, other: &Self) -> bool {
        let net = |problem: &Self| problem.sheet.as_ref().map(|s| s.outline.control_points());
        self.mesh.nodes.len() == other.mesh.nodes.len()
            && self.mesh.bricks == other.mesh.bricks
            && self.layout == other.layout
            && self.supports == other.supports
            && self.surfaces().eq(other.surfaces())
            && net(self) == net(other)
    }

    /// Surfaces under pressure and over the ground, then those of the membranes.
    fn surfaces(&self) -> impl Iterator<Item = Option<&Surface>> {
        let pressure = self.pressure.as_ref().map(|pressure| &pressure.surface);
        let contact = self.contact.as_ref().map(|contact| &contact.surface);
        let membranes = self.membranes.iter();
        let carried = membranes.map(|membrane| Some(&membrane.surface));
        [pressure, contact].into_iter().chain(carried)
    }
}

/// Loads of a problem.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Loads {
    /// Pressure on the pressure surface, MPa.
    pub pressure: f64,
    /// Ground below the contact surface; `None` is no ground.
    pub ground: Option<HeightField>,
    /// Force along its z axis with which the ground presses, N: it rises until it does ([`State::rise`]). `None`: it stands at its own height.
    pub ground_force: Option<f64>,
    /// Factor of the held displacements.
    pub support_factor: f64,
    /// Factor of the dead forces.
    pub traction_factor: f64,
}

impl Loads {
    /// Loads at the fraction `t` of the way to `target`. The ground is the target's, with the depths on their way from
    /// this one's, or from where the profile's crests touch where there is none yet, leaning and dragged as far as it is on its way there.
    pub fn towards(&self, target: &Self, t: f64) -> Self {
        let mix = |a: f64, b: f64| if t >= 1.0 { b } else { a + t * (b - a) };
        let ground = target.ground.as_ref().map(|ground| {
            let start = self.ground.as_ref();
            let start_depths = start.map(|g| g.depths.as_slice()).unwrap_or_default();
            let start_shift = start.map_or([0.0; 2], |g| g.shift);
            let untouched = 0.0 - ground.profile.crest();
            let depths = ground
                .depths
                .iter()
                .enumerate()
                .map(|(k, &depth)| mix(start_depths.get(k).copied().unwrap_or(untouched), depth))
                .collect();
            let (axes, base) = match start {
                Some(start) if start.axes != ground.axes => (
                    GroundAxes::below(mix(start.axes.angle, ground.axes.angle)),
                    mix(start.base, ground.base),
                ),
                _ => (ground.axes, ground.base),
            };
            HeightField {
                axes,
                base,
                depths,
                shift: [0, 1].map(|i| mix(start_shift[i], ground.shift[i])),
                ..ground.clone()
            }
        });
        Self {
            pressure: mix(self.pressure, target.pressure),
            ground,
            ground_force: target
                .ground_force
                .map(|force| mix(self.ground_force.unwrap_or(0.0), force)),
            support_factor: mix(self.support_factor, target.support_factor),
            traction_factor: mix(self.traction_factor, target.traction_factor),
        }
    }
}

impl Loads {
    /// Returns these loads with other depths (mm) of the ground, where there is one.
    pub fn with_depths(&self, depths: &[f64]) -> Self {
        let ground = self.ground.as_ref().map(|ground| HeightField {
            depths: depths.to_vec(),
            ..ground.clone()
        });
        Self {
            ground,
            ..self.clone()
        }
    }

    /// Returns these loads with the ground, where there is one, dragged by other ways along x and y, mm.
    pub fn with_shift(&self, shift: [f64; 2]) -> Self {
        let ground = self.ground.as_ref().map(|ground| HeightField {
            shift,
            ..ground.clone()
        });
        Self {
            ground,
            ..self.clone()
        }
    }

    /// The ground where it stands in a state.
    pub fn ground_in(&self, state: &State) -> Option<HeightField> {
        let ground = self.ground.as_ref()?;
        Some(HeightField {
            base: ground.base + state.rise,
            ..ground.clone()
        })
    }
}

/// Unknowns of a problem.
#[derive(Debug, PartialEq)]
pub struct State {
    /// Nodal displacements, mm.
    pub displacement: Vec<Vector>,
    /// Pressure unknowns of the bricks, one brick after the other, MPa.
    pub pressure: Vec<f64>,
    /// Anchors of friction, in coordinates of the ground, mm: contact face, point; none before a path with friction begins.
    pub anchors: Vec<[f64; 2]>,
    /// Rise of the ground above its own height along its z axis, mm: an unknown where it presses with a force, else 0.
    pub rise: f64,
}

impl Clone for State {
    fn clone(&self) -> Self {
        Self {
            displacement: self.displacement.clone(),
            pressure: self.pressure.clone(),
            anchors: self.anchors.clone(),
            rise: self.rise,
        }
    }

    // Copies into the memory that is there: states are copied in every Newton iteration.
    fn clone_from(&mut self, source: &Self) {
        self.displacement.clone_from(&source.displacement);
        self.pressure.clone_from(&source.pressure);
        self.anchors.clone_from(&source.anchors);
        self.rise = source.rise;
    }
}

impl State {
    /// The undeformed state.
    pub fn reference(problem: &Problem) -> Self {
        Self {
            displacement: vec![[0.0; 3]; problem.mesh.nodes.len()],
            pressure: vec![0.0; problem.mesh.brick_count() * problem.mesh.order.pressure_modes()],
            anchors: Vec::new(),
            rise: 0.0,
        }
    }

    /// Current position of a node, mm.
    pub fn position(&self, mesh: &Mesh, node: u32) -> Vector {
        let (x, u) = (
            &mesh.nodes[node as usize],
            &self.displacement[node as usize],
        );
        [x[0] + u[0], x[1] + u[1], x[2] + u[2]]
    }

    /// Lets friction's anchors follow to where they stand in this equilibrium.
    pub fn settle(&mut self, problem: &Problem, ground: Option<&HeightField>) {
        if let Some(contact) = &problem.contact {
            let position = |node| self.position(&problem.mesh, node);
            self.anchors = contact.settled_anchors(ground, position, &self.anchors);
        }
    }

    /// Adds `factor` times these increments of displacements (mm) and pressures (MPa).
    pub fn add(&mut self, factor: f64, displacement: &[Vector], pressure: &[f64]) {
        let own = self.displacement.as_flattened_mut().iter_mut();
        for (u, du) in own.zip(displacement.as_flattened()) {
            *u += factor * du;
        }
        for (p, dp) in self.pressure.iter_mut().zip(pressure) {
            *p += factor * dp;
        }
    }

    /// All unknowns of the body in one list: displacements (mm), then pressures (MPa). Friction's anchors are no unknowns, and where the ground stands
    /// can be said by its own height.
    pub fn to_flat(&self) -> Vec<f64> {
        self.displacement
            .iter()
            .flatten()
            .chain(&self.pressure)
            .copied()
            .collect()
    }

    /// Reads what [`State::to_flat`] wrote; `None` when the length doesn't fit the problem.
    pub fn from_flat(problem: &Problem, flat: &[f64]) -> Option<Self> {
        let mut state = Self::reference(problem);
        let displacements = 3 * state.displacement.len();
        if flat.len() != displacements + state.pressure.len() {
            return None;
        }
        let (displacement, pressure) = flat.split_at(displacements);
        for (u, values) in state
            .displacement
            .iter_mut()
            .zip(displacement.chunks_exact(3))
        {
            u.copy_from_slice(values);
        }
        state.pressure.copy_from_slice(pressure);
        Some(state)
    }
}
