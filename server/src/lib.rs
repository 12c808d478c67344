//! The strainsite program: HTTP and command line over `service` and `store`.
//!
//! The modules, in reading order:
//!
//! - `config`: settings from flags and environment
//! - `telemetry`: the log
//! - [`token`]: the secret that lets a client in
//! - [`http`]: routes and dashboard
//! - `umbridge`: UM-Bridge: a study as a model for other programs, and models of others
//! - [`running`]: database, queue and HTTP together
//! - [`cli`]: the command line

pub mod cli;
pub(crate) mod config;
pub mod http;
pub mod running;
pub(crate) mod telemetry;
pub mod token;
pub(crate) mod umbridge;
