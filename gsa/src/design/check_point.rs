//! A check point of a design.

/// A run off the cut lines, against which the reduced forms are tested.
#[derive(Debug, Clone, PartialEq)]
pub struct CheckPoint {
    pub(super) ordinal: usize,
    pub(super) nodes: Vec<usize>,
    /// Number of the point that is its mirror image, where the model is known to have a symmetry.
    pub(super) image: Option<usize>,
}

impl CheckPoint {
    /// Returns its number among the points of the design.
    pub fn ordinal(&self) -> usize {
        self.ordinal
    }

    /// Returns for each input the number of the coordinate's node, counted through its lines in the order they were added: of the rule itself where
    /// the line was never refined.
    pub fn nodes(&self) -> &[usize] {
        &self.nodes
    }

    /// Returns the number of the point that is its mirror image, itself perhaps; `None` where no symmetry is known.
    pub(crate) fn image(&self) -> Option<usize> {
        self.image
    }
}
