//! Glued films: their transfer, and what they give beside the contact.

mod glued_layouts;
mod glued_rigs;
mod known_films;
