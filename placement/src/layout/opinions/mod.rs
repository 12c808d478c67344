//! Second opinions on kinds of film: [`candidate_films`] with their figures, by [`modes`] and [`pivots`], and how far orders agree: [`kendall`].

pub mod candidate_films;
pub mod kendall;
pub mod modes;
pub mod pivots;
