//! Responses of a tire with films to any contact, between solves: for a virtual rig, which needs thousands of contacts a second.
//!
//! - `table_settings`: loads and shifts of the ground that are solved
//! - `table_scenes`: the scenes, and those that test the table
//! - `drag_basis`: how a response depends on the ground's shift
//! - `solved_table`: signals and forces between what was solved
//! - `table_films`: what glued films are pressed by, and where what their transfer misses is added
//! - `table_error`: how far they are off
//! - `bare_film`: a bare film as a kind whose signal is in volts
//! - `differing_contacts`: what contacts differ in besides, by the surface of the layouts
//! - [`laid_films`]: a layout's films, as a rig asks for them
//! - `table_solving`: the solves, as points of a study; [`study_table`]: those of a study with a rig; `measuring_forces`: puts what it shows into the result

pub(crate) mod bare_film;
pub(crate) mod differing_contacts;
pub(crate) mod drag_basis;
pub mod laid_films;
pub(crate) mod measuring_forces;
pub(crate) mod solved_table;
pub mod study_table;
pub(crate) mod table_error;
mod table_films;
pub(crate) mod table_scenes;
pub(crate) mod table_settings;
pub(crate) mod table_solving;
