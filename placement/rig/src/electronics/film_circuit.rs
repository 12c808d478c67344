//! A film's charge on its circuit: C dV/dt + V / R = dQ/dt, exact for a charge that is linear between instants.

use crate::electronics::high_pass::HighPass;
use documents::rig::rig_settings::Electronics;

/// Wiring of a film.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wired {
    /// Volts of a held charge, V/nC.
    pub v_per_nc: f64,
    /// Time in which they fall to 1/e, s; `None` where they stay.
    pub time_constant_s: Option<f64>,
}

impl Wired {
    /// A film of this capacitance, pF. A time constant of its own changes the resistance, not the volts.
    pub fn new(electronics: &Electronics, capacitance_pf: f64) -> Self {
        let (v_per_nc, time_constant_s) = electronics.circuit.held(1.0, capacitance_pf);
        Self {
            v_per_nc,
            time_constant_s: electronics.time_constant_s.or(time_constant_s),
        }
    }

    /// The capacitance that holds the charge, pF: of film and cable, or of an amplifier's feedback.
    pub(crate) fn holding_pf(&self) -> f64 {
        1e3 / self.v_per_nc
    }
}

/// Films on their circuits, at one instant after another.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct FilmCircuits {
    films: Vec<FilmNow>,
}

#[derive(Debug, Clone, Copy, PartialEq)]
struct FilmNow {
    v_per_nc: f64,
    filter: HighPass,
    charge_nc: f64,
    output_v: f64,
}

impl FilmCircuits {
    /// Begins without charge, to be asked at even intervals, s.
    pub fn new(films: &[Wired], interval_s: f64) -> Self {
        let empty = |wired: &Wired| FilmNow {
            v_per_nc: wired.v_per_nc,
            filter: HighPass::new(wired.time_constant_s, interval_s),
            charge_nc: 0.0,
            output_v: 0.0,
        };
        Self {
            films: films.iter().map(empty).collect(),
        }
    }

    /// The volts at the next instant, whose charges are given, nC.
    pub fn next(&mut self, charges_nc: &[f64], volts: &mut [f64]) {
        for ((film, charge_nc), volts) in self.films.iter_mut().zip(charges_nc).zip(volts) {
            let rise_v = film.v_per_nc * (charge_nc - film.charge_nc);
            film.output_v = film.filter.next(film.output_v, rise_v);
            film.charge_nc = *charge_nc;
            *volts = film.output_v;
        }
    }
}

#[cfg(test)]
mod tests {
    use fem_client::film::amplifier::{Amplifier, Circuit};
    use fem_client::film::piezo::Piezo;

    use super::*;

    fn electronics(circuit: Circuit, time_constant_s: Option<f64>) -> Electronics {
        Electronics {
            circuit,
            time_constant_s,
            ..Electronics::default()
        }
    }

    /// 1 MPa along 25 x 10 mm is 23 pC/N x 250 mm^2 = 5.75 nC: 0.575 V on 10 nF.
    #[test]
    fn a_charge_amplifier_shows_the_charge_over_its_feedback() {
        let charge = Piezo::default().charge_nc([1.0, 0.0], 250.0);
        let wired = Wired::new(&electronics(Circuit::CHARGE, None), 980.0);
        assert_eq!(
            (wired.time_constant_s, wired.holding_pf()),
            (Some(10.0), 1e4)
        );
        let mut films = FilmCircuits::new(&[wired], 1e-6);
        let mut volts = [0.0];
        films.next(&[charge], &mut volts);
        // A microsecond of ten seconds has leaked, half of it on average.
        assert!((volts[0] / 0.575 - 1.0).abs() < 1e-7, "{volts:?}");
    }

    #[test]
    fn each_circuit_decays_as_its_amplifier_says() {
        let cable = Circuit::Voltage {
            input_mohm: 10.0,
            cable_pf: 300.0,
        };
        for circuit in Circuit::all().into_iter().chain([cable]) {
            let wired = Wired::new(&electronics(circuit, None), 980.0);
            let interval = 1e-5;
            let mut films = FilmCircuits::new(&[wired], interval);
            let mut volts = [0.0];
            films.next(&[2.0], &mut volts);
            let begun = volts[0];
            for _ in 0..1000 {
                films.next(&[2.0], &mut volts);
            }
            let amplifier = Amplifier {
                circuit,
                ..Amplifier::default()
            };
            let at = |elapsed| amplifier.after_step(2.0, 980.0, elapsed);
            // Rounding of 1000 factors, 1e-16 each.
            let expected = at(1000.0 * interval) / at(0.0);
            assert!(
                (volts[0] / begun / expected - 1.0).abs() < 1e-12,
                "{circuit:?}"
            );
        }
    }

    #[test]
    fn a_time_constant_of_its_own_keeps_the_held_volts() {
        for circuit in Circuit::all() {
            let own = Wired::new(&electronics(circuit, None), 980.0);
            let set = Wired::new(&electronics(circuit, Some(0.1)), 980.0);
            assert_eq!(set.v_per_nc, own.v_per_nc);
            assert_eq!(set.time_constant_s, Some(0.1));
        }
    }
}
