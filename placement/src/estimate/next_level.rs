//! Next mesh level: what it would bring a study, and what it would cost.

use fem_client::scene::{Level, Scene};
use fem_client::solver::Solver;

use super::estimated_cost::estimate;
use super::solve_time::Machine;
use super::workload::Workload;
use crate::ladder::fidelity::Fidelity;
use documents::study::plan::{Estimable, PlanError, PlannedStudy};
use documents::study::{Accuracy, Study};
use results::Surer;

/// A mesh's error falls as the size of its cells to this power (`tire::mesh_error`), their number to a third of it.
const ORDER: f64 = 2.0;

/// A study on the next level.
#[derive(Debug, Clone, PartialEq)]
pub struct NextLevel {
    /// Study that asks for that level.
    pub study: Study,
    /// Level of the answer.
    answered: Level,
    /// Share of the claimed error of the mesh that it leaves; `None` where that level claims none, as the draft does.
    leaves: Option<f64>,
    /// Work over that of the study with nothing solved before.
    times: Option<f64>,
    /// Whether layouts are asked for that stay on their mesh.
    keeps_layouts: bool,
}

impl NextLevel {
    /// Plans the next level of a study that was answered on a level; `None` at the top of the ladder.
    ///
    /// # Errors
    /// When the study can't be planned on that level.
    pub fn of(
        study: &Study,
        answered: Level,
        solver: &dyn Solver,
    ) -> Result<Option<Self>, PlanError> {
        let levels = Level::ALL.into_iter();
        let Some(next) = levels.filter(|level| *level > answered).min() else {
            return Ok(None);
        };
        let [own, raised] = [answered, next].map(|level| {
            let fidelity = Fidelity::of(study);
            Study {
                accuracy: Accuracy::Preset,
                ..Fidelity { level, ..fidelity }.raise(study)
            }
        });
        let claims = [&own, &raised].map(|study| claimed(&study.scene, solver));
        let (took, takes) = (work_s(&own, solver)?, work_s(&raised, solver)?);
        let layout_levels = [answered, next].map(|level| study.layouts.level_on(level));
        Ok(Some(Self {
            study: raised,
            answered,
            leaves: claims[0]
                .zip(claims[1])
                .map(|(before, after)| after / before),
            times: took.zip(takes).map(|(took, takes)| takes / took),
            keeps_layouts: study.layouts.is_asked() && layout_levels[0] == layout_levels[1],
        }))
    }

    /// Returns it as it stands in an answer, where it is expected to take so long, s.
    pub fn surer(&self, expected_s: Option<f64>) -> Surer {
        let level = self.study.level.as_str();
        let brings = match self.leaves {
            Some(share) => format!(
                "would leave some {:.0} % of the mesh's claimed error in the indices",
                100.0 * share
            ),
            None if self.answered == Level::Draft => {
                "would say how far the figures are off, which the draft doesn't know".to_owned()
            }
            None => "is finer, and how much less it is off isn't known".to_owned(),
        };
        let layouts = match self.keeps_layouts {
            true => ", and the layouts as they are",
            false => "",
        };
        let work = self
            .times
            .map(|times| format!("{times:.1} times the work of this study"));
        let time = expected_s.map(|seconds| format!("about {} here", duration(seconds)));
        let costs: Vec<String> = work.into_iter().chain(time).collect();
        let costs = match costs.as_slice() {
            [] => "how long that takes isn't known".to_owned(),
            costs => costs.join(", "),
        };
        Surer {
            sentence: format!("The {level} mesh {brings}{layouts}: {costs}."),
            level: level.to_owned(),
            times: self.times,
            expected_s,
        }
    }
}

/// Returns what a level claims of an index's error by its mesh, in units that all levels of a scene share: the difference from the coarser one, where
/// errors go by [`ORDER`], times its factor. `None` of a level that claims nothing.
fn claimed(scene: &Scene, solver: &dyn Solver) -> Option<f64> {
    let coarser = solver.coarser(scene)?;
    let mut below = scene.clone();
    below.model.level = coarser.level;
    let [own, below] = [scene, &below].map(|scene| (solver.cells(scene) as f64).powf(-ORDER / 3.0));
    Some(coarser.of_largest * (below - own))
}

/// Returns the time of a study by the law of solve times with nothing solved before, s of one core; `None` of solvers without a law.
fn work_s(study: &Study, solver: &dyn Solver) -> Result<Option<f64>, PlanError> {
    let work = match Estimable::is_counted(study) {
        true => Workload::counted(study, solver)?,
        false => Workload::of(&PlannedStudy::new(study.clone())?, solver),
    };
    let estimate = estimate(&work, &|_| false, &Machine::new(1));
    Ok(estimate.wall_s.map(|wall_s| wall_s.expected))
}

/// Seconds, minutes or hours, to two digits.
fn duration(seconds: f64) -> String {
    match seconds {
        s if s < 9.5 => format!("{s:.1} s"),
        s if s < 120.0 => format!("{s:.0} s"),
        s if s < 7200.0 => format!("{:.0} minutes", s / 60.0),
        s => format!("{:.1} hours", s / 3600.0),
    }
}

#[cfg(test)]
mod tests {
    use document::Format;
    use fem_client::closed_form::ClosedFormSolver;
    use tire::embedded::EmbeddedSolver;

    use super::*;
    use documents::study::presets;

    fn shipped() -> Study {
        let refuse = |path: &str| Err(path.to_owned());
        let (_, text) = presets()[0];
        Study::from_document(text, Format::Toml, &refuse).expect("ships")
    }

    fn next(level: Level) -> Option<NextLevel> {
        NextLevel::of(&shipped(), level, &EmbeddedSolver::default()).expect("is planned")
    }

    #[test]
    fn every_level_but_the_last_has_a_next_one() {
        let draft = next(Level::Draft).expect("coarse").surer(None);
        assert_eq!(draft.level, "coarse");
        assert!(
            draft
                .sentence
                .starts_with("The coarse mesh would say how far")
        );
        let standard = next(Level::Standard).expect("reference");
        assert_eq!(standard.study.level, Level::Reference);
        assert_eq!(standard.study.accuracy, Accuracy::Preset);
        let surer = standard.surer(Some(700.0));
        let (times, share) = (
            surer.times.expect("a law"),
            standard.leaves.expect("claimed"),
        );
        // Measured: 37.8 s after 21.2 s.
        assert!(times > 1.2 && times < 6.0, "{times}");
        // 4320 cells for 10 240, with one factor: the square of the cube root.
        assert!((share - 0.5625).abs() < 1e-3, "{share}");
        // 1536 cells for 4320; after the coarse level, whose witness is of other bricks, Roache's factor is 1.25 for 3.
        let coarse = next(Level::Coarse).expect("standard").leaves;
        let share = coarse.expect("claimed");
        assert!((share - 0.50189 * 1.25 / 3.0).abs() < 1e-3, "{share}");
        assert!(
            surer.sentence.contains("and the layouts as they are")
                && surer.sentence.ends_with("about 12 minutes here."),
            "{}",
            surer.sentence
        );
        assert_eq!(next(Level::Reference), None);
    }

    #[test]
    fn a_solver_without_a_law_has_no_times() {
        let solver = ClosedFormSolver::new();
        let next = NextLevel::of(&shipped(), Level::Coarse, &solver).expect("is planned");
        let surer = next.expect("standard").surer(None);
        assert_eq!((surer.times, surer.expected_s), (None, None));
        assert!(
            surer
                .sentence
                .contains("is finer, and how much less it is off isn't known"),
            "{}",
            surer.sentence
        );
        assert!(surer.sentence.ends_with("how long that takes isn't known."));
    }
}
