//! Which method, and what it may spend. The ways from runs to indices, in reading order:
//!
//! - `verdict`, [`analysis`]: lines through the cut point
//! - `auto`: lines, and whatever more it takes to meet a tolerance
//! - `bivariate`: lines and the grids of all pairs
//! - `sobol`, [`saltelli`]: pairs of samples
//! - `pce`, `scattered`: polynomial chaos on scattered points

pub mod analysis;
pub(crate) mod auto;
pub(crate) mod bivariate;
pub(crate) mod pce;
pub mod saltelli;
pub(crate) mod scattered;
pub(crate) mod sobol;
pub(crate) mod verdict;

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
    /// All of them.
    pub const ALL: [Self; 6] = [
        Self::Mdrm,
        Self::Bivariate,
        Self::Tensor,
        Self::Pce,
        Self::Saltelli,
        Self::Auto,
    ];

    /// Its name in documents.
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

    /// Whether the points asked for depend on values of earlier ones.
    pub fn is_adaptive(self) -> bool {
        self == Self::Auto
    }
}

/// A method with its settings. Each kind uses some of them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Method {
    /// which one
    pub kind: Kind,
    /// Gauss nodes of each input (`mdrm`, `bivariate`, `tensor`; `auto` starts with them)
    pub nodes: usize,
    /// off-axis points at which forms are checked (`mdrm`, `bivariate`; `auto` starts with them), and points off the nodes at
    /// which grids are (`bivariate`, `tensor`)
    pub check_points: usize,
    /// points of `pce`, base points of `saltelli`
    pub samples: usize,
    /// of the check points and of the samples
    pub seed: u64,
    /// largest error of any first-order index that `auto` stops at
    pub tolerance: f64,
    /// most runs of `auto`
    pub most_runs: usize,
}

impl Method {
    /// The kind with its default settings.
    pub fn of(kind: Kind) -> Self {
        Self {
            kind,
            nodes: 5,
            check_points: 5,
            samples: match kind {
                Kind::Saltelli => 1024,
                _ => 200,
            },
            seed: 1,
            tolerance: 0.02,
            most_runs: 1000,
        }
    }
}
