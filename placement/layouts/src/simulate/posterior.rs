//! Posterior of angle and depth on a grid, from the readings of a layout.
//!
//! Flat prior on the contact angle and on the depths of the study, independent normal noise: ln p = -1/2 sum over films of (y - h)^2 / S + ln S. With 1 / S, h / S
//! and h^2 / S + ln S separated into products, a cell costs as many operations as there are products. The whole grid is looked at by its cells' middles; those
//! that may hold some of the mass are then cut into thirds, ninths or more, until a part is no wider than two standard deviations of the likelihood there: sums
//! of a bell over such steps are off by 1.4 %, and shift its mean by a twentieth of its deviation, at most.

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
/// Distance below the largest ln p at which a part holds nothing: exp(-25) of it.
const NEGLIGIBLE: f64 = 25.0;
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
    /// Functions of the products at each film by part of an angle, product after product.
    linear: Vec<Vec<f64>>,
    /// Functions with squared readings; empty where the noise is the same everywhere.
    quadratic: Vec<Vec<f64>>,
    /// Functions without readings, summed over the films.
    constant: Vec<Vec<f64>>,
}

/// Demands of the likelihood on a cell of the grid.
#[derive(Debug, Clone, Copy)]
struct Cell {
    /// Parts along angle and depth.
    parts: [usize; 2],
    /// Shortfall of its middle below its best point, at most.
    slack: f64,
    /// Part of ln p at its middle without readings.
    constant: f64,
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
        let parts = &likelihood.parts;
        let films = arrangement.films.len();
        let quadratic = parts.quadratic.as_ref();
        let mut estimator = Self {
            likelihood,
            films,
            finest,
            cells,
            linear: at_films(&parts.linear, arrangement, &angles_deg),
            quadratic: quadratic
                .map_or_else(Vec::new, |field| at_films(field, arrangement, &angles_deg)),
            constant: summed(&parts.constant, arrangement, &angles_deg),
            directions: angles_deg
                .iter()
                .map(|angle| angle.to_radians().sin_cos())
                .collect(),
        };
        for cell in 0..estimator.cells.len() {
            estimator.cells[cell].constant = estimator.constant_at(cell);
        }
        estimator
    }

    /// Returns the part of ln p at the middle of a cell without readings.
    fn constant_at(&self, cell: usize) -> f64 {
        let (angle, depth) = (cell / DEPTH_CELLS, cell % DEPTH_CELLS);
        let sums = &self.constant[angle * self.finest + self.finest / 2];
        let coefficients = &self.likelihood.coefficients[depth * MOST_PARTS + MOST_PARTS / 2];
        -0.5 * dot(&coefficients[coefficients.len() - sums.len()..], sums)
    }

    /// The posterior's means after these readings, one of each film.
    pub fn estimate(&self, readings: &[f64]) -> Estimated {
        let squares: Vec<f64> = readings.iter().map(|y| y * y).collect();
        let mut logs = Vec::with_capacity(self.cells.len());
        for angle in 0..ANGLE_CELLS {
            let middle = angle * self.finest + self.finest / 2;
            let products = self.of_readings(middle, readings, &squares);
            logs.extend((0..DEPTH_CELLS).map(|depth| {
                let constant = self.cells[angle * DEPTH_CELLS + depth].constant;
                constant + self.log(&products, depth * MOST_PARTS + MOST_PARTS / 2)
            }));
        }
        let limit = logs.iter().copied().fold(f64::NEG_INFINITY, f64::max) - NEGLIGIBLE;
        let mut points = Vec::new();
        for (angle, column) in self.cells.chunks_exact(DEPTH_CELLS).enumerate() {
            let mut products: Vec<Option<Vec<f64>>> = vec![None; self.finest];
            for (depth, cell) in column.iter().enumerate() {
                if logs[angle * DEPTH_CELLS + depth] + cell.slack < limit {
                    continue;
                }
                let share = (cell.parts[0] * cell.parts[1]) as f64;
                for part in parts(cell.parts[0], self.finest) {
                    let fine = angle * self.finest + part;
                    let products = products[part]
                        .get_or_insert_with(|| self.products(fine, readings, &squares));
                    points.extend(parts(cell.parts[1], MOST_PARTS).map(|part| {
                        let depth = depth * MOST_PARTS + part;
                        (self.log(products, depth) - share.ln(), fine, depth)
                    }));
                }
            }
        }
        self.mean(&points)
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
        let mut products = self.of_readings(angle, readings, squares);
        products.extend(self.constant[angle].iter().map(|sum| -0.5 * sum));
        products
    }

    /// Returns the products that readings enter, which come first.
    fn of_readings(&self, angle: usize, readings: &[f64], squares: &[f64]) -> Vec<f64> {
        let mut products: Vec<f64> = Vec::with_capacity(self.likelihood.coefficients[0].len());
        products.extend(
            self.linear[angle]
                .chunks_exact(self.films)
                .map(|films| dot(films, readings)),
        );
        if let Some(quadratic) = self.quadratic.get(angle) {
            products.extend(
                quadratic
                    .chunks_exact(self.films)
                    .map(|films| -0.5 * dot(films, squares)),
            );
        }
        products
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

/// Middles of a cell's so many parts among those of its finest.
fn parts(count: usize, finest: usize) -> impl Iterator<Item = usize> {
    let stride = finest / count;
    (0..count).map(move |part| part * stride + stride / 2)
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
            slack: deviations.iter().map(|d| d * d / 8.0).sum(),
            constant: 0.0,
        }
    };
    (0..found.len()).map(cell).collect()
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

/// Returns by angle each product's function at each film.
fn at_films(field: &Separated, arrangement: &Arrangement, angles_deg: &[f64]) -> Vec<Vec<f64>> {
    let at = |angle: &f64| {
        let product = |r: usize| {
            arrangement
                .films
                .iter()
                .map(move |film| field.functions[film.kind][r].at(film.theta_deg - angle))
        };
        (0..field.rank()).flat_map(product).collect()
    };
    angles_deg.iter().map(at).collect()
}

/// Returns by angle each product's function, summed over the films.
fn summed(field: &Separated, arrangement: &Arrangement, angles_deg: &[f64]) -> Vec<Vec<f64>> {
    let at = |angle: &f64| {
        let product = |r: usize| {
            let films = arrangement.films.iter();
            films
                .map(|film| field.functions[film.kind][r].at(film.theta_deg - angle))
                .sum()
        };
        (0..field.rank()).map(product).collect()
    };
    angles_deg.iter().map(at).collect()
}
