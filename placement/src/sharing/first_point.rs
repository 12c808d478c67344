//! Point that a study solves first: its cut point, from nothing.

use fem_client::scene::Scene;
use fem_client::solver::{Readout, Solver};

use crate::estimate::rungs;
use crate::points::{PointReadouts, Starts, keys};
use documents::study::plan::PlannedStudy;

/// Point that is solved from nothing.
#[derive(Debug, Clone, PartialEq)]
pub struct FirstPoint {
    /// Content key.
    pub key: String,
    /// Scene, which is solved.
    pub scene: Scene,
    /// Readout of it.
    pub readout: Readout,
}

impl FirstPoint {
    /// Point that a study solves first; `None` where its first method can't be planned.
    pub fn of(planned: &PlannedStudy, solver: &dyn Solver) -> Option<Self> {
        let study = &planned.study;
        let raised = rungs(study).first()?.raise(study);
        let plan = planned.plan.raised(study, &raised).ok()?;
        let scene = plan.points.first()?.clone();
        let scenes = [scene];
        let asked = study.readout();
        let key = keys(&scenes, &Starts::from_first(1), solver, &asked).next()?;
        let readout = PointReadouts::new(&asked, &scenes).of(0);
        let [scene] = scenes;
        Some(Self {
            key,
            scene,
            readout,
        })
    }
}
