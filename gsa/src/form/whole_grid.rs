//! A grid of nodes that check points fill: what a form misses is known at every node.

use std::collections::BTreeMap;

use crate::design::{Design, Line};
use crate::form::composite::Composite;
use crate::form::evidence::Checks;
use crate::form::factors::Tables;

/// A grid that check points fill.
#[derive(Debug, Clone)]
pub(crate) struct WholeGrid {
    pub(crate) sizes: Vec<usize>,
    /// numbers of the nodes that each check point is at, by its ordinal
    nodes: BTreeMap<usize, Vec<usize>>,
    /// rows over the rule's nodes by input: w_j, then w_j p_k(x_j)
    projection: Vec<Vec<Vec<f64>>>,
}

impl WholeGrid {
    /// Makes the grid; `None` if points of it have not been run.
    pub(crate) fn new(design: &Design, tables: &Tables) -> Option<Self> {
        if design.off_axis_left() > 0 {
            return None;
        }
        let nodes = design
            .checks()
            .iter()
            .filter_map(|check| Some((check.ordinal(), design.on_grid(check)?)));
        let rows = |(input, line): (usize, &Line)| {
            let row = |k: usize| tables.projection(line, input, k).to_vec();
            (0..line.rule().len()).map(row).collect()
        };
        let lines = design.lines();
        Some(Self {
            nodes: nodes.collect(),
            sizes: lines.iter().map(|line| line.rule().len()).collect(),
            projection: lines.iter().enumerate().map(rows).collect(),
        })
    }

    fn weight(&self, nodes: &[usize]) -> f64 {
        let inputs = nodes.iter().enumerate();
        inputs.map(|(i, &j)| self.projection[i][0][j]).product()
    }

    /// Probability of the nodes that should have a value and have none.
    pub(crate) fn weight_missing(&self, checks: &Checks<'_>) -> f64 {
        let known = checks
            .iter()
            .filter_map(|(check, _)| self.nodes.get(&check.ordinal()));
        let known: f64 = known.map(|nodes| self.weight(nodes)).sum();
        let all: f64 = self.nodes.values().map(|nodes| self.weight(nodes)).sum();
        let missing = all - known;
        // Sums of many weights round.
        if missing > 1e-12 { missing } else { 0.0 }
    }

    /// Adds the residuals' coefficients, one input after the other.
    pub(crate) fn add_to(
        &self,
        composite: &mut Composite<'_>,
        checks: &Checks<'_>,
        residuals: &[f64],
    ) {
        let mut table = vec![0.0; self.sizes.iter().product()];
        for ((check, _), r) in checks.iter().zip(residuals) {
            if let Some(nodes) = self.nodes.get(&check.ordinal()) {
                let nodes = nodes.iter().zip(&self.sizes);
                table[nodes.fold(0, |at, (j, size)| at * size + j)] = *r;
            }
        }
        let mut after = 1;
        for (input, &size) in self.sizes.iter().enumerate().rev() {
            table = transform(&table, &self.projection[input], size, after);
            after *= size;
        }
        for (at, c) in table.into_iter().enumerate().filter(|(_, c)| *c != 0.0) {
            let mut rest = at;
            let mut index = Vec::new();
            for (input, size) in self.sizes.iter().enumerate().rev() {
                if rest % size > 0 {
                    index.push((input, rest % size));
                }
                rest /= size;
            }
            index.reverse();
            composite.add(index, c);
        }
    }
}

/// Applies a matrix of `size` rows and columns along one axis, `after` entries apart.
fn transform(table: &[f64], matrix: &[Vec<f64>], size: usize, after: usize) -> Vec<f64> {
    let mut out = vec![0.0; table.len()];
    for block in 0..table.len() / (size * after) {
        for rest in 0..after {
            let at = |j: usize| (block * size + j) * after + rest;
            for (k, row) in matrix.iter().enumerate() {
                out[at(k)] = row.iter().enumerate().map(|(j, w)| w * table[at(j)]).sum();
            }
        }
    }
    out
}
