//! The kernel from outside: contracts of all laws, and small problems with exact answers.

mod cube;
mod dragged_cube;
mod factor_precisions;
mod homogeneous_deformations;
mod kept_tangents;
mod law_contract;
mod mixed_solid;
mod plane_strain;
mod pressed_cube;
mod pressing_ground;
mod sphere_inflation;
mod state_rates;
mod stretched_cube;
mod surface_law_contract;
