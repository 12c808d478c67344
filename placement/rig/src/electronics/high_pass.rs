//! A first-order high-pass at even intervals: y' + y / tau = x'.
//!
//! For an input that is linear between instants the step is exact: y_(k+1) = b y_k + p (x_(k+1) - x_k), with b = exp(-h / tau) and p = (1 - b) tau / h for
//! the interval h.

/// A high-pass at even intervals.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct HighPass {
    keep: f64,
    pass: f64,
}

impl HighPass {
    /// Makes a high-pass with a time constant, s, or none where nothing leaks, and the interval, s.
    pub fn new(time_constant_s: Option<f64>, interval_s: f64) -> Self {
        let Some(time_constant_s) = time_constant_s else {
            return Self {
                keep: 1.0,
                pass: 1.0,
            };
        };
        let intervals = interval_s / time_constant_s;
        Self {
            keep: (-intervals).exp(),
            pass: -(-intervals).exp_m1() / intervals,
        }
    }

    /// The output an interval later, in which the input rose by so much.
    pub fn next(self, output: f64, rise: f64) -> f64 {
        self.keep * output + self.pass * rise
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;

    #[test]
    fn a_held_input_decays_with_the_time_constant() {
        for (time_constant, interval) in [(0.01, 0.005), (1.0, 0.005), (10.0, 0.005), (0.001, 0.1)]
        {
            let filter = HighPass::new(Some(time_constant), interval);
            let mut output = 3.0;
            for k in 1..100 {
                output = filter.next(output, 0.0);
                let expected = 3.0 * (-f64::from(k) * interval / time_constant).exp();
                assert!(
                    (output - expected).abs() <= 1e-13 * 3.0,
                    "{time_constant} {k}"
                );
            }
        }
    }

    #[test]
    fn a_ramp_is_exact_whatever_the_interval() {
        // Of a slope of 2: 2 tau (1 - exp(-t / tau)).
        for interval in [0.001, 0.1, 1.0] {
            let filter = HighPass::new(Some(0.3), interval);
            let mut output = 0.0;
            for k in 1..10 {
                output = filter.next(output, 2.0 * interval);
                let expected = -2.0 * 0.3 * (-f64::from(k) * interval / 0.3).exp_m1();
                assert!((output - expected).abs() < 1e-14, "{interval} {k} {output}");
            }
        }
    }

    /// A sine sin(w t) comes out as w tau / sqrt(1 + (w tau)^2), ahead by arctan(1 / (w tau)). A line between instants differs from the sine by (w h)^2
    /// / 8 at most; the high-pass leaves at most twice of that.
    #[test]
    fn a_sine_has_its_amplitude_and_phase() {
        let (hz, interval) = (2.0, 1e-4);
        let turn = TAU * hz * interval;
        for time_constant in [0.01, 0.1, 1.0, 10.0] {
            let filter = HighPass::new(Some(time_constant), interval);
            let wt = TAU * hz * time_constant;
            let (amplitude, ahead) = (wt / wt.hypot(1.0), wt.recip().atan());
            // It begins as if it had gone on forever.
            let mut output = amplitude * ahead.sin();
            for k in 1..20_000 {
                let at = |k: i32| (turn * f64::from(k)).sin();
                output = filter.next(output, at(k) - at(k - 1));
                let expected = amplitude * (turn * f64::from(k) + ahead).sin();
                assert!(
                    (output - expected).abs() < 0.25 * turn * turn,
                    "{time_constant} {k}"
                );
            }
        }
    }

    #[test]
    fn nothing_leaks_from_an_open_circuit() {
        let filter = HighPass::new(None, 0.005);
        assert_eq!(filter.next(2.0, 0.5), 2.5);
        // A long time constant comes to the same.
        let long = HighPass::new(Some(1e15), 0.005);
        assert!((long.next(2.0, 0.5) - 2.5).abs() < 1e-14);
    }
}
