//! Models of one force, one contract: rows of features in, a mean and its standard deviation out.
//!
//! - [`contract`]: what they are given, and what they say
//! - `feature_scale`: features on one scale
//! - `training_mean`, [`ridge`], [`gpr`], [`ann`]: the models
//! - [`fitted`]: one of them, learnt
//! - `learning_time`: how long they take, by their sizes
//! - `box_search`: the least value of a smooth function within bounds
//! - `even_subset`: fewer rows, evenly taken

pub mod ann;
mod box_search;
pub mod contract;
pub(crate) mod even_subset;
pub(crate) mod feature_scale;
pub mod fitted;
pub mod gpr;
pub(crate) mod learning_time;
pub mod ridge;
pub(crate) mod training_mean;
