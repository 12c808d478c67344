//! Tools that the measuring rigs share. Each rig is an example of this crate: `cargo run --release -p lab --example NAME` prints a table of `docs/`.
//!
//! - [`all_cores`]: pieces of work on all cores
//! - [`cpu`]: processor time of a thread
//! - [`largest`]: the largest error among several
//! - [`limit`]: the limit of a value under refinement, with its error
//! - [`mesh_families`]: ever finer meshes of the reference tire
//! - [`film_criteria`]: kinds of film by criteria that no answer uses
//! - [`published`]: the published study's tables of force errors, and a virtual rig under the same conditions
//! - [`reference_tire`]: the reference tire, and one solve of it
//! - [`study_runs`]: studies on any mesh level, and what they are run with

pub mod all_cores;
pub mod cpu;
pub mod film_criteria;
pub mod largest;
pub mod limit;
pub mod mesh_families;
pub mod published;
pub mod reference_tire;
pub mod study_runs;
