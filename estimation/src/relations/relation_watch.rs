//! Rows of one run held against what signals say of each other.
//!
//! A row alone tells a fault only where it shows: a halved film reads rightly without a load. What was told of a signal is held until rows in which it would show
//! speak for it.

use super::learnt_relations::Relations;
use super::still_stretch::StillStretch;

/// Evidence from which on a signal is held faulty, and the most that is kept.
const HELD: f64 = 5.0;
const MOST: f64 = 10.0;
/// Evidence that a row takes away in which the signal reads what the others say, to a fifth of it.
const CLEARED: f64 = 2.0;
const CLEAR_SHARE: f64 = 0.2;

/// Watch over the rows of one run. Memory doesn't grow with them; a row takes as many steps as there are pairs of signals.
#[derive(Debug, Clone)]
pub(crate) struct RelationWatch<'r> {
    relations: &'r Relations,
    first: Option<Vec<f64>>,
    stretch: StillStretch,
    evidence: Vec<f64>,
    is_held: Vec<bool>,
}

/// A row's residuals, over their limits.
struct Over {
    /// Residual over its limit.
    ratio: Vec<f64>,
    /// Value that the others make it have, over the residual's limit.
    expected: Vec<f64>,
    /// Signal that the residuals blame.
    blamed: usize,
}

impl<'r> RelationWatch<'r> {
    pub(crate) fn new(relations: &'r Relations) -> Self {
        let signals = relations.spreads.len();
        Self {
            relations,
            first: None,
            stretch: StillStretch::new(signals),
            evidence: vec![0.0; signals],
            is_held: vec![false; signals],
        }
    }

    /// Begins anew after a pause: the start stays, and so does what is held.
    pub(crate) fn restart(&mut self) {
        self.stretch = StillStretch::new(self.relations.spreads.len());
    }

    /// Number of the signal that a row makes unlikely; none of a row that is as learnt ones.
    pub(crate) fn suspect(&mut self, signals: &[f64]) -> Option<usize> {
        let relations = self.relations;
        let jumped = {
            let mut steps = self.stretch.steps(signals).zip(&relations.steps);
            steps.position(|(step, most)| step.abs() > *most)
        };
        let counts = self.stretch.push(signals);
        let mut stretches = counts.iter().zip(&relations.still);
        let still = stretches.position(|(count, most)| count > most);
        let related = self.related(signals);
        still.or(related).or(jumped).or_else(|| self.held())
    }

    /// The signal that a row's residuals blame, where one exceeds its limit; evidence is kept of it.
    fn related(&mut self, signals: &[f64]) -> Option<usize> {
        let over = self.over(signals)?;
        let vote = over.ratio[over.blamed] > 1.0 && over.expected[over.blamed] > 1.0;
        for (signal, evidence) in self.evidence.iter_mut().enumerate() {
            let (ratio, expected) = (over.ratio[signal], over.expected[signal]);
            let found = f64::from(u8::from(vote && signal == over.blamed));
            let is_cleared = expected > 1.0 && ratio < CLEAR_SHARE * expected;
            let cleared = if is_cleared { CLEARED } else { 0.0 };
            *evidence = (*evidence + found - cleared).clamp(0.0, MOST);
            let held = &mut self.is_held[signal];
            *held = *evidence >= HELD || *held && *evidence > 0.0;
        }
        let is_over = over.ratio.iter().any(|ratio| *ratio > 1.0);
        is_over.then_some(over.blamed)
    }

    /// The signal with the most evidence among those that are held.
    fn held(&self) -> Option<usize> {
        let held = self.is_held.iter().zip(&self.evidence).enumerate();
        let held = held.filter(|(_, (is_held, _))| **is_held);
        held.max_by(|a, b| a.1.1.total_cmp(b.1.1))
            .map(|(signal, _)| signal)
    }

    fn over(&mut self, signals: &[f64]) -> Option<Over> {
        let relations = self.relations;
        let count = relations.blame.len();
        let first = self.first.get_or_insert_with(|| signals.to_vec());
        let parts = signals.iter().zip(first).zip(&relations.spreads);
        let z: Vec<f64> = parts
            .map(|((x, first), spread)| (x - *first) / spread)
            .collect();
        let (mut residual, mut of_gains) = (vec![0.0; count], vec![0.0; count]);
        for (z, weights) in z.iter().zip(relations.weights.chunks_exact(count.max(1))) {
            for ((residual, of_gains), weight) in
                residual.iter_mut().zip(&mut of_gains).zip(weights)
            {
                *residual += z * weight;
                *of_gains += (z * weight).powi(2);
            }
        }
        let limit = |signal: usize| {
            let scale = relations.noise[signal].hypot(relations.gains * of_gains[signal].sqrt());
            relations.limits[signal] * scale
        };
        let limits: Vec<f64> = (0..count).map(limit).collect();
        let over_limit = |of: &dyn Fn(usize) -> f64| -> Vec<f64> {
            (0..count)
                .map(|signal| of(signal).abs() / limits[signal])
                .collect()
        };
        let blame = |signal: &usize| residual[*signal].abs() * relations.blame[*signal];
        let blamed = (0..count).max_by(|a, b| blame(a).total_cmp(&blame(b)))?;
        Some(Over {
            ratio: over_limit(&|signal| residual[signal]),
            expected: over_limit(&|signal| z[signal] - residual[signal]),
            blamed,
        })
    }
}

#[cfg(test)]
mod tests {
    use ndarray::Array2;

    use super::*;

    /// Four signals of one force, with gains and noise of the run.
    fn run(number: usize) -> Array2<f64> {
        Array2::from_shape_fn((160, 4), |(row, signal)| {
            let (run, row, s) = (number as f64, row as f64, signal as f64);
            let force = (5.0 + run) * (row * 0.25 + run).sin().max(0.0);
            let gain = (1.3 - 0.3 * s) * (1.0 + 0.004 * (7.0 * run + 3.0 * s).sin());
            gain * force + 0.03 * (1e4 * (row * (s + 1.0) + 31.0 * run).sin()).sin()
        })
    }

    fn learnt(runs: usize) -> Relations {
        let runs: Vec<Array2<f64>> = (0..runs).map(run).collect();
        Relations::learn(&runs.iter().collect::<Vec<_>>()).expect("relations")
    }

    fn told(relations: &Relations, run: &Array2<f64>) -> Vec<Option<usize>> {
        let mut watch = RelationWatch::new(relations);
        let rows = run.rows().into_iter();
        rows.map(|row| watch.suspect(&row.to_vec())).collect()
    }

    #[test]
    fn relations_are_those_of_another_program() {
        // The same in numpy, written before this.
        for (runs, gains, limit, noise, weights) in [
            (
                1,
                0.070_710_678_118_654_77,
                4.9,
                [0.014_912_064_990_326_292, 0.041_742_897_621_393_875],
                [-0.378_236_591_501_521_2, -0.268_278_887_127_207_7],
            ),
            (
                3,
                0.057_735_026_918_962_574,
                3.733_333_333_333_333,
                [0.014_649_818_912_794_944, 0.047_393_717_468_295_61],
                [-0.373_746_788_979_620_7, -0.272_669_879_360_384_9],
            ),
        ] {
            let found = learnt(runs);
            // It adds the least noise, 1e-9, which is a bound here.
            let near = |a: f64, b: f64| assert!((a - b).abs() < 1.1e-9, "{a} {b}");
            near(found.gains, gains);
            near(found.limits[0], limit);
            near(found.noise[0], noise[0]);
            near(found.noise[3], noise[1]);
            near(found.weights[4], weights[0]);
            near(found.weights[12], weights[1]);
            assert_eq!(found.still, [3; 4]);
        }
        assert!((learnt(3).steps[3] - 1.435_306_055_260_846_8).abs() < 1e-9);
    }

    #[test]
    fn faulty_sensors_are_named_and_clean_rows_are_not() {
        let relations = learnt(3);
        let clean = run(5);
        assert_eq!(told(&relations, &clean), vec![None; 160]);
        type Fault = (&'static str, fn(&mut Array2<f64>), usize);
        let faults: [Fault; 4] = [
            (
                "stuck",
                |run| {
                    let start = run[[0, 1]];
                    run.column_mut(1).fill(start);
                },
                156,
            ),
            (
                "halved",
                |run| run.column_mut(1).mapv_inplace(|x| 0.5 * x),
                154,
            ),
            ("spiked", |run| run[[80, 1]] += 20.0, 2),
            (
                "swapped",
                |run| {
                    let first = run.column(0).to_owned();
                    let third = run.column(2).to_owned();
                    run.column_mut(0).assign(&third);
                    run.column_mut(2).assign(&first);
                },
                154,
            ),
        ];
        for (fault, spoil, rows) in faults {
            let mut spoilt = clean.clone();
            spoil(&mut spoilt);
            let told: Vec<usize> = told(&relations, &spoilt).into_iter().flatten().collect();
            assert_eq!(told.len(), rows, "{fault}");
            let right = |signal: &usize| (*signal == 1) == (fault != "swapped");
            assert!(told.iter().all(right), "{fault}: {told:?}");
        }
    }

    #[test]
    fn one_signal_is_watched_for_what_it_does_itself() {
        let one = run(0).select(ndarray::Axis(1), &[0]);
        let relations = Relations::learn(&[&one]).expect("a signal");
        assert_eq!(relations.check(1), Ok(()));
        let mut spiked = one.clone();
        spiked[[50, 0]] = 100.0;
        let told = told(&relations, &spiked);
        assert_eq!(told.iter().flatten().count(), 2);
        assert!(Relations::learn(&[&one.select(ndarray::Axis(0), &[0; 10])]).is_none());
    }
}
