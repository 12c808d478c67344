//! Forces from recordings: recipes and recordings of users in, estimators, reports and estimates out.
//!
//! - [`recipe_reader`]: recipes from TOML or JSON
//! - [`recorded_texts`]: recordings from their texts
//! - [`fitting`]: learns an estimator on all cores
//! - [`model_file`]: estimators as texts
//! - [`applying`]: estimates of a recording, whole or row by row

pub mod applying;
pub mod fitting;
pub mod model_file;
pub mod recipe_reader;
pub mod recorded_texts;
