//! Posterior of angle and depth on a grid, from the readings of a layout.
//!
//! Flat prior on the contact angle and on the depths of the study, independent normal noise: ln p = -1/2 sum over films of (y - h)^2 / S + ln S. With 1 / S, h / S
//! and h^2 / S + ln S separated into products, a cell costs as many operations as there are products. The whole grid is looked at by its cells' middles; those
//! that may hold some of the mass are then cut into thirds, ninths or more, until a part is no wider than two standard deviations of the likelihood there: sums
//! of a bell over such steps are off by 1.4 %, and shift its mean by a twentieth of its deviation, at most.

use std::collections::HashMap;

use ndarray::{Array2, ArrayView1};

use crate::arrangement::Arrangement;
use crate::simulate::posterior_grid::{Block, PosteriorGrid};
use crate::simulate::reading_likelihood::Likelihood;
use crate::simulate::turned_products::{Functions, TurnedProducts};

/// Distance below the largest ln p at which a part holds nothing: exp(-16) of it.
const NEGLIGIBLE: f64 = 16.0;

/// Estimates angle and depth from readings of one layout.
pub struct Estimator<'l> {
    products: TurnedProducts<'l>,
    grid: PosteriorGrid,
    /// Parts of ln p at the cells' middles without readings.
    constants: Vec<f64>,
    /// Weights of each film's reading in ln p at the cells' middles: films by cells.
    of_readings: Array2<f64>,
    /// Weights of each film's squared reading; none where the noise is the same everywhere.
    of_squares: Option<Array2<f64>>,
    /// Sine and cosine of the middles of the finest parts of angles.
    directions: Vec<(f64, f64)>,
}

/// Parts of the grid that were looked at after one set of readings.
struct Found {
    /// Largest ln p so far.
    largest: f64,
    /// Values of the products' functions by part of an angle.
    products: HashMap<usize, Vec<f64>>,
    /// Logarithm of the mass of each point, and its parts along angle and depth.
    points: Vec<(f64, usize, usize)>,
}

/// An estimate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimated {
    /// Circular mean of the posterior, degrees.
    pub angle_deg: f64,
    /// Mean of the posterior, mm.
    pub depth_mm: f64,
}

impl<'l> Estimator<'l> {
    /// Makes an estimator for this layout.
    pub fn new(likelihood: &'l Likelihood, arrangement: &Arrangement) -> Self {
        let grid = PosteriorGrid::new(likelihood.fields(), arrangement, likelihood.noise());
        let products = TurnedProducts::new(likelihood, arrangement, grid.angles());
        let middles = (0..grid.len()).map(|cell| grid.block(cell, 0.0).middle());
        let middles: Vec<[usize; 2]> = middles.collect();
        let rank = likelihood.parts.linear.rank();
        let of_squares = || weights(&products, &middles, |at| &at.quadratic, (rank, -0.5));
        let directions = (0..grid.angles()).map(|k| products.angle_deg(k).to_radians().sin_cos());
        Self {
            constants: middles.iter().map(|at| products.constant(*at)).collect(),
            of_readings: weights(&products, &middles, |at| &at.linear, (0, 1.0)),
            of_squares: likelihood.parts.quadratic.is_some().then(of_squares),
            directions: directions.collect(),
            products,
            grid,
        }
    }

    /// The posterior's means after each row of readings, one of each film.
    pub fn estimates(&self, readings: &Array2<f64>) -> Vec<Estimated> {
        let squares = readings.mapv(|y| y * y);
        let mut logs = readings.dot(&self.of_readings);
        if let Some(of_squares) = &self.of_squares {
            logs += &squares.dot(of_squares);
        }
        let rows = logs
            .rows()
            .into_iter()
            .zip(readings.rows())
            .zip(squares.rows());
        rows.map(|((logs, readings), squares)| {
            let [readings, squares] = [readings, squares].map(|row| row.to_vec());
            self.estimate(logs, &readings, &squares)
        })
        .collect()
    }

    /// The posterior's means after these readings, whose part of ln p at the cells' middles is known.
    fn estimate(
        &self,
        of_readings: ArrayView1<'_, f64>,
        readings: &[f64],
        squares: &[f64],
    ) -> Estimated {
        let with_constants = of_readings.iter().zip(&self.constants);
        let logs: Vec<f64> = with_constants
            .map(|(log, constant)| log + constant)
            .collect();
        let largest = logs.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let blocks = logs
            .iter()
            .enumerate()
            .map(|(cell, log)| self.grid.block(cell, *log));
        let may_hold = |block: &Block| block.highest() >= largest - NEGLIGIBLE;
        let mut blocks: Vec<Block> = blocks.filter(may_hold).collect();
        // The best first: what is found there leaves less to look for elsewhere.
        blocks.sort_by(|a, b| b.log.total_cmp(&a.log));
        let mut found = Found {
            largest,
            products: HashMap::new(),
            points: Vec::new(),
        };
        for block in &blocks {
            self.refine(block, readings, squares, &mut found);
        }
        self.mean(&found.points)
    }

    /// Cuts a block that may hold some of the mass into thirds along each side that asks for it, and so on; a part that asks for no more is a point.
    fn refine(&self, block: &Block, readings: &[f64], squares: &[f64], found: &mut Found) {
        if block.highest() < found.largest - NEGLIGIBLE {
            return;
        }
        let [angle, depth] = block.middle();
        if block.parts == [1, 1] {
            let mass = block.log - block.share.ln();
            found.points.push((mass, angle, depth));
            return;
        }
        for mut third in block.thirds() {
            let [fine, depth_part] = third.middle();
            if [fine, depth_part] != [angle, depth] {
                let products = found.products.entry(fine);
                let products =
                    products.or_insert_with(|| self.products.after(fine, readings, squares));
                third.log = self.products.log(products, depth_part);
                found.largest = found.largest.max(third.log);
            }
            self.refine(&third, readings, squares, found);
        }
    }

    /// Means over points with the logarithms of their masses.
    fn mean(&self, points: &[(f64, usize, usize)]) -> Estimated {
        let largest = points
            .iter()
            .map(|point| point.0)
            .fold(f64::NEG_INFINITY, f64::max);
        let (mut mass, mut depths, mut vector) = (0.0, 0.0, [0.0; 2]);
        for (log, angle, depth) in points.iter().filter(|point| point.0 > largest - NEGLIGIBLE) {
            let weight = (log - largest).exp();
            let (sin, cos) = self.directions[*angle];
            mass += weight;
            depths += weight * self.products.likelihood.depths_mm[*depth];
            vector = [vector[0] + weight * cos, vector[1] + weight * sin];
        }
        Estimated {
            angle_deg: vector[1].atan2(vector[0]).to_degrees(),
            depth_mm: depths / mass,
        }
    }
}

/// Films by cells: the products' functions at the films times their factors at the cells' middles, which begin at a number, times a factor of all.
fn weights(
    products: &TurnedProducts<'_>,
    middles: &[[usize; 2]],
    functions: impl Fn(&Functions) -> &Vec<f64>,
    (first, factor): (usize, f64),
) -> Array2<f64> {
    let films = products.films();
    let mut weights = Array2::zeros((films, middles.len()));
    for (cell, &[angle, depth]) in middles.iter().enumerate() {
        let coefficients = &products.likelihood.coefficients[depth][first..];
        let of_products = functions(products.at(angle)).chunks_exact(films);
        for (of_films, coefficient) in of_products.zip(coefficients) {
            for (film, function) in of_films.iter().enumerate() {
                weights[[film, cell]] += factor * coefficient * function;
            }
        }
    }
    weights
}
