//! Answers of a study, as the service gives them.

mod export;
mod fields;
mod films;
mod layouts_by_hand;
mod results;
