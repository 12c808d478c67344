//! Density of contacts where noise is the same everywhere: ln p as sums of products.

use ndarray::{Array1, Array2};

use crate::arrangement::Arrangement;
use crate::simulate::posterior_grid::PosteriorGrid;
use crate::simulate::reading_density::Density;
use crate::simulate::reading_likelihood::{Likelihood, Products};
use crate::simulate::turned_products::TurnedProducts;

/// A part of an angle whose products weren't asked for.
const NONE: usize = usize::MAX;

/// Density of one layout.
pub(super) struct SeparatedDensity<'l> {
    products: TurnedProducts<'l>,
    grid: PosteriorGrid,
    /// Parts of ln p at the cells' middles without readings.
    constants: Array1<f64>,
    /// Weights of each film's reading in ln p at the cells' middles: films by cells.
    of_readings: Array2<f64>,
}

/// Readings, and products that were made for them.
pub(super) struct AfterReadings<'r> {
    /// A reading of each film.
    readings: &'r [f64],
    /// Begin of each angle's values among the products; `NONE` where they weren't asked for.
    firsts: Vec<usize>,
    /// Values of the products' functions, part after part.
    products: Vec<f64>,
}

impl<'l> SeparatedDensity<'l> {
    /// Prepares for a layout.
    pub fn new(likelihood: &Likelihood, own: &'l Products, arrangement: &Arrangement) -> Self {
        let grid = PosteriorGrid::new(likelihood.fields(), arrangement, likelihood.noise());
        let products = TurnedProducts::new(own, arrangement, grid.angles());
        let middles = grid.middles();
        Self {
            constants: middles.iter().map(|at| products.constant(*at)).collect(),
            of_readings: weights(&products, &middles),
            products,
            grid,
        }
    }
}

impl Density for SeparatedDensity<'_> {
    type After<'a>
        = AfterReadings<'a>
    where
        Self: 'a;

    fn grid(&self) -> &PosteriorGrid {
        &self.grid
    }

    fn logs(&self, readings: &Array2<f64>) -> Array2<f64> {
        readings.dot(&self.of_readings) + &self.constants
    }

    fn after<'a>(&'a self, readings: &'a [f64]) -> AfterReadings<'a> {
        AfterReadings {
            readings,
            firsts: vec![NONE; self.grid.angles()],
            products: Vec::new(),
        }
    }

    fn log(&self, [angle, depth]: [usize; 2], after: &mut AfterReadings<'_>) -> f64 {
        let first = match after.firsts[angle] {
            NONE => {
                let first = after.products.len();
                self.products
                    .add_after(angle, after.readings, &mut after.products);
                after.firsts[angle] = first;
                first
            }
            first => first,
        };
        let products = &after.products[first..first + self.products.row_len()];
        self.products.log(products, depth)
    }

    fn told(&self, _: [usize; 2], _: &AfterReadings<'_>) -> Vec<f64> {
        Vec::new()
    }
}

/// Films by cells: the functions with readings at the films times their factors at the cells' middles.
fn weights(products: &TurnedProducts<'_>, middles: &[[usize; 2]]) -> Array2<f64> {
    let films = products.films();
    let mut weights = Array2::zeros((films, middles.len()));
    for (cell, &[angle, depth]) in middles.iter().enumerate() {
        let coefficients = products.own.coefficients.at(depth);
        let of_products = products.at(angle).linear.chunks_exact(films);
        for (of_films, coefficient) in of_products.zip(coefficients) {
            for (film, function) in of_films.iter().enumerate() {
                weights[[film, cell]] += coefficient * function;
            }
        }
    }
    weights
}
