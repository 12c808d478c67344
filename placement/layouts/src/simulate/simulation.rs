//! Simulation of a layout's errors, by estimating contacts from noisy readings.

use estimation::error_metrics::order_statistics::interpolated_quantile;
use ndarray::Array2;

use crate::arrangement::Arrangement;
use crate::field::response_surface::Drawn;
use crate::simulate::drawn_contacts::{DrawnContacts, TrueContact};
use crate::simulate::draws::Draws;
use crate::simulate::posterior::Estimator;
use crate::simulate::reading_likelihood::Likelihood;

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
    /// Root mean square of the vertical force's error, N, and its standard error, where contacts differ; else the depth's tells it.
    pub rms_force_n: Option<[f64; 2]>,
}

impl Simulated {
    /// Root mean square of the vertical force's error, N, and its standard error; where contacts don't differ by its slope over the depth, N/mm.
    pub fn force_n(&self, slope: f64) -> [f64; 2] {
        let by_depth = [self.rms_depth_mm * slope, self.rms_depth_se_mm * slope];
        self.rms_force_n.unwrap_or(by_depth)
    }
}

/// Estimates contacts that an estimate takes for the usual ones at each of some depths, mm, from readings with noise.
///
/// # Panics
/// If there are more films than draws.
pub(crate) fn simulate_unknown(
    likelihood: &Likelihood,
    contacts: &[(f64, TrueContact)],
    arrangement: &Arrangement,
    draws: &Draws,
) -> Vec<Simulated> {
    let estimator = Estimator::new(likelihood, arrangement);
    let of = |(depth, contact): &(f64, TrueContact)| {
        let all = DrawnContacts::all_as(contact.clone(), likelihood, *depth);
        simulate_at(*depth, (&estimator, likelihood), arrangement, draws, &all)
    };
    contacts.iter().map(of).collect()
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
    drawn: Drawn,
) -> Vec<Simulated> {
    let estimator = Estimator::new(likelihood, arrangement);
    let at = |depth: &f64| {
        let contacts = DrawnContacts::new(likelihood, *depth, (draws, drawn));
        simulate_at(
            *depth,
            (&estimator, likelihood),
            arrangement,
            draws,
            &contacts,
        )
    };
    depths_mm.iter().map(at).collect()
}

fn simulate_at(
    depth_mm: f64,
    (estimator, likelihood): (&Estimator<'_>, &Likelihood),
    arrangement: &Arrangement,
    draws: &Draws,
    drawn: &DrawnContacts,
) -> Simulated {
    let contacts = Draws::contacts_of(arrangement);
    let repeats = draws.repeats(contacts);
    let (mut angles, mut depths, mut forces) = (Vec::new(), Vec::new(), Vec::new());
    for (c, contact) in arrangement.contacts(contacts).enumerate() {
        let sample = |repeat: usize| c * repeats + repeat;
        let noisy = Array2::from_shape_fn((repeats, arrangement.films.len()), |(repeat, film)| {
            let laid = &arrangement.films[film];
            let signal = drawn.signal(sample(repeat), laid.kind);
            let apart = laid.theta_deg - contact;
            let reading = signal.at(apart);
            let variance = likelihood.noise().variance(reading, signal.slope(apart));
            reading + variance.sqrt() * draws.of(sample(repeat))[film]
        });
        for (repeat, found) in estimator.estimates(&noisy).into_iter().enumerate() {
            angles.push(apart(found.angle_deg, contact));
            depths.push(found.depth_mm - depth_mm);
            let believed = || likelihood.force_n(found.depth_mm);
            forces.extend(drawn.force_n(sample(repeat)).map(|own| believed() - own));
        }
    }
    summary(angles, &depths, &forces)
}

/// Returns the distance of two angles, the short way round, degrees.
fn apart(a: f64, b: f64) -> f64 {
    let turned = (a - b).rem_euclid(360.0);
    turned.min(360.0 - turned)
}

fn summary(mut angles: Vec<f64>, depths: &[f64], forces: &[f64]) -> Simulated {
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
        rms_force_n: (!forces.is_empty()).then(|| root_mean_square(forces)),
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
    use crate::field::response_surface::tests::surface;
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
            Drawn::All,
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

    /// Contacts at other pressures: a film that feels their share of its signal beside its noise knows the force by what the mean one has.
    #[test]
    fn what_contacts_differ_in_is_felt_as_an_error() {
        let mut fields = DepthFields::over_contacts(surface(), Drawn::All);
        let arrangement = Arrangement::regular(24, &[0, 1], false);
        let draws = Draws::new(1, SAMPLES, 48);
        let likelihood = Likelihood::new(fields.clone(), NOISE);
        let at = |likelihood: &Likelihood, drawn| {
            simulate(likelihood, &[1.0], &arrangement, &draws, drawn)[0]
        };
        let alone = likelihood.alone();
        let [nothing, pressure, traction] = [0, 1, 2].map(|k| at(&alone[k].2, alone[k].0));
        let [nothing_n, pressure_n] = [nothing, pressure].map(|found| found.force_n(13.0)[0]);
        // Ten per cent of pressure are eight of the signal, taken for eight of the depth, and one newton: evenly to either side 1.2 N.
        let expected = 0.1 / 3f64.sqrt() * (13.0 * 0.8 + 10.0);
        let beside = (nothing_n * nothing_n + expected * expected).sqrt();
        assert!(
            (pressure_n / beside - 1.0).abs() < 0.15,
            "{pressure_n} {beside}"
        );
        let all = at(&likelihood, Drawn::All);
        assert!(traction.p95_angle_deg > nothing.p95_angle_deg);
        assert!(all.force_n(13.0)[0] > pressure_n);
        // Where they don't differ the force's error is the depth's by its slope.
        fields.contacts = None;
        let alike = simulated(&fields, &arrangement, &NOISE, &draws);
        assert_eq!(alike.rms_force_n, None);
        assert!((alike.force_n(13.0)[0] - 13.0 * alike.rms_depth_mm).abs() < 1e-12);
    }
}
