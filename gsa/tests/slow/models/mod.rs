//! Models whose first-order indices are known, from random families.

pub mod families;
pub mod gaussian_ridge;
pub mod small_grid;
pub mod sum_of_products;
