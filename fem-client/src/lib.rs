//! Scenes and the solvers that answer for them.
//!
//! A [`scene::Scene`] says what is pressed and how. A [`solver::Solver`] turns a scene into an equilibrium and reads
//! the strains of the inner surface off it. The modules, in reading order:
//!
//! - [`fault`]: what is wrong with a document, where, and what would be right
//! - [`hexadecimal`]: hashes as text
//! - [`document`]: reads TOML or JSON text into one kind of value
//! - [`fields`]: reads checked fields from a value, collecting every fault
//! - [`scene`]: the scene document and its defaults
//! - [`scene_reader`]: reads a scene, with the ranges and the rules that tie fields together
//! - [`scene_edit`]: changes single fields of a scene by their path
//! - [`gauge`]: single points with a direction, where strain is read
//! - [`omission`]: what a scene's model leaves out, and the scene that has it
//! - [`solve_error`]: why a solve gave no answer
//! - [`solver`]: the one trait between the product and any solver, with its request and response
//! - [`start_state`]: start states as bytes
//! - `grid_lines`: where the bricks of a mesh begin and end
//! - [`tire_mesh`]: the structured mesh of a tire
//! - `tire_surfaces`: its surfaces, and points of them
//! - `tire_mirror`: its states, left and right exchanged
//! - [`tire`]: a scene as a boundary value problem: what is modelled, and what is left out
//! - [`mesh_error`]: which coarser mesh shows a level's error
//! - [`probe`], [`readout`]: strains of an equilibrium with their errors
//! - `self_contact`: whether a pressed tire touches itself
//! - `session`: one solve on its way: a scene's model, its Newton method, and the loads they meet
//! - `failure`: why a tire can't be pressed further
//! - `inflation`: the inflated state, or why there is none
//! - `neighbourhood`: what solves from the same equilibrium share
//! - `pressing`: the tire pressed on the ground
//! - [`embedded`]: the solver built on `fem`
//! - [`vtu`]: grids as files for ParaView
//! - [`body`]: the whole solved tire as such a grid
//! - [`calculix`]: CalculiX as an external solver
//! - [`verify`]: problems whose answer is known
//! - [`extremes`]: the same at the ends of what a scene can ask for
//! - [`closed_form`]: the stand-in solver for tests of what stands above

pub mod body;
pub mod calculix;
pub mod closed_form;
pub mod document;
pub mod embedded;
pub mod extremes;
mod failure;
pub mod fault;
pub mod fields;
pub mod gauge;
mod grid_lines;
pub mod hexadecimal;
mod inflation;
pub mod mesh_error;
mod neighbourhood;
pub mod omission;
mod pressing;
pub mod probe;
pub mod readout;
pub mod scene;
pub mod scene_edit;
pub mod scene_reader;
mod self_contact;
mod session;
pub mod solve_error;
pub mod solver;
pub mod start_state;
pub mod tire;
pub mod tire_mesh;
mod tire_mirror;
mod tire_surfaces;
pub mod verify;
pub mod vtu;
