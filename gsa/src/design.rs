//! The runs to make: a cut point, one line of Gauss nodes per input through it, and off-axis check points.
//!
//! | symbol | meaning |
//! |---|---|
//! | n, N | inputs, nodes of each input's rule |
//! | c | cut point, the means unless said otherwise |
//! | line i | c with its i-th coordinate at each node of input i |
//!
//! Cost: n N + 1 runs, or n (N - 1) + 1 where a centre node is the mean itself (uniform and normal inputs, odd N), and
//! one run for each check point.

use rand::Rng;
use thiserror::Error;

use crate::distribution::Distribution;
use crate::grid::Grid;
use crate::rule::{GaussRule, RuleError};

/// Most check points a design takes; far beyond what an error estimate gains from, and well within memory.
pub const MAX_CHECK_POINTS: usize = 100_000;

/// Why a design cannot be built. Fields count inputs from 0, messages from 1.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum DesignError {
    /// There is nothing to vary.
    #[error("a design needs at least one input")]
    NoInputs,
    /// An input's Gauss rule does not exist.
    #[error("input {}: {source}", input + 1)]
    Rule {
        /// which input
        input: usize,
        /// what is wrong with its rule
        source: RuleError,
    },
    /// The cut point has another number of coordinates than there are inputs.
    #[error("the cut point has {found} coordinates for {inputs} inputs")]
    CutLength {
        /// number of inputs
        inputs: usize,
        /// coordinates given
        found: usize,
    },
    /// A coordinate of the cut point is NaN or infinite.
    #[error("coordinate {} of the cut point must be finite, not {value}", input + 1)]
    CutNotFinite {
        /// which input
        input: usize,
        /// what was given
        value: f64,
    },
    /// More check points than [`MAX_CHECK_POINTS`].
    #[error("{asked} check points are more than the {MAX_CHECK_POINTS} a design takes")]
    TooManyCheckPoints {
        /// check points asked for
        asked: usize,
    },
}

/// The runs along one input.
#[derive(Debug, Clone, PartialEq)]
pub struct Line {
    rule: GaussRule,
    ordinals: Vec<usize>,
}

impl Line {
    /// The input's Gauss rule.
    pub fn rule(&self) -> &GaussRule {
        &self.rule
    }

    /// For each node of the rule, which point of the design it is.
    pub fn ordinals(&self) -> &[usize] {
        &self.ordinals
    }
}

/// A run off the cut lines, against which the reduced forms are tested.
#[derive(Debug, Clone, PartialEq)]
pub struct CheckPoint {
    ordinal: usize,
    nodes: Vec<usize>,
}

impl CheckPoint {
    /// Which point of the design it is.
    pub fn ordinal(&self) -> usize {
        self.ordinal
    }

    /// For each input, which node of its rule the coordinate is.
    pub fn nodes(&self) -> &[usize] {
        &self.nodes
    }
}

/// A list of runs and what each of them is for. Immutable: the same arguments and the same generator state give the
/// same design to the bit.
#[derive(Debug, Clone, PartialEq)]
pub struct Design {
    inputs: Vec<Distribution>,
    lines: Vec<Line>,
    checks: Vec<CheckPoint>,
    points: Vec<Vec<f64>>,
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

    /// As [`Design::new`], through another cut point.
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
        check_arguments(inputs, cut, check_points)?;
        let rules = rules(inputs, nodes)?;
        let mut points = vec![cut.to_vec()];
        let checked = Grid::new(&rules, cut).off_axis(check_points, rng);
        let ordinals: Vec<Vec<usize>> = rules
            .iter()
            .enumerate()
            .map(|(input, rule)| add_line(&mut points, input, rule))
            .collect();
        let checks = checked
            .into_iter()
            .map(|nodes| {
                // Off-axis points differ from all others in a coordinate, so none of them is a duplicate.
                points.push(
                    rules
                        .iter()
                        .zip(&nodes)
                        .map(|(rule, &j)| rule.nodes[j])
                        .collect(),
                );
                CheckPoint {
                    ordinal: points.len() - 1,
                    nodes,
                }
            })
            .collect();
        let lines = rules
            .into_iter()
            .zip(ordinals)
            .map(|(rule, ordinals)| Line { rule, ordinals })
            .collect();
        Ok(Self {
            inputs: inputs.to_vec(),
            lines,
            checks,
            points,
        })
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
}

fn check_arguments(
    inputs: &[Distribution],
    cut: &[f64],
    check_points: usize,
) -> Result<(), DesignError> {
    if inputs.is_empty() {
        return Err(DesignError::NoInputs);
    }
    if cut.len() != inputs.len() {
        return Err(DesignError::CutLength {
            inputs: inputs.len(),
            found: cut.len(),
        });
    }
    if let Some(input) = cut.iter().position(|c| !c.is_finite()) {
        return Err(DesignError::CutNotFinite {
            input,
            value: cut[input],
        });
    }
    if check_points > MAX_CHECK_POINTS {
        return Err(DesignError::TooManyCheckPoints {
            asked: check_points,
        });
    }
    Ok(())
}

fn rules(inputs: &[Distribution], nodes: usize) -> Result<Vec<GaussRule>, DesignError> {
    let rule = |(input, law): (usize, &Distribution)| {
        law.gauss_rule(nodes)
            .map_err(|source| DesignError::Rule { input, source })
    };
    inputs.iter().enumerate().map(rule).collect()
}

/// Adds the runs of one line; a node that is the cut's own coordinate costs none.
fn add_line(points: &mut Vec<Vec<f64>>, input: usize, rule: &GaussRule) -> Vec<usize> {
    let mut ordinals = Vec::with_capacity(rule.len());
    for &x in &rule.nodes {
        if x == points[0][input] {
            ordinals.push(0);
        } else {
            let mut point = points[0].clone();
            point[input] = x;
            points.push(point);
            ordinals.push(points.len() - 1);
        }
    }
    ordinals
}

#[cfg(test)]
mod tests {
    use rand_chacha::ChaCha8Rng;
    use rand_chacha::rand_core::SeedableRng;

    use super::*;

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
