//! Adds the solves of a workload up, for a machine and a database that may have some of them already.

use super::accuracy::expected_accuracy;
use super::peak_memory::memory_bytes;
use super::solve_time::{How, Machine};
use super::workload::{Point, Stage, Workload};
use documents::layouts::contact_laws::Scatter;
use documents::study::Accuracy;
use results::{CountForecast, Estimate, Forecast, SolveForecast};

/// Analysis, layouts and storing of a result, s: a draft study's time that no solve explains.
const ANALYSIS_S: f64 = 0.05;
/// A time may be off by this factor, where the machine was measured and where it wasn't: solves near a cut point take from half to twice their mean, and
/// other work on a machine's cores and memory as much again.
pub(super) const SPREAD: [f64; 2] = [2.0, 3.0];
/// Analysis of one number that is read of every point, on one mesh, s: by a method with a plan, and by one that adapts, which chooses among surrogates.
/// From maps of 20 402 numbers on the draft mesh.
const OUTPUT_S: [f64; 2] = [25e-6, 100e-6];
/// Score of one layout at one load on one mesh with its share of what is prepared for all, s of one core: of contacts that differ in angle and depth alone, and
/// in more, averaged over or estimated together. The shipped study's took 0.010 to 0.075 s, five quantities' on the coarse mesh 0.13 and 0.37 s.
const SCORING_S: [f64; 3] = [0.025, 0.13, 0.37];
/// Look of a search at one layout by both criteria, s of one core: 20 736 distances are added.
const LOOK_S: f64 = 11.5e-6;
/// Forces of one layout, learnt from the shipped rig's runs with five drifts and judged, s of one core.
const LEARNING_S: f64 = 27.0;

/// Estimates what a workload costs on a machine, where the points whose content keys are known needn't be solved.
pub fn estimate(work: &Workload, is_known: &dyn Fn(&str) -> bool, machine: &Machine) -> Estimate {
    let stages: Vec<StageCost> = work
        .stages
        .iter()
        .map(|stage| StageCost::of(stage, is_known, machine))
        .collect();
    let expected = likely(work, &stages);
    let sum =
        |stages: &[StageCost], part: fn(&StageCost) -> f64| stages.iter().map(part).sum::<f64>();
    let count = |stages: &[StageCost], part: fn(&StageCost) -> usize| {
        stages.iter().map(part).sum::<usize>()
    };
    let spread = SPREAD[usize::from(machine.samples == 0)];
    let analysis_s = |count: usize| -> f64 {
        let stages = work.stages[..count].iter();
        let of_stages =
            stages.map(|stage| stage_analysis_s(work, stage) + scoring_s(stage, machine));
        machine.slowness() * (ANALYSIS_S + of_stages.sum::<f64>())
    };
    let mut wall_s = Forecast {
        least: (analysis_s(1) + sum(&stages[..1], |stage| stage.planned_s)) / spread,
        expected: analysis_s(expected) + sum(&stages[..expected], StageCost::expected_s),
        most: (analysis_s(stages.len()) + sum(&stages, StageCost::most_s)) * spread,
    };
    if let Accuracy::Budget(seconds) = work.accuracy {
        wall_s.expected = wall_s.expected.min(seconds);
        wall_s.most = wall_s.most.min(seconds);
        wall_s.least = wall_s.least.min(seconds);
    }
    Estimate {
        solves: SolveForecast {
            own: count(&stages[..expected], |stage| stage.own),
            coarser: count(&stages[..expected], |stage| stage.coarser),
            effects: count(&stages[..expected], |stage| stage.effects),
            signals: count(&stages[..expected], |stage| stage.signals),
            layouts: count(&stages[..expected], |stage| stage.layouts),
            tables: count(&stages[..expected], |stage| stage.tables),
            known: count(&stages[..expected], |stage| stage.known),
            left: CountForecast {
                least: stages[0].left,
                expected: count(&stages[..expected], |stage| {
                    stage.left + stage.extra_expected
                }),
                most: count(&stages, |stage| stage.left + stage.extra_most),
            },
        },
        wall_s: is_timed(work, machine).then_some(wall_s),
        peak_memory_bytes: memory_bytes(work, &work.stages[..expected], machine),
        database_bytes: (work.result_bytes + sum(&stages[..expected], |stage| stage.stored_bytes))
            as u64,
        accuracy: expected_accuracy(work.stages[expected - 1].fidelity),
        threads: machine.threads,
        measured_solves: machine.samples,
        reasons: reasons(work, machine, spread),
        unlikely: work.unlikely.clone(),
    }
}

/// Returns the time from the responses of a stage to its indices, s.
fn stage_analysis_s(work: &Workload, stage: &Stage) -> f64 {
    OUTPUT_S[usize::from(stage.extra.most > 0)] * work.readings as f64 * stage.meshes() as f64
}

/// Returns the time that layouts' scores, the search for them, and forces learnt of them, take on all cores, s.
fn scoring_s(stage: &Stage, machine: &Machine) -> f64 {
    let scoring_s = match stage.scatter {
        None => SCORING_S[0],
        Some(Scatter::Each) => SCORING_S[1],
        Some(Scatter::Together) => SCORING_S[2],
    };
    let scored_s = scoring_s * stage.scorings as f64 + LOOK_S * stage.searched.0;
    (scored_s + LEARNING_S * stage.learnt as f64) / machine.threads as f64
}

fn is_timed(work: &Workload, machine: &Machine) -> bool {
    work.law_holds || machine.samples > 0
}

/// Returns how many stages are expected to run.
fn likely(work: &Workload, stages: &[StageCost]) -> usize {
    match work.accuracy {
        Accuracy::Preset => 1,
        Accuracy::Tolerance(tolerance) => {
            let serves = |stage: &Stage| {
                let claimed = expected_accuracy(stage.fidelity).error_claimed;
                claimed.is_some_and(|claimed| claimed <= tolerance)
            };
            let first = work.stages.iter().position(serves);
            first.map_or(stages.len(), |index| index + 1)
        }
        Accuracy::Budget(seconds) => {
            let mut spent = ANALYSIS_S;
            let mut fits = |stage: &StageCost| {
                spent += stage.expected_s();
                spent <= seconds
            };
            let in_time = stages.iter().position(|stage| !fits(stage));
            in_time.unwrap_or(stages.len()).max(1)
        }
    }
}

fn reasons(work: &Workload, machine: &Machine, spread: f64) -> Vec<String> {
    let mut reasons = Vec::new();
    if work.is_counted {
        reasons.push(
            "the points of so large a design are counted, not planned: those that an earlier study of the same document had solved are known"
                .to_owned(),
        );
    }
    if work.stages[0].extra.most > 0 {
        let first = &work.stages[0].extra;
        reasons.push(format!(
            "the adaptive method asks for points until its tolerance is met: {} more in studies like the paper's, {} at most",
            first.expected, first.most
        ));
    }
    reasons.extend(match work.accuracy {
        Accuracy::Preset => None,
        Accuracy::Tolerance(_) => Some(
            "how far a tolerance makes the study climb isn't known before its first errors are: at least the first mesh, at most \
             the finest mesh and the adaptive method"
                .to_owned(),
        ),
        Accuracy::Budget(_) => Some(
            "a budget is spent up to the last mesh and method that are expected to end in time".to_owned(),
        ),
    });
    reasons.push(match machine.samples {
        _ if !is_timed(work, machine) => "how long this solver takes isn't known before it has solved something into this database".to_owned(),
        0 => format!(
            "this database has no solves to measure this machine by: the times are those of another machine, and off by a \
             factor of {spread}"
        ),
        count => format!(
            "times are corrected by {count} solves of this database, and off by a factor of {spread} with other work on the machine"
        ),
    });
    reasons
}

/// Cost of a stage.
struct StageCost {
    own: usize,
    coarser: usize,
    effects: usize,
    signals: usize,
    layouts: usize,
    tables: usize,
    known: usize,
    left: usize,
    planned_s: f64,
    /// Room that the points which lack take in a database, bytes.
    stored_bytes: f64,
    extra_expected: usize,
    extra_most: usize,
    /// Time of one further point, on both meshes, s.
    extra_s: f64,
}

impl StageCost {
    fn of(stage: &Stage, is_known: &dyn Fn(&str) -> bool, machine: &Machine) -> Self {
        let lacking = stage.series().map(|series| {
            let lacking = series.iter().filter(|point| !is_known(&point.key));
            lacking.collect::<Vec<_>>()
        });
        let lacking: Vec<_> = lacking.collect();
        let all: usize = stage.series().map(Vec::len).sum();
        let left: usize = lacking.iter().map(Vec::len).sum();
        let meshes = 1 + usize::from(stage.extra.coarser);
        let extra_s = [&stage.own, &stage.coarser]
            .into_iter()
            .take(meshes)
            .map(|series| mean_s(series, machine));
        let own_bytes: f64 = stage.own.iter().map(|point| point.stored_bytes).sum();
        let mean_bytes = own_bytes / stage.own.len().max(1) as f64;
        let extra_expected = meshes * stage.extra.expected;
        let lacking_bytes = lacking.iter().flatten().map(|point| point.stored_bytes);
        Self {
            own: stage.own.len(),
            coarser: stage.coarser.len(),
            effects: stage.effects.len(),
            signals: stage.signals.iter().map(Vec::len).sum(),
            layouts: stage.layouts.iter().map(Vec::len).sum(),
            tables: stage.tables.iter().map(Vec::len).sum(),
            known: all - left,
            left,
            planned_s: lacking.iter().map(|series| series_s(series, machine)).sum(),
            stored_bytes: lacking_bytes.sum::<f64>() + mean_bytes * extra_expected as f64,
            extra_expected,
            extra_most: meshes * stage.extra.most,
            extra_s: extra_s.sum::<f64>() / machine.threads as f64 / meshes as f64,
        }
    }

    fn expected_s(&self) -> f64 {
        self.planned_s + self.extra_expected as f64 * self.extra_s
    }

    fn most_s(&self) -> f64 {
        self.planned_s + self.extra_most as f64 * self.extra_s
    }
}

/// The cut point and its tangents one after the other, then all others on all threads.
fn series_s(series: &[&Point], machine: &Machine) -> f64 {
    let (mut before, mut together, mut longest) = (0.0, 0.0, 0.0f64);
    for point in series {
        let seconds = machine.solve_s(&point.task);
        if point.task.how == How::Cut {
            before += seconds;
        } else {
            together += seconds;
            longest = longest.max(seconds);
        }
    }
    let near = series.iter().find(|point| point.task.how == How::Near);
    let tangents = near.map_or(0.0, |point| machine.tangents_s(&point.task));
    before + tangents + longest.max(together / machine.threads as f64)
}

/// A point's time on average, the cut point aside.
fn mean_s(series: &[Point], machine: &Machine) -> f64 {
    let times: Vec<f64> = series
        .iter()
        .filter(|point| point.task.how != How::Cut)
        .map(|point| machine.solve_s(&point.task))
        .collect();
    times.iter().sum::<f64>() / times.len().max(1) as f64
}

#[cfg(test)]
mod tests {
    use std::collections::HashSet;

    use document::Format;
    use tire::embedded::EmbeddedSolver;

    use super::*;
    use documents::study::plan::PlannedStudy;
    use documents::study::{Study, presets};

    fn study(changes: &[(&str, &str)]) -> Study {
        let mut text = presets()[0]
            .1
            .replace("depths_mm = [0.5, 1, 2]", "units = []");
        let none = ("[layouts]", "[layouts]\nspacings_deg = []");
        for (from, to) in [&[none], changes].concat() {
            assert!(text.contains(from), "{from}");
            text = text.replace(from, to);
        }
        Study::from_document(&text, Format::Toml, &|path| Err(path.to_owned())).unwrap()
    }

    fn work(study: &Study) -> Workload {
        let planned = PlannedStudy::new(study.clone()).unwrap();
        Workload::of(&planned, &EmbeddedSolver::default())
    }

    fn of(study: &Study) -> Estimate {
        estimate(&work(study), &|_| false, &Machine::new(2))
    }

    #[test]
    fn the_shipped_study_takes_the_room_that_it_took() {
        // Files after `strainsite run foot-tire`, less the 0.32 MB of one without rows.
        for (level, taken_mb) in [("draft", 3.33), ("coarse", 6.65), ("standard", 8.51)] {
            let preset = format!("preset = \"{level}\"");
            let text = presets()[0].1.replace("preset = \"standard\"", &preset);
            let study = Study::from_document(&text, Format::Toml, &|path| Err(path.to_owned()));
            let work = work(&study.unwrap());
            let expected_mb = |is_known: bool| {
                let estimate = estimate(&work, &|_| is_known, &Machine::new(2));
                estimate.database_bytes as f64 / 1e6
            };
            let off = expected_mb(false) / taken_mb;
            assert!((0.95..1.05).contains(&off), "{level}: {off}");
            // The result alone.
            assert!((0.8..1.0).contains(&expected_mb(true)));
        }
    }

    #[test]
    fn solves_of_a_plan_are_counted_on_every_mesh_and_known_ones_cost_nothing() {
        let study = study(&[]);
        let found = of(&study);
        // Friction, film and compressibility beside the plain scene, which the coarse mesh has already.
        let (own, coarser, effects) =
            (found.solves.own, found.solves.coarser, found.solves.effects);
        assert_eq!((own, coarser, effects), (26, 26, 3));
        let left = found.solves.left;
        assert_eq!((left.least, left.expected, left.most), (55, 55, 55));

        let work = work(&study);
        assert_eq!(work.keys().collect::<HashSet<_>>().len(), 55);
        let again = estimate(&work, &|_| true, &Machine::new(2));
        assert_eq!((again.solves.known, again.solves.left.most), (55, 0));
        let analysis_s = ANALYSIS_S + stage_analysis_s(&work, &work.stages[0]);
        assert_eq!(again.wall_s.unwrap().expected, analysis_s);
    }

    #[test]
    fn a_large_design_is_counted_to_about_what_planning_it_says() {
        let tensor = ("kind = \"mdrm\"\nnodes = 5", "kind = \"tensor\"\nnodes = 4");
        let study = study(&[tensor]);
        let planned = of(&study);
        let counted = Workload::counted(&study, &EmbeddedSolver::default()).unwrap();
        let counted = estimate(&counted, &|_| false, &Machine::new(2));
        // 4^5 nodes, the cut point and 5 check points, on two meshes.
        assert!(planned.solves.own >= 1024 && counted.solves.own >= planned.solves.own);
        assert!(counted.solves.own <= planned.solves.own + 20);
        // One of them may be a point of the coarser mesh, which the numbers that stand for keys don't show.
        assert!(counted.solves.effects <= planned.solves.effects + 1);
        let [planned, counted] = [planned, counted].map(|found| found.wall_s.unwrap().expected);
        // Half of the grid are mirror images, which cost little; on the lines a fifth are.
        assert!(
            (1.0..2.2).contains(&(counted / planned)),
            "{counted} {planned}"
        );
    }

    #[test]
    fn measured_studies_are_met() {
        // Whole studies on two quiet cores, s. Between a half and twice: the law's 1.3 and what machines differ by.
        for (level, wall_s) in [
            ("draft", 0.33),
            ("coarse", 2.4),
            ("standard", 5.4),
            ("reference", 15.0),
        ] {
            let level = format!("preset = \"{level}\"");
            let expected = of(&study(&[("preset = \"standard\"", &level)]))
                .wall_s
                .unwrap()
                .expected;
            assert!(
                (0.5..2.0).contains(&(expected / wall_s)),
                "{level}: {expected} s, measured {wall_s} s"
            );
        }
        // Peak memory, MB, of which the estimate is a bound: 1 to 3 times.
        for (level, megabytes) in [
            ("draft", 34.0),
            ("coarse", 273.0),
            ("standard", 577.0),
            ("reference", 1266.0),
        ] {
            let level = format!("preset = \"{level}\"");
            let expected =
                of(&study(&[("preset = \"standard\"", &level)])).peak_memory_bytes as f64 / 1e6;
            assert!(
                (1.0..3.0).contains(&(expected / megabytes)),
                "{level}: {expected} MB, measured {megabytes} MB"
            );
        }
    }

    #[test]
    fn another_inflated_tire_at_a_point_and_friction_are_dear() {
        let depths = of(&study(&[])).wall_s.unwrap().expected;
        let pressure = (
            "vary = \"ground.depths_mm[4]\"\ndistribution = { kind = \"uniform\", min = 0.7, max = 1.3 }",
            "vary = \"pressure.internal_mpa\"\ndistribution = { kind = \"uniform\", min = 0.18, max = 0.2 }",
        );
        let varied = of(&study(&[pressure])).wall_s.unwrap().expected;
        let friction = (
            "scene = { preset = \"foot-tire\" }",
            "scene = { preset = \"foot-tire\", contact = { friction = 0.5 } }",
        );
        let slipping = of(&study(&[friction])).wall_s.unwrap().expected;
        assert!(
            varied > 1.5 * depths && slipping > 4.0 * depths,
            "{depths} {varied} {slipping}"
        );
    }

    #[test]
    fn what_is_not_known_before_is_a_range_with_its_reason() {
        let auto = (
            "kind = \"mdrm\"\nnodes = 5\ncheck_points = 5",
            "kind = \"auto\"",
        );
        let adaptive = of(&study(&[auto]));
        let left = adaptive.solves.left;
        assert!(left.least < left.expected && left.expected < left.most);
        // most_runs is 1000 on each of two meshes, and 3 effects.
        assert_eq!(left.most, 2003);
        let tolerance = of(&study(&[("preset = \"standard\"", "tolerance = 0.03")]));
        assert_eq!(tolerance.accuracy.fidelity, "standard auto 5");
        let budget = of(&study(&[("preset = \"standard\"", "budget_s = 60")]));
        assert_eq!(budget.wall_s.unwrap().most, 60.0);
        for found in [adaptive, tolerance, budget] {
            assert!(found.reasons.len() >= 2, "{:?}", found.reasons);
            let wall = found.wall_s.unwrap();
            assert!(wall.least <= wall.expected && wall.expected <= wall.most);
        }
    }
}
