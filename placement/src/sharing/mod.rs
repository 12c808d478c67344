//! Work shared out among machines, as far as a study's plan says what it is.
//!
//! - [`FirstPoint`]: the point that a study solves first, by which a machine's work is judged
//! - [`Part`]: some of the points of a large study, which start from its cut point's equilibrium wherever they are solved

mod first_point;
mod part;

pub use self::first_point::FirstPoint;
pub use self::part::{LARGE, Part, PartPoint, SMALLEST, is_shareable};
