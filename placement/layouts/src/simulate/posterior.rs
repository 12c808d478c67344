//! Posterior of angle and depth on a grid, from the readings of a layout.
//!
//! Flat prior on the contact angle and on the depths of the study, normal noise: ln p = -1/2 (r' C^-1 r + ln det C), with r the readings off their means and C
//! their covariance there. The whole grid is looked at by its cells' middles; those that may hold some of the mass are then cut into thirds, ninths or more, until
//! a part is no wider than two standard deviations of the likelihood there: sums of a bell over such steps are off by 1.4 %, and shift its mean by a twentieth of
//! its deviation, at most.

use ndarray::Array2;

use crate::simulate::lanes::largest;
use crate::simulate::posterior_grid::Block;
use crate::simulate::reading_density::Density;

/// Distance below the largest ln p at which a part holds nothing: exp(-12) of it.
const NEGLIGIBLE: f64 = 12.0;

/// Estimates angle and depth from readings of one layout.
pub(super) struct Estimator<'l, D> {
    density: D,
    /// Shortfalls of the cells' middles below their best points, at most.
    slacks: Vec<f64>,
    /// Sine and cosine of the middles of the finest parts of angles.
    directions: Vec<(f64, f64)>,
    /// Middles of the finest parts of depths, mm.
    depths_mm: &'l [f64],
}

/// Parts of the grid that were looked at after one set of readings.
struct Found<A> {
    after: A,
    /// Largest ln p so far.
    largest: f64,
    /// Logarithm of the mass of each point, and its parts along angle and depth.
    points: Vec<(f64, [usize; 2])>,
}

/// An estimate.
#[derive(Debug, Clone, PartialEq)]
pub struct Estimated {
    /// Circular mean of the posterior, degrees.
    pub angle_deg: f64,
    /// Mean of the posterior, mm.
    pub depth_mm: f64,
    /// Means of the vertical force, N, and of quantities that contacts differ in; none where they are read off the depth alone.
    pub told: Vec<f64>,
}

impl<'l, D: Density> Estimator<'l, D> {
    /// Makes an estimator by a density at these depths.
    pub fn new(density: D, depths_mm: &'l [f64]) -> Self {
        let grid = density.grid();
        let directions = (0..grid.angles()).map(|k| grid.angle_deg(k).to_radians().sin_cos());
        Self {
            directions: directions.collect(),
            slacks: grid.slacks(),
            density,
            depths_mm,
        }
    }

    /// The posterior's means after each row of readings, one of each film.
    pub fn estimates(&self, readings: &Array2<f64>) -> Vec<Estimated> {
        let logs = self.density.logs(readings);
        let rows = logs.rows().into_iter().zip(readings.rows());
        rows.map(|(logs, readings)| self.estimate(&logs.to_vec(), &readings.to_vec()))
            .collect()
    }

    /// The posterior's means after these readings, for which ln p at the cells' middles is known.
    fn estimate(&self, logs: &[f64], readings: &[f64]) -> Estimated {
        let largest = largest(logs);
        let best = logs.iter().position(|log| *log == largest);
        let best = best.unwrap_or_default();
        let mut found = Found {
            after: self.density.after(readings),
            largest,
            points: Vec::new(),
        };
        let grid = self.density.grid();
        // The best first: what is found there leaves less to look for elsewhere.
        self.refine(&grid.block(best, largest), &mut found);
        for (cell, (log, slack)) in logs.iter().zip(&self.slacks).enumerate() {
            if log + slack >= found.largest - NEGLIGIBLE && cell != best {
                self.refine(&grid.block(cell, *log), &mut found);
            }
        }
        self.mean(&found)
    }

    /// Cuts a block that may hold some of the mass into thirds along each side that asks for it, and so on; a piece that asks for no more is a point. All pieces are looked at
    /// before any is cut: the best of them leaves less to look for in the others.
    fn refine<'a>(&'a self, block: &Block, found: &mut Found<D::After<'a>>) {
        let middle = block.middle();
        let [across, along] = block.cuts();
        let mut logs = [[block.log; 3]; 3];
        for (i, logs) in logs.iter_mut().enumerate().take(across) {
            for (j, log) in logs.iter_mut().enumerate().take(along) {
                let at = block.middle_of_piece([i, j]);
                if at != middle {
                    *log = self.density.log(at, &mut found.after);
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

    /// Means over points with the logarithms of their masses.
    fn mean(&self, found: &Found<D::After<'_>>) -> Estimated {
        let points = &found.points;
        let largest = points
            .iter()
            .map(|point| point.0)
            .fold(f64::NEG_INFINITY, f64::max);
        let (mut mass, mut depths, mut vector) = (0.0, 0.0, [0.0; 2]);
        let mut told: Vec<f64> = Vec::new();
        for (log, at) in points.iter().filter(|point| point.0 > largest - NEGLIGIBLE) {
            let weight = (log - largest).exp();
            let [angle, depth] = *at;
            let (sin, cos) = self.directions[angle];
            mass += weight;
            depths += weight * self.depths_mm[depth];
            vector = [vector[0] + weight * cos, vector[1] + weight * sin];
            let own = self.density.told(*at, &found.after);
            told.resize(own.len(), 0.0);
            for (sum, own) in told.iter_mut().zip(own) {
                *sum += weight * own;
            }
        }
        Estimated {
            angle_deg: vector[1].atan2(vector[0]).to_degrees(),
            depth_mm: depths / mass,
            told: told.into_iter().map(|sum| sum / mass).collect(),
        }
    }
}
