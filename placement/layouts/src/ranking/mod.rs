//! Ranking of the layouts that a document asks for: [`asked_layouts`], [`layout_scores`] on one mesh with `shear_score` and `contact_scores`, [`layout_order`], and how far two orders agree:
//! [`kendall`]; [`screening`] leaves those of a menu that can't be the best.

pub mod asked_layouts;
mod contact_scores;
pub mod kendall;
pub mod layout_order;
pub mod layout_scores;
pub mod screening;
mod shear_score;
