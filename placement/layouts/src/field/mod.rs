//! Fields of films around the wheel: [`hermite`] curves through samples, [`film_field`] signals over angle and depth, `separated` the same as short sums.

pub mod film_field;
pub mod hermite;
pub(crate) mod separated;
