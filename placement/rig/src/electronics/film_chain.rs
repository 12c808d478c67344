//! Chain from the charges of all films to the volts that are stored.

use crate::contact_response::ContactResponse;
use crate::electronics::film_circuit::{FilmCircuits, Wired};
use crate::electronics::film_noise::FilmNoise;
use crate::electronics::quantiser::Quantiser;
use crate::seeded_draws::{SeededDraws, Stream};
use documents::rig::rig_settings::RigSettings;

/// Full scales that a converter reads where no range is set: room for gains, drift and pushed rubber.
const RANGE_FULL_SCALES: f64 = 2.0;

/// All films of one run with their electronics.
#[derive(Debug, Clone)]
pub(crate) struct FilmChain {
    circuits: FilmCircuits,
    /// Gains of the films, drawn once a run: what each shows of its volts.
    gains: Vec<f64>,
    noise: FilmNoise,
    converters: Vec<Quantiser>,
    /// Charges by warming, nC/s.
    warming_nc_per_s: Vec<f64>,
    warmed_nc: Vec<f64>,
}

impl FilmChain {
    /// Begins a run: nothing is charged.
    pub fn new<R: ContactResponse + ?Sized>(
        response: &R,
        settings: &RigSettings,
        run: u64,
    ) -> Self {
        let films: Vec<(Wired, f64)> = response
            .capacitance_pf()
            .iter()
            .zip(response.full_scale_nc())
            .map(|(capacitance_pf, full_scale_nc)| {
                let wired = Wired::new(&settings.electronics, *capacitance_pf);
                (wired, (wired.v_per_nc * full_scale_nc).abs())
            })
            .collect();
        let wired: Vec<Wired> = films.iter().map(|(wired, _)| *wired).collect();
        let interval_s = settings.film_rate_hz.recip();
        let draws = |stream| SeededDraws::new(settings.seed, run, stream);
        let mut gain_draws = draws(Stream::Gain);
        let noise = &settings.noise;
        let mut gain = |_: &Wired| 1.0 + noise.gain_std * gain_draws.normal();
        let electronics = &settings.electronics;
        let converter = |(_, full_scale_v): &(Wired, f64)| {
            let range_v = electronics.range_v;
            Quantiser::new(
                electronics.bits,
                range_v.unwrap_or(RANGE_FULL_SCALES * full_scale_v),
            )
        };
        let warming = response.warming_nc_per_k().iter();
        Self {
            circuits: FilmCircuits::new(&wired, interval_s),
            gains: wired.iter().map(&mut gain).collect(),
            noise: FilmNoise::new(noise, &films, interval_s, draws(Stream::Films)),
            converters: films.iter().map(converter).collect(),
            warming_nc_per_s: warming
                .map(|by_kelvin| by_kelvin * noise.warming_k_per_min / 60.0)
                .collect(),
            warmed_nc: vec![0.0; films.len()],
        }
    }

    /// The volts at the next instant, s after the begin, whose charges are given, nC.
    pub fn read(&mut self, time_s: f64, charges_nc: &[f64], volts: &mut [f64]) {
        let warming = charges_nc.iter().zip(&self.warming_nc_per_s);
        for (warmed, (charge, by_second)) in self.warmed_nc.iter_mut().zip(warming) {
            *warmed = charge + by_second * time_s;
        }
        self.circuits.next(&self.warmed_nc, volts);
        for (volts, gain) in volts.iter_mut().zip(&self.gains) {
            *volts *= gain;
        }
        self.noise.add_to(volts);
        for (volts, converter) in volts.iter_mut().zip(&self.converters) {
            *volts = converter.read(*volts);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bump_response::BumpResponse;
    use documents::rig::rig_settings::Noise;

    const FILMS: usize = 12;

    fn quiet() -> RigSettings {
        let mut settings = RigSettings::default();
        settings.noise = Noise {
            white_share: 0.0,
            thermal_k: 0.0,
            drift_share: 0.0,
            gain_std: 0.0,
            warming_k_per_min: 0.0,
            ..settings.noise
        };
        settings.electronics.bits = 0;
        settings
    }

    fn first(settings: &RigSettings, run: u64) -> Vec<f64> {
        let mut chain = FilmChain::new(&BumpResponse::new(FILMS), settings, run);
        let mut volts = vec![0.0; FILMS];
        chain.read(0.0, &[1.0; FILMS], &mut volts);
        volts
    }

    #[test]
    fn gains_are_drawn_once_a_run() {
        let mut settings = quiet();
        let even = first(&settings, 0);
        settings.noise.gain_std = 0.05;
        let (a, b) = (first(&settings, 0), first(&settings, 1));
        assert_eq!(a, first(&settings, 0));
        for film in 0..FILMS {
            assert!(a[film] != even[film] && a[film] != b[film]);
            // Five standard deviations: once in 1.7 million.
            assert!((a[film] / even[film] - 1.0).abs() < 0.25);
        }
    }

    /// A ramp of temperature on a circuit that leaks comes to rest at the charge of a second times the time constant.
    #[test]
    fn warming_charges_the_films() {
        let mut settings = quiet();
        settings.noise.warming_k_per_min = 0.6;
        settings.electronics.time_constant_s = Some(0.1);
        let mut chain = FilmChain::new(&BumpResponse::new(FILMS), &settings, 0);
        let mut volts = vec![0.0; FILMS];
        for k in 0..2000 {
            chain.read(f64::from(k) / 200.0, &[0.0; FILMS], &mut volts);
        }
        // 0.01 K/s x 7.5 nC/K x 0.1 s on 10 nF. Rounding of times of 10 s, 2e-15 s of 5 ms a step, over 20 steps of memory.
        let expected = 0.01 * 7.5 * 0.1 / 10.0;
        for found in volts {
            assert!((found / expected - 1.0).abs() < 1e-10, "{found} {expected}");
        }
    }

    #[test]
    fn a_converter_reads_twice_the_full_scale_where_no_range_is_set() {
        let mut settings = quiet();
        settings.electronics.bits = 12;
        let mut chain = FilmChain::new(&BumpResponse::new(1), &settings, 0);
        let mut volts = [0.0];
        chain.read(0.0, &[1e6], &mut volts);
        // 2 nC on 10 nF, twice: 0.4 V, but for one step.
        let step = 0.8 / 4096.0;
        assert!((volts[0] - (0.4 - step)).abs() < 1e-15, "{volts:?}");
        settings.electronics.range_v = Some(5.0);
        let mut chain = FilmChain::new(&BumpResponse::new(1), &settings, 0);
        chain.read(0.0, &[1e6], &mut volts);
        assert_eq!(volts[0], 5.0 - 10.0 / 4096.0);
    }
}
