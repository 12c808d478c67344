//! Placement of films: from a study to ranked locations and layouts.
//!
//! Folders in reading order; the page of each lists its modules:
//!
//! - [`points`]: solves the points that the archive lacks, on all cores
//! - [`score`]: responses to indices and ranked locations
//! - [`run`]: a study's points, and the answer that is assembled of them
//! - [`signals`]: films' voltages over load, pressure and contact angle
//! - [`layout`]: what is solved for layouts, and scored
//! - [`response_table`]: responses to any contact, between solves
//! - [`answer`]: all of that in one sentence, and how sure it is
//! - `assumptions`: what the answer's figures rest on, changed
//! - [`ladder`]: meshes times methods, from quick to accurate
//! - [`compare`]: studies side by side, and which differences are real
//! - [`estimate`]: what a study will cost, before anything is solved
//! - [`sharing`]: work shared out among machines

pub mod answer;
mod assumptions;
pub mod compare;
pub mod estimate;
pub mod ladder;
pub mod layout;
pub mod points;
pub mod response_table;
pub mod run;
pub mod score;
pub mod sharing;
pub mod signals;
