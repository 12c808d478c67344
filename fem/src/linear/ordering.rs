//! Nested dissection of a mesh: an elimination order with little fill.
//!
//! The bricks are halved across the axis along which they form most layers; nodes that belong to both halves are
//! the separator and come last (A. George, SIAM J. Numer. Anal. 10 (1973) 345). On a regular chart each separator is one
//! layer of nodes.

use crate::linear::coupled::Cell;

/// Parts of no more bricks than this are not dissected further.
const LEAF_BRICKS: usize = 4;

/// Order in which so many nodes are eliminated: `order[k]` is the k-th node.
pub(crate) fn nested_dissection(nodes: usize, cells: &[Cell<'_>]) -> Vec<u32> {
    let mut bricks: Vec<u32> = (0..cells.len() as u32).collect();
    let mut dissection = Dissection {
        cells,
        taken: vec![false; nodes],
        mark: vec![0; nodes],
        stamp: 0,
        order: Vec::with_capacity(nodes),
    };
    dissection.dissect(&mut bricks);
    dissection.order
}

struct Dissection<'a> {
    cells: &'a [Cell<'a>],
    /// Nodes that are ordered already, or belong to an enclosing separator.
    taken: Vec<bool>,
    /// Stamp of the last half that touched a node.
    mark: Vec<u32>,
    stamp: u32,
    order: Vec<u32>,
}

impl Dissection<'_> {
    fn dissect(&mut self, bricks: &mut [u32]) {
        let split = if bricks.len() > LEAF_BRICKS {
            self.halve(bricks)
        } else {
            None
        };
        let Some(split) = split else {
            self.order_rest(bricks);
            return;
        };
        let (left, right) = bricks.split_at_mut(split);
        let separator = self.separator(left, right);
        self.dissect(left);
        self.dissect(right);
        self.order.extend(separator);
    }

    /// Sorts the bricks along the axis with most layers and returns the layer boundary nearest the middle.
    fn halve(&self, bricks: &mut [u32]) -> Option<usize> {
        let position = |brick: &u32, axis: usize| self.cells[*brick as usize].position[axis];
        let extent = |axis: usize| {
            let low = bricks
                .iter()
                .map(|b| position(b, axis))
                .fold(f64::INFINITY, f64::min);
            bricks
                .iter()
                .map(|b| position(b, axis))
                .fold(f64::NEG_INFINITY, f64::max)
                - low
        };
        let axis = (0..3).max_by(|&a, &b| extent(a).total_cmp(&extent(b)))?;
        bricks.sort_by(|a, b| {
            position(a, axis)
                .total_cmp(&position(b, axis))
                .then(a.cmp(b))
        });
        let middle = bricks.len() as f64 / 2.0;
        (1..bricks.len())
            .filter(|&i| position(&bricks[i], axis) > position(&bricks[i - 1], axis))
            .min_by(|&a, &b| {
                (a as f64 - middle)
                    .abs()
                    .total_cmp(&(b as f64 - middle).abs())
            })
    }

    fn separator(&mut self, left: &[u32], right: &[u32]) -> Vec<u32> {
        self.stamp += 1;
        for &brick in left {
            for &node in self.cells[brick as usize].nodes {
                self.mark[node as usize] = self.stamp;
            }
        }
        let mut separator = Vec::new();
        for &brick in right {
            for &node in self.cells[brick as usize].nodes {
                if self.mark[node as usize] == self.stamp && !self.taken[node as usize] {
                    self.taken[node as usize] = true;
                    separator.push(node);
                }
            }
        }
        separator
    }

    fn order_rest(&mut self, bricks: &[u32]) {
        for &brick in bricks {
            for &node in self.cells[brick as usize].nodes {
                if !self.taken[node as usize] {
                    self.taken[node as usize] = true;
                    self.order.push(node);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_node_is_ordered_once() {
        // A row of 9 linear bricks: nodes 4 k .. 4 k + 4 are the k-th layer.
        let bricks = (0..9u32)
            .flat_map(|k| (0..8).map(move |a| 4 * k + a))
            .collect();
        let bricks: Vec<u32> = bricks;
        let cells = bricks.chunks_exact(8).enumerate();
        let cells: Vec<Cell> = cells
            .map(|(k, nodes)| Cell {
                nodes,
                position: [k as f64, 0.0, 0.0],
            })
            .collect();
        let order = nested_dissection(40, &cells);
        let mut sorted = order.clone();
        sorted.sort_unstable();
        assert_eq!(sorted, (0..40).collect::<Vec<_>>());
        // The last four are the layer between the halves: nodes 16..20 or 20..24.
        let last: Vec<_> = order[36..].iter().map(|n| n / 4).collect();
        assert!(last == [4; 4] || last == [5; 4], "{last:?}");
    }
}
