//! Posterior of angle and depth on a grid, from the readings of a layout.
//!
//! Flat prior on the contact angle and on the depths of the study, independent normal noise: ln p = -1/2 sum over films of (y - h)^2 / S + ln S. With 1 / S, h / S
//! and h^2 / S + ln S separated into products, a cell costs as many operations as there are products. The whole grid is looked at by its cells' middles; those
//! that may hold some of the mass are then cut into thirds, ninths or more, until a part is no wider than two standard deviations of the likelihood there: sums
//! of a bell over such steps are off by 1.4 %, and shift its mean by a twentieth of its deviation, at most.

use ndarray::{Array2, ArrayView1};

use crate::arrangement::Arrangement;
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
    constants: Vec<f64>,
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
        let highest = logs.iter().zip(self.grid.slacks());
        let may_hold = highest.map(|(log, slack)| log + slack >= largest - NEGLIGIBLE);
        let cells = may_hold.enumerate().filter(|(_, holds)| *holds);
        let mut cells: Vec<(f64, usize)> = cells.map(|(cell, _)| (logs[cell], cell)).collect();
        // The best first: what is found there leaves less to look for elsewhere.
        cells.sort_unstable_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
        let mut found = Found {
            readings,
            squares,
            largest,
            firsts: vec![NONE; self.grid.angles()],
            products: Vec::new(),
            points: Vec::new(),
        };
        for (log, cell) in cells {
            self.refine(&self.grid.block(cell, log), &mut found);
        }
        self.mean(&found.points)
    }

    /// Cuts a block that may hold some of the mass into thirds along each side that asks for it, and so on; a part that asks for no more is a point. All pieces are looked at
    /// before any is cut: the best of them leaves less to look for in the others.
    fn refine(&self, block: &Block, found: &mut Found<'_>) {
        if block.highest() < found.largest - NEGLIGIBLE {
            return;
        }
        let middle = block.middle();
        if block.parts == [1, 1] {
            found.points.push((block.log - block.log_parts, middle));
            return;
        }
        let [across, along] = block.cuts();
        let mut logs = [[block.log; 3]; 3];
        for (i, logs) in logs.iter_mut().enumerate().take(across) {
            for (j, log) in logs.iter_mut().enumerate().take(along) {
                let at = block.piece([i, j], 0.0).middle();
                if at != middle {
                    *log = self.log(at, found);
                    found.largest = found.largest.max(*log);
                }
            }
        }
        for (i, logs) in logs.iter().enumerate().take(across) {
            for (j, log) in logs.iter().enumerate().take(along) {
                self.refine(&block.piece([i, j], *log), found);
            }
        }
    }

    /// Value of ln p at parts of a turn and of a depth.
    fn log(&self, [angle, depth]: [usize; 2], found: &mut Found<'_>) -> f64 {
        let first = match found.firsts[angle] {
            NONE => {
                let first = found.products.len();
                let after = self.products.after(angle, found.readings, found.squares);
                found.products.extend(after);
                found.firsts[angle] = first;
                first
            }
            first => first,
        };
        let products = &found.products[first..first + self.products.rank()];
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
