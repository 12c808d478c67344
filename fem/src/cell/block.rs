//! Structured meshes: the unit cube, cut into bricks and mapped into space, and several of them joined.

use std::collections::HashMap;

use crate::cell::element::Order;
use crate::cell::mesh::{Mesh, Surface};
use crate::tensor::Vector;

/// A mapped cube of `cells[0]` x `cells[1]` x `cells[2]` bricks.
#[derive(Debug, Clone, PartialEq)]
pub struct Block {
    /// Bricks, the first coordinate running fastest.
    pub mesh: Mesh,
    /// Position of each brick in the block, in bricks.
    pub layout: Vec<[f64; 3]>,
    cells: [usize; 3],
}

impl Block {
    /// Maps the unit cube, right-handed. In plane strain the second coordinate is always 0, and one cell lies across.
    pub fn new(order: Order, cells: [usize; 3], map: impl Fn([f64; 3]) -> Vector) -> Self {
        let cells = if order.is_plane() {
            [cells[0], 1, cells[2]]
        } else {
            cells
        };
        let steps = steps(order);
        let lines = [0, 1, 2].map(|axis| cells[axis] * steps[axis] + 1);
        let nodes = grid(lines).map(|index| {
            map([0, 1, 2]
                .map(|axis| index[axis] as f64 / (cells[axis] * steps[axis]).max(1) as f64))
        });
        let nodes = nodes.collect();
        let (mut bricks, mut layout) = (Vec::new(), Vec::new());
        for cell in grid(cells) {
            layout.push(cell.map(|i| i as f64));
            bricks.extend(grid(steps.map(|n| n + 1)).map(|local| {
                let at = [0, 1, 2].map(|axis| cell[axis] * steps[axis] + local[axis]);
                ((at[2] * lines[1] + at[1]) * lines[0] + at[0]) as u32
            }));
        }
        let mesh = Mesh {
            order,
            nodes,
            bricks,
        };
        Self {
            mesh,
            layout,
            cells,
        }
    }

    /// The faces where a coordinate is 0 or, `upper`, 1. Their normals point along the coordinate.
    ///
    /// # Panics
    /// When `axis` is the one across a body in plane strain, which has no faces there.
    pub fn side(&self, axis: usize, upper: bool) -> Surface {
        let order = self.mesh.order;
        assert!(!(order.is_plane() && axis == 1), "no nodes across");
        let mut local = steps(order).map(|n| n + 1);
        let fixed = if upper { local[axis] - 1 } else { 0 };
        let brick_lines = local;
        local[axis] = 1;
        let layer = if upper { self.cells[axis] - 1 } else { 0 };
        let mut faces = Vec::new();
        for (element, _) in grid(self.cells)
            .enumerate()
            .filter(|(_, cell)| cell[axis] == layer)
        {
            let brick = self.mesh.brick(element);
            faces.extend(grid(local).map(|mut at| {
                at[axis] = fixed;
                brick[(at[2] * brick_lines[1] + at[1]) * brick_lines[0] + at[0]]
            }));
        }
        let surface = Surface { order, faces };
        // The remaining coordinates in ascending order are left-handed about the second axis, and (z, y) of a plane-strain
        // line about the first.
        let turned = axis == 1 || (axis == 0 && order.is_plane());
        if turned { surface.flipped() } else { surface }
    }
}

/// Blocks as one mesh: nodes at the same place, to the bit, become one. Returns the mesh, positions of its bricks for the
/// elimination order, and for each block the new numbers of its nodes.
///
/// # Panics
/// When there is no block, or when the blocks differ in order.
pub fn join(blocks: &[Block]) -> (Mesh, Vec<[f64; 3]>, Vec<Vec<u32>>) {
    let order = blocks.first().expect("at least one block").mesh.order;
    let mut numbers = HashMap::new();
    let mut mesh = Mesh {
        order,
        nodes: Vec::new(),
        bricks: Vec::new(),
    };
    let (mut layout, mut of_blocks) = (Vec::new(), Vec::new());
    for block in blocks {
        assert_eq!(block.mesh.order, order, "blocks of one order");
        let renumbered: Vec<u32> = block
            .mesh
            .nodes
            .iter()
            .map(|x| {
                // Adding zero makes a negative zero positive.
                let key = x.map(|c| (c + 0.0).to_bits());
                *numbers.entry(key).or_insert_with(|| {
                    mesh.nodes.push(*x);
                    mesh.nodes.len() as u32 - 1
                })
            })
            .collect();
        for element in 0..block.mesh.brick_count() {
            let brick = block.mesh.brick(element);
            layout.push([0, 1, 2].map(|axis| {
                let sum: f64 = brick
                    .iter()
                    .map(|&n| block.mesh.nodes[n as usize][axis])
                    .sum();
                sum / brick.len() as f64
            }));
            mesh.bricks
                .extend(brick.iter().map(|&n| renumbered[n as usize]));
        }
        of_blocks.push(renumbered);
    }
    (mesh, layout, of_blocks)
}

/// Node distances along a brick's edges.
fn steps(order: Order) -> [usize; 3] {
    let along = order.edge_nodes() - 1;
    [along, if order.is_plane() { 0 } else { along }, along]
}

/// All indices below `counts`, the first running fastest.
fn grid(counts: [usize; 3]) -> impl Iterator<Item = [usize; 3]> {
    (0..counts.iter().product()).map(move |i| {
        [
            i % counts[0],
            i / counts[0] % counts[1],
            i / (counts[0] * counts[1]),
        ]
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::load::pressure::PressureSurface;
    use crate::solid::SolidGeometry;

    #[test]
    fn a_mapped_block_has_its_volume_and_sides_that_enclose_it() {
        let size = [2.0, 1.0, 5.0];
        for order in Order::ALL {
            let block = Block::new(order, [2, 3, 4], |s| [0, 1, 2].map(|i| size[i] * s[i]));
            let geometry = SolidGeometry::new(&block.mesh).expect("right-handed");
            let bricks = block.mesh.brick_count();
            let volume: f64 = (0..bricks).map(|e| geometry.volume(e)).sum();
            assert!((volume - 10.0).abs() < 1e-13, "{order:?} {volume}");
            let axes: &[usize] = if order.is_plane() {
                &[0, 2]
            } else {
                &[0, 1, 2]
            };
            for &axis in axes {
                let enclosed = |surface: Surface| {
                    PressureSurface::new(surface).enclosed_volume(|n| block.mesh.nodes[n as usize])
                };
                // The flux of the position through the side at the end of the axis is the volume.
                let share = 10.0 / order.dimensions() as f64;
                let upper = enclosed(block.side(axis, true));
                assert!((upper - share).abs() < 1e-13, "{order:?} {axis}: {upper}");
                assert!(enclosed(block.side(axis, false)).abs() < 1e-14);
                let inward = enclosed(block.side(axis, true).flipped());
                assert!((inward + share).abs() < 1e-13, "{order:?} {axis}: {inward}");
            }
        }
    }

    #[test]
    fn joined_blocks_share_the_nodes_between_them() {
        for order in Order::ALL {
            let at = |start: f64| Block::new(order, [2, 2, 2], move |s| [start + s[0], s[1], s[2]]);
            let blocks = [at(0.0), at(1.0)];
            let (mesh, layout, numbers) = join(&blocks);
            let n = 2 * (order.edge_nodes() - 1) + 1;
            let side = if order.is_plane() { n } else { n * n };
            assert_eq!(mesh.nodes.len(), (2 * n - 1) * side);
            assert_eq!(layout.len(), mesh.brick_count());
            for (block, numbers) in blocks.iter().zip(&numbers) {
                for (x, &number) in block.mesh.nodes.iter().zip(numbers) {
                    assert_eq!(*x, mesh.nodes[number as usize]);
                }
            }
        }
    }
}
