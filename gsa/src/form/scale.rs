//! Exact changes of magnitude: multiplication by powers of two.
//!
//! Responses near 1e300 or 1e-300 would over- or underflow as soon as they are squared. Every response is therefore
//! brought to order one first, which costs no digit, and results are taken back at the end.

/// The e with 2^(e-1) <= |x| < 2^e; 0 for x = 0.
///
/// x must be finite.
pub(crate) fn exponent(x: f64) -> i32 {
    const SUBNORMAL_SHIFT: i32 = 64;
    if x == 0.0 {
        0
    } else if x.is_subnormal() {
        exponent(times_power_of_two(x, SUBNORMAL_SHIFT)) - SUBNORMAL_SHIFT
    } else {
        ((x.to_bits() >> 52) & 0x7ff) as i32 - 1022
    }
}

/// x 2^power; infinite or zero where the result is out of range.
pub(crate) fn times_power_of_two(mut x: f64, mut power: i32) -> f64 {
    // 2^power itself may be out of range though the result is not, so it goes in steps.
    const STEP: i32 = 1000;
    while power.abs() > STEP {
        x *= 2f64.powi(STEP * power.signum());
        power -= STEP * power.signum();
    }
    x * 2f64.powi(power)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_magnitude_comes_to_order_one_and_back() {
        for x in [
            1.0,
            -0.75,
            1e300,
            -1e-300,
            f64::MAX,
            f64::MIN_POSITIVE,
            5e-324,
            1e-310,
        ] {
            let e = exponent(x);
            let scaled = times_power_of_two(x, -e);
            assert!((0.5..1.0).contains(&scaled.abs()), "{x:e} {scaled}");
            assert_eq!(times_power_of_two(scaled, e), x);
        }
        assert_eq!(exponent(0.0), 0);
    }

    #[test]
    fn out_of_range_is_infinite_or_zero() {
        assert_eq!(times_power_of_two(1.0, 2100), f64::INFINITY);
        assert_eq!(times_power_of_two(1.0, -2100), 0.0);
    }
}
