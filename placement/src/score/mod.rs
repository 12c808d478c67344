//! Scores of a study, from responses to a result, in reading order:
//!
//! - [`indices`]: responses to indices of every output
//! - `quantity`, `readings`: what of a response is analysed, as numbers
//! - `analyst`: their analysis; `mirror_images`: what points tell of their mirror images
//! - `map_slopes`: what each input changes over the map, to first order
//! - [`rank`]: indices to ranked locations
//! - `notes`: what the user must know before believing the numbers
//! - `scaled_errors`: errors over a scale
//! - [`assemble`]: all of it into the answer

pub(crate) mod analyst;
pub mod assemble;
pub mod indices;
pub(crate) mod map_slopes;
pub(crate) mod mirror_images;
pub(crate) mod notes;
pub(crate) mod quantity;
pub mod rank;
pub(crate) mod readings;
pub(crate) mod scaled_errors;
