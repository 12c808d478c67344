//! Density of contacts where films scatter together, or each by its signal: the readings' covariance at every point that is looked at.

use std::cell::RefCell;
use std::collections::HashMap;
use std::rc::Rc;
use std::sync::OnceLock;

use ndarray::{Array1, Array2};

use crate::arrangement::Arrangement;
use crate::field::film_field::LoadField;
use crate::fisher::joint_scatter::JointScatter;
use crate::simulate::posterior_grid::PosteriorGrid;
use crate::simulate::reading_density::Density;
use crate::simulate::reading_likelihood::Likelihood;

/// Covariances that are kept when the next readings come: 60 MB of 48 films.
const MOST_KEPT: usize = 8192;

/// Density of one layout.
pub(super) struct JointDensity<'l> {
    likelihood: &'l Likelihood,
    /// Fields at the finest parts of depths.
    fields: &'l [OnceLock<LoadField>],
    arrangement: Arrangement,
    grid: PosteriorGrid,
    cells: CellWeights,
    /// Covariances at points that were looked at: contacts near one another look at much the same.
    points: RefCell<HashMap<[usize; 2], Rc<JointScatter>>>,
}

impl<'l> JointDensity<'l> {
    /// Prepares for a layout.
    pub fn new(
        likelihood: &'l Likelihood,
        fields: &'l [OnceLock<LoadField>],
        arrangement: &Arrangement,
    ) -> Self {
        let grid = PosteriorGrid::new(likelihood.fields(), arrangement, likelihood.noise());
        let mut density = Self {
            cells: CellWeights::new(0, &[]),
            points: RefCell::default(),
            arrangement: arrangement.clone(),
            likelihood,
            fields,
            grid,
        };
        let middles = density.grid.middles().into_iter();
        let covariances: Vec<JointScatter> = middles.map(|at| density.covariance(at)).collect();
        density.cells = CellWeights::new(arrangement.films.len(), &covariances);
        density
    }

    /// Covariance at parts of a turn and of a depth.
    fn covariance(&self, [angle, depth]: [usize; 2]) -> JointScatter {
        let of_depth = || self.likelihood.field(self.likelihood.depths_mm[depth]);
        JointScatter::new(
            self.fields[depth].get_or_init(of_depth),
            &self.arrangement,
            self.likelihood.noise(),
            self.grid.angle_deg(angle),
        )
    }

    /// Covariance that is kept: samples of one contact look at much the same points.
    fn point(&self, at: [usize; 2]) -> Rc<JointScatter> {
        let mut points = self.points.borrow_mut();
        let kept = points.entry(at);
        Rc::clone(kept.or_insert_with(|| Rc::new(self.covariance(at))))
    }
}

impl Density for JointDensity<'_> {
    type After<'a>
        = &'a [f64]
    where
        Self: 'a;

    fn grid(&self) -> &PosteriorGrid {
        &self.grid
    }

    fn logs(&self, readings: &Array2<f64>) -> Array2<f64> {
        let mut points = self.points.borrow_mut();
        if points.len() > MOST_KEPT {
            points.clear();
        }
        self.cells.logs(readings)
    }

    fn after<'a>(&'a self, readings: &'a [f64]) -> &'a [f64] {
        readings
    }

    fn log(&self, at: [usize; 2], readings: &mut &[f64]) -> f64 {
        self.point(at).log(readings)
    }

    fn told(&self, at: [usize; 2], readings: &&[f64]) -> Vec<f64> {
        self.point(at).told(readings)
    }
}

/// Weights of readings in ln p at the cells' middles.
struct CellWeights {
    /// Parts without readings.
    constants: Array1<f64>,
    /// Weights of each film's reading, and of its square: films by cells.
    of_readings: Array2<f64>,
    of_squares: Array2<f64>,
    /// The modes' factors of readings: films by modes, cell after cell.
    of_modes: Array2<f64>,
    /// Parts of the means in them.
    of_means: Vec<f64>,
    /// Modes of each cell.
    counts: Vec<usize>,
}

impl CellWeights {
    fn new(films: usize, cells: &[JointScatter]) -> Self {
        let counts: Vec<usize> = cells.iter().map(|cell| cell.whitened.len()).collect();
        let modes = counts.iter().sum();
        let mut weights = Self {
            constants: Array1::zeros(cells.len()),
            of_readings: Array2::zeros((films, cells.len())),
            of_squares: Array2::zeros((films, cells.len())),
            of_modes: Array2::zeros((films, modes)),
            of_means: Vec::with_capacity(modes),
            counts,
        };
        for (number, cell) in cells.iter().enumerate() {
            let mut constant = cell.log_determinant;
            for (film, (mean, variance)) in cell.means.iter().zip(&cell.variances).enumerate() {
                weights.of_readings[[film, number]] = mean / variance;
                weights.of_squares[[film, number]] = -0.5 / variance;
                constant += mean * mean / variance;
            }
            weights.constants[number] = -0.5 * constant;
            for row in &cell.whitened {
                let column = weights.of_means.len();
                let mut of_mean = 0.0;
                for (film, (factor, mean)) in row.iter().zip(&cell.means).enumerate() {
                    weights.of_modes[[film, column]] = *factor;
                    of_mean += factor * mean;
                }
                weights.of_means.push(of_mean);
            }
        }
        weights
    }

    /// Values of ln p: rows of readings by cells.
    fn logs(&self, readings: &Array2<f64>) -> Array2<f64> {
        let mut logs = readings.dot(&self.of_readings);
        logs += &readings.mapv(|y| y * y).dot(&self.of_squares);
        logs += &self.constants;
        let scores = readings.dot(&self.of_modes);
        for (mut logs, scores) in logs.rows_mut().into_iter().zip(scores.rows()) {
            let mut scores = scores.iter().zip(&self.of_means);
            for (log, count) in logs.iter_mut().zip(&self.counts) {
                let own = scores.by_ref().take(*count);
                let squares: f64 = own
                    .map(|(score, mean)| (score - mean) * (score - mean))
                    .sum();
                *log += 0.5 * squares;
            }
        }
        logs
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::field::film_field::DepthFields;
    use crate::field::response_surface::Drawn;
    use crate::field::response_surface::tests::surface;
    use crate::fisher::bounds::tests::NOISE;
    use crate::simulate::reading_likelihood::Prepared;

    #[test]
    fn all_cells_at_once_have_the_density_of_each() {
        let fields = DepthFields::over_contacts(surface(), Drawn::All, true);
        let likelihood = Likelihood::new(fields, NOISE);
        let Prepared::AtPoints(fields) = &likelihood.prepared else {
            panic!("asked for together");
        };
        let arrangement = Arrangement::regular(6, &[0, 1], false);
        let density = JointDensity::new(&likelihood, fields, &arrangement);
        let readings =
            Array2::from_shape_fn((2, 12), |(row, film)| (1.3 * (row + film) as f64).sin());
        let logs = density.logs(&readings);
        for (cell, at) in density.grid.middles().into_iter().enumerate().step_by(97) {
            for row in 0..2 {
                let own = readings.row(row).to_vec();
                let expected = density.log(at, &mut density.after(&own));
                let found = logs[[row, cell]];
                assert!(
                    (found - expected).abs() < 1e-9 * expected.abs(),
                    "{found} {expected}"
                );
            }
        }
    }
}
