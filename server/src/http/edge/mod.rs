//! Edge that every request passes on its way to a handler and back.
//!
//! - `problem_document`: what a client is told when a request can't be answered
//! - [`request_id`]: every request has an identifier
//! - [`guard`]: who may ask
//! - [`access`]: the token, where one is asked for
//! - `extract`: reads addresses and queries
//! - `document_body`: reads the body of a submitted study
//! - `conditional`: answers that needn't be sent again
//! - [`packed`]: answers packed by gzip
//! - [`streams`]: places for event streams
//! - `answer_limits`: how many large answers are made and held at once
//! - `listener`, `connection_slots`, [`reading`]: accepts connections, keeps places for those who belong, and drops those that nobody reads from
//! - [`refusals`]: bodies for what hyper refuses

pub mod access;
pub(crate) mod answer_limits;
pub(crate) mod conditional;
pub(crate) mod connection_slots;
pub(crate) mod document_body;
pub(crate) mod extract;
pub mod guard;
pub(crate) mod listener;
pub mod packed;
pub(crate) mod problem_document;
pub mod reading;
pub mod refusals;
pub mod request_id;
pub mod streams;
