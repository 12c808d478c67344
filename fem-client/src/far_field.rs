//! The part of the tire far from the contact, condensed: it answers linearly about one state.
//!
//! Between the points of a study the wall far from the contact hardly moves. Taken as linear there, it is condensed once onto
//! the two sections where the near part ends; a point then solves the near part alone, and one substitution gives the far
//! one. Where the far part touches the ground, or the near part finds no equilibrium, the caller solves the whole.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use fem::newton::{Effort, Newton, NewtonSettings};
use fem::path::{PathReport, Stability, follow};
use fem::problem::{Loads, Problem, State};
use fem::substructure::Substructure;
use fem::tangent::Tangent;

use crate::scene::Scene;
use crate::tire::{TireModel, problem};
use crate::tire_sector::{TireSector, near_and_far};

/// How the part of the tire far from the contact is modelled where a point starts from a neighbouring equilibrium.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum FarField {
    /// Like the rest.
    #[default]
    Nonlinear,
    /// Linear beyond a wheel angle, deg, about a state.
    Linear {
        /// The mesh's next section is the border.
        beyond_deg: f64,
        /// Where it is exact.
        about: About,
    },
}

/// The state about which a far field is linear.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum About {
    /// The inflated tire.
    Inflated,
    /// The equilibrium at which points start.
    Start,
}

/// A tire whose far part is condensed.
#[derive(Debug)]
pub(crate) struct Condensed {
    near: TireSector,
    far: TireSector,
    near_problem: Problem,
    far_problem: Problem,
    substructure: Substructure,
    start: State,
    start_loads: Loads,
    tangent: Arc<Tangent>,
    near_nodes: Vec<u32>,
}

/// Equilibria that a condensed tire starts from.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Around<'a> {
    pub(crate) inflated: &'a State,
    pub(crate) equilibrium: &'a State,
    /// Loads of the equilibrium.
    pub(crate) loads: &'a Loads,
    /// The same with the highest ground that points may meet.
    pub(crate) raised: &'a Loads,
}

/// An equilibrium of the whole tire, found without its far part.
pub(crate) struct NearEquilibrium {
    pub(crate) state: State,
    pub(crate) report: PathReport,
    pub(crate) effort: Effort,
}

impl Condensed {
    /// `None` where the far field isn't to be condensed, there is none, or it can't be.
    pub(crate) fn new(
        scene: &Scene,
        model: &TireModel,
        around: Around<'_>,
        far_field: FarField,
    ) -> Option<Self> {
        let FarField::Linear { beyond_deg, about } = far_field else {
            return None;
        };
        let [near, far] = near_and_far(&model.grid, beyond_deg.to_radians())?;
        let about = match about {
            About::Inflated => around.inflated,
            About::Start => around.equilibrium,
        };
        let loads = Loads {
            pressure: around.loads.pressure,
            ..Loads::default()
        };
        let far_problem = problem(scene, &far.grid);
        let shared = far.shared_nodes(&near);
        let substructure = Substructure::new(&far_problem, far.cut(about), &loads, shared).ok()?;
        let near_nodes = near.shared_nodes(&far);
        let near_problem = Problem {
            superelement: Some(substructure.superelement(near_nodes.clone())),
            ..problem(scene, &near.grid)
        };
        let start = near.cut(around.equilibrium);
        let mut newton = Newton::for_contact(&near_problem, &start, around.raised).ok()?;
        let tangent = newton.tangent_at(&start, around.loads).ok()?;
        Some(Self {
            near,
            far,
            far_problem,
            substructure,
            start,
            start_loads: around.loads.clone(),
            tangent,
            near_nodes,
            near_problem,
        })
    }

    /// The whole tire's equilibrium with these loads, linear in its far part; `None` when there is none or the far part
    /// touches the ground.
    pub(crate) fn press(
        &self,
        whole: &State,
        target: &Loads,
        settings: NewtonSettings,
        stop: &AtomicBool,
    ) -> Option<NearEquilibrium> {
        let mut newton = Newton::with_tangent(&self.near_problem, self.tangent.clone()).ok()?;
        newton.settings = settings;
        let mut near = self.start.clone();
        let (start, ignored) = (&self.start_loads, Stability::Ignored);
        let report = follow(&mut newton, &mut near, start, target, ignored, stop).ok()?;
        let shared = self.near_nodes.iter();
        let shared: Vec<_> = shared.map(|&n| near.displacement[n as usize]).collect();
        let far = self.substructure.recover(&self.far_problem, &shared);
        if self.touches(&far, target) {
            return None;
        }
        let mut state = whole.clone();
        self.near.paste(&near, &mut state);
        self.far.paste(&far, &mut state);
        Some(NearEquilibrium {
            state,
            report,
            effort: newton.effort,
        })
    }

    fn touches(&self, far: &State, target: &Loads) -> bool {
        let (Some(contact), Some(ground)) = (&self.far_problem.contact, &target.ground) else {
            return false;
        };
        let position = |node| far.position(&self.far_problem.mesh, node);
        contact.faces_near(ground, position).contains(&true)
    }
}
