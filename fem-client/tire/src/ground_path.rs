//! The paths to a scene's place on the ground: the inflated tire is pressed, then the ground may be dragged.

use fem::newton::iteration::LargestStep;
use fem::problem::{Loads, State};
use fem_client::scene::{Level, Scene};

use crate::model::{drag_steps, load_step, press_steps};

/// A part of a path.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Leg {
    /// The ground rises.
    Pressing,
    /// The ground that presses moves sideways.
    Dragging,
}

/// A path of the loads, with the equilibrium where it begins.
#[derive(Debug, Clone, Copy)]
pub(crate) struct GroundPath<'w> {
    pub(crate) leg: Leg,
    pub(crate) begin: &'w State,
    pub(crate) start: &'w Loads,
    pub(crate) target: &'w Loads,
}

impl Leg {
    /// Largest load step that friction allows.
    pub(crate) fn friction_step(self, level: Level) -> LargestStep {
        match self {
            Self::Pressing => LargestStep::OfRoot(1.0 / press_steps(level) as f64),
            Self::Dragging => LargestStep::Even(1.0 / drag_steps(level) as f64),
        }
    }

    /// Share of the path that the tire may bear, 1 or less.
    pub(crate) fn bearable(self, scene: &Scene) -> f64 {
        match self {
            Self::Pressing => load_step(scene),
            Self::Dragging => 1.0,
        }
    }

    /// Says what is asked of the ground, in words.
    pub(crate) fn asked(self, scene: &Scene) -> String {
        match (self, scene.ground.load_n) {
            (Self::Dragging, _) => format!("the shift {:?} mm", scene.ground.shift_mm),
            (Self::Pressing, Some(load)) => format!("the load of {load} N"),
            (Self::Pressing, None) => format!("the depths {:?} mm", scene.ground.depths_mm),
        }
    }

    /// Says where a path stopped, in words: after a share of it, at a load (N) where there is one.
    pub(crate) fn stopped(self, scene: &Scene, share: f64, load: Option<f64>) -> String {
        let (asked, percent) = (self.asked(scene), 100.0 * share);
        match (self, load) {
            (Self::Dragging, _) => {
                format!("dragging stopped at {percent:.1} % of the way to {asked}")
            }
            (Self::Pressing, Some(load)) => {
                format!("pressing stopped at {load:.4} N, short of {asked}")
            }
            (Self::Pressing, None) => {
                format!("pressing stopped at {percent:.1} % of the way to {asked}")
            }
        }
    }

    /// Two shares of a path, in words.
    pub(crate) fn between(self, scene: &Scene, shares: [f64; 2]) -> String {
        let asked = self.asked(scene);
        match (self, scene.ground.load_n) {
            (Self::Pressing, Some(load)) => {
                let [from, to] = shares.map(|share| share * load);
                format!("{from:.4} and {to:.4} N, short of {asked}")
            }
            _ => {
                let [from, to] = shares.map(|share| 100.0 * share);
                format!("{from:.1} and {to:.1} % of the way to {asked}")
            }
        }
    }

    /// Says what keeps the tire from touching itself, in words.
    pub(crate) fn remedy(self) -> &'static str {
        match self {
            Self::Pressing => "press less, or inflate more",
            Self::Dragging => "drag or press less, or inflate more",
        }
    }
}
