//! Elastic layers embedded in the mesh: membranes without thickness or bending.
//!
//! At each integration point the surface has orthonormal reference axes `a1`, `a2` with the derivatives `N,1`, `N,2` of the
//! shape functions along them. With g_A = u,A the current axes are x_A = a_A + g_A, and the strain is free of round-off
//! however far from the origin: 2 E_AB = a_A . g_B + a_B . g_A + g_A . g_B. Nodal forces and stiffness follow from the
//! tensions S and their moduli D:
//!
//! > f_a = S_AB N_a,A x_B,   K_ab = N_a,A N_b,B (D_(AC)(BD) x_C x x_D + S_AB 1).
//!
//! - `layers`: where the layers lie and how they strain
//! - `membrane_forces`: nodal forces and stiffness

mod layers;
mod membrane_forces;

pub use layers::{Direction, Membrane};
