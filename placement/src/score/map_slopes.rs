//! Changes of the strains over the map by each input, to first order: a plane through all solved points by least squares.

use faer::linalg::solvers::{Llt, Solve};
use faer::{Mat, Side};
use fem_client::solver::StrainMap;
use fem_client::solver::direction::{Direction, PerDirection};
use layouts::arrangement::FilmKind;
use layouts::field::hermite::DEGREES;

use crate::points::archive::Outcome;
use crate::score::quantity::over_map;
use documents::study::Study;

/// Strains over the map per standard deviation of each input.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct MapSlopes {
    theta_deg: Vec<f64>,
    phi_deg: Vec<f64>,
    /// Rows x columns of each input.
    of_inputs: Vec<PerDirection<Vec<f64>>>,
}

impl MapSlopes {
    /// Fits the outcomes at these values; `None` without a map, or where the points don't tell the inputs apart.
    pub(crate) fn of(study: &Study, values: &[Vec<f64>], outcomes: &[Outcome]) -> Option<Self> {
        let solved: Vec<(&Vec<f64>, &StrainMap)> = values
            .iter()
            .zip(outcomes)
            .filter_map(|(values, outcome)| Some((values, outcome.as_ref().ok()?.map.as_ref()?)))
            .collect();
        let first = solved.first()?.1;
        let inputs = study.inputs.len();
        let deviations = |point: usize, input: usize| {
            let law = &study.inputs[input].distribution;
            (solved[point].0[input] - law.mean()) / law.std()
        };
        let weights = weights(solved.len(), inputs, deviations)?;
        let slope = |input: usize, direction: Direction| -> Vec<f64> {
            let mut slope = vec![0.0; over_map(first)[direction].len()];
            for (point, (_, map)) in solved.iter().enumerate() {
                let weight = weights[(input, point)];
                let strains = &over_map(map)[direction];
                for (sum, strain) in slope.iter_mut().zip(strains) {
                    *sum += weight * strain;
                }
            }
            slope
        };
        let of_input = |input| PerDirection::of(|direction| slope(input, direction));
        Some(Self {
            theta_deg: first.theta_deg.clone(),
            phi_deg: first.phi_deg.clone(),
            of_inputs: (0..inputs).map(of_input).collect(),
        })
    }

    /// Number of the inputs.
    pub(crate) fn inputs(&self) -> usize {
        self.of_inputs.len()
    }

    /// Change of a film's signal around the wheel, a sample each degree from -180, per standard deviation of an input. Beyond the map's ends it is as there. `None`
    /// of films along other directions than x and y.
    pub(crate) fn of_signal(&self, input: usize, kind: &FilmKind) -> Option<Vec<f64>> {
        let mut mean = vec![0.0; DEGREES];
        let points = kind.points();
        for (angle_deg, weight) in kind.reads.directions(kind.angle_deg) {
            let direction = match angle_deg {
                0.0 => Direction::X,
                90.0 => Direction::Y,
                _ => return None,
            };
            let slopes = &self.of_inputs[input][direction];
            for point in &points {
                for (sum, degree) in mean.iter_mut().zip(-180..180) {
                    let theta = f64::from(degree) + point.wheel_deg;
                    *sum += weight * point.share * self.at(slopes, point.section_deg, theta);
                }
            }
        }
        Some(mean)
    }

    /// Interpolates between rows and columns.
    fn at(&self, slopes: &[f64], phi_deg: f64, theta_deg: f64) -> f64 {
        let rows = between(&self.phi_deg, phi_deg);
        let columns = between(&self.theta_deg, theta_deg);
        let width = self.theta_deg.len();
        let of_row = |row: usize| -> f64 {
            let parts = columns.iter();
            parts
                .map(|(column, share)| share * slopes[row * width + column])
                .sum()
        };
        rows.iter().map(|(row, share)| share * of_row(*row)).sum()
    }
}

/// Weights of the points in each input's slope: rows of (Z' Z)^-1 Z', where Z has a column of ones and one for each input.
fn weights(
    points: usize,
    inputs: usize,
    deviations: impl Fn(usize, usize) -> f64,
) -> Option<Mat<f64>> {
    let design = Mat::from_fn(points, inputs + 1, |point, column| match column {
        0 => 1.0,
        input => deviations(point, input - 1),
    });
    let normal = design.transpose() * &design;
    let factor = Llt::new(normal.as_ref(), Side::Lower).ok()?;
    let solved = factor.solve(design.transpose().to_owned());
    let weights = Mat::from_fn(inputs, points, |input, point| solved[(input + 1, point)]);
    let is_finite = weights
        .col_iter()
        .all(|column| column.iter().all(|w| w.is_finite()));
    (inputs > 0 && is_finite).then_some(weights)
}

/// The places before and after one in an increasing list, with their shares; its ends beyond them.
fn between(places: &[f64], place: f64) -> [(usize, f64); 2] {
    let after = places.partition_point(|&other| other <= place);
    let last = places.len() - 1;
    if after == 0 || after > last {
        let end = after.min(last);
        return [(end, 1.0), (end, 0.0)];
    }
    let share = (place - places[after - 1]) / (places[after] - places[after - 1]);
    [(after - 1, 1.0 - share), (after, share)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn weights_give_the_slopes_of_a_plane() {
        // A cross of five points and one off its lines; 3 + 2 a - b.
        let points = [
            [0.0, 0.0],
            [1.5, 0.0],
            [-1.5, 0.0],
            [0.0, 1.0],
            [0.0, -2.0],
            [1.0, 1.0],
        ];
        let weights = weights(points.len(), 2, |point, input| points[point][input]);
        let weights = weights.expect("they tell both apart");
        for (input, expected) in [(0, 2.0), (1, -1.0)] {
            let value = |[a, b]: [f64; 2]| 3.0 + 2.0 * a - b;
            let found: f64 = (0..points.len())
                .map(|k| weights[(input, k)] * value(points[k]))
                .sum();
            assert!((found - expected).abs() < 1e-12, "{found}");
        }
        // Along one line nothing is known of the other input.
        assert!(super::weights(3, 2, |point, input| points[point][input]).is_none());
    }

    #[test]
    fn a_place_lies_between_two_or_at_an_end() {
        let places = [-10.0, 0.0, 5.0];
        assert_eq!(between(&places, -11.0), [(0, 1.0), (0, 0.0)]);
        assert_eq!(between(&places, -2.5), [(0, 0.25), (1, 0.75)]);
        assert_eq!(between(&places, 5.0), [(2, 1.0), (2, 0.0)]);
        assert_eq!(between(&places, 9.0), [(2, 1.0), (2, 0.0)]);
    }
}
