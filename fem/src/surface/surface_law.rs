//! Elastic laws of layers without thickness or bending: fibre families and thin films.
//!
//! A law gives the energy W per reference area as a function of the Green-Lagrange strain of the surface in two
//! orthonormal reference axes. Its derivatives are the second Piola-Kirchhoff tensions S = dW/dE, force per length.
//!
//! | symbol | meaning |
//! | --- | --- |
//! | `E` | Green-Lagrange strain (C - 1) / 2 of the surface: E11, E22, 2 E12 |
//! | `S` | tensions S11, S22, S12, N/mm |
//! | `D` | dS/dE, 3 x 3, N/mm |

mod fibre_family;
mod film;

pub use fibre_family::FibreFamily;
pub use film::Film;

/// In-plane components 11, 22 and 12; of strains the third is doubled, so that S . dE is the work.
pub type InPlane = [f64; 3];

/// An elastic layer: energy zero and no tension at E = 0.
pub trait SurfaceLaw: std::fmt::Debug + Send + Sync {
    /// Stored energy per reference area, N/mm.
    fn energy(&self, strain: &InPlane) -> f64;

    /// Tensions and their derivatives by the strain, N/mm.
    fn tensions(&self, strain: &InPlane) -> (InPlane, [InPlane; 3]);

    /// Largest stiffness in the reference state, N/mm.
    fn stiffness(&self) -> f64;
}
