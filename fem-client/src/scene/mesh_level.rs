//! Fineness of a scene's model.

use document::{Choice, Table};

/// Fineness of the model.
#[derive(Debug, Clone, PartialEq, Table)]
pub struct Model {
    /// Mesh level.
    #[field(default = Level::Standard)]
    pub level: Level,
}

/// Mesh levels, coarse to fine.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Choice)]
pub enum Level {
    /// Mesh for a first look.
    Draft,
    /// Mesh for a look with an error; it shows the error of the standard level.
    Coarse,
    /// Mesh for placement decisions.
    Standard,
    /// Mesh for judging the others.
    Reference,
}

impl Level {
    /// Cells between the nodes of the reference tire's mesh, in a quarter of it.
    pub fn cells_of_reference_tire(self) -> usize {
        match self {
            Self::Draft => 300,
            Self::Coarse => 1536,
            Self::Standard => 4320,
            Self::Reference => 10240,
        }
    }
}
