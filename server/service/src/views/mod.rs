//! Views of what a study has solved, for a reader:
//!
//! - [`point_views`]: its points, inputs beside what came of them
//! - [`solved_wheel`]: its wheel at the cut point
//! - [`sections`]: its map along the line of an input
//! - [`rings`]: its signals around the wheel
//! - [`hand_layouts`]: layouts that somebody moves by hand

pub mod hand_layouts;
pub mod point_views;
pub mod rings;
pub mod sections;
pub mod solved_wheel;
