//! Bounds of what readings can tell: [`information`], its [`bounds`] over the contact angles, and the [`dense_ring`] they are compared with; of single
//! films the [`candidate_films`]; what makes a layout's error, [`error_sources`]; and the `joint_scatter` of readings over contacts.

pub mod bounds;
pub mod candidate_films;
pub mod dense_ring;
pub mod error_sources;
pub mod information;
pub(crate) mod joint_scatter;
