//! What readings can tell at best: [`information`], its [`bounds`] over the contact angles, and the [`dense_ring`] they are compared with.

pub mod bounds;
pub mod dense_ring;
pub mod information;
