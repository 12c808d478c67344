//! The ends of what a scene can ask for: does a solve end right within its stated error, or with a named, true reason?
//!
//! Where there is no closed form a case is a law that must hold: a difference that falls like a known power, a balance, the
//! same answer on two ways. The families, each a file:
//!
//! - `incompressible`: bulk over shear modulus from 10 to infinity
//! - `walls`: walls from 1/100 to 1/2 of the section's radius
//! - `limit_load`, `limit_sphere`: pressures up to a limit point, and beyond it
//! - `first_touch`, `depths`: from the first touch to a tire that touches itself
//! - `distorted`: elements sheared and squeezed
//! - `units`: the same scene in other units
//! - `cords`: a carcass from nothing to steel
//! - [`studies`]: whole studies

use crate::family::Family;

mod cords;
mod depths;
mod distorted;
mod draft;
mod first_touch;
mod incompressible;
mod limit_load;
mod limit_sphere;
pub mod studies;
mod trend;
mod units;
mod walls;

/// All families but that of whole studies, roughly from the quickest to the slowest.
pub const FAMILIES: [Family; 9] = [
    Family::new("incompressible", incompressible::cases),
    Family::new("cords", cords::cases),
    Family::new("units", units::cases),
    Family::new("limit-load", limit_load::cases),
    Family::new("distorted", distorted::cases),
    Family::new("limit-sphere", limit_sphere::cases),
    Family::new("first-touch", first_touch::cases),
    Family::new("walls", walls::cases),
    Family::new("depths", depths::cases),
];
