//! Work that is given to other machines, and comes back: taking in what another database of this program has, points by their content keys, studies by their identifiers.
//!
//! A file is read whole from a private copy and compared with its hashes, and taken in one transaction, or refused and named. Doing it again changes nothing.

mod differing;
mod giving;
pub mod parts;
mod taking;
pub mod target;
pub mod whole_file;
