//! Unknowns that the elements couple: bricks, and what is glued on them.

use crate::problem::Problem;

/// Nodes whose displacements an element couples.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Cell<'p> {
    /// The nodes.
    pub(crate) nodes: &'p [u32],
    /// Position in the chart of the bricks, in bricks.
    pub(crate) position: [f64; 3],
}

/// The elements of a problem that couple nodes: bricks first, then those of a sheet, which lie where a brick under them does. Faces couple no more than their bricks.
///
/// # Panics
/// When the problem's layout doesn't have one position for each brick.
pub(crate) fn cells(problem: &Problem) -> Vec<Cell<'_>> {
    let (mesh, layout) = (&problem.mesh, &problem.layout);
    assert_eq!(
        layout.len(),
        mesh.brick_count(),
        "one chart position per brick"
    );
    let bricks = (0..mesh.brick_count()).map(|brick| Cell {
        nodes: mesh.brick(brick),
        position: layout[brick],
    });
    let mut cells: Vec<Cell<'_>> = bricks.collect();
    if let Some(sheet) = &problem.sheet {
        let mut brick_of = vec![0; mesh.nodes.len()];
        for brick in 0..mesh.brick_count() {
            for &node in mesh.brick(brick) {
                brick_of[node as usize] = brick;
            }
        }
        let elements = (0..sheet.element_count()).map(|element| {
            let nodes = sheet.nodes(element);
            let under = nodes.last().map_or(0, |&node| brick_of[node as usize]);
            Cell {
                nodes,
                position: layout[under],
            }
        });
        cells.extend(elements);
    }
    cells
}
