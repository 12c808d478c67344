//! From a study to ranked locations and layouts.
//!
//! The modules, in reading order, one arrow of the chain each:
//!
//! - [`directions`]: which strains are asked for, and what follows from that
//! - [`study`]: the study document: what varies, what is asked
//! - [`plan`]: the design points of a study, a pure function of the document
//! - `candidate_reader`, [`distribution_reader`], `input_reader`, [`study_reader`]: read a study, with every fault at once
//! - [`sweep`]: designs of one study
//! - [`archive`], [`memory`]: where solved points are kept, so that none is solved twice
//! - [`result`]: the answer, field by field
//! - [`score`]: responses to indices per output
//! - [`rank`]: indices to ranked locations
//! - `ring_field`, [`layout`]: strain rings to ranked layouts
//! - `notes`: what the user must know before believing the numbers
//! - [`assemble`]: all of it into the answer
//! - [`usage`]: what a run takes of the machine
//! - [`run`]: solves the points that the archive lacks, on all cores, and assembles the answer
//! - [`effects`]: what leaving out a part of reality does
//! - [`fidelity`]: mesh and method as one value, and the ladder of them
//! - [`climb`]: the cheapest model that meets a tolerance or a budget
//! - [`compare`]: studies side by side, and which differences are real
//! - [`estimate`]: what a study will cost, before anything is solved
//! - [`trade`]: what accuracy a second buys
//! - [`inputs_document`], [`value_table`]: inputs and outputs of models that others run

pub mod archive;
pub mod assemble;
mod candidate_reader;
pub mod climb;
pub mod compare;
pub mod directions;
pub mod distribution_reader;
pub mod effects;
pub mod estimate;
pub mod fidelity;
mod input_reader;
pub mod inputs_document;
pub mod layout;
pub mod memory;
mod method_reader;
mod notes;
pub mod plan;
pub mod rank;
pub mod result;
mod ring_field;
pub mod run;
pub mod score;
pub mod study;
pub mod study_reader;
pub mod sweep;
pub mod trade;
pub mod usage;
pub mod value_table;
