//! Piezoelectric films and their amplifiers: what they make of the film's tension. Pure: numbers in, numbers out.
//!
//! - [`laminate`]: stiffness of a film of several layers
//! - [`piezo`]: the film's charge and capacitance
//! - [`amplifier`]: what is left of the charge where it is read

pub mod amplifier;
pub mod laminate;
pub mod piezo;
