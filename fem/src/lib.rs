//! Nonlinear finite elements for inflated, reinforced rubber bodies pressed on a rigid ground.
//!
//! The unknowns are the nodal displacements `u` and element-wise discontinuous pressures `p` of a body whose reference
//! points are `X` and current points `x = X + u`. Units are the caller's, as long as they agree: lengths in mm, forces
//! in N and stresses in MPa (N/mm^2) throughout the product.
//!
//! | symbol | meaning |
//! | --- | --- |
//! | `F` | deformation gradient dx/dX |
//! | `J` | volume ratio det F |
//! | `P` | first Piola-Kirchhoff stress dW/dF |
//! | `A` | tangent dP/dF, 9 x 9, row and column index 3 i + J |
//! | `G` | cofactor J F^-T |
//!
//! Modules in reading order, each importing only those above it:
//!
//! - [`tensor`]: 3 x 3 algebra
//! - [`quadrature`], [`element`]: reference cells
//! - [`mesh`]: nodes, elements, surfaces
//! - [`block`]: structured meshes
//! - [`material`]: hyperelastic laws: neo-Hookean, Mooney-Rivlin, Yeoh, Ogden
//! - [`surface_law`], [`membrane`]: fibre families and films embedded in the mesh
//! - [`solid`]: the mixed displacement-pressure element
//! - [`pressure`]: live pressure on a surface
//! - [`traction`]: dead forces on a surface
//! - [`obstacle`], [`friction`], [`contact`]: rigid ground and contact with it
//! - [`problem`]: a boundary value problem, its loads and its state
//! - [`ordering`], [`sparsity`], `substitution`, [`linear`]: the sparse linear system
//! - [`setup`]: what all states of a problem share
//! - [`system`], [`assembly`]: residual and tangent of the whole problem
//! - `focus`, `condensed_contact`, [`tangent`]: linear body, nonlinear contact
//! - [`newton`]: equilibrium under given loads
//! - [`volume_control`]: equilibrium at a given volume of a cavity, and limit points
//! - [`path`]: load stepping with automatic cut-back
//! - [`patch`], [`stretch`], [`surface`]: strains of a surface

mod acceleration;
pub mod assembly;
pub mod block;
mod condensed_contact;
pub mod contact;
pub mod element;
mod focus;
pub mod friction;
pub mod linear;
pub mod material;
pub mod membrane;
pub mod mesh;
pub mod newton;
pub mod obstacle;
pub mod ordering;
pub mod patch;
pub mod path;
pub mod pressure;
pub mod problem;
pub mod quadrature;
pub mod setup;
pub mod solid;
pub mod sparsity;
pub mod stretch;
mod substitution;
pub mod surface;
pub mod surface_law;
pub mod system;
pub mod tangent;
pub mod tensor;
pub mod traction;
pub mod volume_control;
