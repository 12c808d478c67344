//! Strain gauges: a point of the inner surface and a direction there.

use std::str::FromStr;

use serde::{Deserialize, Serialize};

use crate::scene::Scene;
use document::Table;
use document::fault::{Fault, entry, member};
use document::fields::Range;

/// A point of the inner surface and a direction there, as a strain gauge has it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, Table, utoipa::ToSchema)]
pub struct Gauge {
    /// Wheel angle from the contact centre, degrees, positive in the rolling direction.
    #[field(required = "a wheel angle, degrees", within = TURN)]
    pub theta_deg: f64,
    /// Section angle from the crown, degrees; from bead to bead.
    #[field(required = "a section angle, degrees", within = SECTION)]
    pub phi_deg: f64,
    /// Angle of the material line to the circumferential direction, drawn on the undeformed tire, degrees: 0 is x, 90 is y.
    #[field(default = 0.0, within = TURN)]
    pub angle_deg: f64,
}

/// Strain of a material line.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct GaugeReading {
    /// Place and direction of the gauge.
    #[serde(flatten)]
    pub gauge: Gauge,
    /// The signal: stretch relative to the inflated state, minus one.
    pub strain: f64,
    /// Stretch relative to the undeformed tire.
    pub stretch: f64,
    /// Green-Lagrange strain relative to the undeformed tire, (stretch^2 - 1) / 2.
    pub green_lagrange: f64,
    /// Von Mises stress of the rubber at the point, MPa.
    pub von_mises_mpa: f64,
    /// Estimated discretisation errors; absent when the solver has no estimate.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub error: Option<GaugeError>,
}

/// Estimated discretisation errors, absolute: root mean square of recovered minus raw values over the faces around the
/// point.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct GaugeError {
    /// Error of the strain since inflation.
    pub strain: f64,
    /// Error of the stretch.
    pub stretch: f64,
    /// Error of the Green-Lagrange strain.
    pub green_lagrange: f64,
    /// Error of the von Mises stress, MPa.
    pub von_mises_mpa: f64,
}

/// Text that isn't a gauge.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{text:?} isn't THETA,PHI or THETA,PHI,ANGLE in degrees, as in 0,45 or 10,0,90")]
pub struct NotAGauge {
    text: String,
}

impl FromStr for Gauge {
    type Err = NotAGauge;

    /// Reads `THETA,PHI` or `THETA,PHI,ANGLE`, degrees; the angle is 0 when left out.
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let numbers: Result<Vec<f64>, _> =
            text.split(',').map(|part| part.trim().parse()).collect();
        let (theta_deg, phi_deg, angle_deg) = match numbers.as_deref() {
            Ok(&[theta, phi]) => (theta, phi, 0.0),
            Ok(&[theta, phi, angle]) => (theta, phi, angle),
            _ => {
                return Err(NotAGauge {
                    text: text.to_owned(),
                });
            }
        };
        Ok(Self {
            theta_deg,
            phi_deg,
            angle_deg,
        })
    }
}

const TURN: Range = Range::new(-360.0, 360.0, "degrees");
const SECTION: Range = Range::new(-180.0, 180.0, "degrees");

/// Every gauge that lies off the scene's inner surface, or isn't finite.
pub fn faults(gauges: &[Gauge], scene: &Scene) -> Vec<Fault> {
    let bead = scene.geometry.bead_angle_deg;
    let mut faults = Vec::new();
    for (i, gauge) in gauges.iter().enumerate() {
        let pointer = entry("/gauges", i);
        for (name, value, range) in [
            ("theta_deg", gauge.theta_deg, TURN),
            ("phi_deg", gauge.phi_deg, Range::new(-bead, bead, "degrees")),
            ("angle_deg", gauge.angle_deg, TURN),
        ] {
            if !(range.low..=range.high).contains(&value) {
                let detail = format!("must be a number {range}; it is {value}");
                Fault::add(&mut faults, &member(&pointer, name), detail);
            }
        }
    }
    faults
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_gauge_reads_from_two_or_three_numbers() {
        let gauge = |theta_deg, phi_deg, angle_deg| Gauge {
            theta_deg,
            phi_deg,
            angle_deg,
        };
        assert_eq!("-6.5,45".parse(), Ok(gauge(-6.5, 45.0, 0.0)));
        assert_eq!("0, 10, 90".parse(), Ok(gauge(0.0, 10.0, 90.0)));
        for bad in ["", "1", "1,2,3,4", "1,x", "1;2"] {
            assert!(bad.parse::<Gauge>().is_err(), "{bad}");
        }
    }

    #[test]
    fn a_gauge_off_the_surface_is_a_fault() {
        let scene = Scene::default();
        let read = |text: &str| text.parse::<Gauge>().expect("a gauge");
        assert_eq!(faults(&[read("180,-120,45")], &scene), []);
        let found = faults(&[read("0,0"), read("nan,121,inf")], &scene);
        let pointers: Vec<&str> = found.iter().map(|fault| fault.pointer.as_str()).collect();
        assert_eq!(
            pointers,
            [
                "/gauges/1/theta_deg",
                "/gauges/1/phi_deg",
                "/gauges/1/angle_deg"
            ]
        );
        assert_eq!(
            found[1].detail,
            "must be a number from -120 to 120 degrees; it is 121"
        );
    }
}
