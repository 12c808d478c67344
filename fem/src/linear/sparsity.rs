//! Equation numbers and the pattern of the tangent.

use crate::linear::coupled::Cell;
use crate::linear::ordering::nested_dissection;

/// Marks a held displacement in [`Equations`], and an absent entry in a scatter list.
pub const NONE: u32 = u32::MAX;

/// Equation numbers of the free displacements, in elimination order.
#[derive(Debug)]
pub struct Equations {
    /// Equation of each node and axis; [`NONE`] where the displacement is held.
    pub of_node: Vec<[u32; 3]>,
    /// Number of equations.
    pub count: usize,
    /// Number of equations before the border's.
    pub interior: usize,
}

impl Equations {
    /// Numbers the free displacements by nested dissection, last those that `border` marks.
    pub(crate) fn new(
        cells: &[Cell<'_>],
        supports: &[[Option<f64>; 3]],
        border: &[[bool; 3]],
    ) -> Self {
        let mut of_node = vec![[NONE; 3]; supports.len()];
        let order = nested_dissection(supports.len(), cells);
        let mut count = 0;
        let mut number = |in_border: bool| {
            for &node in &order {
                let node = node as usize;
                for axis in 0..3 {
                    let held = supports[node][axis].is_some();
                    if !held && border[node][axis] == in_border {
                        of_node[node][axis] = count;
                        count += 1;
                    }
                }
            }
            count as usize
        };
        let (interior, count) = (number(false), number(true));
        Self {
            of_node,
            count,
            interior,
        }
    }

    /// Equations of a list of nodes, three per node.
    pub fn of(&self, nodes: &[u32]) -> impl Iterator<Item = u32> {
        nodes.iter().flat_map(|&node| self.of_node[node as usize])
    }
}

/// Upper triangle of a symmetric sparse matrix by columns, rows ascending.
#[derive(Debug)]
pub struct Pattern {
    /// Start of each column, and the end of the last.
    pub column_starts: Vec<usize>,
    /// Row of each entry.
    pub rows: Vec<usize>,
}

impl Pattern {
    /// Pattern in which all unknowns of a cell are coupled.
    pub(crate) fn new(cells: &[Cell<'_>], equations: &Equations) -> Self {
        let neighbours = node_neighbours(equations.of_node.len(), cells);
        let mut column_starts = vec![0; equations.count + 1];
        let mut columns: Vec<Vec<u32>> = vec![Vec::new(); equations.count];
        for (node, neighbours) in neighbours.iter().enumerate() {
            let mut rows: Vec<u32> = equations.of(neighbours).filter(|&e| e != NONE).collect();
            rows.sort_unstable();
            for &column in equations.of_node[node].iter().filter(|&&e| e != NONE) {
                columns[column as usize] = rows
                    .iter()
                    .copied()
                    .take_while(|&row| row <= column)
                    .collect();
            }
        }
        let mut rows = Vec::with_capacity(columns.iter().map(Vec::len).sum());
        for (column, entries) in columns.iter().enumerate() {
            rows.extend(entries.iter().map(|&row| row as usize));
            column_starts[column + 1] = rows.len();
        }
        Self {
            column_starts,
            rows,
        }
    }

    /// Number of stored entries.
    pub fn entries(&self) -> usize {
        self.rows.len()
    }

    /// Positions of a dense symmetric block's upper triangle (by rows) in the list of entries; [`NONE`] where a row or
    /// column is held.
    pub fn scatter(&self, equations: &[u32]) -> Vec<u32> {
        let n = equations.len();
        let mut positions = Vec::with_capacity(n * (n + 1) / 2);
        for (r, &row) in equations.iter().enumerate() {
            for &column in &equations[r..] {
                positions.push(if row == NONE || column == NONE {
                    NONE
                } else {
                    self.position(row, column)
                });
            }
        }
        positions
    }

    fn position(&self, a: u32, b: u32) -> u32 {
        let (row, column) = (a.min(b) as usize, a.max(b) as usize);
        let range = self.column_starts[column]..self.column_starts[column + 1];
        let offset = self.rows[range.clone()]
            .binary_search(&row)
            .expect("all unknowns of a cell are coupled");
        (range.start + offset) as u32
    }
}

/// Nodes that share a cell with each node, itself included, ascending.
fn node_neighbours(nodes: usize, cells: &[Cell<'_>]) -> Vec<Vec<u32>> {
    let mut neighbours: Vec<Vec<u32>> = vec![Vec::new(); nodes];
    for cell in cells {
        for &node in cell.nodes {
            neighbours[node as usize].extend_from_slice(cell.nodes);
        }
    }
    for list in &mut neighbours {
        list.sort_unstable();
        list.dedup();
    }
    neighbours
}
