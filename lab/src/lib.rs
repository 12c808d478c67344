//! What the measuring rigs share. Each rig is an example of this crate: `cargo run --release -p lab --example NAME` prints a table
//! of `docs/`.
//!
//! - [`cpu`]: processor time of a thread
//! - [`limit`]: the limit of a value under refinement, with its error
//! - [`mesh_families`]: ever finer meshes of the reference tire
//! - [`reference_tire`]: the reference tire, and one solve of it

pub mod cpu;
pub mod limit;
pub mod mesh_families;
pub mod reference_tire;
