//! Fields of films around the wheel: [`hermite`] curves through samples, [`film_field`] signals over angle and depth, [`response_surface`] their changes with
//! whatever else a contact is, `separated` the same as short sums.

pub mod film_field;
pub mod hermite;
pub mod response_surface;
pub(crate) mod separated;
