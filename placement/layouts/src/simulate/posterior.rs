//! Posterior of angle and depth on a grid, from the readings of a layout.
//!
//! Flat prior on the contact angle and on the depths of the study, independent normal noise: ln p = -1/2 sum over films of (y - h)^2 / S + ln S. With 1 / S, h / S
//! and h^2 / S + ln S separated into products, a cell costs as many operations as there are products. The whole grid is looked at by its cells' middles; those
//! that may hold some of the mass are then cut into thirds, ninths or more, until a part is no wider than two standard deviations of the likelihood there: sums
//! of a bell over such steps are off by 1.4 %, and shift its mean by a twentieth of its deviation, at most.

use ndarray::{Array1, Array2};

use crate::arrangement::Arrangement;
use crate::simulate::lanes::largest;
use crate::simulate::posterior_grid::{Block, PosteriorGrid};
use crate::simulate::reading_likelihood::Likelihood;
use crate::simulate::turned_products::{Functions, TurnedProducts};

/// Distance below the largest ln p at which a part holds nothing: exp(-16) of it.
const NEGLIGIBLE: f64 = 16.0;

/// A part of an angle whose products weren't asked for.
const NONE: usize = usize::MAX;

/// Estimates angle and depth from readings of one layout.
pub struct Estimator<'l> {
    products: TurnedProducts<'l>,
    grid: PosteriorGrid,
    /// Parts of ln p at the cells' middles without readings.
    constants: Array1<f64>,
    /// Shortfalls of the cells' middles below their best points, at most.
    slacks: Vec<f64>,
    /// Weights of each film's reading in ln p at the cells' middles: films by cells.
    of_readings: Array2<f64>,
    /// Weights of each film's squared reading; none where the noise is the same everywhere.
    of_squares: Option<Array2<f64>>,
    /// Sine and cosine of the middles of the finest parts of angles.
    directions: Vec<(f64, f64)>,
}

/// Parts of the grid that were looked at after one set of readings.
struct Found<'r> {
    /// A reading of each film.
    readings: &'r [f64],
    /// Squares of them.
    squares: &'r [f64],
    /// Largest ln p so far.
    largest: f64,
    /// Begin of each angle's values among the products; `NONE` where they weren't asked for.
    firsts: Vec<usize>,
    /// Values of the products' functions, part after part.
    products: Vec<f64>,
    /// Logarithm of the mass of each point, and its parts along angle and depth.
    points: Vec<(f64, [usize; 2])>,
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
            slacks: grid.slacks(),
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
        logs += &self.constants;
        let rows = logs
            .rows()
            .into_iter()
            .zip(readings.rows())
            .zip(squares.rows());
        rows.map(|((logs, readings), squares)| {
            let [logs, readings, squares] = [logs, readings, squares].map(|row| row.to_vec());
            self.estimate(&logs, &readings, &squares)
        })
        .collect()
    }

    /// The posterior's means after these readings, for which ln p at the cells' middles is known.
    fn estimate(&self, logs: &[f64], readings: &[f64], squares: &[f64]) -> Estimated {
        let largest = largest(logs);
        let best = logs.iter().position(|log| *log == largest);
        let best = best.unwrap_or_default();
        let mut found = Found {
            readings,
            squares,
            largest,
            firsts: vec![NONE; self.grid.angles()],
            products: Vec::new(),
            points: Vec::new(),
        };
        // The best first: what is found there leaves less to look for elsewhere.
        self.refine(&self.grid.block(best, largest), &mut found);
        for (cell, (log, slack)) in logs.iter().zip(&self.slacks).enumerate() {
            if log + slack >= found.largest - NEGLIGIBLE && cell != best {
                self.refine(&self.grid.block(cell, *log), &mut found);
            }
        }
        self.mean(&found.points)
    }

    /// Cuts a block that may hold some of the mass into thirds along each side that asks for it, and so on; a piece that asks for no more is a point. All pieces are looked at
    /// before any is cut: the best of them leaves less to look for in the others.
    fn refine(&self, block: &Block, found: &mut Found<'_>) {
        let middle = block.middle();
        let [across, along] = block.cuts();
        let mut logs = [[block.log; 3]; 3];
        for (i, logs) in logs.iter_mut().enumerate().take(across) {
            for (j, log) in logs.iter_mut().enumerate().take(along) {
                let at = block.middle_of_piece([i, j]);
                if at != middle {
                    *log = self.log(at, found);
                    found.largest = found.largest.max(*log);
                }
            }
        }
        let (slack, are_points) = (block.slack_of_pieces(), block.is_cut_into_points());
        for (i, logs) in logs.iter().enumerate().take(across) {
            for (j, log) in logs.iter().enumerate().take(along) {
                if log + slack < found.largest - NEGLIGIBLE {
                    continue;
                }
                if are_points {
                    let at = block.middle_of_piece([i, j]);
                    found.points.push((log - block.log_parts, at));
                } else {
                    self.refine(&block.piece([i, j], *log), found);
                }
            }
        }
    }

    /// Value of ln p at parts of a turn and of a depth.
    fn log(&self, [angle, depth]: [usize; 2], found: &mut Found<'_>) -> f64 {
        let first = match found.firsts[angle] {
            NONE => {
                let first = found.products.len();
                let Found {
                    readings, squares, ..
                } = *found;
                self.products
                    .add_after(angle, readings, squares, &mut found.products);
                found.firsts[angle] = first;
                first
            }
            first => first,
        };
        let products = &found.products[first..first + self.products.row_len()];
        self.products.log(products, depth)
    }

    /// Means over points with the logarithms of their masses.
    fn mean(&self, points: &[(f64, [usize; 2])]) -> Estimated {
        let largest = points
            .iter()
            .map(|point| point.0)
            .fold(f64::NEG_INFINITY, f64::max);
        let (mut mass, mut depths, mut vector) = (0.0, 0.0, [0.0; 2]);
        for (log, [angle, depth]) in points.iter().filter(|point| point.0 > largest - NEGLIGIBLE) {
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
        let coefficients = &products.likelihood.coefficients.at(depth)[first..];
        let of_products = functions(products.at(angle)).chunks_exact(films);
        for (of_films, coefficient) in of_products.zip(coefficients) {
            for (film, function) in of_films.iter().enumerate() {
                weights[[film, cell]] += factor * coefficient * function;
            }
        }
    }
    weights
}
