//! The grids of all pairs of inputs, everything else at the cut.

use std::collections::HashMap;

use super::Design;

/// The runs of one pair of inputs.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct PairGrid {
    pub(crate) inputs: (usize, usize),
    /// point at node j of the first and l of the second, row by row
    pub(crate) ordinals: Vec<usize>,
}

impl Design {
    /// Adds the grids of all pairs; check points and lines that lie on them are reused.
    pub(crate) fn add_pairs(&mut self) -> Vec<PairGrid> {
        let bits = |point: &[f64]| point.iter().map(|x| x.to_bits()).collect::<Vec<u64>>();
        let known = self.points().iter().enumerate();
        let mut known: HashMap<Vec<u64>, usize> = known.map(|(k, x)| (bits(x), k)).collect();
        let inputs = self.inputs().len();
        let mut grids = Vec::new();
        for i in 0..inputs {
            for j in i + 1..inputs {
                let nodes = |input: usize| self.lines()[input].rule().nodes.clone();
                let (first, second) = (nodes(i), nodes(j));
                let mut ordinals = Vec::with_capacity(first.len() * second.len());
                for &x in &first {
                    for &y in &second {
                        let mut point = self.points()[0].clone();
                        (point[i], point[j]) = (x, y);
                        let key = bits(&point);
                        let ordinal = known
                            .get(&key)
                            .copied()
                            .unwrap_or_else(|| self.add_point(point));
                        known.insert(key, ordinal);
                        ordinals.push(ordinal);
                    }
                }
                grids.push(PairGrid {
                    inputs: (i, j),
                    ordinals,
                });
            }
        }
        grids
    }
}
