//! The embedded solver against independent solutions, limit cases and symmetries.

mod film;
mod five_depth_study;
mod independent;
mod inflation;
mod reference_tire;
mod self_contact;
mod solution;
mod strain_error;
mod whole_tire;
