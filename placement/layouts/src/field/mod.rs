//! Fields of films around the wheel: [`hermite`] curves through samples, [`film_field`] signals over angle and depth, [`response_surface`] their changes with
//! whatever else a contact is, by [`contact_axis`] of one quantity alone and by [`contact_pair`] of two, `scatter_modes` what they scatter in together,
//! `separated` the fields as short sums.

pub mod contact_axis;
pub mod contact_pair;
pub mod film_field;
pub mod hermite;
pub mod response_surface;
pub(crate) mod scatter_modes;
pub(crate) mod separated;
