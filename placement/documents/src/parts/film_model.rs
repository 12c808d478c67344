//! Models of films.

use document::Choice;

/// Model of a film.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Choice)]
pub enum FilmModel {
    /// Film that follows the wall and resists nothing.
    Bare,
    /// Bare, its strains made tensions by a matrix that two coupled solves give.
    Transfer,
    /// Film glued to the wall, with its stiffness.
    Coupled,
}
