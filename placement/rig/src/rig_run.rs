//! A run of a rig: the films' volts by their clock, the forces by that of the force sensor.
//!
//! Both clocks' instants are true times, as one recorder sees them; the force sensor's are apart from the films' and drift against them.

use ndarray::Array2;

use crate::contact_response::ContactResponse;
use crate::electronics::film_chain::FilmChain;
use crate::even_clock::EvenClock;
use crate::gait::drawn_gait::Gait;
use crate::gait::stance::Stance;
use crate::pressed_tire::PressedTire;
use crate::seeded_draws::{SeededDraws, Stream};
use documents::rig::rig_settings::{ForceSensor, RigSettings};

/// Forces along, across and vertical.
const AXES: usize = 3;

/// Record of a run, and what it really was.
#[derive(Debug, Clone, PartialEq)]
pub struct RigRun {
    /// Stances by number.
    pub stances: Vec<Stance>,
    /// Readings by the films' clock.
    pub films: FilmReadings,
    /// Readings by the force sensor's clock.
    pub forces: ForceReadings,
}

/// Readings by the films' clock.
#[derive(Debug, Clone, PartialEq)]
pub struct FilmReadings {
    /// Instants, s.
    pub time_s: Vec<f64>,
    /// Number of each instant's stance.
    pub stance: Vec<usize>,
    /// Instants x films, V.
    pub volts: Array2<f64>,
    /// Instants x forces of the ground on the tire along, across and vertical, N; without noise.
    pub true_force_n: Array2<f64>,
}

/// Readings by the force sensor's clock.
#[derive(Debug, Clone, PartialEq)]
pub struct ForceReadings {
    /// Instants, s.
    pub time_s: Vec<f64>,
    /// Number of each instant's stance.
    pub stance: Vec<usize>,
    /// Instants x forces of the ground on the tire along, across and vertical, N; with noise.
    pub force_n: Array2<f64>,
}

impl RigRun {
    /// Records a run, counted from 0, of a tire. The same tire, settings and run give the same bits.
    pub fn recorded<R: ContactResponse + ?Sized>(
        response: &R,
        settings: &RigSettings,
        run: u64,
    ) -> Self {
        let gait = gait(response, settings, run);
        let films = film_readings(response, settings, &gait, run);
        let forces = force_readings(response, settings, &gait, run);
        Self {
            stances: gait.stances,
            films,
            forces,
        }
    }

    /// Runs stances and films, to the same bits, without the force sensor: in half the time.
    pub fn films_alone<R: ContactResponse + ?Sized>(
        response: &R,
        settings: &RigSettings,
        run: u64,
    ) -> (Vec<Stance>, FilmReadings) {
        let gait = gait(response, settings, run);
        let films = film_readings(response, settings, &gait, run);
        (gait.stances, films)
    }
}

fn gait<R: ContactResponse + ?Sized>(response: &R, settings: &RigSettings, run: u64) -> Gait {
    Gait::drawn(&settings.gait, response, (settings.seed, run))
}

/// Instants of a force sensor.
fn clock_of(sensor: &ForceSensor) -> EvenClock {
    EvenClock::new(sensor.offset_s, sensor.rate_hz / (1.0 + 1e-6 * sensor.ppm))
}

fn film_readings<R: ContactResponse + ?Sized>(
    response: &R,
    settings: &RigSettings,
    gait: &Gait,
    run: u64,
) -> FilmReadings {
    let clock = EvenClock::new(0.0, settings.film_rate_hz);
    let instants = clock.instants_before(gait.end_s);
    let films = response.films();
    let mut tire = PressedTire::new(response, &settings.relaxation, clock.interval_s());
    let mut chain = FilmChain::new(response, settings, run);
    let (mut time_s, mut numbers) = (Vec::with_capacity(instants), Vec::with_capacity(instants));
    let mut volts = Vec::with_capacity(instants * films);
    let mut forces = Vec::with_capacity(instants * AXES);
    let mut charges_nc = vec![0.0; films];
    for (now_s, stance, contact) in gait.contacts(clock, response) {
        charges_nc.fill(0.0);
        let mut force_n = [0.0; AXES];
        if let Some(pressed) = tire.next(stance, &contact, &mut charges_nc) {
            if settings.films_follow_force {
                charges_nc.iter_mut().for_each(|q| *q *= pressed.factor);
            }
            force_n = pressed.force_n;
        }
        let row = volts.len();
        volts.resize(row + films, 0.0);
        chain.read(now_s, &charges_nc, &mut volts[row..]);
        forces.extend(force_n);
        time_s.push(now_s);
        numbers.push(stance.number);
    }
    FilmReadings {
        volts: table(films, volts),
        true_force_n: table(AXES, forces),
        time_s,
        stance: numbers,
    }
}

fn force_readings<R: ContactResponse + ?Sized>(
    response: &R,
    settings: &RigSettings,
    gait: &Gait,
    run: u64,
) -> ForceReadings {
    let clock = clock_of(&settings.force_sensor);
    let instants = clock.instants_before(gait.end_s);
    let mut tire = PressedTire::new(response, &settings.relaxation, clock.interval_s());
    let mut draws = SeededDraws::new(settings.seed, run, Stream::Force);
    let (mut time_s, mut numbers) = (Vec::with_capacity(instants), Vec::with_capacity(instants));
    let mut forces = Vec::with_capacity(instants * AXES);
    for (now_s, stance, contact) in gait.contacts(clock, response) {
        let pressed = tire.next(stance, &contact, &mut []);
        let force_n = pressed.map_or([0.0; AXES], |pressed| pressed.force_n);
        forces.extend(force_n.map(|force| force + settings.force_sensor.noise_n * draws.normal()));
        time_s.push(now_s);
        numbers.push(stance.number);
    }
    ForceReadings {
        force_n: table(AXES, forces),
        time_s,
        stance: numbers,
    }
}

/// Rows one after another, as a table of so many columns.
fn table(columns: usize, cells: Vec<f64>) -> Array2<f64> {
    let rows = cells.len().checked_div(columns).unwrap_or(0);
    Array2::from_shape_vec((rows, columns), cells).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bump_response::BumpResponse;
    use documents::rig::gait_settings::{Frequency, RunLength};
    use documents::rig::rig_settings::Noise;

    fn settings(frequency: Frequency, stances: usize) -> RigSettings {
        let mut settings = RigSettings::default();
        settings.gait.frequency = frequency;
        settings.gait.length = RunLength::Stances(stances);
        settings
    }

    fn silent(mut settings: RigSettings) -> RigSettings {
        settings.noise = Noise {
            white_share: 0.0,
            thermal_k: 0.0,
            drift_share: 0.0,
            warming_k_per_min: 0.0,
            gain_std: 0.0,
            ..settings.noise
        };
        settings.force_sensor.noise_n = 0.0;
        settings.electronics.bits = 0;
        settings
    }

    #[test]
    fn the_same_seed_and_run_give_the_same_bits_and_others_other_ones() {
        let tire = BumpResponse::new(6);
        let settings = settings(
            Frequency::Randomised {
                min_hz: 1.0,
                max_hz: 5.0,
            },
            10,
        );
        let first = RigRun::recorded(&tire, &settings, 0);
        assert_eq!(RigRun::recorded(&tire, &settings, 0), first);
        let (stances, films) = RigRun::films_alone(&tire, &settings, 0);
        assert_eq!(
            (stances, films),
            (first.stances.clone(), first.films.clone())
        );
        let other_seed = RigSettings {
            seed: 2,
            ..settings.clone()
        };
        for other in [
            RigRun::recorded(&tire, &settings, 1),
            RigRun::recorded(&tire, &other_seed, 0),
        ] {
            assert_ne!(other.stances, first.stances);
            assert_ne!(other.films.volts.row(0), first.films.volts.row(0));
            assert_ne!(other.forces.force_n.row(0), first.forces.force_n.row(0));
        }
    }

    #[test]
    fn noise_leaves_the_stances_and_the_true_forces_as_they_are() {
        let tire = BumpResponse::new(6);
        let settings = settings(Frequency::Fixed { hz: 2.0 }, 5);
        let noisy = RigRun::recorded(&tire, &settings, 0);
        let silent = RigRun::recorded(&tire, &silent(settings), 0);
        assert_eq!(noisy.stances, silent.stances);
        assert_eq!(noisy.films.true_force_n, silent.films.true_force_n);
        assert_ne!(noisy.films.volts, silent.films.volts);
    }

    #[test]
    fn a_slow_elastic_press_reaches_its_load_and_its_charges() {
        let tire = BumpResponse::new(6);
        let mut settings = silent(settings(Frequency::Fixed { hz: 0.5 }, 3));
        settings.relaxation = Vec::new();
        settings.gait.shear_share = 0.0;
        let run = RigRun::recorded(&tire, &settings, 0);
        // Two seconds a turn of 400 instants, the deepest one amid it.
        for stance in &run.stances {
            let row = 400 * stance.number + 200;
            assert_eq!(run.films.stance[row], stance.number);
            let found = run.films.true_force_n[[row, 2]];
            assert!((found / stance.load_n - 1.0).abs() < 1e-12, "{found}");
            assert_eq!(run.films.true_force_n[[row, 0]], 0.0);
            // The first film's charge through the amplifier, 0.1 V/nC, less what a quarter of a turn lets leak: 0.5 s of 10 s at most. What earlier presses
            // left is below what they leaked themselves.
            let charge = stance.peak_mm * (-0.5 * (stance.contact_deg / 22.0).powi(2)).exp();
            let volts = run.films.volts[[row, 0]];
            assert!(
                (volts / (0.1 * charge) - 1.0).abs() < 0.3,
                "{volts} {charge}"
            );
        }
    }

    /// Readings on a film's circuit are the charges' through its high-pass; charges of films that follow the force are those of the depth times its factor.
    #[test]
    fn films_follow_the_force_where_they_should() {
        let tire = BumpResponse::new(6);
        let settings = silent(settings(Frequency::Fixed { hz: 2.0 }, 4));
        let of = |follow, relaxation| {
            let settings = RigSettings {
                films_follow_force: follow,
                relaxation,
                ..settings.clone()
            };
            RigRun::recorded(&tire, &settings, 0)
        };
        let (following, slow) = (of(true, settings.relaxation.clone()), of(true, Vec::new()));
        let apart = of(false, settings.relaxation.clone());
        assert_eq!(apart.films.volts, slow.films.volts);
        assert_eq!(apart.films.true_force_n, following.films.true_force_n);
        // While the first press deepens, the rubber bears more than slowly, up to the branch's tenth.
        let middle = 50;
        for row in 27..middle {
            let [fast, slow] = [&following, &slow].map(|run| run.films.true_force_n[[row, 2]]);
            assert!(fast > slow && fast < 1.1 * slow, "{row} {fast} {slow}");
        }
        let [fast, slow] = [&following, &slow].map(|run| run.films.volts[[middle, 0]]);
        assert!(fast > slow && fast < 1.1 * slow, "{fast} {slow}");
    }

    #[test]
    fn the_force_sensor_has_a_clock_of_its_own() {
        let tire = BumpResponse::new(6);
        let mut settings = silent(settings(Frequency::Fixed { hz: 2.0 }, 4));
        settings.force_sensor = ForceSensor {
            rate_hz: 100.0,
            offset_s: 0.003,
            ppm: 1000.0,
            noise_n: 0.0,
        };
        let run = RigRun::recorded(&tire, &settings, 0);
        let times = &run.forces.time_s;
        // Two seconds at 99.9 readings a second.
        assert_eq!(times.len(), 200);
        assert!((times[100] - (0.003 + 1.001)).abs() < 1e-12);
        assert_eq!(run.films.time_s.len(), 400);
        // Its forces are those between the films' instants; a quarter of an interval's curvature apart, (w h)^2 / 8 of the load, and relaxation.
        let row = 50;
        let films_row = (times[row] * 200.0) as usize;
        let [before, after] = [films_row, films_row + 1].map(|k| run.films.true_force_n[[k, 2]]);
        let found = run.forces.force_n[[row, 2]];
        let bound = 30.0 * (std::f64::consts::TAU * 2.0 * 0.005).powi(2);
        assert!(found > before.min(after) - bound && found < before.max(after) + bound);
    }

    #[test]
    fn the_force_s_noise_has_its_size() {
        let tire = BumpResponse::new(1);
        let mut settings = settings(Frequency::Fixed { hz: 2.0 }, 100);
        settings.gait.load_n = [0.0, 0.0];
        settings.force_sensor.noise_n = 0.05;
        let forces = RigRun::recorded(&tire, &settings, 0).forces.force_n;
        let variance = forces.iter().map(|f| f * f).sum::<f64>() / forces.len() as f64;
        // Three standard errors of a variance.
        let bound = 3.0 * (2.0 / forces.len() as f64).sqrt();
        assert!((variance / 0.0025 - 1.0).abs() < bound, "{variance}");
    }
}
