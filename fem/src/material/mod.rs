//! Hyperelastic laws of the solid's isochoric response.
//!
//! The volumetric response belongs to the mixed element, so a law here sees F only through its isochoric invariants.

mod first_invariant;
mod isochoric;
mod mooney_rivlin;
mod neo_hookean;
mod ogden;
mod yeoh;

pub use isochoric::Isochoric;
pub use mooney_rivlin::MooneyRivlin;
pub use neo_hookean::NeoHookean;
pub use ogden::{Ogden, OgdenTerm};
pub use yeoh::Yeoh;
