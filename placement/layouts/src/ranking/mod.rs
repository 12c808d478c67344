//! Ranking of the layouts that a document asks for: [`asked_layouts`], [`layout_scores`] on one mesh, [`layout_order`], and how far two orders agree:
//! [`kendall`].

pub mod asked_layouts;
pub mod kendall;
pub mod layout_order;
pub mod layout_scores;
