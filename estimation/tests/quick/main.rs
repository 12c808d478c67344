//! What the crate's parts do together.

mod process;
mod virtual_rig;
mod whole;
