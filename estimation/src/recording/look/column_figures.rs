//! Figures of one column: range, noise, level without a force, drift.

use crate::error_metrics::order_statistics::upper_median;
use crate::recording::Recording;
use crate::recording::unloaded::unloaded_rows;

/// Median of the sizes of normal deviates: what their median is divided by gives their deviation.
const NORMAL_MEDIAN: f64 = 0.6745;
/// Fewest measured rows without a force that tell a drift: ten in each third.
const FEWEST_UNLOADED: usize = 30;

/// Figures of a column's measured values.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ColumnFigures {
    /// Rows with a value.
    pub measured: usize,
    /// Least and greatest value; none of none.
    pub range: Option<(f64, f64)>,
    /// Deviation of the noise: median size of differences between neighbours over sqrt(2) 0.6745. Slow signals and single steps leave it as it is. None of fewer than two values.
    pub noise: Option<f64>,
    /// Median where no force acts; none where no row is known to be so.
    pub unloaded: Option<f64>,
    /// Median of the last third of the rows without a force less that of the first third; none of fewer than 30.
    pub drift: Option<f64>,
}

impl ColumnFigures {
    /// Figures of values, NaN where nothing was measured, and of the rows without a force.
    pub fn of(values: &[f64], unloaded: &[usize]) -> Self {
        let known: Vec<f64> = measured(values).map(|(_, value)| value).collect();
        let at_rest = unloaded.iter().filter_map(|row| values.get(*row).copied());
        let at_rest: Vec<f64> = at_rest.filter(|value| value.is_finite()).collect();
        let least = known.iter().copied().fold(f64::INFINITY, f64::min);
        let greatest = known.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        Self {
            measured: known.len(),
            range: (!known.is_empty()).then_some((least, greatest)),
            noise: upper_median(steps(&known))
                .map(|step| step / (std::f64::consts::SQRT_2 * NORMAL_MEDIAN)),
            unloaded: upper_median(at_rest.iter().copied()),
            drift: drift(&at_rest),
        }
    }
}

/// Rows that are known to be without a force: none of a run that has no forces.
pub fn rows_at_rest(run: &Recording) -> Vec<usize> {
    match run.forces.ncols() {
        0 => Vec::new(),
        _ => unloaded_rows(run),
    }
}

/// Rows with a value, and their values.
pub(super) fn measured(values: &[f64]) -> impl Iterator<Item = (usize, f64)> {
    let numbered = values.iter().copied().enumerate();
    numbered.filter(|(_, value)| value.is_finite())
}

/// Sizes of the differences between neighbours.
fn steps(known: &[f64]) -> impl Iterator<Item = f64> {
    known
        .iter()
        .zip(known.iter().skip(1))
        .map(|(a, b)| (b - a).abs())
}

/// Robust deviation of the differences between neighbours. Where most are 0, as those of a column with few digits, that of the others; 0 where all are.
pub(super) fn step_deviation(known: &[f64]) -> f64 {
    let of =
        |steps: &mut dyn Iterator<Item = f64>| upper_median(steps).unwrap_or(0.0) / NORMAL_MEDIAN;
    match of(&mut steps(known)) {
        0.0 => of(&mut steps(known).filter(|step| *step > 0.0)),
        deviation => deviation,
    }
}

fn drift(at_rest: &[f64]) -> Option<f64> {
    let third = at_rest.len() / 3;
    if at_rest.len() < FEWEST_UNLOADED {
        return None;
    }
    let median = |part: Option<&[f64]>| upper_median(part?.iter().copied());
    let last = median(at_rest.get(at_rest.len() - third..))?;
    Some(last - median(at_rest.get(..third))?)
}

#[cfg(test)]
mod tests {
    use ndarray::array;
    use rand::RngExt;
    use rand_chacha::ChaCha8Rng;
    use rand_chacha::rand_core::SeedableRng;

    use super::*;

    #[test]
    fn figures_are_those_of_the_measured_values() {
        let nan = f64::NAN;
        let found = ColumnFigures::of(&[1.0, nan, 3.0, 2.0, 7.0], &[0, 1, 3]);
        assert_eq!((found.measured, found.range), (4, Some((1.0, 7.0))));
        // Differences 2, 1, 5.
        assert_eq!(found.noise, Some(2.0 / (2.0_f64.sqrt() * 0.6745)));
        assert_eq!((found.unloaded, found.drift), (Some(2.0), None));
        assert_eq!(
            ColumnFigures::of(&[nan, nan], &[0]),
            ColumnFigures::default()
        );
        assert_eq!(ColumnFigures::of(&[4.0], &[]).noise, None);
    }

    #[test]
    fn noise_is_the_deviation_of_normal_noise_on_a_slow_signal() {
        let mut random = ChaCha8Rng::seed_from_u64(1);
        let mut normal = || {
            let (radius, turn): (f64, f64) = (random.random(), random.random());
            (-2.0 * (1.0 - radius).ln()).sqrt() * (std::f64::consts::TAU * turn).cos()
        };
        let values: Vec<f64> = (0..20_000)
            .map(|row| (1e-3 * f64::from(row)).sin() + 0.25 * normal())
            .collect();
        let noise = ColumnFigures::of(&values, &[]).noise.unwrap_or(0.0);
        // The median of 20 000 sizes is within 3 % of its expectation.
        assert!((noise / 0.25 - 1.0).abs() < 0.03, "{noise}");
    }

    #[test]
    fn drift_is_told_by_the_rows_without_a_force() {
        let level: Vec<f64> = (0..60)
            .map(|row| if row % 2 == 0 { f64::from(row) } else { 1e3 })
            .collect();
        let at_rest: Vec<usize> = (0..60).step_by(2).collect();
        let found = ColumnFigures::of(&level, &at_rest);
        // Medians of 0 to 18 and of 40 to 58, the upper ones of two in the middle.
        assert_eq!(found.drift, Some(50.0 - 10.0));
        assert_eq!(found.unloaded, Some(30.0));
        assert_eq!(
            ColumnFigures::of(&level, at_rest.get(1..).unwrap_or_default()).drift,
            None
        );
    }

    #[test]
    fn a_run_without_forces_has_no_rows_at_rest() {
        let mut run = Recording {
            name: "r".to_owned(),
            time_s: vec![0.0, 1.0, 2.0],
            signals: array![[1.0], [2.0], [3.0]],
            forces: array![[0.1], [10.0], [f64::NAN]],
            cycle: None,
        };
        assert_eq!(rows_at_rest(&run), [0]);
        run.forces = ndarray::Array2::zeros((3, 0));
        assert!(rows_at_rest(&run).is_empty());
    }
}
