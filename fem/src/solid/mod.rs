//! The mixed displacement-pressure brick.
//!
//! With the pressure `p` an independent, element-wise discontinuous field and `c` the bulk compliance (1/kappa; 0 is
//! exactly incompressible), the element makes stationary
//!
//! > integral of W_iso(F) + p (J - 1) - c p^2 / 2 over the reference volume.
//!
//! Residuals, with G the cofactor of F and q the pressure modes:
//!
//! > r_u = integral of (P_iso + p G) : grad(du),   r_p = integral of q (J - 1) - c M p,   M = integral of q q.
//!
//! One Newton step eliminates the pressures on the element. Where c is smaller than the compliance `SolidModel::step_compliance`
//! the step (never the residual) uses that larger one: a proximal step, whose limit is the exact constraint and whose
//! matrix stays positive definite and well conditioned for any bulk modulus. Pressures kept as unknowns make this
//! converge where p = kappa (J - 1), inserted, does not.
//!
//! - `solid_model`: law and compressibility
//! - `solid_geometry`: bricks in the reference state
//! - `contribution`: residuals and tangent of a brick
//! - `stress`: mean stresses of a brick

mod contribution;
mod solid_geometry;
mod solid_model;
mod stress;

pub(crate) use contribution::SolidContribution;
pub use solid_geometry::{InvalidReference, SolidGeometry};
pub use solid_model::SolidModel;
pub use stress::MeanStress;
