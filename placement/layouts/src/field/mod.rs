//! Fields of films around the wheel: [`hermite`] curves through samples, [`film_field`] signals over angle and depth, [`response_surface`] their changes with
//! whatever else a contact is, by [`contact_axis`] of one quantity alone and by [`contact_pair`] of two, `scatter_modes` what they scatter in together,
//! `contact_means` each for its own, `told_loads` the loads that go with them, `separated` the fields as short sums.

pub mod contact_axis;
mod contact_means;
pub mod contact_pair;
pub mod film_field;
pub mod hermite;
pub mod response_surface;
pub(crate) mod scatter_modes;
pub(crate) mod separated;
pub(crate) mod told_loads;
