//! A scene as a boundary value problem, in reading order:
//!
//! - `dimensions`: the uninflated tire, and the mesh of a level
//! - `cords_and_film`: cords and film as membranes
//! - `resting_ground`: the ground and how the tread meets it
//! - `boundary_values`: the problem
//! - `choices`: what is modelled, and what is left out
//! - `tire_model`: a scene ready to be solved

mod boundary_values;
mod choices;
mod cords_and_film;
mod dimensions;
mod resting_ground;
mod tire_model;

pub use cords_and_film::{cord_families, film_law};
pub use dimensions::{mesh_plan, shape};
pub use resting_ground::{FRICTION_STEPS, depth_of_load, ground, load_step};
pub use tire_model::TireModel;
