//! From a study to ranked locations and layouts.
//!
//! Rooms in reading order; a room's page lists its modules:
//!
//! - [`study`]: the study document, its readers, and the design points that follow from it
//! - [`sweep`]: designs of one study
//! - [`result`]: the answer, field by field
//! - [`run`]: solves the points that the archive lacks, on all cores, and assembles the answer
//! - [`score`]: responses to indices and ranked locations
//! - [`layout`]: strain rings to ranked layouts
//! - [`answer`]: all of that in one sentence, and how sure it is
//! - [`ladder`]: meshes times methods, from quick to accurate
//! - [`response_table`]: responses to any contact, between solves
//! - [`signals`]: films' voltages over load, pressure and contact angle
//! - [`rig`]: what films and a force sensor record of a tire that steps, and how well forces are known by that
//! - [`compare`]: studies side by side, and which differences are real
//! - [`estimate`]: what a study will cost, before anything is solved
//! - [`own_model`]: inputs and outputs of models that others run

pub mod answer;
pub mod compare;
pub mod estimate;
pub mod ladder;
pub mod layout;
pub mod own_model;
pub mod response_table;
pub mod result;
pub mod rig;
pub mod run;
pub mod score;
pub mod signals;
pub mod study;
pub mod sweep;
