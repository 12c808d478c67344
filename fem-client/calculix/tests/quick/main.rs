//! Tests without an installed CalculiX.

#[cfg(unix)]
mod calculix_sources;
mod stand_in;
