//! Errors of forces by a layout's films: runs recorded, learnt from and tested as recordings of a real rig would be.
//!
//! - [`thinned_run`]: a run as an estimator reads it
//! - [`learnt_force`]: the model of one force, and its errors on what was left out
//! - [`fresh_trials`]: the same on runs that nobody learnt from, with films dead or askew
//! - `tried_rows`: estimates beside true forces
//! - `instant_floor`: how well one instant's readings can tell forces at all
//! - `drifts`: drifts of the readings with which they are learnt anew
//! - [`layout_forces`]: all three forces of a layout
//! - [`force_prices`]: what a force's error costs in films
//! - [`assumed_rig`]: what is assumed of the rig, in sentences

pub mod assumed_rig;
mod drifts;
pub mod force_prices;
pub mod fresh_trials;
pub(crate) mod instant_floor;
pub mod layout_forces;
pub mod learnt_force;
pub mod thinned_run;
pub(crate) mod tried_rows;
