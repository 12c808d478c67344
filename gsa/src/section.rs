//! What one output shows on the cut lines: the mean and variance of each section, free of cancellation.
//!
//! | symbol | meaning |
//! |---|---|
//! | h0 | value at the cut point |
//! | h_i(x) | section: the output along the line of input i |
//! | d_ij | h_i(x_j) - h0 at node j |
//! | dbar_i | E\[d_i\] = sum_j w_j d_ij, so that rho_i = E\[h_i\] = h0 + dbar_i |
//! | v_i | Var\[h_i\] = sum_j w_j (d_ij - dbar_i)^2, centred, never E\[h_i^2\] - rho_i^2 |
//! | c_ik | coefficient of section i on the law's k-th orthonormal polynomial; v_i = sum_{0<k<N} c_ik^2 |
//!
//! All values are held in units of 2^exponent, in which the largest of them is of order one.

use crate::design::{CheckPoint, Design, Line};
use crate::scale::{exponent, times_power_of_two};

/// A response rounded in its last bits has this many eps of spread without depending on anything.
const NOISE_IN_EPS: f64 = 4.0;

/// The sections of one output.
#[derive(Debug, Clone)]
pub(crate) struct Sections {
    /// Stored values are the true ones divided by 2^exponent.
    pub(crate) exponent: i32,
    /// h0
    pub(crate) centre: f64,
    /// max |h| on the lines
    pub(crate) largest: f64,
    /// dbar_i
    pub(crate) shifts: Vec<f64>,
    /// v_i
    pub(crate) variances: Vec<f64>,
    /// The part of v_i in the highest modes (see [`modes_dropped`]); `None` if the rule is too small to tell.
    pub(crate) tails: Option<Vec<f64>>,
    /// d_ij by line and node
    differences: Vec<Vec<f64>>,
}

impl Sections {
    /// From the values of one output at the points of the design, all finite on the lines.
    pub(crate) fn new(design: &Design, values: &[f64]) -> Self {
        let on_lines = || design.lines().iter().flat_map(Line::ordinals).chain([&0]);
        let largest = on_lines().fold(0.0f64, |max, &k| max.max(values[k].abs()));
        let exponent = exponent(largest);
        let scaled = |k: usize| times_power_of_two(values[k], -exponent);
        let centre = scaled(0);
        let differences: Vec<Vec<f64>> = design
            .lines()
            .iter()
            .map(|line| {
                line.ordinals()
                    .iter()
                    .map(|&k| scaled(k) - centre)
                    .collect()
            })
            .collect();
        let moments: Vec<(f64, f64)> = design
            .lines()
            .iter()
            .zip(&differences)
            .map(|(line, d)| moments(&line.rule().weights, d))
            .collect();
        Self {
            exponent,
            centre,
            largest: times_power_of_two(largest, -exponent),
            shifts: moments.iter().map(|&(shift, _)| shift).collect(),
            variances: moments.iter().map(|&(_, variance)| variance).collect(),
            tails: tails(design.lines(), &differences, &moments),
            differences,
        }
    }

    /// n
    pub(crate) fn inputs(&self) -> usize {
        self.variances.len()
    }

    /// rho_i
    pub(crate) fn section_mean(&self, input: usize) -> f64 {
        self.centre + self.shifts[input]
    }

    /// sqrt(sum v): the standard deviation the lines show.
    pub(crate) fn spread(&self) -> f64 {
        self.variances.iter().sum::<f64>().sqrt()
    }

    /// eps max|h| / sqrt(sum v): the error that the rounding of the model itself leaves in any index, at most 1.
    pub(crate) fn floor(&self) -> f64 {
        let floor = f64::EPSILON * self.largest / self.spread();
        if floor < 1.0 { floor } else { 1.0 }
    }

    /// Whether the lines vary by more than a model rounds.
    pub(crate) fn varies(&self) -> bool {
        self.spread() > self.noise()
    }

    /// What a model of a few operations may round by.
    pub(crate) fn noise(&self) -> f64 {
        NOISE_IN_EPS * f64::EPSILON * self.largest
    }

    /// The first input along whose line the output takes both signs, or touches zero.
    pub(crate) fn sign_change(&self) -> Option<usize> {
        let sign = |h: f64| (h > 0.0, h < 0.0);
        let changes = |d: &Vec<f64>| d.iter().any(|d| sign(self.centre + d) != sign(self.centre));
        self.differences.iter().position(changes)
    }

    /// d_i at the coordinates of a check point, input by input.
    pub(crate) fn differences_at<'a>(
        &'a self,
        check: &'a CheckPoint,
    ) -> impl Iterator<Item = f64> + 'a {
        self.differences
            .iter()
            .zip(check.nodes())
            .map(|(d, &j)| d[j])
    }
}

/// (dbar, v) in two passes.
fn moments(weights: &[f64], d: &[f64]) -> (f64, f64) {
    let shift: f64 = weights.iter().zip(d).map(|(w, d)| w * d).sum();
    let variance = weights
        .iter()
        .zip(d)
        .map(|(w, d)| w * (d - shift) * (d - shift))
        .sum();
    (shift, variance)
}

/// How many of the N - 1 modes that a rule resolves count as its unreliable end: two, because a section even or odd
/// about the mean leaves every second mode empty and the last one alone would then report no error at all. A
/// three-point rule has but two modes and gives up one; smaller rules cannot tell.
fn modes_dropped(nodes: usize) -> Option<usize> {
    match nodes {
        0..=2 => None,
        3 => Some(1),
        _ => Some(2),
    }
}

fn tails(lines: &[Line], differences: &[Vec<f64>], moments: &[(f64, f64)]) -> Option<Vec<f64>> {
    let tail = |((line, d), &(_, variance)): ((&Line, &Vec<f64>), &(f64, f64))| {
        let n = line.rule().len();
        let dropped = modes_dropped(n)?;
        let squares = (n - dropped..n).map(|k| line.rule().coefficient(k, d).powi(2));
        // Rounding must not let the part exceed the whole.
        Some(squares.sum::<f64>().min(variance))
    };
    lines
        .iter()
        .zip(differences)
        .zip(moments)
        .map(tail)
        .collect()
}

#[cfg(test)]
mod tests {
    use rand_chacha::ChaCha8Rng;
    use rand_chacha::rand_core::SeedableRng;

    use super::*;
    use crate::distribution::Distribution;

    fn sections(nodes: usize, model: impl Fn(&[f64]) -> f64) -> Sections {
        let inputs = [
            Distribution::normal(0.0, 1.0).unwrap(),
            Distribution::uniform(-1.0, 1.0).unwrap(),
        ];
        let design = Design::new(&inputs, nodes, 0, &mut ChaCha8Rng::seed_from_u64(1)).unwrap();
        let values: Vec<f64> = design.points().iter().map(|x| model(x)).collect();
        Sections::new(&design, &values)
    }

    #[test]
    fn moments_of_a_polynomial_are_exact() {
        let s = sections(5, |x| 3.0 + x[0] * x[0] + 2.0 * x[1]);
        let unit = 2f64.powi(s.exponent);
        assert!((s.section_mean(0) * unit - 4.0).abs() < 1e-14);
        assert!((s.section_mean(1) * unit - 3.0).abs() < 1e-14);
        assert!((s.variances[0] * unit * unit - 2.0).abs() < 1e-13);
        assert!((s.variances[1] * unit * unit - 4.0 / 3.0).abs() < 1e-14);
    }

    #[test]
    fn a_constant_far_from_zero_costs_no_digits_of_the_variance() {
        let offset = 2f64.powi(30);
        // offset and section are exact in double precision, so only the centred form keeps v exact
        let s = sections(3, |x| offset + (x[1] * 1024.0).round());
        let unit = 2f64.powi(s.exponent);
        let node = (0.6f64.sqrt() * 1024.0).round();
        let expected = node * node * 5.0 / 9.0;
        assert!((s.variances[1] * unit * unit / expected - 1.0).abs() < 1e-14);
    }

    #[test]
    fn tails_see_the_modes_a_rule_barely_resolves() {
        // He_4 / sqrt(24) has unit variance, all of it in the fourth mode
        let fourth = |x: &[f64]| (x[0].powi(4) - 6.0 * x[0] * x[0] + 3.0) / 24f64.sqrt();
        let s = sections(5, fourth);
        assert!((s.tails.as_ref().unwrap()[0] / s.variances[0] - 1.0).abs() < 1e-13);
        let s = sections(7, fourth);
        assert!(s.tails.as_ref().unwrap()[0] / s.variances[0] < 1e-26);
        assert!(sections(2, fourth).tails.is_none());
    }

    #[test]
    fn signs_and_zeros_along_a_line_are_seen() {
        assert_eq!(sections(5, |x| 4.0 + x[0]).sign_change(), None);
        assert_eq!(sections(5, |x| 0.5 + x[1]).sign_change(), Some(1));
        assert_eq!(sections(5, |x| x[0] * x[0]).sign_change(), Some(0));
        assert_eq!(sections(5, |_| 0.0).sign_change(), None);
    }

    #[test]
    fn rounding_noise_is_no_variation() {
        assert!(!sections(5, |_| 7.0).varies());
        assert!(!sections(5, |x| if x[0] > 0.0 { 1.0 + f64::EPSILON } else { 1.0 }).varies());
        assert!(sections(5, |x| 1.0 + 1e-14 * x[0]).varies());
        assert_eq!(sections(5, |_| 0.0).floor(), 1.0);
    }
}
