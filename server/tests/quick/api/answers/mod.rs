//! What a study found, as the service answers it.

mod export;
mod fields;
mod films;
mod layouts_by_hand;
mod results;
