//! The tire between a scene and the `fem` kernel: its mesh, its model, and the solver that answers for it.
//!
//! The modules, in reading order:
//!
//! - [`mesh`]: the structured mesh, its surfaces and mirror images
//! - `rubber`: a scene's rubber as the kernel evaluates it
//! - [`omission`]: what a scene's model leaves out, and the scene that has it
//! - [`model`]: a scene as a boundary value problem: what is modelled, and what is left out
//! - [`mesh_error`]: which coarser mesh shows a level's error
//! - [`readout`]: strains of an equilibrium with their errors
//! - `self_contact`: whether a pressed tire touches itself
//! - `session`: one solve on its way: a scene's model, its Newton method, and the loads they meet
//! - `ground_path`: the paths of the ground: pressing, dragging
//! - `press_failure`: why a tire can't be pressed further, or dragged
//! - `inflate`: the inflated state, or why there is none
//! - `neighbourhood`: what solves from the same equilibrium share
//! - `press`: the tire pressed on the ground, and dragged
//! - [`embedded`]: the solver

pub mod embedded;
mod ground_path;
mod inflate;
pub mod mesh;
pub mod mesh_error;
pub mod model;
mod neighbourhood;
pub mod omission;
mod press;
mod press_failure;
pub mod readout;
mod rubber;
mod self_contact;
mod session;
