//! Points of a study: which of them are solved for others, and where.

mod mirrored;
mod shared;
