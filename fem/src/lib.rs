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
//! Folders in reading order, each importing only those above it; the page of each lists its modules:
//!
//! - [`tensor`]: 3 x 3 algebra
//! - [`cell`]: reference cells, meshes, structured blocks
//! - [`material`]: hyperelastic laws: neo-Hookean, Mooney-Rivlin, Yeoh, Ogden
//! - [`surface`]: stretches of a surface; fibre families embedded in it, and a film glued on it
//! - [`load`]: live pressure, dead forces, rigid ground with friction
//! - [`solid`]: the mixed displacement-pressure element
//! - [`problem`]: a boundary value problem, its loads and its state
//! - [`linear`]: numbering, assembly and factorisation of the linear system
//! - [`newton`]: equilibria: Newton's method, load steps, volume control

pub mod cell;
#[cfg(test)]
mod central_differences;
pub mod linear;
pub mod load;
pub mod material;
pub mod newton;
pub mod problem;
pub mod solid;
pub mod surface;
pub mod tensor;
