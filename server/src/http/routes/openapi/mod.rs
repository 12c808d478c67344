//! The description of all operations.
//!
//! - [`description`]: from the handlers and their types, and where it is asked for
//! - `generator_idioms`: in the words that generators of clients know

pub mod description;
mod generator_idioms;
