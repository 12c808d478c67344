//! Density of a contact's angle and depth after a layout's readings: what an estimate asks of a likelihood.

use ndarray::Array2;

use crate::simulate::posterior_grid::PosteriorGrid;

/// Density of angle and depth on a grid, up to a factor.
pub(super) trait Density {
    /// Readings of one sample, and what was made for them.
    type After<'a>
    where
        Self: 'a;

    /// The grid.
    fn grid(&self) -> &PosteriorGrid;

    /// Values of ln p at the cells' middles: rows of readings by cells.
    fn logs(&self, readings: &Array2<f64>) -> Array2<f64>;

    /// Begins with one set of readings.
    fn after<'a>(&'a self, readings: &'a [f64]) -> Self::After<'a>;

    /// Value of ln p at parts of a turn and of a depth.
    fn log(&self, at: [usize; 2], after: &mut Self::After<'_>) -> f64;

    /// Means of what else readings tell with the contact there: the vertical force, N, then quantities that contacts differ in; nothing where they are read off
    /// the depth alone.
    fn told(&self, at: [usize; 2], after: &Self::After<'_>) -> Vec<f64>;
}
