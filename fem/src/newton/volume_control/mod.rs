//! Equilibrium at a prescribed volume of a cavity, its pressure being the unknown: the way through limit points, where no
//! pressure is high enough to go on but every volume has its pressure.
//!
//! With the condensed tangent K, the volume's gradient g = dV/du and the residual r of the displacements, one step is
//!
//! > K du - g dp = -r,   g . du = V* - V,
//!
//! solved by two substitutions with one factor of K (bordering): du = a + b dp with K a = -r and K b = g. K may be
//! indefinite. Along the path dp/dV = 1 / (g . b), smooth through the limit point, where K is singular and g . b infinite.
//! For (nearly) incompressible bodies K is that of the step's bulk modulus, not the residual's: dp/dV then errs by about 1e-4
//! of itself, and the pressure at its root by the square of that.
//!
//! [`VolumeControl::inflate`] follows the path of growing volume and says where it ends.
//!
//! - `bordering`: one equilibrium at a volume
//! - `continuation`: the path of growing volume

mod bordering;
mod continuation;

pub use bordering::{Inflated, VolumeControl};
pub use continuation::{Ending, LIMIT_TOLERANCE};
