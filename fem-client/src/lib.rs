//! Scenes and the solvers that answer for them.
//!
//! A [`scene::Scene`] says what is pressed and how. A [`solver::Solver`] turns a scene into an equilibrium and reads
//! the strains of the inner surface off it. The modules, in reading order:
//!
//! - [`fault`]: what is wrong with a document, where, and what would be right
//! - [`document`]: reads TOML or JSON into checked values, collecting every fault
//! - [`scene`]: the scene document, its defaults and checked ranges
//! - [`solver`]: the one trait between the product and any solver, with its request, response and errors

pub mod fault;
pub mod document;
pub mod scene;
pub mod solver;
