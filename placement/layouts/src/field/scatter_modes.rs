//! Scatter that films' signals have together over contacts: independent modes, each a pattern of all signals.
//!
//! A quantity changes signals by a polynomial of the step that makes it. Written in polynomials that are orthonormal over its law (D. Xiu and G. E. Karniadakis,
//! 2002), a signal is its mean and the sum of modes times scores of unit variance without correlation. The force at a depth, and the quantity itself, go with them.

use crate::field::hermite::Turn;
use crate::field::response_surface::{Drawn, MOST_NODES, ResponseSurface, Weights, polynomials};

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
    /// Numbers that an estimate tells beside angle and depth: the vertical force, then the quantities that have one axis alone.
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
        let axes = 0..surface.laws_of_axes().count();
        let modes: Vec<Mode> = axes
            .flat_map(|axis| of_axis(surface, axis, depth_mm, drawn))
            .collect();
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
        let told = std::iter::once(force).chain(told).collect();
        let kinds = 0..surface.kinds();
        let of_kind = |kind: usize| {
            let signals = felt
                .iter()
                .map(|mode| Turn::new(mode.signals[kind].clone()));
            signals.collect()
        };
        Self {
            kinds: kinds.map(of_kind).collect(),
            told,
        }
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

/// Modes of one axis; none where its quantity isn't drawn.
fn of_axis(surface: &ResponseSurface, axis: usize, depth_mm: f64, drawn: Drawn) -> Vec<Mode> {
    let law = surface.laws_of_axes().nth(axis).unwrap_or_default();
    if !drawn.has(law) {
        return Vec::new();
    }
    let values: Vec<f64> = shares()
        .map(|share| surface.laws()[law].value_at(share))
        .collect();
    let steps: Vec<f64> = values
        .iter()
        .map(|value| surface.step(depth_mm, axis, *value))
        .collect();
    let count = surface.nodes_of(axis);
    let weights: Vec<Weights> = steps.iter().map(|step| polynomials(count, *step)).collect();
    let mode = |scores: Vec<f64>| {
        let of_node = |node: usize| mean(scores.iter().zip(&weights).map(|(s, w)| s * w[node]));
        let mut own: Weights = [0.0; MOST_NODES];
        for (node, weight) in own.iter_mut().enumerate().take(count) {
            *weight = of_node(node);
        }
        let (signals, force_n) = surface.change(depth_mm, axis, &own);
        Mode {
            law,
            signals,
            force_n,
            of_value: mean(scores.iter().zip(&values).map(|(s, value)| s * value)),
        }
    };
    orthonormal(&steps, count - 1)
        .into_iter()
        .map(mode)
        .collect()
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
    use crate::field::response_surface::tests::surface;

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
        // The pressure changes all signals by one share: of an even law to 0.0998 either side the deviation is that over the root of 3.
        let alone = ScatterModes::of(&surface, 1.0, Drawn::Only(0), 13.0);
        assert_eq!((modes.told.len(), alone.count()), (3, 1));
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
