//! Noise beside the film's own signal. All of it is added behind the circuit, and no gain touches it.
//!
//! - White noise: hum and cable, a share of the film's full scale in held volts, whatever the circuit leaks.
//! - Heat: the circuit's resistance makes a voltage of variance k T / C, whose memory is the circuit's time constant; a constant where nothing leaks.
//! - Drift: a first-order Gauss-Markov process, which the rig begins at zero. Its variance grows as s^2 (1 - exp(-2 t / tau)).
//!
//! A Gauss-Markov process at even intervals is exact: x_(k+1) = b x_k + s sqrt(1 - b^2) n, with b = exp(-h / tau) and n standard normal.

use crate::electronics::film_circuit::Wired;
use crate::seeded_draws::SeededDraws;
use documents::rig::rig_settings::Noise;

/// Boltzmann's constant, J/K (exact in the SI).
const BOLTZMANN: f64 = 1.380_649e-23;

/// Standard deviation of the voltage that heat makes on a capacitance, pF, at a temperature, K; V.
pub(crate) fn thermal_v(temperature_k: f64, capacitance_pf: f64) -> f64 {
    (BOLTZMANN * temperature_k / (1e-12 * capacitance_pf)).sqrt()
}

/// A first-order Gauss-Markov process.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct GaussMarkov {
    keep: f64,
    kick: f64,
    now: f64,
}

impl GaussMarkov {
    /// Begins at a first value, with its standard deviation in the long run, its time constant, s (None: it stays), and the interval, s.
    pub fn new(first: f64, std: f64, time_constant_s: Option<f64>, interval_s: f64) -> Self {
        let intervals = time_constant_s.map_or(0.0, |time| interval_s / time);
        Self {
            keep: (-intervals).exp(),
            kick: std * (-(-2.0 * intervals).exp_m1()).sqrt(),
            now: first,
        }
    }

    /// An interval later.
    fn next(&mut self, draws: &mut SeededDraws) -> f64 {
        // What doesn't move takes no number.
        if self.kick > 0.0 {
            self.now = self.keep * self.now + self.kick * draws.normal();
        }
        self.now
    }
}

/// Noise of all films of a run.
#[derive(Debug, Clone)]
pub struct FilmNoise {
    films: Vec<NoiseNow>,
    draws: SeededDraws,
}

#[derive(Debug, Clone, Copy)]
struct NoiseNow {
    white_v: f64,
    thermal: GaussMarkov,
    drift: GaussMarkov,
}

impl FilmNoise {
    /// Makes the noise of films by their wiring and their full scales, V, to be asked at even intervals, s.
    pub fn new(
        settings: &Noise,
        films: &[(Wired, f64)],
        interval_s: f64,
        mut draws: SeededDraws,
    ) -> Self {
        let drift_s = Some(settings.drift_time_s);
        let mut begun = |(wired, full_scale_v): &(Wired, f64)| {
            let thermal_v = thermal_v(settings.thermal_k, wired.holding_pf());
            let first_v = thermal_v * draws.normal();
            let drift_v = settings.drift_share * full_scale_v;
            NoiseNow {
                white_v: settings.white_share * full_scale_v,
                thermal: GaussMarkov::new(first_v, thermal_v, wired.time_constant_s, interval_s),
                drift: GaussMarkov::new(0.0, drift_v, drift_s, interval_s),
            }
        };
        Self {
            films: films.iter().map(&mut begun).collect(),
            draws,
        }
    }

    /// Adds an instant's noise, V.
    pub fn add_to(&mut self, volts: &mut [f64]) {
        let draws = &mut self.draws;
        for (film, volts) in self.films.iter_mut().zip(volts) {
            *volts += film.thermal.next(draws) + film.drift.next(draws);
            if film.white_v > 0.0 {
                *volts += film.white_v * draws.normal();
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::seeded_draws::Stream;

    const FILMS: usize = 4000;
    const QUIET: Noise = Noise {
        white_share: 0.0,
        thermal_k: 0.0,
        drift_share: 0.0,
        drift_time_s: 60.0,
        warming_k_per_min: 0.0,
        gain_std: 0.0,
    };

    /// Variances over many films of this wiring and a full scale of 2 V, at each of some instants.
    fn variances(settings: &Noise, wired: Wired, interval_s: f64, instants: usize) -> Vec<f64> {
        let draws = SeededDraws::new(3, 0, Stream::Films);
        let mut noise = FilmNoise::new(settings, &[(wired, 2.0); FILMS], interval_s, draws);
        let at_instant = |_| {
            let mut volts = [0.0; FILMS];
            noise.add_to(&mut volts);
            volts.iter().map(|v| v * v).sum::<f64>() / FILMS as f64
        };
        (0..instants).map(at_instant).collect()
    }

    /// Whether a variance of so many independent draws a film is within three standard errors, sqrt(2 / n) of it each.
    fn is_near(found: f64, expected: f64, draws: usize) -> bool {
        (found / expected - 1.0).abs() < 3.0 * (2.0 / (draws * FILMS) as f64).sqrt()
    }

    fn mean(variances: &[f64]) -> f64 {
        variances.iter().sum::<f64>() / variances.len() as f64
    }

    fn film(time_constant_s: Option<f64>) -> Wired {
        Wired {
            v_per_nc: 1e3 / 980.0,
            time_constant_s,
        }
    }

    #[test]
    fn heat_makes_two_microvolts_on_a_film() {
        // sqrt(1.380649e-23 x 293 / 980e-12) = sqrt(4.1278e-12) V.
        assert!((thermal_v(293.0, 980.0) - 2.0317e-6).abs() < 1e-10);
        let settings = Noise {
            thermal_k: 293.0,
            ..QUIET
        };
        let expected = thermal_v(293.0, 980.0).powi(2);
        // What is kept over 20 instants is one draw; a millisecond's memory is gone at the next one.
        for (time_constant, draws) in [(None, 1), (Some(10.0), 1), (Some(1e-3), 20)] {
            let found = mean(&variances(&settings, film(time_constant), 0.005, 20));
            assert!(is_near(found, expected, draws), "{time_constant:?} {found}");
        }
    }

    #[test]
    fn white_noise_is_a_share_of_full_scale() {
        let settings = Noise {
            white_share: 0.01,
            ..QUIET
        };
        let found = mean(&variances(&settings, film(Some(0.1)), 0.005, 20));
        assert!(is_near(found, 0.02 * 0.02, 20), "{found}");
    }

    #[test]
    fn drift_begins_at_nothing_and_grows_to_its_share() {
        let settings = Noise {
            drift_share: 0.005,
            drift_time_s: 3.0,
            ..QUIET
        };
        let all = variances(&settings, film(None), 0.1, 100);
        for k in [1, 5, 20, 100] {
            let time_s = 0.1 * k as f64;
            let expected = 0.01 * 0.01 * -(-2.0 * time_s / 3.0).exp_m1();
            assert!(is_near(all[k - 1], expected, 1), "{time_s} {}", all[k - 1]);
        }
    }

    #[test]
    fn without_noise_nothing_is_added() {
        assert_eq!(variances(&QUIET, film(None), 0.005, 3), [0.0; 3]);
    }
}
