//! UM-Bridge's protocol 1.0 (L. Seelinger et al., JOSS 8 (2023) 4748), from both sides: a study as a model that other programs ask over HTTP, and models of others that are asked.
//!
//! - [`forward_model`]: values of the inputs to strains and reaction, with derivatives
//! - [`model_routes`]: requests and refusals as the protocol has them
//! - [`asked_model`]: a model that another program serves
//! - [`http_exchange`]: questions to its server, asked again while that is away
//! - [`stored_runs`]: its runs at the points of a plan, stored before they count
//! - `lenient_json`: what servers answer

pub(crate) mod asked_model;
pub(crate) mod forward_model;
pub(crate) mod http_exchange;
mod lenient_json;
pub(crate) mod model_routes;
pub(crate) mod stored_runs;
