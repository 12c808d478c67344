//! Methods, and what they may spend.
//!
//! Every method is a `procedure`: one file that says which points it asks for and what it makes of their values. `choice` has
//! the list of them.
//!
//! - [`analysis`]: what any of them finds out; `verdict`: which form speaks for an output
//! - [`lines`]: `mdrm`, lines through the cut point
//! - `bivariate`: lines and the grids of all pairs
//! - `tensor_grid`: the whole grid
//! - `auto`: lines, and whatever more it takes to meet a tolerance; `correction`: what check points mend
//! - `pce`, `saltelli`: polynomial chaos, and pairs of samples; `scattered`: what these have in common
//! - `amended`: what mirror images, failed runs and printed digits make of an analysis

mod amended;
pub mod analysis;
mod auto;
mod bivariate;
mod choice;
mod correction;
pub mod lines;
mod pce;
pub(crate) mod procedure;
pub(crate) mod saltelli;
mod scattered;
mod tensor_grid;
mod verdict;

/// Ways to sensitivity indices.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Kind {
    /// lines through the cut point: product, shifted product or sum, whichever holds
    Mdrm,
    /// lines and the grids of all pairs
    Bivariate,
    /// the whole grid
    Tensor,
    /// sparse polynomial chaos on scattered points
    Pce,
    /// pairs of samples
    Saltelli,
    /// lines, and whatever more it takes to meet the tolerance
    Auto,
}

impl Kind {
    /// Kinds, all of them.
    pub const ALL: [Self; 6] = [
        Self::Mdrm,
        Self::Bivariate,
        Self::Tensor,
        Self::Pce,
        Self::Saltelli,
        Self::Auto,
    ];

    /// Returns its name in documents.
    pub fn as_str(self) -> &'static str {
        match self {
            Self::Mdrm => "mdrm",
            Self::Bivariate => "bivariate",
            Self::Tensor => "tensor",
            Self::Pce => "pce",
            Self::Saltelli => "saltelli",
            Self::Auto => "auto",
        }
    }
}

/// A method with its settings. Each kind uses some of them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Method {
    /// kind of procedure
    pub kind: Kind,
    /// Gauss nodes of each input (`mdrm`, `bivariate`, `tensor`; `auto` starts with them)
    pub nodes: usize,
    /// off-axis points at which forms are checked (`mdrm`, `bivariate`; `auto` starts with them), and points off the nodes at
    /// which grids are (`bivariate`, `tensor`)
    pub check_points: usize,
    /// points of `pce`, base points of `saltelli`
    pub samples: usize,
    /// seed of the check points and of the samples
    pub seed: u64,
    /// largest error of any first-order index that `auto` stops at
    pub tolerance: f64,
    /// most runs of `auto`
    pub most_runs: usize,
}
