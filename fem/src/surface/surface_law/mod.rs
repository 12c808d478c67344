//! Elastic laws of layers without thickness or bending: fibre families.
//!
//! A law gives the energy W per reference area as a function of the Green-Lagrange strain of the surface in two
//! orthonormal reference axes. Its derivatives are the second Piola-Kirchhoff tensions S = dW/dE, force per length.
//!
//! | symbol | meaning |
//! | --- | --- |
//! | `E` | Green-Lagrange strain (C - 1) / 2 of the surface: E11, E22, 2 E12 |
//! | `S` | tensions S11, S22, S12, N/mm |
//! | `D` | dS/dE, 3 x 3, N/mm |

mod elastic_layer;
mod fibre_family;

pub use elastic_layer::{InPlane, SurfaceLaw};
pub use fibre_family::FibreFamily;
