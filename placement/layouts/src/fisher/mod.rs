//! Bounds of what readings can tell: [`information`], its [`bounds`] over the contact angles, and the [`dense_ring`] they are compared with; and of single
//! films the [`candidate_films`].

pub mod bounds;
pub mod candidate_films;
pub mod dense_ring;
pub mod information;
