//! A study as a model that other programs ask over HTTP, by UM-Bridge's protocol 1.0 (L. Seelinger et al., JOSS 8 (2023) 4748).
//!
//! - [`forward_model`]: values of the inputs to strains and reaction, with derivatives
//! - [`model_routes`]: requests and refusals as the protocol has them

pub(crate) mod forward_model;
pub(crate) mod model_routes;
