//! Amplifier of a film's charge.
//!
//! A film of capacitance C with a resistance R across it obeys C dV/dt + V/R = dQ/dt: of a press once a second it keeps little, unless C R is long beside the
//! press. For a charge that swings as a sine, the voltage's amplitude is that of the open circuit times w C R / sqrt(1 + (w C R)^2).

use std::f64::consts::TAU;

use document::fields::Range;
use document::{Table, Variants};

const RESISTANCE: Range = Range::new(1e-6, 1e9, "megohm");
const CABLE: Range = Range::new(0.0, 1e6, "pF");
const CAPACITANCE: Range = Range::new(1e-6, 1e6, "nF");
const FREQUENCY: Range = Range::new(1e-6, 1e6, "Hz");
const NOISE: Range = Range::new(0.0, 1e9, "mV");
const GAIN: Range = Range::new(0.0, 1.0, "");
const FEEDBACK_NF: f64 = 10.0;
const FEEDBACK_MOHM: f64 = 1000.0;
const WARMING: Range = Range::new(0.0, 1e3, "K");
const SUPPLY: Range = Range::new(1e-3, 1e4, "V");
/// Supply that amplifiers have at most, V, as far as a note knows.
const LARGEST_SUPPLY: f64 = 30.0;

/// Circuit that a film is wired to, and how fast it is pressed.
#[derive(Debug, Clone, Copy, PartialEq, Table)]
pub struct Amplifier {
    /// The circuit.
    #[field(default = Circuit::OpenCircuit, group)]
    pub circuit: Circuit,
    /// Presses per second, Hz.
    #[field(default = 1.0, within = FREQUENCY)]
    pub press_hz: f64,
    /// Standard deviation of what it shows without a film, mV.
    #[field(default = 0.0, within = NOISE)]
    pub noise_mv: f64,
    /// Standard deviation of film and amplifier's gain from one to the next, as a share.
    #[field(default = 0.05, within = GAIN)]
    pub gain_std: f64,
    /// Standard deviation of the film's temperature within a press, K.
    #[field(default = 0.0, within = WARMING)]
    pub temperature_k: f64,
    /// Voltage to both sides of zero that it can show, V; absent: it isn't known.
    #[field(within = SUPPLY)]
    pub supply_v: Option<f64>,
}

/// Circuits that read a film.
#[derive(Debug, Clone, Copy, PartialEq, Variants)]
#[variants(tag = "kind")]
pub enum Circuit {
    /// Open circuit: nothing draws charge.
    OpenCircuit,
    /// A voltage amplifier; the usual one is as a multimeter or an oscilloscope's probe.
    Voltage {
        /// Input resistance, megohm.
        #[field(default = 10.0, within = RESISTANCE)]
        input_mohm: f64,
        /// Capacitance of the cable to it, pF.
        #[field(default = 0.0, within = CABLE)]
        cable_pf: f64,
    },
    /// A charge amplifier; the usual one has a time constant of ten seconds.
    Charge {
        /// Feedback capacitance, nF.
        #[field(default = FEEDBACK_NF, within = CAPACITANCE)]
        feedback_nf: f64,
        /// Feedback resistance, megohm.
        #[field(default = FEEDBACK_MOHM, within = RESISTANCE)]
        feedback_mohm: f64,
    },
}

impl Circuit {
    /// The usual charge amplifier.
    pub const CHARGE: Self = Self::Charge {
        feedback_nf: FEEDBACK_NF,
        feedback_mohm: FEEDBACK_MOHM,
    };

    /// Voltage of a film's charge, nC, without any resistance, V, and the time constant with it, s; the film's capacitance in pF. Charge amplifiers are taken
    /// without their change of sign.
    pub fn held(&self, charge_nc: f64, capacitance_pf: f64) -> (f64, Option<f64>) {
        match *self {
            Self::OpenCircuit => (1e3 * charge_nc / capacitance_pf, None),
            Self::Voltage {
                input_mohm,
                cable_pf,
            } => {
                let capacitance_pf = capacitance_pf + cable_pf;
                (
                    1e3 * charge_nc / capacitance_pf,
                    Some(1e-6 * input_mohm * capacitance_pf),
                )
            }
            Self::Charge {
                feedback_nf,
                feedback_mohm,
            } => (
                charge_nc / feedback_nf,
                Some(1e-3 * feedback_mohm * feedback_nf),
            ),
        }
    }
}

/// Voltages that an amplifier reads of a film.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reading {
    /// Amplitude for presses that swing the charge as a sine, V.
    pub output_v: f64,
    /// Time in which a held charge falls to 1/e, s; `None` where it stays.
    pub time_constant_s: Option<f64>,
}

impl Amplifier {
    /// Returns what is read of a film with this charge, nC, and capacitance, pF.
    pub fn reading(&self, charge_nc: f64, capacitance_pf: f64) -> Reading {
        let (held_v, time_constant_s) = self.circuit.held(charge_nc, capacitance_pf);
        let share = time_constant_s.map_or(1.0, |time| {
            let turns = TAU * self.press_hz * time;
            turns / turns.hypot(1.0)
        });
        Reading {
            output_v: share * held_v,
            time_constant_s,
        }
    }

    /// Standard deviation of a reading, V, by noise, gain and temperature; `warming` is the charge of a kelvin, nC/K.
    pub(crate) fn reading_std_v(&self, charge_nc: f64, capacitance_pf: f64, warming: f64) -> f64 {
        let of = |charge_nc| self.reading(charge_nc, capacitance_pf).output_v;
        let gain = self.gain_std * of(charge_nc);
        let warmed = of(self.temperature_k * warming);
        (1e-3 * self.noise_mv).hypot(gain).hypot(warmed)
    }

    /// Whether an output, V, is more than it can show.
    pub(crate) fn saturates(&self, output_v: f64) -> bool {
        self.supply_v
            .is_some_and(|supply_v| output_v.abs() > supply_v)
    }

    /// Returns a sentence on an output, V, that no amplifier shows, where its supply isn't known.
    pub fn unlikely_output(&self, output_v: f64) -> Option<String> {
        let is_amplified = self.circuit != Circuit::OpenCircuit;
        let is_unlikely = self.supply_v.is_none() && output_v.abs() > LARGEST_SUPPLY;
        (is_amplified && is_unlikely).then(|| {
            format!(
                "the amplifier's output is {output_v:.0} V, where supplies are 3 to 15 V: it would saturate; supply_v says where, and a larger capacitance, or a smaller film, makes less"
            )
        })
    }

    /// Voltage, V, so long after a press that came at once and stays, s.
    pub fn after_step(&self, charge_nc: f64, capacitance_pf: f64, elapsed_s: f64) -> f64 {
        let (held_v, time_constant_s) = self.circuit.held(charge_nc, capacitance_pf);
        let decay = time_constant_s.map_or(1.0, |time| (-elapsed_s / time).exp());
        decay * held_v
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const VOLTAGE: Circuit = Circuit::Voltage {
        input_mohm: 10.0,
        cable_pf: 0.0,
    };

    fn amplifier(circuit: Circuit, press_hz: f64) -> Amplifier {
        Amplifier {
            circuit,
            press_hz,
            ..Amplifier::default()
        }
    }

    #[test]
    fn little_is_left_of_a_slow_press_on_ten_megohm() {
        // 95 pF on 10 Mohm at 1 Hz: w C R = 5.97e-3.
        let read = amplifier(VOLTAGE, 1.0).reading(0.095, 95.0);
        let turns = TAU * 95e-12 * 10e6;
        assert!((read.output_v / (turns / (1.0 + turns * turns).sqrt()) - 1.0).abs() < 1e-10);
        assert!((read.output_v - 0.006).abs() < 1e-4);
        assert!((read.time_constant_s.expect("it leaks") / 950e-6 - 1.0).abs() < 1e-10);
    }

    #[test]
    fn a_circuit_s_limits_are_the_charge_and_its_rate() {
        let open = amplifier(Circuit::OpenCircuit, 1.0).reading(2.0, 100.0);
        assert_eq!((open.output_v, open.time_constant_s), (20.0, None));
        let fast = amplifier(VOLTAGE, 1e9).reading(2.0, 100.0);
        assert!((fast.output_v / 20.0 - 1.0).abs() < 1e-10);
        let cable = Circuit::Voltage {
            input_mohm: 10.0,
            cable_pf: 300.0,
        };
        assert!((amplifier(cable, 1e9).reading(2.0, 100.0).output_v / 5.0 - 1.0).abs() < 1e-10);
        // Slow: R dQ/dt = 10 Mohm x 2 pi f Q.
        let slow = amplifier(VOLTAGE, 1e-6).reading(2.0, 100.0);
        assert!((slow.output_v / (10e6 * TAU * 1e-6 * 2e-9) - 1.0).abs() < 1e-10);
        let charge = amplifier(Circuit::CHARGE, 1e6).reading(2.0, 100.0);
        assert!((charge.output_v / 0.2 - 1.0).abs() < 1e-10);
    }

    #[test]
    fn a_reading_is_as_sure_as_its_three_causes_together() {
        let amplifier = Amplifier {
            noise_mv: 300.0,
            gain_std: 0.02,
            temperature_k: 0.1,
            ..Amplifier::default()
        };
        // 2 nC on 100 pF is 20 V: 0.3 V of noise, 0.4 V of gain, 1.2 V of 0.12 nC.
        let std = amplifier.reading_std_v(2.0, 100.0, 1.2);
        assert!((std / 1.69_f64.sqrt() - 1.0).abs() < 1e-10, "{std}");
    }

    /// The ODE C dV/dt + V/R = dQ/dt, by Richardson's extrapolation of the implicit midpoint rule, whose error falls as the step squared.
    #[test]
    fn a_step_decays_as_the_circuit_s_equation_says() {
        let amplifier = amplifier(VOLTAGE, 1.0);
        let (charge, capacitance) = (2.0, 100.0);
        let elapsed = 1.5e-3;
        let by_steps = |steps: i32| {
            let half = 0.5 * elapsed / f64::from(steps) / (1e-6 * 10.0 * capacitance);
            20.0 * ((1.0 - half) / (1.0 + half)).powi(steps)
        };
        // Errors in powers of the step squared: two eliminations of 1000, 2000 and 4000 steps leave the sixth power, 1e-17.
        let [a, b, c] = [1000, 2000, 4000].map(by_steps);
        let [ab, bc] = [(4.0 * b - a) / 3.0, (4.0 * c - b) / 3.0];
        let expected = (16.0 * bc - ab) / 15.0;
        let found = amplifier.after_step(charge, capacitance, elapsed);
        assert!((found / expected - 1.0).abs() < 1e-10, "{found} {expected}");
    }
}
