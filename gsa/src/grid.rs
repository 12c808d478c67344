//! Off-axis check points: where on the tensor grid of the Gauss nodes a form is tested against the model.
//!
//! A check point sits on the grid because there the reduced form costs nothing: its sections are already known. It
//! leaves the cut in at least two coordinates, since on the cut lines every form agrees with the model. Two of three points
//! leave it in all: a triple interaction that vanishes at the cut shows nowhere else, and of five normal inputs at five nodes
//! only one point in forty, drawn by weight alone, would. Every third point is drawn by weight alone: without coordinates at
//! the cut, modes of an interaction that are even there can't be told apart.

use std::collections::HashSet;

use rand::Rng;

use crate::rule::GaussRule;

/// Every so manieth point is drawn by weight alone.
const BY_WEIGHT: usize = 3;
/// Draws by weight before the grid is walked instead: rare points of a nearly used-up grid would take for ever.
const DRAWS_BEFORE_WALK: usize = 256;

/// The grid of all node combinations, and which node of each input (if any) coincides with the cut.
pub(crate) struct Grid<'a> {
    rules: &'a [&'a GaussRule],
    centre: Vec<Option<usize>>,
}

impl<'a> Grid<'a> {
    pub(crate) fn new(rules: &'a [&'a GaussRule], cut: &[f64]) -> Self {
        let centre = rules
            .iter()
            .zip(cut)
            .map(|(rule, c)| rule.nodes.iter().position(|x| x == c))
            .collect();
        Self { rules, centre }
    }

    /// Distinct off-axis combinations of node indices, none of them `seen`, at most `wanted` and as many as there are.
    /// Coordinates are drawn with their rule's weights, those of two points in three off the cut.
    pub(crate) fn off_axis(
        &self,
        wanted: usize,
        mut seen: HashSet<Vec<usize>>,
        rng: &mut impl Rng,
    ) -> Vec<Vec<usize>> {
        let count = wanted.min(self.off_axis_len() - seen.len());
        let mut points = Vec::with_capacity(count);
        while points.len() < count {
            let by_weight = seen.len() % BY_WEIGHT == BY_WEIGHT - 1;
            let mut point = self.draw(by_weight, rng);
            let mut draws = 1;
            while !self.is_off_axis(&point) || seen.contains(&point) {
                if draws < DRAWS_BEFORE_WALK {
                    point = self.draw(by_weight, rng);
                    draws += 1;
                } else {
                    self.step(&mut point);
                }
            }
            seen.insert(point.clone());
            points.push(point);
        }
        points
    }

    /// Number of off-axis combinations, saturating: all of them but the cut point and the lines, where those are on
    /// the grid.
    pub(crate) fn off_axis_len(&self) -> usize {
        // ways to choose coordinates so far with none, or exactly one, of them off the cut
        let (mut none_off, mut one_off, mut all) = (1usize, 0usize, 1usize);
        for (rule, centre) in self.rules.iter().zip(&self.centre) {
            let on = usize::from(centre.is_some());
            one_off = one_off * on + none_off * (rule.len() - on);
            none_off *= on;
            all = all.saturating_mul(rule.len());
        }
        all - none_off - one_off
    }

    /// What a mean over these points counts for in a mean over the law, if interactions are of pairs: how often two inputs
    /// are both off the cut by weight, over how often they are at the points. Of more inputs at once it counts too much.
    ///
    /// The points are given by their numbers of coordinates off the cut.
    pub(crate) fn pair_weight(&self, points: impl Iterator<Item = usize>) -> f64 {
        let off = self.rules.iter().zip(&self.centre);
        let by_weight: Vec<f64> = off
            .map(|(rule, centre)| 1.0 - centre.map_or(0.0, |j| rule.weights[j]))
            .collect();
        let (mut seen, mut count) = (0.0, 0.0);
        for off in points {
            let off = off as f64;
            let pairs = (by_weight.len() * (by_weight.len() - 1)) as f64;
            (seen, count) = (seen + off * (off - 1.0) / pairs, count + 1.0);
        }
        let expected = pairs_share(&by_weight);
        if seen > 0.0 {
            expected * count / seen
        } else {
            expected
        }
    }

    fn is_off_axis(&self, point: &[usize]) -> bool {
        let off = |(j, centre): &(&usize, &Option<usize>)| **centre != Some(**j);
        point.iter().zip(&self.centre).filter(off).count() >= 2
    }

    fn draw(&self, by_weight: bool, rng: &mut impl Rng) -> Vec<usize> {
        let rules = self.rules.iter().zip(&self.centre);
        rules
            .map(|(rule, centre)| draw_node(rule, centre.filter(|_| !by_weight), unit(rng)))
            .collect()
    }

    /// The next combination in lexicographic order, round and round.
    fn step(&self, point: &mut [usize]) {
        for (j, rule) in point.iter_mut().zip(self.rules).rev() {
            *j = (*j + 1) % rule.len();
            if *j != 0 {
                return;
            }
        }
    }
}

/// Mean over all pairs of the probability that both happen.
fn pairs_share(probabilities: &[f64]) -> f64 {
    let sums = |(s, q): (f64, f64), p: &f64| (s + p, q + p * p);
    let (sum, squares) = probabilities.iter().fold((0.0, 0.0), sums);
    let ordered = (probabilities.len() * probabilities.len().saturating_sub(1)) as f64;
    if ordered > 0.0 {
        (sum * sum - squares) / ordered
    } else {
        0.0
    }
}

/// Inverse of the rule's discrete distribution function, without the node at the cut unless there is no other.
fn draw_node(rule: &GaussRule, centre: Option<usize>, u: f64) -> usize {
    let centre = centre.filter(|_| rule.len() > 1);
    let left = 1.0 - centre.map_or(0.0, |j| rule.weights[j]);
    let (mut sum, mut last) = (0.0, 0);
    for (j, w) in rule.weights.iter().enumerate() {
        if centre == Some(j) {
            continue;
        }
        (sum, last) = (sum + w, j);
        if sum > u * left {
            break;
        }
    }
    last
}

/// Uniform on \[0, 1) from the upper 53 bits; spelled out so that a seed means the same points in every release of
/// the random number library.
fn unit(rng: &mut impl Rng) -> f64 {
    (rng.next_u64() >> 11) as f64 * (0.5 * f64::EPSILON)
}

#[cfg(test)]
mod tests {
    use rand_chacha::ChaCha8Rng;
    use rand_chacha::rand_core::SeedableRng;

    use super::*;
    use crate::distribution::Distribution;

    fn rules(sizes: &[usize]) -> Vec<GaussRule> {
        let law = Distribution::normal(0.0, 1.0).unwrap();
        sizes.iter().map(|&n| law.gauss_rule(n).unwrap()).collect()
    }

    #[test]
    fn nodes_are_drawn_with_their_weights() {
        let rule = &rules(&[5])[0];
        let mut rng = ChaCha8Rng::seed_from_u64(1);
        let draws = 100_000;
        let mut hits = [0.0; 5];
        for _ in 0..draws {
            hits[draw_node(rule, None, unit(&mut rng))] += 1.0;
        }
        for (hit, w) in hits.iter().zip(&rule.weights) {
            let deviation = (w * (1.0 - w) / f64::from(draws)).sqrt();
            // five binomial standard deviations: one false alarm in a million
            assert!((hit / f64::from(draws) - w).abs() < 5.0 * deviation);
        }
        assert_eq!(draw_node(rule, None, 0.0), 0);
        assert_eq!(draw_node(rule, Some(0), 0.0), 1);
        assert_eq!(draw_node(rule, Some(4), 1.0 - f64::EPSILON), 3);
        assert_eq!(draw_node(rule, None, 1.0 - 0.5 * f64::EPSILON), 4);
    }

    #[test]
    fn a_used_up_grid_gives_every_point_once() {
        let rules = rules(&[3, 5, 3]);
        let rules: Vec<&GaussRule> = rules.iter().collect();
        let grid = Grid::new(&rules, &[0.0; 3]);
        // 45 combinations less the cut point and 2 + 4 + 2 on the lines
        assert_eq!(grid.off_axis_len(), 36);
        let points = grid.off_axis(1000, HashSet::new(), &mut ChaCha8Rng::seed_from_u64(7));
        assert_eq!(points.len(), 36);
        assert_eq!(points.iter().collect::<HashSet<_>>().len(), 36);
        assert!(points.iter().all(|point| grid.is_off_axis(point)));
        // nodes off the centre: 2 of 3, 4 of 5, 2 of 3
        let all_off = |point: &Vec<usize>| point[0] != 1 && point[1] != 2 && point[2] != 1;
        for (k, point) in points[..12].iter().enumerate() {
            assert!(k % 3 == 2 || all_off(point), "{k} {point:?}");
        }
        assert!(!points[..12].iter().all(all_off));
        // 1/3 and 7/15 of the normal law's weight: He_3 and He_5
        let pairs = (2.0 * (1.0 / 3.0) * (7.0 / 15.0) + 1.0 / 9.0) / 3.0;
        let weight = |off: &[usize]| grid.pair_weight(off.iter().copied());
        assert!((weight(&[3, 3]) - pairs).abs() < 1e-14);
        // two of three coordinates off are one pair of three
        assert!((weight(&[2]) - 3.0 * pairs).abs() < 1e-14);
        assert!((weight(&[2, 3]) - 1.5 * pairs).abs() < 1e-14);
        assert!((weight(&[]) - pairs).abs() < 1e-14);
    }

    #[test]
    fn a_cut_off_the_grid_leaves_every_combination() {
        let rules = rules(&[3, 3]);
        let rules: Vec<&GaussRule> = rules.iter().collect();
        assert_eq!(Grid::new(&rules, &[0.1, 0.1]).off_axis_len(), 9);
        assert_eq!(Grid::new(&rules, &[0.0, 0.1]).off_axis_len(), 6);
    }

    #[test]
    fn one_input_has_no_off_axis_points() {
        let rules = rules(&[5]);
        let rules: Vec<&GaussRule> = rules.iter().collect();
        for cut in [0.0, 0.1] {
            assert_eq!(Grid::new(&rules, &[cut]).off_axis_len(), 0);
            assert!(
                Grid::new(&rules, &[cut])
                    .off_axis(4, HashSet::new(), &mut ChaCha8Rng::seed_from_u64(7))
                    .is_empty()
            );
        }
    }

    #[test]
    fn huge_grids_do_not_overflow() {
        let rules = rules(&[64; 50]);
        let rules: Vec<&GaussRule> = rules.iter().collect();
        let points = Grid::new(&rules, &[0.0; 50]).off_axis(
            10,
            HashSet::new(),
            &mut ChaCha8Rng::seed_from_u64(3),
        );
        assert_eq!(points.len(), 10);
    }
}
