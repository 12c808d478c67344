//! Loads of the ground on the wheel that an estimate tells beside the vertical force.

use crate::field::contact_axis::Wrench;

/// Load in the wheel's frame; the usual contact has none of it.
pub(crate) struct ToldLoad {
    /// Number among those of a [`Wrench`].
    axis: usize,
    /// Name in a result.
    pub name: &'static str,
    /// Name for people.
    pub words: &'static str,
}

/// Loads that an estimate tells.
pub(crate) const TOLD_LOADS: [ToldLoad; 5] = [
    ToldLoad::new(0, "fx_n", "Fx (N)"),
    ToldLoad::new(1, "fy_n", "Fy (N)"),
    ToldLoad::new(3, "mx_nmm", "Mx (N mm)"),
    ToldLoad::new(4, "my_nmm", "My (N mm)"),
    ToldLoad::new(5, "mz_nmm", "Mz (N mm)"),
];

impl ToldLoad {
    const fn new(axis: usize, name: &'static str, words: &'static str) -> Self {
        Self { axis, name, words }
    }

    /// Returns it of all that the ground does.
    pub(super) fn of(&self, wrench: &Wrench) -> f64 {
        wrench[self.axis]
    }
}
