//! Verification: problems whose answer is known, solved by `fem` and compared.
//!
//! A case is a number with what it should be. Answers come from closed forms where there are any, else from independent
//! codes. Tolerances come from theory: round-off and Newton's tolerance for homogeneous deformations, the discretisation
//! error estimated from two meshes (and the rate that theory promises) for the others, what a formula neglects for
//! Hertz's, and the other code's own error for comparisons. The families, each a file:
//!
//! - `homogeneous`: stretches, shear, bulk compression, patch test, rigid rotation
//! - `cylinder`: inflated thick cylinder in plane strain
//! - `sphere`: inflated thick sphere, through its limit point
//! - `cook`: Cook's membrane
//! - `pressed`: contact of a cylinder and of a ball with a plane, level or leaning, and of a ring between plates
//! - `glued_bar`: a bar on glue on a stretched body
//! - `strip`: a stiff strip glued on a stretched half plane
//! - [`extremes`]: the ends of what can be asked
//!
//! Each builds on `body` (blocks of rubber), `plate` (bodies pressed on a plane) and `mesh_refinement` (errors on finer meshes), and answers with
//! [`Case`]s in a [`family`].

pub(crate) mod body;
mod cook;
pub(crate) mod cylinder;
pub mod extremes;
pub mod family;
mod glued_bar;
pub(crate) mod homogeneous;
pub(crate) mod known_case;
pub(crate) mod mesh_refinement;
mod pressed;
pub(crate) mod sphere;
mod strip;

pub use family::{Family, Solve, Unsolved};
pub use known_case::{Case, Measure, Slope, Verdict};

/// All families, roughly from the quickest to the slowest.
pub const FAMILIES: [Family; 12] = [
    Family::new("homogeneous", homogeneous::stretches),
    Family::new("patch", homogeneous::others),
    Family::new("cook", cook::cases),
    Family::new("cylinder", cylinder::cases),
    Family::new("ring", pressed::ring::cases),
    Family::new("strip", strip::cases),
    Family::new("glue", glued_bar::cases),
    Family::new("hertz-line", pressed::hertz::line),
    Family::new("leaning", pressed::leaning::cases),
    Family::new("sphere", sphere::mooney_rivlin),
    Family::new("hertz-ball", pressed::hertz::ball),
    Family::new("sphere-limit", sphere::limit_points),
];
