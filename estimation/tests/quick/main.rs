//! Tests of what the crate's parts do together.

mod fuzzed;
mod process;
mod spiked;
mod virtual_rig;
mod whole;
