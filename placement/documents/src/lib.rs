//! Documents that users write: studies with their layouts, signals and rigs, sweeps of them, and inputs of models of their own.
//!
//! Folders in reading order; the page of each lists its modules:
//!
//! - [`parts`]: what several documents have, from names to scenes
//! - [`layouts`]: layouts of films
//! - [`signals`]: films' voltages over load, pressure and contact angle
//! - [`rig`]: a virtual rig
//! - [`study`]: the study document, and the design points that follow from it
//! - [`sweep`]: designs of one study
//! - [`scene_question`]: a scene to be solved once, and what is read of it
//! - [`own_model`]: inputs and outputs of models that others run
//! - [`schemas`]: JSON Schemas of all of them

pub mod layouts;
pub mod own_model;
pub mod parts;
pub mod rig;
pub mod scene_question;
pub mod schemas;
pub mod signals;
pub mod study;
pub mod sweep;
