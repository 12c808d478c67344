//! Parts that several documents have.
//!
//! - [`directions`]: which strains are asked for, and what follows from that
//! - [`distribution_reader`]: laws of what is uncertain
//! - [`film_place`], [`film_model`]: where a film lies, and how it is modelled
//! - `scene_number`, `scene_reader`: read a number as a scene has it, and a scene

pub mod directions;
pub mod distribution_reader;
pub mod film_model;
pub mod film_place;
pub(crate) mod scene_number;
pub(crate) mod scene_reader;
