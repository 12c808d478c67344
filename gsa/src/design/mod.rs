//! The runs to make: a cut point, one line of Gauss nodes per input through it, and off-axis check points.
//!
//! | symbol | meaning |
//! |---|---|
//! | n, N | inputs, nodes of each input's rule |
//! | c | cut point, the means unless said otherwise |
//! | line i | c with its i-th coordinate at each node of input i |
//!
//! Cost: n N + 1 runs, or n (N - 1) + 1 where a centre node is the mean itself (symmetric laws, odd N), and
//! one run for each check point.
//!
//! - [`Line`], [`CheckPoint`], `node_grid`, `distance`: the runs, and where check points are drawn
//! - `pair_grid`, `probes`: grids of pairs of inputs, and runs off all nodes
//! - `images`: points that a symmetry of the model adds without a run
//! - `sobol`: points of methods without lines

use std::collections::HashSet;

use rand::Rng;

use crate::law::distribution::Distribution;
use crate::law::polynomials::Polynomials;
use crate::law::rule::GaussRule;

mod check_point;
mod design_error;
mod distance;
mod images;
mod line;
mod node_grid;
pub(crate) mod pair_grid;
mod probes;
pub mod sobol;

pub use check_point::CheckPoint;
pub use design_error::{DesignError, MAX_CHECK_POINTS};
pub use line::Line;

/// A list of runs and what each of them is for. It only grows: a point keeps its ordinal, and the same calls with the
/// same generator state give the same design to the bit.
#[derive(Debug, Clone, PartialEq)]
pub struct Design {
    inputs: Vec<Distribution>,
    lines: Vec<Line>,
    /// Lines by input whose place a finer one has taken, in the order they were added.
    replaced: Vec<Vec<Line>>,
    checks: Vec<CheckPoint>,
    /// Points off all nodes, by ordinal.
    probes: Vec<usize>,
    points: Vec<Vec<f64>>,
    /// Number of points that are to be run: those behind them are mirror images, whose values follow.
    to_run: Option<usize>,
    on_demand: bool,
}

impl Design {
    /// The design through the means of the inputs, with `nodes` Gauss nodes along each. Fewer check points than asked
    /// come out where the grid has no more (none for a single input).
    ///
    /// # Errors
    /// No inputs, a rule that does not exist, too many check points.
    pub fn new(
        inputs: &[Distribution],
        nodes: usize,
        check_points: usize,
        rng: &mut impl Rng,
    ) -> Result<Self, DesignError> {
        let means: Vec<f64> = inputs.iter().map(Distribution::mean).collect();
        Self::with_cut(inputs, nodes, &means, check_points, rng)
    }

    /// Makes a design as [`Design::new`] does, through another cut point.
    ///
    /// # Errors
    /// As [`Design::new`], and a cut point of the wrong length or not finite.
    pub fn with_cut(
        inputs: &[Distribution],
        nodes: usize,
        cut: &[f64],
        check_points: usize,
        rng: &mut impl Rng,
    ) -> Result<Self, DesignError> {
        check_arguments(inputs, cut)?;
        let mut design = Self {
            inputs: inputs.to_vec(),
            lines: Vec::with_capacity(inputs.len()),
            replaced: vec![Vec::new(); inputs.len()],
            checks: Vec::new(),
            probes: Vec::new(),
            points: vec![cut.to_vec()],
            to_run: None,
            on_demand: false,
        };
        for input in 0..inputs.len() {
            let line = design.add_line(input, nodes)?;
            design.lines.push(line);
        }
        design.add_checks(check_points, rng)?;
        Ok(design)
    }

    /// Returns the most that the cut point and the lines cost, saturating.
    pub(crate) fn most_line_points(inputs: usize, nodes: usize) -> usize {
        inputs.saturating_mul(nodes).saturating_add(1)
    }

    /// Adds check points on the grid of the present lines, as many as asked or as it still has, and returns how many those
    /// were.
    ///
    /// # Errors
    /// More check points than [`MAX_CHECK_POINTS`].
    pub(crate) fn add_checks(
        &mut self,
        count: usize,
        rng: &mut impl Rng,
    ) -> Result<usize, DesignError> {
        let asked = self.checks.len().saturating_add(count);
        if asked > MAX_CHECK_POINTS {
            return Err(DesignError::TooManyCheckPoints { asked });
        }
        let rules = self.rules();
        let known = self.checks.iter().filter_map(|check| self.on_grid(check));
        let drawn = self.grid(&rules).off_axis(count, known.collect(), rng);
        let points: Vec<Vec<f64>> = drawn
            .iter()
            .map(|nodes| {
                let coordinates = rules.iter().zip(nodes);
                coordinates.map(|(rule, &j)| rule.nodes[j]).collect()
            })
            .collect();
        let added = drawn.len();
        // Off-axis points differ from all others in a coordinate, so none of them is a duplicate.
        for (mut nodes, point) in drawn.into_iter().zip(points) {
            for (input, node) in nodes.iter_mut().enumerate() {
                *node += self.nodes_before(input);
            }
            let ordinal = self.points.len();
            self.checks.push(CheckPoint {
                ordinal,
                nodes,
                image: None,
            });
            self.points.push(point);
        }
        Ok(added)
    }

    /// Replaces an input's line by one of more nodes. The check points stay where they are, and the old line's runs
    /// still serve them; new ones are drawn from the new line, and so test what the old nodes could not tell.
    ///
    /// # Errors
    /// A rule that does not exist.
    pub(crate) fn refine(&mut self, input: usize, nodes: usize) -> Result<(), DesignError> {
        let fine = self.add_line(input, nodes)?;
        let before = std::mem::replace(&mut self.lines[input], fine);
        self.replaced[input].push(before);
        Ok(())
    }

    /// Leaves lines as they are that don't seem to need more nodes.
    pub(crate) fn refined_on_demand(self) -> Self {
        Self {
            on_demand: true,
            ..self
        }
    }

    /// Whether lines stay as they are because their error looks small.
    pub(crate) fn is_refined_on_demand(&self) -> bool {
        self.on_demand
    }

    /// The runs, one coordinate per input, in the inputs' units. Point 0 is the cut point.
    pub fn points(&self) -> &[Vec<f64>] {
        &self.points
    }

    /// The laws of the inputs.
    pub fn inputs(&self) -> &[Distribution] {
        &self.inputs
    }

    /// The lines through the cut point, one per input.
    pub fn lines(&self) -> &[Line] {
        &self.lines
    }

    /// The check points, in the order drawn.
    pub fn checks(&self) -> &[CheckPoint] {
        &self.checks
    }

    /// All lines of an input in the order they were added; the last is the present one.
    pub(crate) fn lines_of(&self, input: usize) -> impl Iterator<Item = &Line> {
        self.replaced[input].iter().chain([&self.lines[input]])
    }

    /// Nodes of the lines that the present one of an input has replaced.
    pub(crate) fn nodes_before(&self, input: usize) -> usize {
        self.replaced[input]
            .iter()
            .map(|line| line.rule.len())
            .sum()
    }

    /// Whether no check point has been drawn from an input's present line.
    pub(crate) fn is_unchecked(&self, input: usize) -> bool {
        let before = self.nodes_before(input);
        before > 0 && self.checks.iter().all(|check| check.nodes[input] < before)
    }

    /// Counts by input the coordinates that the check points have, the cut's among them.
    pub(crate) fn checked_coordinates(&self) -> Vec<usize> {
        let of_input = |input: usize| {
            let bits = |check: &CheckPoint| self.points[check.ordinal][input].to_bits();
            let mut seen: HashSet<u64> = self.checks.iter().map(bits).collect();
            seen.insert(self.points[0][input].to_bits());
            seen.len()
        };
        (0..self.lines.len()).map(of_input).collect()
    }

    /// Returns for each input the node of its present rule that a check point's coordinate is; `None` if it is off that grid.
    pub(crate) fn on_grid(&self, check: &CheckPoint) -> Option<Vec<usize>> {
        let node = |(input, line): (usize, &Line)| {
            let x = self.points[check.ordinal][input];
            line.rule.nodes.iter().position(|node| *node == x)
        };
        self.lines.iter().enumerate().map(node).collect()
    }

    /// Counts the check points that the grid of the present lines has in all.
    pub(crate) fn off_axis_len(&self) -> usize {
        self.grid(&self.rules()).off_axis_len()
    }

    /// Counts those that are not check points yet.
    pub(crate) fn off_axis_left(&self) -> usize {
        let on_grid = self.checks.iter().filter_map(|check| self.on_grid(check));
        self.off_axis_len() - on_grid.count()
    }

    fn rules(&self) -> Vec<&GaussRule> {
        self.lines.iter().map(|line| &line.rule).collect()
    }

    /// Appends a run that is not a check point, and returns which point it is.
    pub(crate) fn add_point(&mut self, point: Vec<f64>) -> usize {
        self.points.push(point);
        self.points.len() - 1
    }

    /// The runs of one line; a node that is the cut's own coordinate costs none.
    fn add_line(&mut self, input: usize, nodes: usize) -> Result<Line, DesignError> {
        let law = &self.inputs[input];
        let rule = law
            .gauss_rule(nodes)
            .map_err(|source| DesignError::Rule { input, source })?;
        let polynomials = Polynomials::new(law, &rule);
        let mut ordinals = Vec::with_capacity(rule.len());
        for &x in &rule.nodes {
            if x == self.points[0][input] {
                ordinals.push(0);
            } else {
                let mut point = self.points[0].clone();
                point[input] = x;
                ordinals.push(self.add_point(point));
            }
        }
        Ok(Line {
            rule,
            polynomials,
            ordinals,
        })
    }
}

fn check_arguments(inputs: &[Distribution], cut: &[f64]) -> Result<(), DesignError> {
    if inputs.is_empty() {
        return Err(DesignError::NoInputs);
    }
    if cut.len() != inputs.len() {
        return Err(DesignError::CutLength {
            inputs: inputs.len(),
            found: cut.len(),
        });
    }
    match cut.iter().position(|c| !c.is_finite()) {
        Some(input) => Err(DesignError::CutNotFinite {
            input,
            value: cut[input],
        }),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use rand_chacha::ChaCha8Rng;
    use rand_chacha::rand_core::SeedableRng;

    use super::*;
    use crate::law::rule::RuleError;

    fn rng() -> ChaCha8Rng {
        ChaCha8Rng::seed_from_u64(42)
    }

    fn uniforms(n: usize) -> Vec<Distribution> {
        vec![Distribution::uniform(0.7, 1.3).unwrap(); n]
    }

    #[test]
    fn costs_are_those_of_the_method() {
        let runs = |inputs: &[Distribution], nodes, checks| {
            Design::new(inputs, nodes, checks, &mut rng())
                .unwrap()
                .points()
                .len()
        };
        assert_eq!(runs(&uniforms(5), 5, 0), 21);
        assert_eq!(runs(&uniforms(5), 5, 5), 26);
        assert_eq!(runs(&uniforms(5), 4, 0), 21);
        assert_eq!(runs(&uniforms(1), 5, 10), 5);
        assert_eq!(runs(&uniforms(3), 1, 10), 1);
        let lognormals = vec![Distribution::lognormal(0.0, 0.3).unwrap(); 5];
        assert_eq!(runs(&lognormals, 5, 0), 26);
    }

    #[test]
    fn every_point_is_what_it_is_filed_under() {
        let mut inputs = uniforms(2);
        inputs.push(Distribution::lognormal(0.0, 0.3).unwrap());
        let design = Design::new(&inputs, 5, 9, &mut rng()).unwrap();
        let points = design.points();
        let cut: Vec<f64> = inputs.iter().map(Distribution::mean).collect();
        assert_eq!(points[0], cut);
        for (input, line) in design.lines().iter().enumerate() {
            for (&ordinal, &x) in line.ordinals().iter().zip(&line.rule().nodes) {
                let mut expected = cut.clone();
                expected[input] = x;
                assert_eq!(points[ordinal], expected);
            }
        }
        assert_eq!(design.checks().len(), 9);
        for check in design.checks() {
            let off = points[check.ordinal()]
                .iter()
                .zip(&cut)
                .filter(|(x, c)| x != c)
                .count();
            assert!(off >= 2);
            for (input, &j) in check.nodes().iter().enumerate() {
                assert_eq!(
                    points[check.ordinal()][input],
                    design.lines()[input].rule().nodes[j]
                );
            }
        }
        for (k, point) in points.iter().enumerate() {
            assert!(!points[..k].contains(point), "point {k} twice");
        }
    }

    #[test]
    fn the_same_seed_gives_the_same_design() {
        let design =
            |seed| Design::new(&uniforms(4), 5, 10, &mut ChaCha8Rng::seed_from_u64(seed)).unwrap();
        assert_eq!(design(1), design(1));
        assert_ne!(design(1).points(), design(2).points());
    }

    #[test]
    fn another_cut_moves_the_lines() {
        let design = Design::with_cut(&uniforms(2), 3, &[1.0, 0.9], 0, &mut rng()).unwrap();
        // the first line shares its centre, the second does not
        assert_eq!(design.points().len(), 1 + 2 + 3);
        assert_eq!(design.lines()[0].ordinals()[1], 0);
        assert!(design.points()[1..3].iter().all(|point| point[1] == 0.9));
    }

    #[test]
    fn bad_arguments_are_named() {
        let new = |inputs: &[Distribution], nodes, checks| {
            Design::new(inputs, nodes, checks, &mut rng()).unwrap_err()
        };
        assert_eq!(new(&[], 5, 0), DesignError::NoInputs);
        assert_eq!(
            new(&uniforms(2), 5, 100_001),
            DesignError::TooManyCheckPoints { asked: 100_001 }
        );
        let rule = DesignError::Rule {
            input: 0,
            source: RuleError::Size { nodes: 0 },
        };
        assert_eq!(new(&uniforms(2), 0, 0), rule);
        let cut = |cut: &[f64]| Design::with_cut(&uniforms(2), 5, cut, 0, &mut rng()).unwrap_err();
        assert_eq!(
            cut(&[1.0]),
            DesignError::CutLength {
                inputs: 2,
                found: 1
            }
        );
        assert!(matches!(
            cut(&[1.0, f64::NAN]),
            DesignError::CutNotFinite { input: 1, .. }
        ));
    }
}
