//! Parts of the points of a large study.
//!
//! Points start from the equilibrium of their cut point, so whoever has that finds the same answers to the bit. Of two mirrored grounds only one is solved: both are in one part, one
//! behind the other.

use std::collections::BTreeMap;

use documents::study::plan::{Plan, PlannedStudy};
use documents::study::{Accuracy, Study};
use fem_client::scene::Scene;
use fem_client::solver::{Readout, Solver};
use serde::{Deserialize, Serialize};

use crate::points::{
    Place, PointReadouts, PointSeries, RunContext, RunError, Starts, answers_of_all, keys,
    mirror_key,
};

/// Points that a study has to lack to be worth another machine: each takes a tenth of what their cut point does, which every machine reads.
pub const LARGE: usize = 500;
/// Points of the smallest part.
pub const SMALLEST: usize = 100;

/// Some of the points of a study, on both its meshes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct Part {
    /// Number of the part, from 1.
    pub number: usize,
    /// Number of parts in all.
    pub of: usize,
}

/// Point of a part.
#[derive(Debug, Clone, PartialEq)]
pub struct PartPoint {
    /// Content key.
    pub key: String,
    /// Content key of the cut point that it starts from.
    pub cut: String,
    /// Scene, which is solved.
    pub scene: Scene,
    /// Readout of it.
    pub readout: Readout,
}

/// Whether a study's points follow from its document alone, whatever some of them answer.
pub fn is_shareable(study: &Study) -> bool {
    matches!(study.accuracy, Accuracy::Preset) && !study.method.kind.is_adaptive()
}

/// Cut point on a mesh, and points that start from it.
struct Series {
    scenes: Vec<Scene>,
    values: Vec<Vec<f64>>,
}

impl Part {
    /// Solves the points that the archive lacks, after the cut points where these lack, too.
    ///
    /// # Errors
    /// See [`RunError`].
    pub fn solve(self, planned: &PlannedStudy, context: RunContext<'_>) -> Result<(), RunError> {
        solve(&self.series(planned, context.solver), planned, context)
    }

    /// Solves the cut points alone.
    ///
    /// # Errors
    /// See [`RunError`].
    pub fn solve_cut_points(
        planned: &PlannedStudy,
        context: RunContext<'_>,
    ) -> Result<(), RunError> {
        let cut = |plan: Plan| Series::of(&plan, &[]);
        let series: Vec<Series> = meshes(planned, context.solver).map(cut).collect();
        solve(&series, planned, context)
    }

    /// Lists its points, without the cut points.
    pub fn points(self, planned: &PlannedStudy, solver: &dyn Solver) -> Vec<PartPoint> {
        let readout = planned.study.readout();
        let all = self.series(planned, solver).into_iter();
        all.flat_map(|series| series.points(&readout, solver))
            .collect()
    }

    fn series(self, planned: &PlannedStudy, solver: &dyn Solver) -> Vec<Series> {
        let chosen = self.ordinals(&planned.plan);
        let of_part = |plan: Plan| Series::of(&plan, &chosen);
        meshes(planned, solver).map(of_part).collect()
    }

    /// Ordinals of its points in the plan: mirrored grounds together, parts as large as each other.
    fn ordinals(self, plan: &Plan) -> Vec<usize> {
        let mut classes: BTreeMap<(String, Vec<u64>), Vec<usize>> = BTreeMap::new();
        for (ordinal, scene) in plan.points.iter().enumerate().skip(1) {
            classes.entry(mirror_key(scene)).or_default().push(ordinal);
        }
        let mut classes: Vec<Vec<usize>> = classes.into_values().collect();
        classes.sort();
        let bound = |number: usize| number * classes.len() / self.of;
        classes[bound(self.number - 1)..bound(self.number)].concat()
    }
}

/// The plan on each mesh of the study.
fn meshes(planned: &PlannedStudy, solver: &dyn Solver) -> impl Iterator<Item = Plan> {
    let plan = &planned.plan;
    let coarser = solver.coarser(&planned.study.scene);
    let coarser = coarser.map(|coarser| plan.on_level(coarser.level));
    std::iter::once(plan.clone()).chain(coarser)
}

fn solve(
    series: &[Series],
    planned: &PlannedStudy,
    context: RunContext<'_>,
) -> Result<(), RunError> {
    let readout = planned.study.readout();
    let asked: Vec<PointSeries<'_>> = series
        .iter()
        .map(|series| PointSeries {
            scenes: &series.scenes,
            starts: Starts::from_first(series.scenes.len()),
            values: &series.values,
            readout: &readout,
        })
        .collect();
    let of = series.iter().map(|series| series.scenes.len()).sum();
    let mut answers = answers_of_all(&asked, Place { first: 0, of }, context)?;
    // What fails on the coarser mesh costs an error, not the study.
    answers.swap_remove(0).map(drop)
}

impl Series {
    fn of(plan: &Plan, chosen: &[usize]) -> Self {
        let ordinals = || std::iter::once(0).chain(chosen.iter().copied());
        Self {
            scenes: ordinals()
                .map(|ordinal| plan.points[ordinal].clone())
                .collect(),
            values: ordinals()
                .map(|ordinal| plan.values()[ordinal].clone())
                .collect(),
        }
    }

    fn points(self, readout: &Readout, solver: &dyn Solver) -> Vec<PartPoint> {
        let starts = Starts::from_first(self.scenes.len());
        let keys: Vec<String> = keys(&self.scenes, &starts, solver, readout).collect();
        let readouts = PointReadouts::new(readout, &self.scenes);
        let point = |ordinal: usize| PartPoint {
            key: keys[ordinal].clone(),
            cut: keys[0].clone(),
            scene: self.scenes[ordinal].clone(),
            readout: readouts.of(ordinal),
        };
        (1..self.scenes.len()).map(point).collect()
    }
}

#[cfg(test)]
mod tests {
    use document::Format;

    use super::*;

    fn tensor() -> PlannedStudy {
        let text = documents::study::presets()[0].1;
        let mut study =
            Study::from_document(text, Format::Toml, &|path| Err(path.to_owned())).unwrap();
        study.method.kind = gsa::method::Kind::Tensor;
        study.method.nodes = 3;
        PlannedStudy::new(study).unwrap()
    }

    #[test]
    fn every_point_is_in_one_part_beside_its_mirror_image() {
        let planned = tensor();
        let all = planned.plan.points.len();
        assert!(
            is_shareable(&planned.study) && all >= 3_usize.pow(5),
            "{all}"
        );
        let parts = (1..=7).map(|number| Part { number, of: 7 }.ordinals(&planned.plan));
        let parts: Vec<Vec<usize>> = parts.collect();
        let mut sorted = parts.concat();
        sorted.sort_unstable();
        assert_eq!(sorted, (1..all).collect::<Vec<_>>());
        for part in &parts {
            // Each has as many classes, of one point or two.
            assert!(
                (all / 14..=2 * all / 7).contains(&part.len()),
                "{}",
                part.len()
            );
            for ordinal in part {
                let mut image = planned.plan.points[*ordinal].clone();
                image.ground.depths_mm.reverse();
                let image = planned.plan.points.iter().position(|scene| *scene == image);
                assert!(image.is_none_or(|image| image == 0 || part.contains(&image)));
            }
        }
    }
}
