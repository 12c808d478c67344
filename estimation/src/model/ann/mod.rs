//! Small neural networks: layers of nodes, trained by L-BFGS on all rows at once.
//!
//! - `activation`: what a node makes of its sum, and its slope
//! - `network`: layers, loss and gradient
//! - `ensemble`: several networks, stopped early on left-out cycles; their mean is the estimate

mod activation;
mod ensemble;
mod network;

pub use ensemble::Ensemble;
pub(crate) use ensemble::{Sizes, nodes_and_weights};
pub use network::{Shape, train};
