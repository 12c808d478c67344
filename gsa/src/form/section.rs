//! Sections of an output on the cut lines: the mean and variance of each, free of cancellation.
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
use crate::form::refinement::{self, Level};
use crate::form::scale::{exponent, times_power_of_two};
use crate::form::spectrum::{Tail, tail};
use crate::law::distribution::Distribution;

/// A response rounded in its last bits has this many eps of spread without depending on anything.
const NOISE_IN_EPS: f64 = 4.0;
/// A section is refitted from what is left of its nodes if these are enough to judge it by.
const LEAST_NODES: usize = 3;

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
    /// Share of v_i that the rule misses; `None` if a rule is too small to tell.
    pub(crate) missing: Option<Vec<f64>>,
    /// Points on the lines that gave no number, whose values were taken from their lines' other nodes.
    pub(crate) lost: Vec<usize>,
    /// d_i at the nodes of all lines of an input, in the order they were added
    differences: Vec<Vec<f64>>,
    /// places where those of the present line begin
    present: Vec<usize>,
}

impl Sections {
    /// Computes the sections from the values of one output at the points of the design.
    ///
    /// # Errors
    /// The point without whose value there is no analysis: the cut point, or a node of a line that has lost too many.
    pub(crate) fn new(design: &Design, values: &[f64]) -> Result<Self, usize> {
        if !values[0].is_finite() {
            return Err(0);
        }
        let inputs = design.lines().len();
        let on_lines =
            (0..inputs).flat_map(|input| design.lines_of(input).flat_map(Line::ordinals));
        let largest = on_lines
            .chain([&0])
            .map(|&k| values[k].abs())
            .filter(|h| h.is_finite())
            .fold(0.0f64, f64::max);
        let exponent = exponent(largest);
        let centre = times_power_of_two(values[0], -exponent);
        let mut lost = Vec::new();
        let mut differences = vec![Vec::new(); inputs];
        for (input, known) in differences.iter_mut().enumerate() {
            for line in design.lines_of(input) {
                let scaled = |&k: &usize| times_power_of_two(values[k], -exponent) - centre;
                let mut d: Vec<f64> = line.ordinals().iter().map(scaled).collect();
                restore(line, &mut d, &mut lost)?;
                known.extend(d);
            }
        }
        let mut sections = Self {
            exponent,
            centre,
            largest: times_power_of_two(largest, -exponent),
            shifts: Vec::with_capacity(inputs),
            variances: Vec::with_capacity(inputs),
            missing: Some(Vec::with_capacity(inputs)),
            lost: Vec::new(),
            differences,
            present: (0..inputs)
                .map(|input| design.nodes_before(input))
                .collect(),
        };
        let stopping = refinement::stopping(design.is_refined_on_demand());
        for (input, law) in design.inputs().iter().enumerate() {
            let lines: Vec<&Line> = design.lines_of(input).collect();
            sections.add_moments((input, law), &lines, &lost, stopping);
        }
        sections.lost = lost;
        Ok(sections)
    }

    fn add_moments(
        &mut self,
        (input, law): (usize, &Distribution),
        lines: &[&Line],
        lost: &[usize],
        stopping: f64,
    ) {
        let line = lines[lines.len() - 1];
        let (shift, variance) = moments(&line.rule().weights, self.differences(input));
        let levels = self.levels((input, law), lines, variance, lost);
        let missing = levels.and_then(|levels| {
            let (finest, coarser) = levels.split_last()?;
            Some(finest.missing(coarser, stopping))
        });
        self.shifts.push(shift);
        self.variances.push(variance);
        self.missing = self.missing.take().and_then(|mut shares| {
            shares.push(missing?);
            Some(shares)
        });
    }

    /// Returns what each of an input's lines shows; `None` if one is too small to tell.
    fn levels(
        &self,
        (input, law): (usize, &Distribution),
        lines: &[&Line],
        variance: f64,
        lost: &[usize],
    ) -> Option<Vec<Level>> {
        let (low, high) = law.support();
        let is_bounded = low.is_finite() && high.is_finite();
        let mut from = 0;
        let of_line = |line: &&Line| {
            let nodes = line.rule().len();
            let d = &self.differences[input][from..from + nodes];
            from += nodes;
            let (_, seen) = moments(&line.rule().weights, d);
            let error = (seen - variance).abs() / variance;
            tail_of(line, d, lost).map(|tail| Level {
                nodes,
                is_bounded,
                tail,
                error,
            })
        };
        lines.iter().map(of_line).collect()
    }

    /// n
    pub(crate) fn inputs(&self) -> usize {
        self.variances.len()
    }

    /// sqrt(sum v): the standard deviation the lines show.
    pub(crate) fn spread(&self) -> f64 {
        self.variances.iter().sum::<f64>().sqrt()
    }

    /// eps max|h| / sqrt(sum v), the error that the rounding of the model itself leaves in any index, and an eps for each
    /// term of the sums; at most 1.
    pub(crate) fn floor(&self) -> f64 {
        self.floor_for(self.spread())
    }

    /// [`Sections::floor`] where the output's standard deviation is another than the lines show.
    pub(crate) fn floor_for(&self, deviation: f64) -> f64 {
        let sums = (self.inputs() + 4) as f64;
        let floor = f64::EPSILON * (self.largest / deviation + sums);
        if floor < 1.0 { floor } else { 1.0 }
    }

    /// Whether the lines vary by more than a model rounds.
    pub(crate) fn varies(&self) -> bool {
        self.spread() > self.noise()
    }

    /// Returns the rounding that a model of a few operations may have.
    pub(crate) fn noise(&self) -> f64 {
        NOISE_IN_EPS * f64::EPSILON * self.largest
    }

    /// Inputs along whose lines the output varies by no more than a model rounds.
    pub(crate) fn flat(&self) -> Vec<usize> {
        let is_flat = |input: &usize| self.variances[*input].sqrt() <= self.noise();
        (0..self.inputs()).filter(is_flat).collect()
    }

    /// The first input along whose line the output takes both signs, or touches zero.
    pub(crate) fn sign_change(&self) -> Option<usize> {
        let sign = |h: f64| (h > 0.0, h < 0.0);
        let changes = |d: &Vec<f64>| d.iter().any(|d| sign(self.centre + d) != sign(self.centre));
        self.differences.iter().position(changes)
    }

    /// d_ij at the nodes of line i.
    pub(crate) fn differences(&self, input: usize) -> &[f64] {
        &self.differences[input][self.present[input]..]
    }

    /// d_i at the coordinates of a check point, input by input.
    pub(crate) fn differences_at<'a>(
        &'a self,
        check: &'a CheckPoint,
    ) -> impl Iterator<Item = f64> + 'a {
        check
            .nodes()
            .iter()
            .enumerate()
            .map(|(input, &j)| self.difference_at(input, j))
    }

    /// d_i at a node, counted through the lines of the input.
    pub(crate) fn difference_at(&self, input: usize, node: usize) -> f64 {
        self.differences[input][node]
    }

    /// Counts the nodes at which d_i is known.
    pub(crate) fn known(&self, input: usize) -> usize {
        self.differences[input].len()
    }
}

fn tail_of(line: &Line, d: &[f64], lost: &[usize]) -> Option<Tail> {
    let restored = line.ordinals().iter().filter(|k| lost.contains(k)).count();
    let energies: Vec<f64> = (1..line.rule().len() - restored)
        .map(|k| line.rule().coefficient(k, d).powi(2))
        .collect();
    tail(&energies, restored == 0)
}

/// Puts in, for nodes without a number, the polynomial through the others, and names them in `lost`.
fn restore(line: &Line, d: &mut [f64], lost: &mut Vec<usize>) -> Result<(), usize> {
    if d.iter().all(|d| d.is_finite()) {
        return Ok(());
    }
    let known: Vec<usize> = (0..d.len()).filter(|&j| d[j].is_finite()).collect();
    for j in (0..d.len()).filter(|j| !known.contains(j)) {
        if known.len() < LEAST_NODES {
            return Err(line.ordinals()[j]);
        }
        let xi = |j: usize| line.coordinate(line.rule().nodes[j]);
        let share = |&k: &usize| {
            let others = known.iter().filter(|&&l| l != k);
            others.fold(1.0, |share, &l| share * (xi(j) - xi(l)) / (xi(k) - xi(l)))
        };
        d[j] = known.iter().map(|k| share(k) * d[*k]).sum();
        lost.push(line.ordinals()[j]);
    }
    Ok(())
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

#[cfg(test)]
mod tests {
    use rand_chacha::ChaCha8Rng;
    use rand_chacha::rand_core::SeedableRng;

    use super::*;

    fn sections(nodes: usize, model: impl Fn(&[f64]) -> f64) -> Sections {
        let inputs = [
            Distribution::normal(0.0, 1.0).unwrap(),
            Distribution::uniform(-1.0, 1.0).unwrap(),
        ];
        let design = Design::new(&inputs, nodes, 0, &mut ChaCha8Rng::seed_from_u64(1)).unwrap();
        let values: Vec<f64> = design.points().iter().map(|x| model(x)).collect();
        Sections::new(&design, &values).unwrap()
    }

    #[test]
    fn moments_of_a_polynomial_are_exact() {
        let s = sections(5, |x| 3.0 + x[0] * x[0] + 2.0 * x[1]);
        let unit = 2f64.powi(s.exponent);
        assert!(((s.centre + s.shifts[0]) * unit - 4.0).abs() < 1e-14);
        assert!(((s.centre + s.shifts[1]) * unit - 3.0).abs() < 1e-14);
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
    fn a_lost_node_is_taken_from_the_others() {
        let inputs = [Distribution::uniform(-1.0, 1.0).unwrap(); 2];
        let design = Design::new(&inputs, 5, 0, &mut ChaCha8Rng::seed_from_u64(1)).unwrap();
        let run = |x: &[f64]| 2.0 + x[0] + 0.1 * x[0].powi(2) + 0.01 * x[0].powi(3) - x[1];
        let mut values: Vec<f64> = design.points().iter().map(|x| run(x)).collect();
        let whole = Sections::new(&design, &values).unwrap();
        let ordinals = design.lines()[0].ordinals();
        values[ordinals[4]] = f64::NAN;
        // four nodes still hold a cubic
        let less = Sections::new(&design, &values).unwrap();
        assert!((less.variances[0] / whole.variances[0] - 1.0).abs() < 1e-13);
        assert_eq!(less.lost, [ordinals[4]]);
        assert!(less.missing.unwrap()[0] > whole.missing.unwrap()[0]);
        values[ordinals[0]] = f64::INFINITY;
        values[ordinals[1]] = f64::INFINITY;
        assert_eq!(Sections::new(&design, &values).unwrap_err(), ordinals[0]);
        values[0] = f64::NAN;
        assert_eq!(Sections::new(&design, &values).unwrap_err(), 0);
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
