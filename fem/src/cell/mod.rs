//! Reference cells and meshes of them, in reading order:
//!
//! - [`quadrature`], [`element`]: integration points and shape functions
//! - [`mesh`]: nodes, elements, surfaces
//! - [`block`]: structured meshes

pub mod block;
pub mod element;
pub mod mesh;
pub mod quadrature;
