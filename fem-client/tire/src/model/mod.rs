//! A scene as a boundary value problem, in reading order:
//!
//! - `dimensions`: the uninflated tire, and the mesh of a level
//! - `carcass_layer`: the textile layer as a membrane
//! - `glued_film`: the film as a sheet of its own
//! - `resting_ground`: the ground and how the tread meets it
//! - `boundary_values`: the problem
//! - `choices`: what is modelled, and what is left out
//! - `meshed_part`: how much of it is meshed
//! - `tire_model`: a scene ready to be solved
//! - `mirrored_state`: its states with left and right exchanged

mod boundary_values;
mod carcass_layer;
mod choices;
mod dimensions;
mod glued_film;
mod meshed_part;
mod mirrored_state;
mod resting_ground;
mod rough_ground;
mod tire_model;

pub use carcass_layer::cord_families;
pub use dimensions::{mesh_plan, mesh_plan_for, shape};
pub(crate) use glued_film::{Place, following_film};
pub use meshed_part::extent;
pub(crate) use meshed_part::inflated_key;
pub(crate) use resting_ground::depth_of_load;
pub(crate) use resting_ground::ground_axes;
pub(crate) use resting_ground::load_step;
pub(crate) use resting_ground::profiled_ground;
pub use resting_ground::{drag_steps, ground, press_steps};
pub use tire_model::TireModel;
