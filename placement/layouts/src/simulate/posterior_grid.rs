//! Grid of contact angles and depths: its cells, and the parts that they are cut into where the likelihood is sharp.

use crate::arrangement::Arrangement;
use crate::field::film_field::{DepthFields, LoadField, Noise};
use crate::fisher::bounds::information;

/// Cells around the wheel, 2 degrees each.
pub(super) const ANGLE_CELLS: usize = 180;
/// Cells over the depths of the study.
pub(super) const DEPTH_CELLS: usize = 16;
/// Most parts of a cell along either side, a power of three: parts of parts share their middles.
pub(super) const MOST_PARTS: usize = 27;
/// Standard deviations that a part may be wide.
const STEP: f64 = 2.0;

/// Cells of a layout's grid.
pub(super) struct PosteriorGrid {
    /// Cells by angle, then depth.
    cells: Vec<Cell>,
    /// Most parts of any cell around the wheel.
    finest: usize,
}

impl PosteriorGrid {
    /// Cells for a layout, each with the parts that the information asks for.
    pub fn new(fields: &DepthFields, arrangement: &Arrangement, noise: &Noise) -> Self {
        let cells = cells(fields, arrangement, noise);
        let finest = cells.iter().map(|cell| cell.parts[0]).fold(1, usize::max);
        Self { cells, finest }
    }

    /// Number of the finest parts of angles around the wheel.
    pub fn angles(&self) -> usize {
        ANGLE_CELLS * self.finest
    }

    /// The middle of a finest part of a turn, degrees.
    pub fn angle_deg(&self, angle: usize) -> f64 {
        (angle as f64 + 0.5) * 360.0 / self.angles() as f64
    }

    /// Middles of all cells, among the finest parts.
    pub fn middles(&self) -> Vec<[usize; 2]> {
        (0..self.cells.len())
            .map(|cell| self.block(cell, 0.0).middle())
            .collect()
    }

    /// Shortfalls of all cells' middles below their best points, at most.
    pub(super) fn slacks(&self) -> Vec<f64> {
        let slack = |cell: &Cell| cell.slack[0] + cell.slack[1];
        self.cells.iter().map(slack).collect()
    }

    /// The whole of a cell, with ln p at its middle.
    pub fn block(&self, cell: usize, log: f64) -> Block {
        let Cell { parts, slack } = self.cells[cell];
        Block {
            first: [
                cell / DEPTH_CELLS * self.finest,
                cell % DEPTH_CELLS * MOST_PARTS,
            ],
            spans: [self.finest, MOST_PARTS],
            parts,
            log_parts: ((parts[0] * parts[1]) as f64).ln(),
            slack,
            log,
        }
    }
}

/// Demands of the likelihood on a cell of the grid.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cell {
    /// Parts along angle and depth.
    pub parts: [usize; 2],
    /// Shortfall of its middle below its best point by either side, at most.
    pub slack: [f64; 2],
}

/// Part of a cell, among the finest parts.
#[derive(Debug, Clone, Copy)]
pub(super) struct Block {
    /// First parts along angle and depth.
    pub first: [usize; 2],
    /// Finest parts that it spans.
    pub spans: [usize; 2],
    /// Parts that it is still to be cut into.
    pub parts: [usize; 2],
    /// Logarithm of the number of parts of the whole cell.
    pub log_parts: f64,
    /// Shortfall of its middle below its best point by either side, at most.
    pub slack: [f64; 2],
    /// Value of ln p at its middle.
    pub log: f64,
}

impl Block {
    pub fn middle(&self) -> [usize; 2] {
        [0, 1].map(|k| self.first[k] + self.spans[k] / 2)
    }

    /// Shortfall of a piece's middle below its best point, at most: it goes by the square of a side.
    pub(super) fn slack_of_pieces(&self) -> f64 {
        let [angle, depth] = self.pieces_slack();
        angle + depth
    }

    fn pieces_slack(&self) -> [f64; 2] {
        let cuts = self.cuts();
        [0, 1].map(|k| self.slack[k] / (cuts[k] * cuts[k]) as f64)
    }

    /// Returns the middle of a piece.
    pub(super) fn middle_of_piece(&self, piece: [usize; 2]) -> [usize; 2] {
        let cuts = self.cuts();
        [0, 1].map(|k| {
            let span = divided(self.spans[k], cuts[k]);
            self.first[k] + piece[k] * span + span / 2
        })
    }

    /// Whether its pieces are cut no more.
    pub(super) fn is_cut_into_points(&self) -> bool {
        self.parts[0] <= 3 && self.parts[1] <= 3
    }

    /// Pieces that it is cut into along each side: thirds, where that is to be cut.
    pub(super) fn cuts(&self) -> [usize; 2] {
        self.parts.map(|parts| if parts > 1 { 3 } else { 1 })
    }

    /// A piece, with its own ln p.
    #[inline]
    pub(super) fn piece(&self, piece: [usize; 2], log: f64) -> Self {
        let cuts = self.cuts();
        let spans = [0, 1].map(|k| divided(self.spans[k], cuts[k]));
        Self {
            first: [0, 1].map(|k| self.first[k] + piece[k] * spans[k]),
            spans,
            parts: [0, 1].map(|k| divided(self.parts[k], cuts[k])),
            slack: self.pieces_slack(),
            log,
            ..*self
        }
    }
}

/// Divides by 1 or 3: by constants, which takes a tenth of the time.
fn divided(count: usize, cuts: usize) -> usize {
    if cuts == 1 { count } else { count / 3 }
}

/// Middles of equal parts of an interval.
pub(super) fn middles([low, high]: [f64; 2], count: usize) -> Vec<f64> {
    let step = (high - low) / count as f64;
    (0..count).map(|k| low + (k as f64 + 0.5) * step).collect()
}

/// Returns what the information asks of each cell: that at the middles of the cell and its neighbours.
fn cells(fields: &DepthFields, arrangement: &Arrangement, noise: &Noise) -> Vec<Cell> {
    let ends = fields.depths.ends();
    let widths = [
        360.0 / ANGLE_CELLS as f64,
        (ends[1] - ends[0]) / DEPTH_CELLS as f64,
    ];
    let loads: Vec<LoadField> = middles(ends, DEPTH_CELLS)
        .iter()
        .map(|depth| fields.at(*depth))
        .collect();
    let mut found = Vec::with_capacity(ANGLE_CELLS * DEPTH_CELLS);
    for contact in middles([0.0, 360.0], ANGLE_CELLS) {
        found.extend(loads.iter().map(|load| {
            let information = information(load, arrangement, noise, contact);
            [0, 1].map(|k| widths[k] * information.entry(k, k).sqrt())
        }));
    }
    let largest = |cell: usize| {
        let (angle, depth) = (cell / DEPTH_CELLS, cell % DEPTH_CELLS);
        let angles = [ANGLE_CELLS - 1, 0, 1].map(|by| (angle + by) % ANGLE_CELLS);
        let depths = depth.saturating_sub(1)..=(depth + 1).min(DEPTH_CELLS - 1);
        let near = angles
            .into_iter()
            .flat_map(|angle| depths.clone().map(move |depth| angle * DEPTH_CELLS + depth));
        near.fold([0.0f64; 2], |largest, cell| {
            [0, 1].map(|k| largest[k].max(found[cell][k]))
        })
    };
    let cell = |cell: usize| {
        let deviations = largest(cell);
        Cell {
            parts: deviations.map(parts_of),
            slack: deviations.map(|d| d * d / 8.0),
        }
    };
    (0..found.len()).map(cell).collect()
}

/// Parts of a cell that is so many standard deviations wide.
fn parts_of(deviations: f64) -> usize {
    let mut parts = 1;
    while STEP * (parts as f64) < deviations && parts < MOST_PARTS {
        parts *= 3;
    }
    parts
}
