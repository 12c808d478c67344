//! Simulation of a layout's errors, by estimating contacts from noisy readings.

use estimation::error_metrics::order_statistics::interpolated_quantile;
use ndarray::Array2;

use crate::arrangement::Arrangement;
use crate::field::response_surface::Drawn;
use crate::simulate::drawn_contacts::{DrawnContacts, TrueContact};
use crate::simulate::draws::Draws;
use crate::simulate::joint_density::JointDensity;
use crate::simulate::posterior::Estimator;
use crate::simulate::reading_density::Density;
use crate::simulate::reading_likelihood::{Likelihood, Prepared};
use crate::simulate::separated_density::SeparatedDensity;

/// Readings of one layout at one load that tell a root mean square to 3 %, and a 95th percentile to some 8 %.
pub const SAMPLES: usize = 480;
/// An estimate further off than this has lost the contact, degrees.
pub const LOST_DEG: f64 = 20.0;

/// Errors of an estimate of a quantity that contacts differ in.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ToldError {
    /// Root mean square, in the quantity's unit.
    pub rms: f64,
    /// Standard error of it by the number of contacts.
    pub rms_se: f64,
    /// Standard deviation of the quantity itself.
    pub deviation: f64,
}

/// Errors of a layout at one load.
#[derive(Debug, Clone, PartialEq)]
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
    /// Errors of the quantities that contacts have one of, in their laws' order, where an estimate knows how films scatter together.
    pub told: Vec<ToldError>,
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
    let all = contacts.iter().map(|(depth, contact)| {
        let all = DrawnContacts::all_as(contact.clone(), likelihood, *depth);
        (*depth, all)
    });
    estimated(likelihood, all, arrangement, draws)
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
    let contacts = depths_mm.iter().map(|depth| {
        let contacts = DrawnContacts::new(likelihood, *depth, (draws, drawn));
        (*depth, contacts)
    });
    estimated(likelihood, contacts, arrangement, draws)
}

/// Estimates drawn contacts at each of some depths, mm, by what the likelihood knows of their scatter.
fn estimated(
    likelihood: &Likelihood,
    contacts: impl Iterator<Item = (f64, DrawnContacts)>,
    arrangement: &Arrangement,
    draws: &Draws,
) -> Vec<Simulated> {
    match &likelihood.prepared {
        Prepared::Separated(products) => {
            let density = SeparatedDensity::new(likelihood, products, arrangement);
            by_density(density, likelihood, contacts, arrangement, draws)
        }
        Prepared::AtPoints(fields) => {
            let density = JointDensity::new(likelihood, fields, arrangement);
            by_density(density, likelihood, contacts, arrangement, draws)
        }
    }
}

fn by_density<D: Density>(
    density: D,
    likelihood: &Likelihood,
    contacts: impl Iterator<Item = (f64, DrawnContacts)>,
    arrangement: &Arrangement,
    draws: &Draws,
) -> Vec<Simulated> {
    let estimator = Estimator::new(density, &likelihood.depths_mm);
    contacts
        .map(|at| simulate_at(&at, (&estimator, likelihood), arrangement, draws))
        .collect()
}

/// Errors of simulated estimates, contact after contact.
#[derive(Default)]
struct SampleErrors {
    /// Distances of the angle, degrees.
    angles: Vec<f64>,
    depths: Vec<f64>,
    forces: Vec<f64>,
    /// Errors of further quantities, and their values, by quantity.
    told: Vec<[Vec<f64>; 2]>,
}

fn simulate_at<D: Density>(
    (depth_mm, drawn): &(f64, DrawnContacts),
    (estimator, likelihood): (&Estimator<'_, D>, &Likelihood),
    arrangement: &Arrangement,
    draws: &Draws,
) -> Simulated {
    let contacts = Draws::contacts_of(arrangement);
    let repeats = draws.repeats(contacts);
    let mut errors = SampleErrors::default();
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
            errors.angles.push(apart(found.angle_deg, contact));
            errors.depths.push(found.depth_mm - depth_mm);
            let by_depth = || likelihood.force_n(found.depth_mm);
            let believed = || found.told.first().copied().unwrap_or_else(by_depth);
            let force_n = drawn.force_n(sample(repeat));
            errors.forces.extend(force_n.map(|own| believed() - own));
            errors.add_told(&found.told, drawn.values(sample(repeat)));
        }
    }
    errors.summary()
}

/// Returns the distance of two angles, the short way round, degrees.
fn apart(a: f64, b: f64) -> f64 {
    let turned = (a - b).rem_euclid(360.0);
    turned.min(360.0 - turned)
}

impl SampleErrors {
    /// Adds what an estimate tells beside the force, which stands first, and what is true.
    fn add_told(&mut self, told: &[f64], values: &[f64]) {
        let pairs = told.iter().skip(1).zip(values);
        self.told.resize_with(pairs.len(), Default::default);
        for ([errors, all], (told, value)) in self.told.iter_mut().zip(pairs) {
            errors.push(told - value);
            all.push(*value);
        }
    }

    fn summary(mut self) -> Simulated {
        let angles = &mut self.angles;
        angles.sort_by(f64::total_cmp);
        let count = angles.len() as f64;
        let at_share = |share: f64| interpolated_quantile(angles, share);
        // One standard deviation of the binomial number below the percentile.
        let spread = (0.95 * 0.05 / count).sqrt();
        let [rms_angle_deg, rms_angle_se_deg] = root_mean_square(angles);
        let [rms_depth_mm, rms_depth_se_mm] = root_mean_square(&self.depths);
        let told = self.told.iter().map(|[errors, values]| {
            let [rms, rms_se] = root_mean_square(errors);
            ToldError {
                rms,
                rms_se,
                deviation: deviation(values),
            }
        });
        Simulated {
            rms_angle_deg,
            rms_angle_se_deg,
            p95_angle_deg: at_share(0.95),
            p95_angle_se_deg: 0.5 * (at_share(0.95 + spread) - at_share(0.95 - spread)),
            lost_share: angles.iter().filter(|error| **error > LOST_DEG).count() as f64 / count,
            rms_depth_mm,
            rms_depth_se_mm,
            rms_force_n: (!self.forces.is_empty()).then(|| root_mean_square(&self.forces)),
            told: told.collect(),
        }
    }
}

/// Standard deviation of some numbers.
fn deviation(values: &[f64]) -> f64 {
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    let off: Vec<f64> = values.iter().map(|value| value - mean).collect();
    root_mean_square(&off)[0]
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
        )
        .swap_remove(0)
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
        let mut fields = DepthFields::over_contacts(surface(), Drawn::All, false);
        let arrangement = Arrangement::regular(24, &[0, 1], false);
        let draws = Draws::new(1, SAMPLES, 48);
        let likelihood = Likelihood::new(fields.clone(), NOISE);
        let at = |likelihood: &Likelihood, drawn| {
            simulate(likelihood, &[1.0], &arrangement, &draws, drawn).swap_remove(0)
        };
        let alone = likelihood.alone();
        let [nothing, pressure, traction] = [0, 1, 2].map(|k| at(&alone[k].2, alone[k].0));
        let [nothing_n, pressure_n] = [&nothing, &pressure].map(|found| found.force_n(13.0)[0]);
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

    /// A pressure makes the first kind of film weaker, as a smaller depth does, and a traction adds to all alike: who knows so tells angle and force better.
    #[test]
    fn scatter_that_is_known_together_costs_less() {
        let arrangement = Arrangement::regular(24, &[0, 1], false);
        let draws = Draws::new(1, SAMPLES, 48);
        let likelihood = |together| {
            let fields = DepthFields::over_contacts(surface(), Drawn::All, together);
            Likelihood::new(fields, NOISE)
        };
        let [each, together] = [false, true].map(likelihood);
        let at = |likelihood: &Likelihood, drawn| {
            simulate(likelihood, &[1.0], &arrangement, &draws, drawn).swap_remove(0)
        };
        let [apart, joint] = [&each, &together].map(|own| at(own, Drawn::All));
        assert!(joint.rms_depth_mm < 0.2 * apart.rms_depth_mm);
        assert!(joint.force_n(13.0)[0] < 0.4 * apart.force_n(13.0)[0]);
        // The bound counts normal scores; those of even laws and squares are within it by as much as 480 samples tell.
        let bound = bounds(&together.field(1.0), &arrangement, &NOISE).expect("dense");
        let ratios = [
            joint.rms_angle_deg / bound.rms_angle_deg,
            joint.rms_depth_mm / bound.worst_depth_mm,
        ];
        assert!(
            ratios.iter().all(|ratio| (0.85..1.15).contains(ratio)),
            "{ratios:?}"
        );
        // A pressure looks like a depth; the traction's square is seen, its sign isn't.
        let [pressure, traction] = [joint.told[0], joint.told[1]];
        assert!(
            (pressure.deviation / 0.0576 - 1.0).abs() < 0.05,
            "{pressure:?}"
        );
        assert!(pressure.rms < 1.02 * pressure.deviation, "{pressure:?}");
        assert!(
            (traction.rms / traction.deviation - 1.0).abs() < 0.02,
            "{traction:?}"
        );
        assert_eq!(apart.told, []);
    }

    /// A variance by the slope falls to the floor's where the slope is zero, within 0.1 degrees: an estimate that follows it comes as near as the bound by means alone, or
    /// nearer.
    #[test]
    fn places_that_spread_are_told_by_many_films() {
        let noise = Noise {
            floor: 0.002,
            place_std_deg: 2.0,
            ..NOISE
        };
        let arrangement = Arrangement::regular(30, &[0], false);
        let draws = Draws::new(4, SAMPLES, 30);
        for width in [8.0, 14.0] {
            let fields = gaussian(width);
            let found = simulated(&fields, &arrangement, &noise, &draws);
            let bound = bounds(&fields.at(1.0), &arrangement, &noise).expect("dense");
            let ratio = found.rms_angle_deg / bound.rms_angle_deg;
            assert!(ratio < 1.1, "{width}: {ratio}");
        }
    }

    /// Densities are one where nothing scatters.
    #[test]
    fn without_scatter_both_densities_agree() {
        let arrangement = Arrangement::regular(9, &[0, 1], true);
        let draws = Draws::new(3, SAMPLES, 18);
        let [each, together] = [false, true].map(|together| {
            let mut fields = DepthFields::over_contacts(surface(), Drawn::Nothing, together);
            if !together {
                fields.spread = None;
            }
            let likelihood = Likelihood::new(fields, NOISE);
            assert_eq!(
                matches!(likelihood.prepared, Prepared::AtPoints(_)),
                together
            );
            simulate(&likelihood, &[1.0], &arrangement, &draws, Drawn::Nothing).swap_remove(0)
        });
        // Products leave out 3e-6 of the largest field.
        assert!((each.rms_angle_deg / together.rms_angle_deg - 1.0).abs() < 1e-3);
        assert!((each.rms_depth_mm / together.rms_depth_mm - 1.0).abs() < 1e-3);
        assert!(together.told.iter().all(|told| told.rms < 1e-12));
    }
}
