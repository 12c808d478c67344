//! Strains of an equilibrium with their errors: of a point ([`probe`]), of cords and film (`glued_layers`), and all that a request asks for ([`surface_reader`]).

mod carcass_reading;
mod film_reading;
pub mod probe;
pub mod surface_reader;
