//! Glued films, whose volts aren't the bare wall's strains:
//!
//! - [`transfers`]: volts from the bare wall's strains, by two coupled equilibria of each kind of film
//! - [`film_angles`]: films beside the contact, solved with the tire; `angle_residual`: what their transfer misses there
//! - [`layout_films`]: those of layouts

pub(crate) mod angle_residual;
pub(crate) mod film_angles;
pub(crate) mod layout_films;
pub(crate) mod transfers;
