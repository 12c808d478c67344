//! Strains of an equilibrium with their errors: of a point ([`probe`]), and all that a request asks for ([`surface_reader`]).

pub mod probe;
pub mod surface_reader;
