//! The limit of a value under refinement, with its error.
//!
//! v(h) = v0 + c h^p is fitted to the finest meshes: least squares for v0 and c at every p of a grid, and the best p. The error
//! is a safety factor times the distance from the finest value to the limit, plus the fit's own standard deviation, after
//! L. Eça and M. Hoekstra, J. Comput. Phys. 262 (2014) 104: 1.25 for a fit to be trusted, else 3 times the values' range.

/// Meshes that take part: one more than the fit has parameters.
const FITTED: usize = 4;
/// Orders that are tried: a best one at either end says that the meshes aren't in the range of a power law.
const ORDERS: (f64, f64) = (0.5, 6.0);
const ORDER_STEP: f64 = 0.01;

/// Limit of a value.
#[derive(Debug, Clone, Copy)]
pub struct Limit {
    /// The value there.
    pub value: f64,
    /// Error of the limit, absolute.
    pub error: f64,
    /// Observed order; `None` when no power law fits.
    pub order: Option<f64>,
}

/// Limit of values on meshes of these sizes, coarse to fine.
pub fn limit(sizes: &[f64], values: &[f64]) -> Limit {
    let first = values.len().saturating_sub(FITTED);
    let (sizes, values) = (&sizes[first..], &values[first..]);
    let finest = values[values.len() - 1];
    let steps = ((ORDERS.1 - ORDERS.0) / ORDER_STEP).round() as usize;
    let fits = (0..=steps).map(|k| {
        let order = ORDERS.0 + k as f64 * ORDER_STEP;
        let (value, deviation) = fit(sizes, values, order);
        (order, value, deviation)
    });
    let best = fits.min_by(|a, b| a.2.total_cmp(&b.2));
    let (order, value, deviation) = best.expect("the grid of orders isn't empty");
    let is_inside = order > ORDERS.0 + ORDER_STEP && order < ORDERS.1 - ORDER_STEP;
    let spread = |f: fn(f64, f64) -> f64| values.iter().copied().fold(finest, f);
    if is_inside {
        Limit {
            value,
            error: 1.25 * (value - finest).abs() + deviation,
            order: Some(order),
        }
    } else {
        Limit {
            value: finest,
            error: 3.0 * (spread(f64::max) - spread(f64::min)),
            order: None,
        }
    }
}

/// Limit and standard deviation of the best fit of this order.
fn fit(sizes: &[f64], values: &[f64], order: f64) -> (f64, f64) {
    let n = sizes.len() as f64;
    let powers: Vec<f64> = sizes.iter().map(|h| h.powf(order)).collect();
    let mean = |values: &[f64]| values.iter().sum::<f64>() / n;
    let (mean_power, mean_value) = (mean(&powers), mean(values));
    let pairs = || powers.iter().zip(values);
    let covariance: f64 = pairs()
        .map(|(p, v)| (p - mean_power) * (v - mean_value))
        .sum();
    let variance: f64 = powers.iter().map(|p| (p - mean_power).powi(2)).sum();
    let slope = covariance / variance;
    let limit = mean_value - slope * mean_power;
    let squares: f64 = pairs().map(|(p, v)| (v - limit - slope * p).powi(2)).sum();
    (limit, (squares / (n - 3.0)).sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZES: [f64; 5] = [1.0, 0.5, 1.0 / 3.0, 0.25, 0.2];

    #[test]
    fn a_power_law_is_found() {
        for (order, factor) in [(1.0, 0.3), (2.0, -5.0), (3.5, 2.0)] {
            let values = SIZES.map(|h: f64| 7.0 + factor * h.powf(order));
            let limit = limit(&SIZES, &values);
            // The order is on the grid, so what remains is round-off.
            assert!((limit.value - 7.0).abs() < 1e-12, "{limit:?}");
            let found = limit.order.expect("a power law");
            assert!((found - order).abs() < 0.5 * ORDER_STEP, "{limit:?}");
            assert!((limit.error - 1.25 * (values[4] - 7.0).abs()).abs() < 1e-12);
        }
    }

    #[test]
    fn values_that_scatter_have_no_order() {
        let limit = limit(&SIZES, &[0.0, 1.0, 1.2, 1.0, 1.1]);
        assert!(limit.order.is_none());
        assert!((limit.value - 1.1).abs() < 1e-12 && (limit.error - 0.6).abs() < 1e-12);
    }
}
