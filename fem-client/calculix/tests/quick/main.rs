//! Tests without an installed CalculiX.

#[cfg(unix)]
mod calculix_sources;
#[cfg(unix)]
mod stand_in;
