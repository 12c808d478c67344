//! Models whose first-order indices are known, from random families.

#[path = "../support/known.rs"]
mod known;

pub mod families;
pub mod gaussian_ridge;
pub mod small_grid;
pub mod sum_of_products;

pub use known::Known;
