//! Fields of films around the wheel: [`hermite`] curves through samples, [`film_field`] signals over angle and depth, [`response_surface`] their changes with
//! whatever else a contact is, `scatter_modes` what they scatter in together, `separated` the fields as short sums.

pub mod film_field;
pub mod hermite;
pub mod response_surface;
pub(crate) mod scatter_modes;
pub(crate) mod separated;
