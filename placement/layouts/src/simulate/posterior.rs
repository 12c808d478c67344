//! Posterior of angle and depth on a grid, from the readings of a layout.
//!
//! Flat prior on the contact angle and on the depths of the study, independent normal noise: ln p = -1/2 sum over films of (y - h)^2 / S + ln S. With 1 / S, h / S
//! and h^2 / S + ln S separated into products, a cell costs as many operations as there are products. The whole grid is looked at by its cells' middles; those
//! that may hold some of the mass are then cut into thirds, ninths or more, until a part is no wider than two standard deviations of the likelihood there: sums
//! of a bell over such steps are off by 1.4 %, and shift its mean by a twentieth of its deviation, at most.

use std::cell::OnceCell;
use std::collections::HashMap;

use ndarray::{Array2, ArrayView1};

use crate::arrangement::Arrangement;
use crate::field::film_field::{DepthFields, LoadField, Noise};
use crate::field::separated::Separated;
use crate::fisher::bounds::information;

/// Cells around the wheel, 2 degrees each.
const ANGLE_CELLS: usize = 180;
/// Cells over the depths of the study.
const DEPTH_CELLS: usize = 16;
/// Most parts of a cell along either side, a power of three: parts of parts share their middles.
const MOST_PARTS: usize = 27;
/// Standard deviations that a part may be wide.
const STEP: f64 = 2.0;
/// Distance below the largest ln p at which a part holds nothing: exp(-16) of it.
const NEGLIGIBLE: f64 = 16.0;
/// Share of the largest field that separation may leave out: of a signal 100 times the noise it changes ln p by some hundredths.
const TOLERANCE: f64 = 3e-6;

/// The likelihood of readings of some kinds of film, whatever their layout.
pub struct Likelihood {
    fields: DepthFields,
    noise: Noise,
    /// Middles of the finest parts of the depth cells, mm.
    depths_mm: Vec<f64>,
    /// Factors of the products by part of a depth, those of readings first, then those of squared readings.
    coefficients: Vec<Vec<f64>>,
    parts: Parts,
}

/// The three parts of ln p as separated fields; that of squared readings is left out where the noise is the same everywhere.
struct Parts {
    linear: Separated,
    quadratic: Option<Separated>,
    constant: Separated,
}

/// Estimates angle and depth from readings of one layout.
pub struct Estimator<'l> {
    likelihood: &'l Likelihood,
    films: usize,
    /// Parts of a cell around the wheel for which there are functions.
    finest: usize,
    /// Sine and cosine of the middles of these parts.
    directions: Vec<(f64, f64)>,
    /// Cells by angle, then depth.
    cells: Vec<Cell>,
    /// Weights of each film's reading, and of its square, in ln p at the cells' middles.
    at_middles: [Option<Array2<f64>>; 2],
    arrangement: Arrangement,
    /// Products' functions by part of an angle, where they were asked for.
    functions: Vec<OnceCell<Functions>>,
}

/// Products' functions at an angle.
struct Functions {
    /// Functions with readings at each film, product after product.
    linear: Vec<f64>,
    /// Functions with squared readings; empty where the noise is the same everywhere.
    quadratic: Vec<f64>,
    /// Functions without readings, summed over the films.
    constant: Vec<f64>,
}

/// Demands of the likelihood on a cell of the grid.
#[derive(Debug, Clone, Copy)]
struct Cell {
    /// Parts along angle and depth.
    parts: [usize; 2],
    /// Shortfall of its middle below its best point by either side, at most.
    slack: [f64; 2],
    /// Part of ln p at its middle without readings.
    constant: f64,
}

/// Part of a cell, among the finest parts.
#[derive(Debug, Clone, Copy)]
struct Block {
    /// First parts along angle and depth.
    first: [usize; 2],
    /// Finest parts that it spans.
    spans: [usize; 2],
    /// Parts that it is still to be cut into.
    parts: [usize; 2],
    /// Parts of the whole cell.
    share: f64,
    /// Shortfall of its middle below its best point by either side, at most.
    slack: [f64; 2],
    /// Value of ln p at its middle.
    log: f64,
}

impl Block {
    fn middle(&self) -> [usize; 2] {
        [0, 1].map(|k| self.first[k] + self.spans[k] / 2)
    }

    /// Thirds along each side that is to be cut, with its own ln p. The slack goes by the square of a side.
    fn thirds(&self) -> impl Iterator<Item = Self> + use<> {
        let whole = *self;
        let cuts = whole.parts.map(|parts| if parts > 1 { 3 } else { 1 });
        let part = move |i: usize, j: usize| Self {
            first: [(0, i), (1, j)].map(|(k, i)| whole.first[k] + i * whole.spans[k] / cuts[k]),
            spans: [0, 1].map(|k| whole.spans[k] / cuts[k]),
            parts: [0, 1].map(|k| whole.parts[k] / cuts[k]),
            slack: [0, 1].map(|k| whole.slack[k] / (cuts[k] * cuts[k]) as f64),
            ..whole
        };
        (0..cuts[0]).flat_map(move |i| (0..cuts[1]).map(move |j| part(i, j)))
    }
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

impl Likelihood {
    /// Prepares films of these fields; depths are flat between the ends of the solved ones.
    pub fn new(fields: DepthFields, noise: Noise) -> Self {
        let depths_mm = middles(fields.depths.ends(), DEPTH_CELLS * MOST_PARTS);
        let parts = separate(&fields, &depths_mm, &noise);
        Self {
            fields,
            noise,
            coefficients: joined(&parts),
            parts,
            depths_mm,
        }
    }

    /// The fields.
    pub fn fields(&self) -> &DepthFields {
        &self.fields
    }

    /// The fields at a depth, mm.
    pub fn field(&self, depth_mm: f64) -> LoadField {
        self.fields.at(depth_mm)
    }

    /// Errors of readings.
    pub fn noise(&self) -> &Noise {
        &self.noise
    }
}

impl<'l> Estimator<'l> {
    /// Makes an estimator for this layout.
    pub fn new(likelihood: &'l Likelihood, arrangement: &Arrangement) -> Self {
        let cells = cells(&likelihood.fields, arrangement, &likelihood.noise);
        let finest = cells.iter().map(|cell| cell.parts[0]).fold(1, usize::max);
        let angles_deg = middles([0.0, 360.0], ANGLE_CELLS * finest);
        let directions = angles_deg.iter().map(|angle| angle.to_radians().sin_cos());
        let mut estimator = Self {
            likelihood,
            films: arrangement.films.len(),
            finest,
            cells,
            at_middles: [None, None],
            directions: directions.collect(),
            arrangement: arrangement.clone(),
            functions: angles_deg.iter().map(|_| OnceCell::new()).collect(),
        };
        for cell in 0..estimator.cells.len() {
            estimator.cells[cell].constant = estimator.constant_at(cell);
        }
        let parts = &likelihood.parts;
        let of_readings = estimator.weights(|at| &at.linear, (0, 1.0));
        let rank = parts.linear.rank();
        let of_squares = || estimator.weights(|at| &at.quadratic, (rank, -0.5));
        let of_squares = parts.quadratic.is_some().then(of_squares);
        estimator.at_middles = [Some(of_readings), of_squares];
        estimator
    }

    /// The products' functions at a part of an angle.
    fn at(&self, fine: usize) -> &Functions {
        self.functions[fine].get_or_init(|| {
            let angle_deg = (fine as f64 + 0.5) * 360.0 / self.functions.len() as f64;
            let parts = &self.likelihood.parts;
            let films = |field| at_films(field, &self.arrangement, angle_deg);
            Functions {
                linear: films(&parts.linear),
                quadratic: parts.quadratic.as_ref().map(films).unwrap_or_default(),
                constant: summed(&films(&parts.constant), self.films),
            }
        })
    }

    /// Films by cells: the products' functions at the films times their factors at the cells' middles, which begin at a number, times a factor of all.
    fn weights(
        &self,
        functions: impl Fn(&Functions) -> &Vec<f64>,
        (first, factor): (usize, f64),
    ) -> Array2<f64> {
        let mut weights = Array2::zeros((self.films, self.cells.len()));
        for cell in 0..self.cells.len() {
            let [angle, depth] = self.block(cell, 0.0).middle();
            let coefficients = &self.likelihood.coefficients[depth][first..];
            let products = functions(self.at(angle)).chunks_exact(self.films);
            for (of_films, coefficient) in products.zip(coefficients) {
                for (film, function) in of_films.iter().enumerate() {
                    weights[[film, cell]] += factor * coefficient * function;
                }
            }
        }
        weights
    }

    /// Returns the part of ln p at the middle of a cell without readings.
    fn constant_at(&self, cell: usize) -> f64 {
        let [angle, depth] = self.block(cell, 0.0).middle();
        let sums = &self.at(angle).constant;
        let coefficients = &self.likelihood.coefficients[depth];
        -0.5 * dot(&coefficients[coefficients.len() - sums.len()..], sums)
    }

    /// The posterior's means after each row of readings, one of each film.
    pub fn estimates(&self, readings: &Array2<f64>) -> Vec<Estimated> {
        let squares = readings.mapv(|y| y * y);
        let mut logs = Array2::zeros((readings.nrows(), self.cells.len()));
        for (values, weights) in [readings, &squares].into_iter().zip(&self.at_middles) {
            if let Some(weights) = weights {
                logs += &values.dot(weights);
            }
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
        let with_constants = of_readings.iter().zip(&self.cells);
        let logs: Vec<f64> = with_constants
            .map(|(log, cell)| log + cell.constant)
            .collect();
        let largest = logs.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let may_hold =
            |cell: &usize| logs[*cell] + sum(self.cells[*cell].slack) >= largest - NEGLIGIBLE;
        let mut cells: Vec<usize> = (0..logs.len()).filter(may_hold).collect();
        // The best first: what is found there leaves less to look for elsewhere.
        cells.sort_by(|&a, &b| logs[b].total_cmp(&logs[a]));
        let mut found = Found {
            largest,
            products: HashMap::new(),
            points: Vec::new(),
        };
        for cell in cells {
            let block = self.block(cell, logs[cell]);
            self.refine(&block, readings, squares, &mut found);
        }
        self.mean(&found.points)
    }

    /// The whole of a cell.
    fn block(&self, cell: usize, log: f64) -> Block {
        let Cell { parts, slack, .. } = self.cells[cell];
        Block {
            first: [
                cell / DEPTH_CELLS * self.finest,
                cell % DEPTH_CELLS * MOST_PARTS,
            ],
            spans: [self.finest, MOST_PARTS],
            parts,
            share: (parts[0] * parts[1]) as f64,
            slack,
            log,
        }
    }

    /// Cuts a block that may hold some of the mass into thirds along each side that asks for it, and so on; a part that asks for no more is a point.
    fn refine(&self, block: &Block, readings: &[f64], squares: &[f64], found: &mut Found) {
        if block.log + sum(block.slack) < found.largest - NEGLIGIBLE {
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
                let products = products.or_insert_with(|| self.products(fine, readings, squares));
                third.log = self.log(products, depth_part);
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
            depths += weight * self.likelihood.depths_mm[*depth];
            vector = [vector[0] + weight * cos, vector[1] + weight * sin];
        }
        Estimated {
            angle_deg: vector[1].atan2(vector[0]).to_degrees(),
            depth_mm: depths / mass,
        }
    }

    /// The products' functions at an angle, after these readings.
    fn products(&self, angle: usize, readings: &[f64], squares: &[f64]) -> Vec<f64> {
        let Functions {
            linear,
            quadratic,
            constant,
        } = self.at(angle);
        let linear = linear.chunks_exact(self.films);
        let quadratic = quadratic.chunks_exact(self.films);
        let of_readings = linear.map(|films| dot(films, readings));
        let of_squares = quadratic.map(|films| -0.5 * dot(films, squares));
        let constant = constant.iter().map(|sum| -0.5 * sum);
        of_readings.chain(of_squares).chain(constant).collect()
    }

    /// The sum of the first products at a depth.
    fn log(&self, products: &[f64], depth: usize) -> f64 {
        let coefficients = &self.likelihood.coefficients[depth];
        dot(&coefficients[..products.len()], products)
    }
}

/// Four sums side by side: one alone would wait for each addition.
fn dot(a: &[f64], b: &[f64]) -> f64 {
    let mut sums = [0.0; 4];
    let (fours_a, fours_b) = (a.chunks_exact(4), b.chunks_exact(4));
    let rest = fours_a.remainder().iter().zip(fours_b.remainder());
    let rest: f64 = rest.map(|(a, b)| a * b).sum();
    for (a, b) in fours_a.zip(fours_b) {
        for k in 0..4 {
            sums[k] += a[k] * b[k];
        }
    }
    (sums[0] + sums[1]) + (sums[2] + sums[3]) + rest
}

/// Middles of equal parts of an interval.
fn middles([low, high]: [f64; 2], count: usize) -> Vec<f64> {
    let step = (high - low) / count as f64;
    (0..count).map(|k| low + (k as f64 + 0.5) * step).collect()
}

/// Returns what the information asks of each cell: that at the middles of the cell and its neighbours.
fn cells(fields: &DepthFields, arrangement: &Arrangement, noise: &Noise) -> Vec<Cell> {
    let ends = fields.depths.ends();
    let widths = [
        360.0 / ANGLE_CELLS as f64,
        (ends[1] - ends[0]) / DEPTH_CELLS as f64,
    ];
    let loads: Vec<LoadField> = middles(ends, DEPTH_CELLS)
        .iter()
        .map(|depth| fields.at(*depth))
        .collect();
    let mut found = Vec::with_capacity(ANGLE_CELLS * DEPTH_CELLS);
    for contact in middles([0.0, 360.0], ANGLE_CELLS) {
        found.extend(loads.iter().map(|load| {
            let information = information(load, arrangement, noise, contact);
            [0, 1].map(|k| widths[k] * information.entry(k, k).sqrt())
        }));
    }
    let largest = |cell: usize| {
        let (angle, depth) = (cell / DEPTH_CELLS, cell % DEPTH_CELLS);
        let angles = [ANGLE_CELLS - 1, 0, 1].map(|by| (angle + by) % ANGLE_CELLS);
        let depths = depth.saturating_sub(1)..=(depth + 1).min(DEPTH_CELLS - 1);
        let near = angles
            .into_iter()
            .flat_map(|angle| depths.clone().map(move |depth| angle * DEPTH_CELLS + depth));
        near.fold([0.0f64; 2], |largest, cell| {
            [0, 1].map(|k| largest[k].max(found[cell][k]))
        })
    };
    let cell = |cell: usize| {
        let deviations = largest(cell);
        Cell {
            parts: deviations.map(parts_of),
            slack: deviations.map(|d| d * d / 8.0),
            constant: 0.0,
        }
    };
    (0..found.len()).map(cell).collect()
}

fn sum([along, across]: [f64; 2]) -> f64 {
    along + across
}

/// Parts of a cell that is so many standard deviations wide.
fn parts_of(deviations: f64) -> usize {
    let mut parts = 1;
    while STEP * (parts as f64) < deviations && parts < MOST_PARTS {
        parts *= 3;
    }
    parts
}

/// 1 / S, h / S and h^2 / S + ln S of every kind at every depth.
fn separate(fields: &DepthFields, depths_mm: &[f64], noise: &Noise) -> Parts {
    let loads: Vec<LoadField> = depths_mm.iter().map(|depth| fields.at(*depth)).collect();
    let over = |part: &dyn Fn(f64, f64) -> f64| -> Separated {
        let kind = |kind: &crate::field::film_field::KindField| -> Vec<f64> {
            let angles = (-180..180).map(f64::from).zip(kind.signal.samples());
            angles
                .map(|(u, signal)| part(*signal, noise.variance(*signal, kind.signal.slope(u))))
                .collect()
        };
        let fields: Vec<Vec<Vec<f64>>> = loads
            .iter()
            .map(|load| load.kinds.iter().map(kind).collect())
            .collect();
        Separated::of(&fields, TOLERANCE)
    };
    Parts {
        linear: over(&|signal, variance| signal / variance),
        quadratic: (!noise.is_plain()).then(|| over(&|_, variance| 1.0 / variance)),
        constant: over(&|signal, variance| {
            signal * signal / variance + (variance / (noise.floor * noise.floor)).ln()
        }),
    }
}

/// The factors of all products by depth.
fn joined(parts: &Parts) -> Vec<Vec<f64>> {
    let all = |depth: usize| {
        let quadratic = parts
            .quadratic
            .iter()
            .flat_map(|field| &field.coefficients[depth]);
        let linear = parts.linear.coefficients[depth].iter();
        linear
            .chain(quadratic)
            .chain(&parts.constant.coefficients[depth])
            .copied()
            .collect()
    };
    (0..parts.linear.coefficients.len()).map(all).collect()
}

/// Returns each product's function at each film with the contact at an angle.
fn at_films(field: &Separated, arrangement: &Arrangement, angle_deg: f64) -> Vec<f64> {
    let product = |r: usize| {
        let films = arrangement.films.iter();
        films.map(move |film| field.functions[film.kind][r].at(film.theta_deg - angle_deg))
    };
    (0..field.rank()).flat_map(product).collect()
}

/// Sums products' functions over the films.
fn summed(at_films: &[f64], films: usize) -> Vec<f64> {
    at_films
        .chunks_exact(films)
        .map(|films| films.iter().sum())
        .collect()
}
