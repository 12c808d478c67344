//! Off-axis check points: where on the tensor grid of the Gauss nodes a form is tested against the model.
//!
//! A check point sits on the grid because there the reduced form costs nothing: its sections are already known. It
//! leaves the cut in at least two coordinates, since on the cut lines every form agrees with the model. Two of three points
//! leave it in all: a triple interaction that vanishes at the cut shows nowhere else, and of five normal inputs at five nodes
//! only one point in forty, drawn by weight alone, would. Their coordinates are drawn by the weight times the distance from the cut,
//! as interactions vanish there and are largest far out, where weights alone would seldom lead. Every third point is drawn by
//! weight alone: without coordinates at the cut, modes of an interaction that are even there can't be told apart.
//!
//! The points drawn at once are a Latin hypercube in each of these kinds: few as they are, they visit every input's nodes evenly.

use std::collections::HashSet;

use rand::Rng;

use crate::law::rule::GaussRule;

/// Number of points of which one is drawn by weight alone.
const BY_WEIGHT: usize = 3;
/// Draws by weight before the grid is walked instead: rare points of a nearly used-up grid would take for ever.
const DRAWS_BEFORE_WALK: usize = 256;

/// The grid of all node combinations, and which node of each input (if any) coincides with the cut.
pub(crate) struct Grid<'a> {
    rules: &'a [&'a GaussRule],
    centre: Vec<Option<usize>>,
    /// share by input and node of the draws among those off the cut
    shares: Vec<Vec<f64>>,
}

impl<'a> Grid<'a> {
    /// `distances`: of the nodes from the cut, by input.
    pub(crate) fn new(rules: &'a [&'a GaussRule], cut: &[f64], distances: &[Vec<f64>]) -> Self {
        let share = |(rule, d): (&&GaussRule, &Vec<f64>)| match rule.len() {
            1 => vec![1.0],
            _ => rule.weights.iter().zip(d).map(|(w, d)| w * d).collect(),
        };
        let centre = rules
            .iter()
            .zip(cut)
            .map(|(rule, c)| rule.nodes.iter().position(|x| x == c))
            .collect();
        Self {
            rules,
            centre,
            shares: rules.iter().zip(distances).map(share).collect(),
        }
    }

    /// Distinct off-axis combinations of node indices, none of them `seen`, at most `wanted` and as many as there are.
    /// Two points in three leave the cut in all coordinates.
    pub(crate) fn off_axis(
        &self,
        wanted: usize,
        mut seen: HashSet<Vec<usize>>,
        rng: &mut impl Rng,
    ) -> Vec<Vec<usize>> {
        let count = wanted.min(self.off_axis_len() - seen.len());
        let by_weight: Vec<bool> = (seen.len()..seen.len() + count)
            .map(|k| k % BY_WEIGHT == BY_WEIGHT - 1)
            .collect();
        let strata = self.strata(&by_weight, rng);
        let mut points = Vec::with_capacity(count);
        for (by_weight, u) in by_weight.into_iter().zip(strata) {
            let mut point = self.place(by_weight, u.into_iter());
            let mut draws = 1;
            while !self.is_off_axis(&point) || seen.contains(&point) {
                if draws < DRAWS_BEFORE_WALK {
                    let u: Vec<f64> = self.rules.iter().map(|_| unit(rng)).collect();
                    point = self.place(by_weight, u.into_iter());
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

    fn is_off_axis(&self, point: &[usize]) -> bool {
        let off = |(j, centre): &(&usize, &Option<usize>)| **centre != Some(**j);
        point.iter().zip(&self.centre).filter(off).count() >= 2
    }

    /// A probability for every point and input: a Latin hypercube of each of the two kinds of points.
    fn strata(&self, by_weight: &[bool], rng: &mut impl Rng) -> Vec<Vec<f64>> {
        let [mut off, mut weighted] = [false, true].map(|kind| {
            let count = by_weight.iter().filter(|other| **other == kind).count();
            latin_hypercube(count, self.rules.len(), rng).into_iter()
        });
        let next = |by_weight: &bool| {
            if *by_weight {
                weighted.next()
            } else {
                off.next()
            }
        };
        by_weight.iter().filter_map(next).collect()
    }

    /// The nodes at these probabilities, by weight or off the cut.
    fn place(&self, by_weight: bool, u: impl Iterator<Item = f64>) -> Vec<usize> {
        let rules = self.rules.iter().zip(&self.shares).zip(u);
        rules
            .map(|((rule, shares), u)| draw_node(if by_weight { &rule.weights } else { shares }, u))
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

/// Points of the unit cube of which each coordinate has one in every stratum, one of `count` equal parts of \[0, 1).
pub(crate) fn latin_hypercube(count: usize, inputs: usize, rng: &mut impl Rng) -> Vec<Vec<f64>> {
    let mut points = vec![Vec::with_capacity(inputs); count];
    for _ in 0..inputs {
        let mut left: Vec<usize> = (0..count).collect();
        for stratum in 0..count {
            let drawn = (unit(rng) * left.len() as f64) as usize;
            let u = (stratum as f64 + unit(rng)) / count as f64;
            points[left.swap_remove(drawn)].push(u);
        }
    }
    points
}

/// Inverse of a discrete distribution function.
fn draw_node(shares: &[f64], u: f64) -> usize {
    let whole: f64 = shares.iter().sum();
    let (mut sum, mut last) = (0.0, 0);
    for (j, w) in shares.iter().enumerate().filter(|(_, w)| **w > 0.0) {
        (sum, last) = (sum + w, j);
        if sum > u * whole {
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
    use crate::law::distribution::Distribution;

    fn rules(sizes: &[usize]) -> Vec<GaussRule> {
        let law = Distribution::normal(0.0, 1.0).unwrap();
        sizes.iter().map(|&n| law.gauss_rule(n).unwrap()).collect()
    }

    /// Returns the distances of the nodes from zero.
    fn distances(rules: &[&GaussRule]) -> Vec<Vec<f64>> {
        let of_rule = |rule: &&GaussRule| rule.nodes.iter().map(|x| x.abs()).collect();
        rules.iter().map(of_rule).collect()
    }

    #[test]
    fn few_points_visit_all_nodes_evenly() {
        // Nodes of 0 and +-sqrt(3): off the cut half of the points are on either side.
        let rules = rules(&[3; 12]);
        let rules: Vec<&GaussRule> = rules.iter().collect();
        let grid = Grid::new(&rules, &[0.0; 12], &distances(&rules));
        for seed in 0..20 {
            let mut rng = ChaCha8Rng::seed_from_u64(seed);
            let points = grid.off_axis(6, HashSet::new(), &mut rng);
            for input in 0..12 {
                let above = (0..6).filter(|k| k % 3 != 2 && points[*k][input] == 2);
                assert_eq!(above.count(), 2, "{points:?}");
            }
        }
    }

    #[test]
    fn nodes_are_drawn_with_their_weights() {
        let rule = &rules(&[5])[0];
        let mut rng = ChaCha8Rng::seed_from_u64(1);
        let draws = 100_000;
        let mut hits = [0.0; 5];
        for _ in 0..draws {
            hits[draw_node(&rule.weights, unit(&mut rng))] += 1.0;
        }
        for (hit, w) in hits.iter().zip(&rule.weights) {
            let deviation = (w * (1.0 - w) / f64::from(draws)).sqrt();
            // five binomial standard deviations: one false alarm in a million
            assert!((hit / f64::from(draws) - w).abs() < 5.0 * deviation);
        }
        assert_eq!(draw_node(&rule.weights, 0.0), 0);
        assert_eq!(draw_node(&rule.weights, 1.0 - 0.5 * f64::EPSILON), 4);
        let shares = [0.0, 1.0, 0.0, 1.0, 0.0];
        let drawn = [0.0, 0.49, 0.51, 1.0 - f64::EPSILON].map(|u| draw_node(&shares, u));
        assert_eq!(drawn, [1, 1, 3, 3]);
    }

    #[test]
    fn a_used_up_grid_gives_every_point_once() {
        let rules = rules(&[3, 5, 3]);
        let rules: Vec<&GaussRule> = rules.iter().collect();
        let grid = Grid::new(&rules, &[0.0; 3], &distances(&rules));
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
    }

    #[test]
    fn a_cut_off_the_grid_leaves_every_combination() {
        let rules = rules(&[3, 3]);
        let rules: Vec<&GaussRule> = rules.iter().collect();
        assert_eq!(
            Grid::new(&rules, &[0.1, 0.1], &distances(&rules)).off_axis_len(),
            9
        );
        assert_eq!(
            Grid::new(&rules, &[0.0, 0.1], &distances(&rules)).off_axis_len(),
            6
        );
    }

    #[test]
    fn one_input_has_no_off_axis_points() {
        let rules = rules(&[5]);
        let rules: Vec<&GaussRule> = rules.iter().collect();
        for cut in [0.0, 0.1] {
            assert_eq!(
                Grid::new(&rules, &[cut], &distances(&rules)).off_axis_len(),
                0
            );
            assert!(
                Grid::new(&rules, &[cut], &distances(&rules))
                    .off_axis(4, HashSet::new(), &mut ChaCha8Rng::seed_from_u64(7))
                    .is_empty()
            );
        }
    }

    #[test]
    fn huge_grids_do_not_overflow() {
        let rules = rules(&[64; 50]);
        let rules: Vec<&GaussRule> = rules.iter().collect();
        let points = Grid::new(&rules, &[0.0; 50], &distances(&rules)).off_axis(
            10,
            HashSet::new(),
            &mut ChaCha8Rng::seed_from_u64(3),
        );
        assert_eq!(points.len(), 10);
    }
}
