//! Who is let in, and how much a client can ask for.

mod access;
mod guard;
mod limits;
