//! The embedded solver against independent solutions and its own limits, as far as that takes seconds.

mod derivatives;
mod five_depth_study;
mod folded_wall;
mod glued_film;
mod independent;
mod inflation;
mod reference_figures;
mod solution;
mod strain_error;
