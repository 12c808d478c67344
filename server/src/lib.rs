//! The strainsite program: command line, HTTP service, queue and database. The only async code of the project.
//!
//! The modules, in reading order:
//!
//! - [`config`]: settings from flags and environment
//! - [`telemetry`]: the log
//! - [`store`]: the database, all SQL

pub mod config;
pub mod store;
pub mod telemetry;
