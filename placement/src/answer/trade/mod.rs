//! The trade of films against errors:
//!
//! - `film_trade`: the best layout of each number of films, and which of them answers; `trade_words`: the same in words
//! - `picked_layout`: the layout that answers; `rivals`: its verdict against the others, and the reason

mod film_trade;
mod picked_layout;
mod rivals;
mod trade_words;

pub(super) use film_trade::trade;
pub(super) use picked_layout::{PickedLayout, contenders, picked_layout};
