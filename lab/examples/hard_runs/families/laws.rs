//! Laws of inputs.

use gsa::law::distribution::Distribution;

pub fn between(low: f64, high: f64) -> Distribution {
    Distribution::uniform(low, high).expect("a valid law")
}

/// The uniform law of width 2 about a middle.
pub fn around(middle: f64) -> Distribution {
    between(middle - 1.0, middle + 1.0)
}

pub fn bell(mean: f64, std: f64) -> Distribution {
    Distribution::normal(mean, std).expect("a valid law")
}

pub fn triangle(low: f64, mode: f64, high: f64) -> Distribution {
    Distribution::triangular(low, mode, high).expect("a valid law")
}
