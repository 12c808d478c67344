//! The design points of a study, a pure function of the document.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use document::fault::Fault;
use fem_client::scene::slips::Slip;
use fem_client::scene::{Level, Scene};
use gsa::campaign::Campaign;
use gsa::design::DesignError;
use gsa::law::distribution::Distribution;
use ndarray::ArrayView2;
use serde_json::Value;

use crate::study::Study;

/// The equilibria that a study needs, as far as that is known. Point 0 is the cut point: every input at its mean.
#[derive(Debug, Clone, PartialEq)]
pub struct Plan {
    /// The scene of each point.
    pub points: Vec<Scene>,
    /// Asks for the points and analyses what they answer; its points are the input values, in the same order.
    campaign: Campaign,
}

/// A study with its plan, which a large design takes a second to make.
#[derive(Debug, Clone, PartialEq)]
pub struct PlannedStudy {
    /// The study.
    pub study: Study,
    /// Points of the study.
    pub plan: Plan,
}

impl PlannedStudy {
    /// Plans a study.
    ///
    /// # Errors
    /// As for [`Plan::new`].
    pub fn new(study: Study) -> Result<Self, PlanError> {
        let plan = Plan::new(&study)?;
        Ok(Self { study, plan })
    }
}

/// Most points that are planned for an estimate: each takes a tenth of a millisecond.
const MOST_PLANNED: usize = 1000;

/// A study of which only the cost is asked.
#[derive(Debug, Clone, PartialEq)]
pub enum Estimable {
    /// Study with its plan.
    Planned(PlannedStudy),
    /// Study with a design so large that its points are only counted.
    Counted(Study),
}

impl Estimable {
    /// Whether a study has so many points that an estimate counts them only.
    pub fn is_counted(study: &Study) -> bool {
        study.method.first_points(study.inputs.len()) > MOST_PLANNED
    }
}

/// A study that can't be planned.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum PlanError {
    /// A design that doesn't exist.
    #[error("there is no such design: {0}")]
    Design(#[from] DesignError),
    /// A point's values make a scene that is refused.
    #[error("point {ordinal} of the plan, at {values:?}, is refused: {}", first(.faults))]
    Point {
        /// Number of the point.
        ordinal: usize,
        /// Values of its inputs.
        values: Vec<f64>,
        /// Faults of its scene, at least one.
        faults: Vec<Fault>,
    },
}

fn first(faults: &[Fault]) -> String {
    faults.first().map(Fault::to_string).unwrap_or_default()
}

impl Plan {
    /// Plans a study, an adaptive method's first points only. What is random comes from ChaCha8 seeded by the study, whose
    /// stream is the same on every machine and in every version.
    ///
    /// # Errors
    /// When the design doesn't exist, or a point leaves the ranges of the scene. A study that
    /// [`Study::from_document`] returned has a plan.
    pub fn new(study: &Study) -> Result<Self, PlanError> {
        let laws: Vec<Distribution> = study
            .inputs
            .iter()
            .map(|input| input.distribution)
            .collect();
        let mut plan = Self {
            points: Vec::new(),
            campaign: Campaign::new(&laws, study.method)?,
        };
        plan.add_scenes(study)?;
        Ok(plan)
    }

    /// Tells an adaptive method what all points so far answered (a row each, a column per output that it serves), and whether it asks
    /// for more, which are in the plan then.
    ///
    /// # Errors
    /// When a further point leaves the ranges of the scene.
    ///
    /// # Panics
    /// If there is not one row for each point.
    pub fn extend(&mut self, study: &Study, values: &ArrayView2<f64>) -> Result<bool, PlanError> {
        if !study.method.kind.is_adaptive() {
            return Ok(false);
        }
        let before = self.points.len();
        self.campaign.tell(values)?;
        self.add_scenes(study)?;
        Ok(self.points.len() > before)
    }

    fn add_scenes(&mut self, study: &Study) -> Result<(), PlanError> {
        for (ordinal, values) in self
            .campaign
            .points()
            .iter()
            .enumerate()
            .skip(self.points.len())
        {
            let scene = scene_at(study, values).map_err(|faults| PlanError::Point {
                ordinal,
                values: values.clone(),
                faults,
            })?;
            self.points.push(scene);
        }
        Ok(())
    }

    /// The plan of a study that differs from this plan's own in mesh and method alone; another mesh has the same points.
    ///
    /// # Errors
    /// As for [`Plan::new`].
    pub fn raised(&self, own: &Study, raised: &Study) -> Result<Self, PlanError> {
        if raised.method == own.method {
            Ok(self.on_level(raised.level))
        } else {
            Self::new(raised)
        }
    }

    /// Returns the points on another level of the mesh.
    #[must_use]
    pub fn on_level(&self, level: Level) -> Self {
        let mut plan = self.clone();
        for scene in &mut plan.points {
            scene.model.level = level;
        }
        plan
    }

    /// Returns the unlikely values of the scene at the means, and of the films that the study reads on it.
    pub fn slips(&self, study: &Study) -> Vec<Slip> {
        let own = self.points.first().map_or_else(Vec::new, Scene::slips);
        let signals = study.signals.iter();
        let films = signals.flat_map(|signals| signals.film.slips("signals.film"));
        own.into_iter().chain(films).collect()
    }

    /// The input values of each point.
    pub fn values(&self) -> &[Vec<f64>] {
        self.campaign.points()
    }

    /// Returns the campaign that asks for the points and analyses them.
    pub fn campaign(&self) -> &Campaign {
        &self.campaign
    }
}

/// The study's scene with values put in for the inputs.
///
/// # Errors
/// Every fault of that scene.
pub fn scene_at(study: &Study, values: &[f64]) -> Result<Scene, Vec<Fault>> {
    let values: Vec<Value> = values.iter().map(|x| Value::from(*x)).collect();
    let paths = study.inputs.iter().map(|input| input.vary.as_str());
    let changes: Vec<(&str, &Value)> = paths.zip(&values).collect();
    let mut scene = study.scene.clone();
    scene.set_all(&changes)?;
    Ok(scene)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::presets;
    use document::Format;
    use gsa::method::{Kind, Method};

    fn study() -> Study {
        Study::from_document(presets()[0].1, Format::Toml, &|path| Err(path.to_owned())).unwrap()
    }

    #[test]
    fn the_cut_point_comes_first_and_the_count_is_the_method_s() {
        let plan = Plan::new(&study()).unwrap();
        assert_eq!(plan.points[0].ground.depths_mm, [1.0; 5]);
        // 5 inputs x 4 nodes beside the shared centre, the centre, 5 check points.
        assert_eq!((plan.points.len(), plan.values().len()), (26, 26));
        for (scene, values) in plan.points.iter().zip(plan.values()) {
            assert_eq!(&scene.ground.depths_mm, values);
        }
    }

    #[test]
    fn no_method_asks_for_more_points_at_first_than_it_is_said_to() {
        for kind in Kind::ALL {
            for nodes in [1, 3, 4] {
                let mut study = study();
                study.inputs.truncate(3);
                study.method = Method {
                    nodes,
                    samples: 20,
                    ..Method::of(kind)
                };
                let Ok(plan) = Plan::new(&study) else {
                    continue;
                };
                let most = study.method.first_points(3);
                let planned = plan.points.len();
                assert!(
                    (planned..=2 * planned + 20).contains(&most),
                    "{kind:?}: {planned}, {most}"
                );
            }
        }
    }

    #[test]
    fn the_plan_is_a_function_of_the_study() {
        assert_eq!(Plan::new(&study()).unwrap(), Plan::new(&study()).unwrap());
        let mut other = study();
        other.method.seed = 2;
        assert_ne!(Plan::new(&other).unwrap(), Plan::new(&study()).unwrap());
    }

    #[test]
    fn a_point_out_of_range_is_named() {
        let mut study = study();
        study.inputs[2].distribution = Distribution::normal(1.0, 1.0).unwrap();
        let PlanError::Point {
            ordinal,
            values,
            faults,
        } = Plan::new(&study).unwrap_err()
        else {
            panic!("a depth below zero must be refused");
        };
        assert!(ordinal > 0 && values[2] < 0.0);
        assert_eq!(faults[0].pointer, "/ground/depths_mm/2");
    }
}
