//! Simulation of a layout's errors, by estimating contacts from noisy readings.

use estimation::error_metrics::order_statistics::interpolated_quantile;
use ndarray::Array2;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

use crate::arrangement::Arrangement;
use crate::simulate::normal_pairs::normal_pair;
use crate::simulate::posterior::Estimator;
use crate::simulate::reading_likelihood::Likelihood;

/// Contacts in one period of a layout; as many more where there is none.
const CONTACTS: usize = 24;
/// Contacts of a layout without symmetry: every 2.5 degrees.
const MOST_CONTACTS: usize = 144;
/// Readings of one layout at one load that tell a root mean square to 3 %, and a 95th percentile to some 8 %.
pub const SAMPLES: usize = 480;
/// An estimate further off than this has lost the contact, degrees.
pub const LOST_DEG: f64 = 20.0;

/// Errors of a layout at one load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Simulated {
    /// Root mean square of the contact angle's error, degrees.
    pub rms_angle_deg: f64,
    /// Standard error of the root mean square by the number of samples, degrees.
    pub rms_angle_se_deg: f64,
    /// 95th percentile of the angle's error, degrees.
    pub p95_angle_deg: f64,
    /// Standard error of the percentile, degrees.
    pub p95_angle_se_deg: f64,
    /// Share of contacts that are off by more than [`LOST_DEG`].
    pub lost_share: f64,
    /// Root mean square of the depth's error, mm.
    pub rms_depth_mm: f64,
    /// Standard error of it by the number of samples, mm.
    pub rms_depth_se_mm: f64,
}

/// Standard normal numbers, the same for all layouts: by sample, then film.
#[derive(Debug, Clone, PartialEq)]
pub struct Draws {
    samples: usize,
    films: usize,
    normals: Vec<f64>,
}

impl Draws {
    /// Draws so many readings, or a few more, of layouts of up to so many films.
    pub fn new(seed: u64, samples: usize, films: usize) -> Self {
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        let most = MOST_CONTACTS * samples.div_ceil(MOST_CONTACTS);
        // The first of each pair alone.
        let normals = (0..most * films).map(|_| normal_pair(&mut rng)[0]);
        Self {
            samples,
            films,
            normals: normals.collect(),
        }
    }

    fn of(&self, sample: usize) -> &[f64] {
        &self.normals[sample * self.films..][..self.films]
    }
}

/// Estimates contacts at each of some depths (mm) from readings with noise.
///
/// # Panics
/// If there are more films than draws.
pub fn simulate(
    likelihood: &Likelihood,
    depths_mm: &[f64],
    arrangement: &Arrangement,
    draws: &Draws,
) -> Vec<Simulated> {
    let estimator = Estimator::new(likelihood, arrangement);
    let at = |depth: &f64| simulate_at(*depth, &estimator, likelihood, arrangement, draws);
    depths_mm.iter().map(at).collect()
}

fn simulate_at(
    depth_mm: f64,
    estimator: &Estimator<'_>,
    likelihood: &Likelihood,
    arrangement: &Arrangement,
    draws: &Draws,
) -> Simulated {
    let (field, noise) = (likelihood.field(depth_mm), likelihood.noise());
    let contacts = if arrangement.period_deg < 360.0 {
        CONTACTS
    } else {
        MOST_CONTACTS
    };
    let repeats = draws.samples.div_ceil(contacts);
    let (mut angles, mut depths) = (Vec::new(), Vec::new());
    for (c, contact) in arrangement.contacts(contacts).enumerate() {
        let readings: Vec<(f64, f64)> = arrangement
            .films
            .iter()
            .map(|film| {
                let (signal, apart) = (&field.kinds[film.kind].signal, film.theta_deg - contact);
                let reading = signal.at(apart);
                (reading, noise.variance(reading, signal.slope(apart)).sqrt())
            })
            .collect();
        let noisy = Array2::from_shape_fn((repeats, readings.len()), |(repeat, film)| {
            let (signal, deviation) = readings[film];
            signal + deviation * draws.of(c * repeats + repeat)[film]
        });
        for found in estimator.estimates(&noisy) {
            angles.push(apart(found.angle_deg, contact));
            depths.push(found.depth_mm - depth_mm);
        }
    }
    summary(angles, &depths)
}

/// Returns the distance of two angles, the short way round, degrees.
fn apart(a: f64, b: f64) -> f64 {
    let turned = (a - b).rem_euclid(360.0);
    turned.min(360.0 - turned)
}

fn summary(mut angles: Vec<f64>, depths: &[f64]) -> Simulated {
    let count = angles.len() as f64;
    angles.sort_by(f64::total_cmp);
    let at_share = |share: f64| interpolated_quantile(&angles, share);
    // One standard deviation of the binomial number below the percentile.
    let spread = (0.95 * 0.05 / count).sqrt();
    let [rms_angle_deg, rms_angle_se_deg] = root_mean_square(&angles);
    let [rms_depth_mm, rms_depth_se_mm] = root_mean_square(depths);
    Simulated {
        rms_angle_deg,
        rms_angle_se_deg,
        p95_angle_deg: at_share(0.95),
        p95_angle_se_deg: 0.5 * (at_share(0.95 + spread) - at_share(0.95 - spread)),
        lost_share: angles.iter().filter(|error| **error > LOST_DEG).count() as f64 / count,
        rms_depth_mm,
        rms_depth_se_mm,
    }
}

/// Root mean square of errors, and its standard error by their number.
fn root_mean_square(errors: &[f64]) -> [f64; 2] {
    let count = errors.len() as f64;
    let mean = |power: i32| errors.iter().map(|e| e.powi(power)).sum::<f64>() / count;
    let (square, fourth) = (mean(2), mean(4));
    let rms = square.sqrt();
    let of_squares = (fourth - square * square).max(0.0).sqrt() / count.sqrt();
    [
        rms,
        if rms > 0.0 {
            of_squares / (2.0 * rms)
        } else {
            0.0
        },
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::field::film_field::{DepthFields, Noise};
    use crate::fisher::bounds::bounds;
    use crate::fisher::bounds::tests::{NOISE, gaussian};

    fn simulated(
        fields: &DepthFields,
        arrangement: &Arrangement,
        noise: &Noise,
        draws: &Draws,
    ) -> Simulated {
        simulate(
            &Likelihood::new(fields.clone(), *noise),
            &[1.0],
            arrangement,
            draws,
        )[0]
    }

    #[test]
    fn dense_layouts_reach_their_bounds() {
        let fields = gaussian(14.0);
        let draws = Draws::new(1, SAMPLES, 48);
        for (units, kinds) in [(18, &[0, 1][..]), (24, &[0, 1]), (36, &[0])] {
            let arrangement = Arrangement::regular(units, kinds, false);
            let found = simulated(&fields, &arrangement, &NOISE, &draws);
            let bound = bounds(&fields.at(1.0), &arrangement, &NOISE)
                .expect("dense")
                .rms_angle_deg;
            // 480 samples tell a standard deviation to 1 / sqrt(960) of it, 3.2 %: three times that.
            let ratio = found.rms_angle_deg / bound;
            assert!((0.9..1.1).contains(&ratio), "{units}: {ratio}");
            assert!((found.rms_angle_se_deg / found.rms_angle_deg / 0.032 - 1.0).abs() < 0.2);
            // A bell's 95th percentile is 1.96 standard deviations.
            assert!(
                (found.p95_angle_deg / bound / 1.96 - 1.0).abs() < 0.15,
                "{units}"
            );
            assert_eq!(found.lost_share, 0.0);
        }
    }

    #[test]
    fn what_two_narrow_films_do_not_see_is_lost() {
        let found = simulated(
            &gaussian(5.0),
            &Arrangement::regular(2, &[0], false),
            &NOISE,
            &Draws::new(1, SAMPLES, 2),
        );
        assert!(
            found.lost_share > 0.5 && found.p95_angle_deg > 60.0,
            "{found:?}"
        );
        assert!(found.rms_angle_deg <= 180.0);
    }

    #[test]
    fn gains_that_spread_are_felt_as_their_bound_says() {
        let fields = gaussian(14.0);
        let noise = Noise {
            gain_std: 0.1,
            place_std_deg: 0.3,
            ..NOISE
        };
        let arrangement = Arrangement::regular(24, &[0, 1], false);
        let draws = Draws::new(2, SAMPLES, 48);
        let [plain, spread] =
            [NOISE, noise].map(|noise| simulated(&fields, &arrangement, &noise, &draws));
        let bound = bounds(&fields.at(1.0), &arrangement, &noise)
            .expect("dense")
            .rms_angle_deg;
        assert!(spread.rms_angle_deg > 1.5 * plain.rms_angle_deg);
        // The variances tell something of the contact as well, so that the bound by means alone may be undercut a little.
        assert!(
            (0.8..1.1).contains(&(spread.rms_angle_deg / bound)),
            "{} {bound}",
            spread.rms_angle_deg
        );
    }

    #[test]
    fn one_seed_gives_the_same_numbers() {
        let [a, b, c] = [7, 7, 8].map(|seed| Draws::new(seed, SAMPLES, 3));
        assert_eq!(a, b);
        assert_ne!(a, c);
        let mean = a.normals.iter().sum::<f64>() / a.normals.len() as f64;
        let square = a.normals.iter().map(|z| z * z).sum::<f64>() / a.normals.len() as f64;
        // 1728 numbers: three of their standard errors.
        assert!(
            mean.abs() < 3.0 / 1728f64.sqrt()
                && (square - 1.0).abs() < 3.0 * (2.0 / 1728f64).sqrt()
        );
    }
}
