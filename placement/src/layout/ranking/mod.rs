//! From a document to layouts in their order: [`asked_layouts`], [`layout_scores`] on one mesh, [`layout_order`].

pub mod asked_layouts;
pub mod layout_order;
pub mod layout_scores;
