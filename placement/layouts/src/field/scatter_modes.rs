//! Scatter that films' signals have together over contacts: independent modes, each a pattern of all signals.
//!
//! A quantity changes signals by a polynomial of the step that makes it. Written in polynomials that are orthonormal over its law (D. Xiu and G. E. Karniadakis,
//! 2002), a signal is its mean and the sum of modes times scores of unit variance without correlation. The force at a depth, and the quantity itself, go with them.
//! What two quantities change at once goes with each by its mean over the other; the rest is left, as dozens of small modes would cost more than they tell.

use crate::field::contact_axis::{ContactAxis, Weights, Wrench};
use crate::field::contact_pair::ContactPair;
use crate::field::hermite::{DEGREES, Turn};
use crate::field::response_surface::{Drawn, ResponseSurface, summed_signals, summed_wrench};
use crate::field::told_loads::TOLD_LOADS;

/// Values of a law over which a covariance is summed.
const VALUES: usize = 64;
/// Share of a power's squares that is left by the polynomials before it where it is one of them: rounding of the sums.
const SINGULAR: f64 = 1e-12;
/// Share of the largest mode's squares below which a mode is left out: 0.3 % of its signals, a tenth of usual noise.
const NEGLIGIBLE: f64 = 1e-5;

/// Modes at one depth.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ScatterModes {
    /// Signals by kind of film, then mode.
    pub kinds: Vec<Vec<Turn>>,
    /// Variances of the signals by kind of film that pairs of quantities have beside the modes: an estimate takes them for noise of each film.
    left: Vec<Turn>,
    /// Numbers that an estimate tells beside angle and depth: the vertical force, then the quantities that have one axis alone, then the other loads.
    pub told: Vec<Told>,
}

/// A number that goes with the modes.
#[derive(Debug, Clone, PartialEq)]
pub struct Told {
    /// Mean over contacts.
    pub mean: f64,
    /// Covariance with each mode's score.
    pub with_modes: Vec<f64>,
}

/// Mode of one axis.
struct Mode {
    /// Number of the axis' law.
    law: usize,
    signals: Vec<Vec<f64>>,
    force_n: f64,
    wrench: Wrench,
    /// Covariance of the axis' quantity with the score.
    of_value: f64,
}

impl Mode {
    fn squares(&self) -> f64 {
        squares(&self.signals)
    }
}

impl ScatterModes {
    /// Modes of a surface at a depth, mm, over contacts of which this is drawn; `force_n` is their mean force.
    pub(super) fn of(surface: &ResponseSurface, depth_mm: f64, drawn: Drawn, force_n: f64) -> Self {
        let drawn_axes = DrawnAxes::new(surface, depth_mm, drawn);
        let axes = 0..surface.axes().len();
        let modes: Vec<Mode> = axes.flat_map(|axis| drawn_axes.modes_of(axis)).collect();
        let largest = modes.iter().map(Mode::squares).fold(0.0, f64::max);
        let felt: Vec<Mode> = modes
            .into_iter()
            .filter(|mode| mode.squares() > NEGLIGIBLE * largest)
            .collect();
        let force = Told {
            mean: force_n,
            with_modes: felt.iter().map(|mode| mode.force_n).collect(),
        };
        let told = surface.told().into_iter().map(|law| Told {
            mean: mean_of(surface, law, drawn),
            with_modes: felt
                .iter()
                .map(|mode| if mode.law == law { mode.of_value } else { 0.0 })
                .collect(),
        });
        let mean = drawn_axes.mean_wrench();
        let loads = TOLD_LOADS.iter().map(|load| Told {
            mean: load.of(&mean),
            with_modes: felt.iter().map(|mode| load.of(&mode.wrench)).collect(),
        });
        let told = std::iter::once(force).chain(told).chain(loads).collect();
        let kinds = 0..surface.kinds();
        let of_kind = |kind: usize| {
            let signals = felt
                .iter()
                .map(|mode| Turn::new(mode.signals[kind].clone()));
            signals.collect()
        };
        let left = drawn_axes.left().into_iter();
        Self {
            kinds: kinds.map(of_kind).collect(),
            left: left.map(Turn::new).collect(),
            told,
        }
    }

    /// Variance of a kind of film's signal beside the modes, of a film this far from the contact, degrees.
    pub fn left(&self, kind: usize, apart_deg: f64) -> f64 {
        // A cubic through variances may fall below zero between two of them.
        let variance = |left: &Turn| left.at(apart_deg).max(0.0);
        self.left.get(kind).map_or(0.0, variance)
    }

    /// Number of modes.
    pub fn count(&self) -> usize {
        self.kinds.first().map_or(0, Vec::len)
    }
}

/// Shares at which a law's values are taken.
fn shares() -> impl Iterator<Item = f64> {
    (0..VALUES).map(|k| (k as f64 + 0.5) / VALUES as f64)
}

/// Mean of a law's quantity.
fn mean_of(surface: &ResponseSurface, law: usize, drawn: Drawn) -> f64 {
    let law_itself = &surface.laws()[law];
    match drawn.has(law) {
        true => {
            shares()
                .map(|share| law_itself.value_at(share))
                .sum::<f64>()
                / VALUES as f64
        }
        false => law_itself.quantity.usual(),
    }
}

/// Values that are drawn of an axis.
struct DrawnAxis {
    values: Vec<f64>,
    /// Steps that give these values at a depth.
    steps: Vec<f64>,
    /// Scores of unit variance at them: polynomials of the step.
    scores: Vec<Vec<f64>>,
}

/// Axes of a surface at a depth, with what is drawn of each.
struct DrawnAxes<'s> {
    surface: &'s ResponseSurface,
    depth_mm: f64,
    /// Values by axis; none where its quantity isn't drawn.
    axes: Vec<Option<DrawnAxis>>,
}

impl<'s> DrawnAxes<'s> {
    fn new(surface: &'s ResponseSurface, depth_mm: f64, drawn: Drawn) -> Self {
        let axis = |(number, axis): (usize, &ContactAxis)| {
            let law = &surface.laws()[axis.law];
            drawn.has(axis.law).then(|| {
                let values: Vec<f64> = shares().map(|share| law.value_at(share)).collect();
                let step = |value: &f64| surface.step(depth_mm, number, *value);
                let steps: Vec<f64> = values.iter().map(step).collect();
                DrawnAxis {
                    scores: orthonormal(&steps, axis.count() - 1),
                    values,
                    steps,
                }
            })
        };
        Self {
            surface,
            depth_mm,
            axes: surface.axes().iter().enumerate().map(axis).collect(),
        }
    }

    /// Weights of an axis' nodes at each value that is drawn; none where its quantity isn't.
    fn weights_of(&self, axis: usize) -> Vec<Weights> {
        let solved = &self.surface.axes()[axis];
        let steps = self.axes[axis].iter().flat_map(|own| &own.steps);
        steps.map(|step| solved.polynomials(*step)).collect()
    }

    /// Modes of one axis; none where its quantity isn't drawn.
    fn modes_of(&self, axis: usize) -> Vec<Mode> {
        let Some(own) = &self.axes[axis] else {
            return Vec::new();
        };
        let solved = &self.surface.axes()[axis];
        let weights = self.weights_of(axis);
        let mode = |scores: &Vec<f64>| {
            let of_nodes = mean_weights(scores, &weights);
            let mut changes = self.surface.changes_of_axis(self.depth_mm, axis, &of_nodes);
            for (number, pair) in self.surface.pairs().iter().enumerate() {
                // The mean over the other quantity goes with this one alone.
                let with = |own_axis: usize| if own_axis == axis { Some(scores) } else { None };
                if pair.axes.contains(&axis) {
                    let weights = self.of_pair(pair, pair.axes.map(with));
                    changes.extend(
                        self.surface
                            .changes_of_pair(self.depth_mm, number, &weights),
                    );
                }
            }
            let kinds = 0..self.surface.kinds();
            Mode {
                law: solved.law,
                signals: kinds.map(|kind| summed_signals(&changes, kind)).collect(),
                wrench: summed_wrench(&changes),
                force_n: changes
                    .iter()
                    .map(|(weight, own)| weight * own.force_n)
                    .sum(),
                of_value: mean(scores.iter().zip(&own.values).map(|(s, value)| s * value)),
            }
        };
        own.scores.iter().map(mode).collect()
    }

    /// Mean over contacts of what the ground does beside the usual contact.
    fn mean_wrench(&self) -> Wrench {
        let mut changes = Vec::new();
        for axis in 0..self.axes.len() {
            let of_nodes = mean_weights(&[1.0; VALUES], &self.weights_of(axis));
            let own = self.surface.changes_of_axis(self.depth_mm, axis, &of_nodes);
            changes.extend(own);
        }
        for (number, pair) in self.surface.pairs().iter().enumerate() {
            let weights = self.of_pair(pair, [None, None]);
            let own = self
                .surface
                .changes_of_pair(self.depth_mm, number, &weights);
            changes.extend(own);
        }
        summed_wrench(&changes)
    }

    /// Means of a pair's weights times these scores of its axes, each its own or none.
    fn of_pair(&self, pair: &ContactPair, scores: [Option<&Vec<f64>>; 2]) -> [f64; 2] {
        let [first, second] = pair.axes.map(|axis| self.axes[axis].as_ref());
        let with_score = |scores: Option<&Vec<f64>>, of: &dyn Fn(f64) -> f64, steps: &[f64]| {
            let score = |k: usize| scores.map_or(1.0, |scores| scores[k]);
            mean(
                steps
                    .iter()
                    .enumerate()
                    .map(|(k, step)| score(k) * of(*step)),
            )
        };
        let of_second = second.map_or(0.0, |own| {
            with_score(scores[1], &|step| pair.of_second(step), &own.steps)
        });
        [0, 1].map(|node| {
            let of_first = first.map_or(0.0, |own| {
                with_score(scores[0], &|step| pair.of_first(step)[node], &own.steps)
            });
            of_first * of_second
        })
    }

    /// Variances of the signals, by kind, that pairs have beside all modes.
    fn left(&self) -> Vec<Vec<f64>> {
        let mut left = vec![vec![0.0; DEGREES]; self.surface.kinds()];
        for (number, pair) in self.surface.pairs().iter().enumerate() {
            let [Some(first), Some(second)] = pair.axes.map(|axis| self.axes[axis].as_ref()) else {
                continue;
            };
            let products = first
                .scores
                .iter()
                .flat_map(|own| second.scores.iter().map(move |other| [own, other]));
            for scores in products {
                let weights = self.of_pair(pair, scores.map(Some));
                let changes = self
                    .surface
                    .changes_of_pair(self.depth_mm, number, &weights);
                for (kind, left) in left.iter_mut().enumerate() {
                    let mode = summed_signals(&changes, kind);
                    left.iter_mut()
                        .zip(mode)
                        .for_each(|(sum, own)| *sum += own * own);
                }
            }
        }
        left
    }
}

/// Means of nodes' weights times scores over a law's values.
fn mean_weights(scores: &[f64], weights: &[Weights]) -> Weights {
    let of_node = |node: usize| mean(scores.iter().zip(weights).map(|(s, w)| s * w[node]));
    std::array::from_fn(of_node)
}

/// Mean of numbers over a law's values.
fn mean(numbers: impl Iterator<Item = f64>) -> f64 {
    numbers.sum::<f64>() / VALUES as f64
}

/// Values at these steps of polynomials up to a degree, but for the constant one: orthonormal over the steps (Gram and Schmidt).
fn orthonormal(steps: &[f64], degree: usize) -> Vec<Vec<f64>> {
    let mut found = vec![vec![1.0; steps.len()]];
    for power in 1..=degree {
        let of_power: Vec<f64> = steps.iter().map(|step| step.powi(power as i32)).collect();
        let mut rest = of_power.clone();
        // Twice, as rounding leaves a part of those before.
        for _ in 0..2 {
            for before in &found {
                let share = mean(rest.iter().zip(before).map(|(a, b)| a * b));
                for (value, own) in rest.iter_mut().zip(before) {
                    *value -= share * own;
                }
            }
        }
        let [left, all] = [&rest, &of_power].map(|values| mean(values.iter().map(|v| v * v)));
        if left > SINGULAR * all {
            found.push(rest.iter().map(|value| value / left.sqrt()).collect());
        }
    }
    found.split_off(1)
}

/// Sum of the squares of all samples.
fn squares(signals: &[Vec<f64>]) -> f64 {
    signals.iter().flatten().map(|sample| sample * sample).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::field::contact_axis::Change;
    use crate::field::response_surface::tests::{LEVER_MM, surface};

    /// Variance over a law of one quantity alone of a film's signal, by contacts of the surface.
    fn variance(surface: &ResponseSurface, law: usize, [kind, degree]: [usize; 2]) -> f64 {
        let signal = |share: f64| {
            let contact = surface.contact(1.0, &surface.drawn(&[share; 2], Drawn::Only(law)));
            surface.signal(&contact, kind)[degree]
        };
        let signals: Vec<f64> = shares().map(signal).collect();
        let mean = signals.iter().sum::<f64>() / VALUES as f64;
        let squares = signals.iter().map(|signal| (signal - mean).powi(2));
        squares.sum::<f64>() / VALUES as f64
    }

    /// The modes' squares add up to the variances that contacts have, for every kind of film and angle.
    #[test]
    fn modes_have_the_variances_of_contacts() {
        let surface = surface();
        let modes = ScatterModes::of(&surface, 1.0, Drawn::All, 13.0);
        for (kind, modes) in modes.kinds.iter().enumerate() {
            for degree in (0..360).step_by(7) {
                let squares = modes.iter().map(|mode| mode.samples()[degree].powi(2));
                let sum: f64 = squares.sum();
                // Quantities are independent, and their changes add up; a mode that is left out has 1e-5 of the largest.
                let of_law = |law| variance(&surface, law, [kind, degree]);
                let expected: f64 = [0, 1].map(of_law).iter().sum();
                assert!(
                    (sum - expected).abs() < 1e-4 * expected + 1e-9,
                    "{degree} {sum} {expected}"
                );
            }
        }
        // Loads go with the traction's square, as signals do.
        let pull = |share: f64| {
            let contact = surface.contact(1.0, &surface.drawn(&[share; 2], Drawn::Only(1)));
            surface.changed_wrench(&contact)[0]
        };
        let pulls: Vec<f64> = shares().map(pull).collect();
        let mean = pulls.iter().sum::<f64>() / VALUES as f64;
        let squares = pulls.iter().map(|pull| (pull - mean).powi(2));
        let deviation = (squares.sum::<f64>() / VALUES as f64).sqrt();
        let [along, across, .., about_axle, _] = &modes.told[3..] else {
            panic!("five loads")
        };
        for (told, lever) in [(along, 1.0), (about_axle, -LEVER_MM), (across, 0.0)] {
            let covariances = told.with_modes.iter().map(|own| own * own);
            let found = covariances.sum::<f64>().sqrt();
            let expected = (lever * deviation).abs();
            assert!(
                (found - expected).abs() < 1e-9 * (1.0 + expected),
                "{found} {expected}"
            );
            assert!(
                (told.mean - lever * mean).abs() < 1e-9,
                "{} {mean}",
                told.mean
            );
        }
        // The pressure changes all signals by one share: of an even law to 0.0998 either side the deviation is that over the root of 3.
        let alone = ScatterModes::of(&surface, 1.0, Drawn::Only(0), 13.0);
        assert_eq!((modes.told.len(), alone.count()), (3 + TOLD_LOADS.len(), 1));
        let [force, pressure, traction] = [0, 1, 2].map(|k| &alone.told[k]);
        let deviation = 0.0998 / 3f64.sqrt();
        let score = alone.kinds[0][0].at(0.0) / -0.8;
        assert!((score.abs() / deviation - 1.0).abs() < 1e-3, "{score}");
        assert!((pressure.with_modes[0] - score).abs() < 1e-9);
        assert!((force.with_modes[0] - 10.0 * score).abs() < 1e-9);
        assert!((pressure.mean - 1.0).abs() < 1e-12);
        assert_eq!((traction.mean, traction.with_modes[0]), (0.0, 0.0));
        assert_eq!(
            ScatterModes::of(&surface, 1.0, Drawn::Nothing, 13.0).count(),
            0
        );
    }

    /// A variance over all pairs of values is that of the modes and what is left beside them: a pair's means over one quantity go with the other.
    #[test]
    fn modes_and_what_is_left_have_the_variances_of_two_quantities_at_once() {
        const PAIR: [usize; 2] = [1, 0];
        let node = |of_first: f64| Change {
            force_n: 0.0,
            wrench: [0.0; 6],
            signals: [0, 1]
                .map(|kind| {
                    (0..DEGREES)
                        .map(|d| of_first * (1 + d % 7 + kind) as f64)
                        .collect()
                })
                .to_vec(),
        };
        let pair = ContactPair {
            axes: PAIR,
            steps: [0.7, 0.8],
            nodes: vec![[node(0.02), node(0.05)]; 3],
        };
        let surface = surface().with_pairs(vec![pair]);
        let modes = ScatterModes::of(&surface, 1.0, Drawn::All, 13.0);
        let (kind, degree) = (1, 200);
        let signal = |first: f64, second: f64| {
            let contact = surface.contact(1.0, &surface.drawn(&[first, second], Drawn::All));
            surface.signal(&contact, kind)[degree]
        };
        let all: Vec<f64> = shares()
            .flat_map(|first| shares().map(move |second| (first, second)))
            .map(|(first, second)| signal(first, second))
            .collect();
        let [mean, square] = [1, 2].map(|power| {
            let powers = all.iter().map(|signal| signal.powi(power));
            powers.sum::<f64>() / all.len() as f64
        });
        let squares = modes.kinds[kind]
            .iter()
            .map(|mode| mode.samples()[degree].powi(2));
        let left = modes.left(kind, degree as f64 - 180.0);
        let found = squares.sum::<f64>() + left;
        let expected = square - mean * mean;
        assert!((found / expected - 1.0).abs() < 1e-3, "{found} {expected}");
        assert!(left > 0.01 * expected, "{left} {expected}");
    }

    #[test]
    fn polynomials_are_orthonormal_over_a_law() {
        let steps: Vec<f64> = shares().map(|share| 1.8 * share - 0.7).collect();
        let found = orthonormal(&steps, 4);
        assert_eq!(found.len(), 4);
        for (i, own) in found.iter().enumerate() {
            assert!(mean(own.iter().copied()).abs() < 1e-13);
            for (j, other) in found.iter().enumerate() {
                let product = mean(own.iter().zip(other).map(|(a, b)| a * b));
                let expected = if i == j { 1.0 } else { 0.0 };
                assert!((product - expected).abs() < 1e-12, "{i} {j} {product}");
            }
        }
        // A law of one value alone has none.
        assert!(orthonormal(&[0.5; VALUES], 4).is_empty());
    }
}
