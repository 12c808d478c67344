//! Edge of the service: who is let in, and how much a client can ask for.

mod access;
mod limits;
