//! Meshes times methods, from quick to accurate:
//!
//! - [`fidelity`]: mesh and method as one value, and the ladder of them
//! - [`effects`]: what leaving out a part of reality does
//! - [`climb`]: the cheapest model that meets a tolerance or a budget
//! - [`preview`]: what is answered while somebody writes the document
//! - [`trade`]: what accuracy a second buys

pub mod climb;
pub mod effects;
pub mod fidelity;
pub mod preview;
pub mod trade;
