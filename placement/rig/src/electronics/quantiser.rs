//! A converter from volts to whole steps.

/// A converter of a range of volts to both sides of zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Quantiser {
    /// 0: what comes is what is read.
    step_v: f64,
    lowest: f64,
    highest: f64,
}

impl Quantiser {
    /// Makes a converter from -range to range, V, in 2^bits steps; without bits, or without a range, nothing is rounded.
    pub fn new(bits: u32, range_v: f64) -> Self {
        let half = 0.5 * f64::from(bits).exp2();
        Self {
            step_v: if bits > 0 { range_v / half } else { 0.0 },
            lowest: -half,
            highest: half - 1.0,
        }
    }

    /// Volts as they are stored, V: the nearest step, within the range.
    pub fn read(&self, volts: f64) -> f64 {
        if self.step_v == 0.0 {
            return volts;
        }
        let code = (volts / self.step_v).round();
        self.step_v * code.clamp(self.lowest, self.highest)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_read_is_half_a_step_off_at_most() {
        let converter = Quantiser::new(12, 2.0);
        let step = 4.0 / 4096.0;
        // Up to the highest step, which is one below the range.
        for k in -10_000..=9990 {
            let volts = 2.0 * f64::from(k) / 10_000.0;
            let off = converter.read(volts) - volts;
            // Rounding of 2 V beside half a step.
            assert!(off.abs() <= 0.5 * step + 1e-15, "{volts} {off}");
            let steps = converter.read(volts) / step;
            assert_eq!(steps, steps.round());
        }
    }

    #[test]
    fn beyond_the_range_it_stays_at_the_end() {
        let converter = Quantiser::new(8, 1.0);
        assert_eq!(converter.read(5.0), 127.0 / 128.0);
        assert_eq!(converter.read(-5.0), -1.0);
    }

    #[test]
    fn without_bits_nothing_is_rounded() {
        assert_eq!(Quantiser::new(0, 1.0).read(1.234_567), 1.234_567);
        assert_eq!(Quantiser::new(12, 0.0).read(1e-6), 1e-6);
    }
}
