//! Scenes, and what is asked of the solvers that answer for them. Knows no finite elements.
//!
//! A [`scene::Scene`] says what is pressed and how. A [`solver::Solver`] turns a scene into an equilibrium and reads
//! the strains of the inner surface off it. The modules, in reading order:
//!
//! - [`hexadecimal`]: hashes as text
//! - [`film`]: what a piezoelectric film and its amplifier make of a tension
//! - [`scene`]: the scene document, its defaults, its reader, and changes of single fields
//! - [`solver`]: the one trait between the product and any solver, with its request and response
//! - [`closed_form`]: the stand-in solver for tests of what stands above

pub mod closed_form;
pub mod film;
pub mod hexadecimal;
pub mod scene;
pub mod solver;
