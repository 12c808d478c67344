//! Laws by the names that documents give them, for whoever reads one.

use crate::law::distribution::distribution_error::{finite, positive};
use crate::law::distribution::{Distribution, DistributionError};

/// A parameter of a law.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameter {
    /// key in a document
    pub name: &'static str,
    /// whether it must be greater than zero
    pub positive: bool,
    /// value where a document leaves it out, if it may
    pub default: Option<f64>,
}

impl Parameter {
    /// Returns what is wrong with a value by itself.
    pub fn fault(&self, value: f64) -> Option<DistributionError> {
        let check = if self.positive { positive } else { finite };
        check(self.name, value).err()
    }
}

/// A kind of law.
#[derive(Debug, Clone, Copy)]
pub struct Kind {
    name: &'static str,
    parameters: &'static [Parameter],
    build: fn(&[f64]) -> Result<Distribution, DistributionError>,
}

impl Kind {
    /// The kind of this name.
    pub fn named(name: &str) -> Option<&'static Self> {
        KINDS.iter().find(|kind| kind.name == name)
    }

    /// Returns the name as documents spell it.
    pub fn name(&self) -> &'static str {
        self.name
    }

    /// Returns the parameters in the order of the constructor.
    pub fn parameters(&self) -> &'static [Parameter] {
        self.parameters
    }

    /// The law with these values, in the order of the parameters.
    ///
    /// # Errors
    /// Every fault: of each parameter by itself or, if there are none, of the values together.
    ///
    /// # Panics
    /// If there are not as many values as parameters.
    pub fn distribution(&self, values: &[f64]) -> Result<Distribution, Vec<DistributionError>> {
        assert_eq!(
            values.len(),
            self.parameters.len(),
            "one value for each parameter of a {} law",
            self.name
        );
        let pairs = self.parameters.iter().zip(values);
        let faults: Vec<_> = pairs.filter_map(|(p, &value)| p.fault(value)).collect();
        if faults.is_empty() {
            (self.build)(values).map_err(|fault| vec![fault])
        } else {
            Err(faults)
        }
    }
}

const fn any(name: &'static str) -> Parameter {
    Parameter {
        name,
        positive: false,
        default: None,
    }
}

const fn above_zero(name: &'static str) -> Parameter {
    Parameter {
        positive: true,
        ..any(name)
    }
}

const fn optional(name: &'static str, default: f64) -> Parameter {
    Parameter {
        default: Some(default),
        ..any(name)
    }
}

/// All kinds of laws.
pub const KINDS: [Kind; 9] = [
    Kind {
        name: "uniform",
        parameters: &[any("min"), any("max")],
        build: |v| Distribution::uniform(v[0], v[1]),
    },
    Kind {
        name: "normal",
        parameters: &[any("mean"), above_zero("std")],
        build: |v| Distribution::normal(v[0], v[1]),
    },
    Kind {
        name: "lognormal",
        parameters: &[any("mu"), above_zero("sigma")],
        build: |v| Distribution::lognormal(v[0], v[1]),
    },
    Kind {
        name: "exponential",
        parameters: &[above_zero("rate")],
        build: |v| Distribution::exponential(v[0]),
    },
    Kind {
        name: "gamma",
        parameters: &[above_zero("shape"), above_zero("scale")],
        build: |v| Distribution::gamma(v[0], v[1]),
    },
    Kind {
        name: "weibull",
        parameters: &[above_zero("shape"), above_zero("scale")],
        build: |v| Distribution::weibull(v[0], v[1]),
    },
    Kind {
        name: "beta",
        parameters: &[
            above_zero("alpha"),
            above_zero("beta"),
            optional("min", 0.0),
            optional("max", 1.0),
        ],
        build: |v| Distribution::beta(v[0], v[1], v[2], v[3]),
    },
    Kind {
        name: "gumbel",
        parameters: &[any("location"), above_zero("scale")],
        build: |v| Distribution::gumbel(v[0], v[1]),
    },
    Kind {
        name: "triangular",
        parameters: &[any("min"), any("mode"), any("max")],
        build: |v| Distribution::triangular(v[0], v[1], v[2]),
    },
];
