//! Contact of a surface with the rigid ground, by a penalty on the gap along its z axis, with or without friction.
//!
//! The ground stores phi(g) per reference area of the surface at each integration point, with the gap
//! g = z - z_g(x) in the ground's axes. A point that penetrates by s = -g > 0 is pushed with phi' = -eps s, whose slope grows from zero over a
//! small width, so that the tangent is continuous and a surface that just touches feels nothing. The forces are the
//! derivative of that energy, along (-z_g', 0, 1) there: normal to the ground.
//!
//! - [`Penalty`]: the pressure that a penetration costs
//! - `contact_surface`: gap, and the points that touch
//! - `contact_forces`: nodal forces and stiffness
//! - `anchors`: what friction remembers from one load step to the next
//! - `resultant`: force and moment of the ground, and penetration

mod anchors;
mod contact_forces;
mod contact_surface;
mod penalty;
mod resultant;

pub use contact_surface::ContactSurface;
pub use penalty::Penalty;
pub use resultant::{ContactResultant, Wrench};
