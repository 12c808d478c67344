//! A thin elastic sheet glued to a surface of the mesh, at any place and turned by any angle.
//!
//! The sheet has its own displacements, by quadratic B-splines on its own spans, so that neither its outline nor its curvature asks anything of the mesh under it.
//! It is a Kirchhoff-Love shell (J. Kiendl, K.-U. Bletzinger, J. Linhard, R. Wuechner, Comput. Methods Appl. Mech. Engrg 198 (2009) 3902): with the current
//! tangents x_A and the unit normal n,
//!
//! > 2 E_AB = x_A . x_B - X_A . X_B,   k_AB = x_AB . n - X_AB . N,   W = E A E / 2 + k D k / 2.
//!
//! Springs over its area hold it to the surface: glue of shear modulus G and thickness t has G / t, in every direction; a film that can't slide has stiff ones.
//! The bending part of the tangent leaves out the second derivatives of curvature, which the moments of a thin film multiply.
//!
//! - `spline`: the functions on a line
//! - `control_net`: the control points, and which of them are mirror images of others
//! - `glued_sheet`: integration points between the sheet and the surface
//! - `sheet_forces`: nodal forces and stiffness
//! - `sheet_state`: strains, curvatures and positions of a state

mod control_net;
mod glued_sheet;
mod sheet_forces;
mod sheet_state;
mod spline;
#[cfg(test)]
mod tests;

pub use control_net::Outline;
pub use glued_sheet::{Elasticity, Sheet, Underlay};
pub(crate) use sheet_forces::Buffers;
pub use sheet_state::SheetPoint;
