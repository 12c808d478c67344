//! Pace of a study: what it is expected to take once some of its solves were measured.

use std::collections::{BTreeMap, HashMap, HashSet};

use super::estimated_cost::{SPREAD, estimate};
use super::solve_time::{How, Machine, Taken, Task, TaskKind};
use super::workload::Workload;
use documents::study::Accuracy;
use results::{Estimate, Forecast};

/// Solves of one kind that tell how fast a study goes.
const ENOUGH: usize = 3;
/// An estimate off by this factor isn't worth having any more: as much as one on a measured machine may be off.
const REVISED: f64 = SPREAD[0];
/// Shortest time that is revised, s: nobody waits for less.
const SHORT_S: f64 = 1.0;
/// Share by which the solves grow from look to look: each goes through all points.
const LOOK: f64 = 1.25;

/// A study's expected time beside what its solves take.
#[derive(Debug)]
pub struct Pace {
    work: Workload,
    tasks: HashMap<String, Task>,
    known: HashSet<String>,
    machine: Machine,
    first: Estimate,
    shown_s: f64,
    taken: BTreeMap<TaskKind, Taken>,
    /// Solves near each cut point so far.
    near: BTreeMap<TaskKind, usize>,
    solves: usize,
    /// Count of those that nobody had planned.
    extra: usize,
    next_look: usize,
}

impl Pace {
    /// Begins with a workload on a machine, where the points with the `known` content keys needn't be solved.
    pub fn new(work: Workload, known: HashSet<String>, machine: Machine) -> Self {
        let first = estimate(&work, &|key| known.contains(key), &machine);
        let points = work.points().map(|point| (point.key.clone(), point.task));
        Self {
            tasks: points.collect(),
            shown_s: first.wall_s.map_or(0.0, |wall_s| wall_s.expected),
            first,
            work,
            known,
            machine,
            taken: BTreeMap::new(),
            near: BTreeMap::new(),
            solves: 0,
            extra: 0,
            next_look: ENOUGH,
        }
    }

    /// Returns what was expected at first.
    pub fn estimate(&self) -> &Estimate {
        &self.first
    }

    /// Takes note of a solve.
    pub fn solved(&mut self, key: &str, wall_s: f64) {
        self.solves += 1;
        let Some(task) = self.tasks.get(key) else {
            return self.extra_solved();
        };
        self.known.insert(key.to_owned());
        let kind = task.kind();
        if task.how == How::Near {
            let before = self.near.entry(kind).or_default();
            *before += 1;
            // The first of all threads wait for the tangents that all others share.
            if *before <= self.machine.threads {
                return;
            }
        }
        if task.how != How::Image {
            self.taken.entry(kind).or_default().add(task, wall_s);
        }
    }

    /// An adaptive method asked for it: one less is to come.
    fn extra_solved(&mut self) {
        self.extra += 1;
        let mut extras = self.work.stages.iter_mut().map(|stage| &mut stage.extra);
        if let Some(extra) = extras.find(|extra| extra.most > 0)
            && self.extra.is_multiple_of(1 + usize::from(extra.coarser))
        {
            extra.expected = extra.expected.saturating_sub(1);
            extra.most -= 1;
        }
    }

    /// Returns what the study is expected to take in all, so many seconds after its beginning, where that is far from what was said last.
    pub fn revised(&mut self, elapsed_s: f64) -> Option<Estimate> {
        let budget = matches!(self.work.accuracy, Accuracy::Budget(_));
        if budget || self.solves < self.next_look || !self.is_measured() {
            return None;
        }
        self.next_look = (self.solves as f64 * LOOK).ceil() as usize;
        let wall_s = self.in_all(elapsed_s)?;
        let (now, before) = (wall_s.expected, self.shown_s);
        let off = (now / before).max(before / now);
        if off < REVISED || now.max(before) < SHORT_S {
            return None;
        }
        self.shown_s = now;
        let mut revised = self.first.clone();
        revised.reasons.push(self.reason());
        revised.wall_s = Some(wall_s);
        Some(revised)
    }

    fn is_measured(&self) -> bool {
        self.taken.values().any(|taken| taken.solves >= ENOUGH)
    }

    /// Past and rest together; None where no time was expected at first.
    fn in_all(&self, elapsed_s: f64) -> Option<Forecast> {
        self.first.wall_s?;
        let machine = self.machine.revised(&self.taken);
        let rest = estimate(&self.work, &|key| self.known.contains(key), &machine).wall_s?;
        Some(Forecast {
            least: elapsed_s + rest.least,
            expected: elapsed_s + rest.expected,
            most: elapsed_s + rest.most,
        })
    }

    fn reason(&self) -> String {
        let first_s = self.first.wall_s.map_or(0.0, |wall_s| wall_s.expected);
        format!(
            "the time is revised after {} solves of this study, which took {:.1} times what was expected of them: at first {first_s:.1} s were \
             expected in all",
            self.solves,
            self.machine.off(&self.taken)
        )
    }
}

#[cfg(test)]
mod tests {
    use document::Format;
    use tire::embedded::EmbeddedSolver;

    use super::*;
    use documents::study::plan::PlannedStudy;
    use documents::study::{Study, presets};

    /// The shipped study on a machine with one thread, as fast as the law says.
    fn pace() -> Pace {
        let text = presets()[0]
            .1
            .replace("[layouts]", "[layouts]\nspacings_deg = []");
        let study = Study::from_document(&text, Format::Toml, &|path| Err(path.to_owned()));
        let planned = PlannedStudy::new(study.expect("ships")).expect("a plan");
        let work = Workload::of(&planned, &EmbeddedSolver::default());
        Pace::new(work, HashSet::new(), Machine::new(1))
    }

    /// Solves so many of a study's points in their order, each in `factor` of its time; what was said on the way and the time.
    fn run(pace: &mut Pace, solves: usize, factor: f64) -> (Vec<Estimate>, f64) {
        let points: Vec<_> = pace.work.points().cloned().collect();
        let (mut said, mut elapsed_s) = (Vec::new(), 0.0);
        for point in &points[..solves] {
            let wall_s = factor * pace.machine.solve_s(&point.task);
            elapsed_s += wall_s;
            pace.solved(&point.key, wall_s);
            said.extend(pace.revised(elapsed_s));
        }
        (said, elapsed_s)
    }

    /// Returns the time that is left when all points are there, s.
    fn analysis_s() -> f64 {
        let pace = pace();
        let rest = estimate(&pace.work, &|_| true, &pace.machine);
        rest.wall_s.expect("a time").expected
    }

    #[test]
    fn a_study_that_goes_as_expected_is_never_revised() {
        for factor in [0.6, 1.0, 1.8] {
            let mut pace = pace();
            assert_eq!(run(&mut pace, 55, factor).0, [], "{factor}");
        }
    }

    #[test]
    fn a_tenth_of_the_work_tells_how_long_all_of_it_takes() {
        for factor in [0.2, 4.0, 80.0] {
            let (said, _) = run(&mut pace(), 6, factor);
            let [revised] = &said[..] else {
                panic!("{factor}: said {} times", said.len());
            };
            let (_, solves_s) = run(&mut pace(), 55, factor);
            let in_all = solves_s + analysis_s();
            let expected = revised.wall_s.expect("a time").expected;
            // The tangents between the points take time that isn't any point's.
            assert!(
                (0.8..1.3).contains(&(expected / in_all)),
                "{factor}: {expected} s expected, {in_all} s taken"
            );
            let reason = revised.reasons.last().expect("a reason");
            assert!(reason.contains(&format!("{factor:.1} times")), "{reason}");
            assert_eq!(revised.solves, pace().estimate().solves);
        }
    }

    #[test]
    fn what_becomes_slow_later_is_said_again() {
        let mut pace = pace();
        let points: Vec<_> = pace.work.points().cloned().collect();
        let (mut said, mut elapsed_s) = (0, 0.0);
        for (ordinal, point) in points.iter().enumerate() {
            let factor = if ordinal < 10 { 4.0 } else { 100.0 };
            let wall_s = factor * pace.machine.solve_s(&point.task);
            elapsed_s += wall_s;
            pace.solved(&point.key, wall_s);
            said += usize::from(pace.revised(elapsed_s).is_some());
        }
        assert!((2..=6).contains(&said), "said {said} times");
        assert!((1.0 / REVISED..REVISED).contains(&(pace.shown_s / elapsed_s)));
    }
}
