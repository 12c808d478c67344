//! Floor of the forces' errors from one instant's readings: the bound of Cramer and Rao, with what is known of the gait before.
//!
//! Unknown are the contact's angle, its depth and the ground's shift along and across; what contacts differ in besides is taken as known, so that the floor is lower. Films that hold their charge read them with white noise and gains of their own.
//! Before, each unknown is taken as normal with the deviation that the gait draws it with (van Trees' bound). An estimator that looks back over earlier readings,
//! or a gait that isn't normal, can be a little better; drift, rounding and a circuit that forgets make all estimators worse.

use crate::contact_response::{Contact, ContactResponse};
use crate::even_clock::EvenClock;
use crate::gait::drawn_gait::Gait;
use crate::gait::stance::shear_deviation;
use documents::rig::rig_settings::{Noise, RigSettings};
use layouts::fisher::information::{Information, MOST};

/// Instants of a run that the bound is averaged over.
const INSTANTS: f64 = 400.0;
/// Half of the step of differences over the angle, degrees.
const STEP_DEG: f64 = 0.25;
/// Half of the steps over depth and shifts, as shares of the depth and of the largest shift there.
const STEP_SHARE: f64 = 0.01;
/// Least deviation before, for what a gait doesn't vary.
const LEAST: f64 = 1e-6;

/// Readings of films and force sensor without noise.
struct Answer {
    charges_nc: Vec<f64>,
    force_n: [f64; 3],
}

/// Least roots of the mean squared errors of the forces along, across and vertical over a run, N; those in the air are known.
pub(crate) fn floors_n<R: ContactResponse + ?Sized>(
    response: &R,
    settings: &RigSettings,
) -> [f64; 3] {
    let run = settings.runs as u64;
    let gait = Gait::drawn(&settings.gait, response, (settings.seed, run));
    let clock = EvenClock::new(0.0, INSTANTS / gait.end_s);
    let (mut squares, mut count) = ([0.0; 3], 0.0);
    for (time_s, stance, contact) in gait.contacts(clock, response) {
        count += 1.0;
        if contact.is_air() {
            continue;
        }
        let prior = prior(response, settings, &contact, stance.progress(time_s));
        let deviations = deviations_n(
            response,
            &settings.noise,
            &prior,
            (stance.contact_deg, &stance.shares),
            &contact,
        );
        for (sum, deviation) in squares.iter_mut().zip(deviations) {
            *sum += deviation * deviation;
        }
    }
    squares.map(|sum: f64| (sum / f64::max(count, 1.0)).sqrt())
}

/// Least deviations of the three forces at one contact, N.
fn deviations_n<R: ContactResponse + ?Sized>(
    response: &R,
    noise: &Noise,
    prior: &[f64; MOST],
    at: (f64, &[f64]),
    contact: &Contact,
) -> [f64; 3] {
    let here = answer(response, at, contact);
    let slopes = slopes(response, at, contact);
    let mut information = Information::of(MOST);
    for (film, full_scale_nc) in response.full_scale_nc().iter().enumerate() {
        let white = noise.white_share * full_scale_nc;
        let gain = noise.gain_std * here.charges_nc[film];
        let by_unknown = slopes.each_ref().map(|slope| slope.charges_nc[film]);
        let variance = white * white + gain * gain;
        if variance > 0.0 {
            information.add(&by_unknown, variance);
        }
    }
    let information = information.with_prior(prior);
    [0, 1, 2].map(|axis| {
        let by_unknown = slopes.each_ref().map(|slope| slope.force_n[axis]);
        information.deviation_of(&by_unknown).unwrap_or(0.0)
    })
}

/// Deviations of the unknowns as the gait draws them: even angles and depths, shifts part of the way between two points of a disc.
fn prior<R: ContactResponse + ?Sized>(
    response: &R,
    settings: &RigSettings,
    contact: &Contact,
    progress: f64,
) -> [f64; MOST] {
    let even = |[low, high]: [f64; 2]| ((high - low) / 12f64.sqrt()).max(LEAST);
    let deepest_mm = response.depth_of_load_mm(settings.gait.load_n[1]);
    let share = settings.gait.shear_share * shear_deviation(progress);
    let shift = |largest_mm: f64| (share * largest_mm).max(LEAST);
    let [along, across] = response.sticking_shift_mm(contact.depth_mm).map(shift);
    [
        even(settings.gait.contact_deg),
        even([0.0, deepest_mm]),
        along,
        across,
    ]
}

/// Derivatives by the angle, the depth and both shifts.
fn slopes<R: ContactResponse + ?Sized>(
    response: &R,
    (contact_deg, shares): (f64, &[f64]),
    contact: &Contact,
) -> [Answer; MOST] {
    let largest_mm = response.sticking_shift_mm(contact.depth_mm);
    [0, 1, 2, 3].map(|unknown| {
        let step = match unknown {
            0 => STEP_DEG,
            1 => STEP_SHARE * contact.depth_mm,
            _ => (STEP_SHARE * largest_mm[unknown - 2]).max(LEAST),
        };
        let beside = |by: f64| {
            let (mut angle_deg, mut contact) = (contact_deg, *contact);
            match unknown {
                0 => angle_deg += by,
                1 => contact.depth_mm += by,
                _ => contact.shift_mm[unknown - 2] += by,
            }
            answer(response, (angle_deg, shares), &contact)
        };
        let (high, low) = (beside(step), beside(-step));
        let slope = |high: f64, low: f64| (high - low) / (2.0 * step);
        let films = high.charges_nc.iter().zip(&low.charges_nc);
        Answer {
            charges_nc: films.map(|(high, low)| slope(*high, *low)).collect(),
            force_n: [0, 1, 2].map(|axis| slope(high.force_n[axis], low.force_n[axis])),
        }
    })
}

fn answer<R: ContactResponse + ?Sized>(
    response: &R,
    (angle_deg, shares): (f64, &[f64]),
    contact: &Contact,
) -> Answer {
    let mut charges_nc = vec![0.0; response.films()];
    let films = response.at_angle(angle_deg, shares);
    let force_n = films.answer(contact, &mut charges_nc);
    Answer {
        charges_nc,
        force_n,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bump_response::BumpResponse;
    use crate::force_error::thinned_run::ThinnedRun;

    const CONTACT: Contact = Contact {
        depth_mm: 1.2,
        shift_mm: [0.1, 0.0],
    };

    /// Returns the deviations at touch-down.
    fn at_first(tire: &BumpResponse, settings: &RigSettings) -> [f64; 3] {
        let prior = prior(tire, settings, &CONTACT, 0.0);
        deviations_n(tire, &settings.noise, &prior, (10.0, &[]), &CONTACT)
    }

    fn quiet() -> RigSettings {
        let mut settings = RigSettings::default();
        settings.noise.gain_std = 0.0;
        settings
    }

    /// A film of a bump h as high as the depth reads it to noise / h where angle and shift are known, and F = k d^1.5 follows.
    #[test]
    fn a_depth_alone_is_known_as_its_films_read_it() {
        let mut settings = quiet();
        settings.gait.contact_deg = [10.0, 10.0];
        settings.gait.shear_share = 0.0;
        let tire = BumpResponse::new(6);
        let found = at_first(&tire, &settings)[2];
        let heights = (0..6).map(|film| {
            let away = 60.0 * f64::from(film) - 10.0;
            let away: f64 = away - 360.0 * (away / 360.0_f64).round();
            (-0.5 * (away / 22.0).powi(2)).exp()
        });
        let noise_nc = 0.01 * 2.0;
        let prior_mm = tire.depth_of_load_mm(30.0) / 12f64.sqrt();
        let information =
            heights.map(|h| h * h).sum::<f64>() / (noise_nc * noise_nc) + prior_mm.powi(-2);
        // The film's charge has the skew of the shift, too, by the depth alone.
        let expected = 1.5 * 11.0 * CONTACT.depth_mm.sqrt() / information.sqrt();
        assert!((found / expected - 1.0).abs() < 1e-4, "{found} {expected}");
    }

    #[test]
    fn a_force_that_no_film_feels_is_as_uncertain_as_before() {
        let settings = quiet();
        let tire = BumpResponse::new(12);
        let [along, across, vertical] = at_first(&tire, &settings);
        // A shift even in a disc of 0.6 of the sliding one has a quarter of its diameter's deviation; 4 N/mm of stiffness.
        let sliding_n = 0.8 * 11.0 * CONTACT.depth_mm.powf(1.5);
        assert!((across / (0.3 * sliding_n) - 1.0).abs() < 1e-6, "{across}");
        assert!(
            along < across && vertical < along,
            "{along} {across} {vertical}"
        );
    }

    /// The floor of what no film feels is the error of the mean over a run: what the gait leaves open.
    #[test]
    fn what_no_film_feels_is_known_as_the_mean_knows_it() {
        let (tire, settings) = (BumpResponse::new(6), RigSettings::default());
        let floor = floors_n(&tire, &settings)[1];
        let run = ThinnedRun::recorded(&tire, &settings, settings.runs as u64, 1);
        let squares = run.true_force_n.column(1).mapv(|force| force * force);
        let mean = squares.mean().expect("rows").sqrt();
        // Of some 180 stances: a deviation's own is 1 / sqrt(2 n), 5 %, thrice; relaxation makes forces larger by up to 10 %.
        assert!((floor / mean - 1.0).abs() < 0.25, "{floor} {mean}");
    }

    #[test]
    fn more_noise_and_fewer_films_know_less() {
        let of = |films: usize, white_share: f64| {
            let mut settings = RigSettings::default();
            settings.noise.white_share = white_share;
            floors_n(&BumpResponse::new(films), &settings)[2]
        };
        let usual = of(12, 0.01);
        assert!(of(12, 0.04) > usual && of(4, 0.01) > usual && usual > 0.0);
    }
}
