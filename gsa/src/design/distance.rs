//! Distance of points from the cut, in the coordinates of the rules: deviations of each law, of ln x for lognormal ones.

use super::{CheckPoint, Design};
use crate::design::node_grid::Grid;
use crate::law::rule::GaussRule;

impl Design {
    /// The grid of the present lines.
    pub(super) fn grid<'a>(&self, rules: &'a [&'a GaussRule]) -> Grid<'a> {
        let of_input = |(input, rule): (usize, &&GaussRule)| {
            let nodes = rule.nodes.iter();
            nodes.map(|&x| self.distance(input, x)).collect()
        };
        let distances: Vec<Vec<f64>> = rules.iter().enumerate().map(of_input).collect();
        Grid::new(rules, &self.points[0], &distances)
    }

    /// Factor from a mean of squared residuals over the check points to their mean over the law, for residuals that are interactions
    /// of `order` inputs and grow with the distances: the mean of d_i d_j .. by the law over that at the points, each over all
    /// choices of inputs. Interactions of more inputs get too large a factor; there are none of more inputs than the model has.
    pub(crate) fn weight_of_interactions(&self, order: usize) -> f64 {
        let by_law = |input: usize| {
            let rule = self.lines[input].rule();
            let terms = rule.nodes.iter().zip(&rule.weights);
            terms.map(|(&x, w)| w * self.distance(input, x)).sum()
        };
        let expected: Vec<f64> = (0..self.lines.len()).map(by_law).collect();
        let expected = mean_of_products(&expected, order);
        let at = |check: &CheckPoint| {
            let x = self.points[check.ordinal].iter().enumerate();
            let distances: Vec<f64> = x.map(|(input, &x)| self.distance(input, x)).collect();
            mean_of_products(&distances, order)
        };
        let seen = self.checks.iter().map(at).sum::<f64>() / self.checks.len() as f64;
        if seen > 0.0 {
            expected / seen
        } else {
            expected
        }
    }

    fn distance(&self, input: usize, x: f64) -> f64 {
        let (line, cut) = (&self.lines[input], self.points[0][input]);
        // Not from equal coordinates alone: these may round to the same.
        if x == cut {
            0.0
        } else {
            (line.coordinate(x) - line.coordinate(cut)).abs()
        }
    }
}

/// Mean over all choices of `order` numbers of their product; zero if there are too few.
fn mean_of_products(d: &[f64], order: usize) -> f64 {
    // means over the choices of 0, 1, .. of the numbers so far: the last of m is among k with probability k/m
    let mut means = vec![0.0; order + 1];
    means[0] = 1.0;
    for (before, d) in d.iter().enumerate() {
        for k in (1..=order.min(before + 1)).rev() {
            let share = k as f64 / (before + 1) as f64;
            means[k] = share * d * means[k - 1] + (1.0 - share) * means[k];
        }
    }
    means[order]
}

#[cfg(test)]
mod tests {
    use rand_chacha::ChaCha8Rng;
    use rand_chacha::rand_core::SeedableRng;

    use super::*;
    use crate::law::distribution::Distribution;

    #[test]
    fn choices_are_counted_once() {
        let mean = |order| mean_of_products(&[2.0, 3.0, 5.0, 7.0], order);
        // 6 + 10 + 14 + 15 + 21 + 35 of six pairs, 30 + 42 + 70 + 105 of four triples
        assert!((mean(2) - 101.0 / 6.0).abs() < 1e-13);
        assert!((mean(3) - 247.0 / 4.0).abs() < 1e-13);
        assert_eq!(mean_of_products(&[2.0], 2), 0.0);
    }

    /// |x| of a standard normal at three nodes is 0 or sqrt(3), the latter in one of three: 1/sqrt(3) on average.
    #[test]
    fn the_weight_is_that_of_an_interaction_that_grows_with_the_distances() {
        let inputs = [Distribution::normal(1.0, 2.0).unwrap(); 2];
        let design = Design::new(&inputs, 3, 4, &mut ChaCha8Rng::seed_from_u64(1)).unwrap();
        // All four corners: the square of a residual of d_1 d_2 is three there, and a third by the law.
        assert!((design.weight_of_interactions(2) - 1.0 / 9.0).abs() < 1e-14);
        let none = Design::new(&inputs, 3, 0, &mut ChaCha8Rng::seed_from_u64(1)).unwrap();
        assert!((none.weight_of_interactions(2) - 1.0 / 3.0).abs() < 1e-14);
    }
}
