//! Triangular law; its polynomials are computed from a discretisation with a break at the peak.

use super::law_contract::Law;
use crate::law::basis::Basis;
use crate::law::density::{Density, Place, centred};
use crate::law::discretisation;
use crate::law::distribution::distribution_error::{DistributionError, finite, range};

/// Density that rises straight from zero at min to its peak at mode and falls straight to zero at max.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Triangular {
    min: f64,
    mode: f64,
    max: f64,
}

impl Triangular {
    pub(super) fn new(min: f64, mode: f64, max: f64) -> Result<Self, DistributionError> {
        finite("mode", mode)?;
        range("triangular", min, max)?;
        if !(min..=max).contains(&mode) {
            return Err(DistributionError::ModeOutside { min, mode, max });
        }
        Ok(Self { min, mode, max })
    }

    fn is_symmetric(&self) -> bool {
        centred(self.min, self.mode, self.max)
    }
}

impl Law for Triangular {
    fn kind(&self) -> &'static str {
        "triangular"
    }

    fn parameters(&self) -> Vec<(&'static str, f64)> {
        vec![("min", self.min), ("mode", self.mode), ("max", self.max)]
    }

    /// (min + mode + max) / 3
    fn mean(&self) -> f64 {
        if self.is_symmetric() {
            self.mode
        } else {
            self.mode + ((self.max - self.mode) - (self.mode - self.min)) / 3.0
        }
    }

    /// sqrt((r^2 + r f + f^2)/18), r = mode - min, f = max - mode
    fn std(&self) -> f64 {
        let width = self.max - self.min;
        let (rise, fall) = (
            (self.mode - self.min) / width,
            (self.max - self.mode) / width,
        );
        width * ((rise * rise + rise * fall + fall * fall) / 18.0).sqrt()
    }

    fn probabilities(&self, x: f64) -> (f64, f64) {
        let width = self.max - self.min;
        let x = x.clamp(self.min, self.max);
        if x < self.mode {
            let p = (x - self.min) / width * ((x - self.min) / (self.mode - self.min));
            (p, 1.0 - p)
        } else if x < self.max {
            let q = (self.max - x) / width * ((self.max - x) / (self.max - self.mode));
            (1.0 - q, q)
        } else {
            (1.0, 0.0)
        }
    }

    fn quantile(&self, p: f64, q: f64) -> f64 {
        let width = self.max - self.min;
        let (rise, fall) = (self.mode - self.min, self.max - self.mode);
        let x = if p < rise / width {
            self.min + width * (p * (rise / width)).sqrt()
        } else {
            self.max - width * (q * (fall / width)).sqrt()
        };
        x.clamp(self.min, self.max)
    }

    fn basis(&self, size: usize) -> Option<Basis> {
        discretisation::basis(self, self.min, self.max, size)
    }

    fn density(&self) -> &dyn Density {
        self
    }
}

impl Density for Triangular {
    fn support(&self) -> (f64, f64) {
        (self.min, self.max)
    }

    fn width(&self) -> f64 {
        self.max - self.min
    }

    fn anchor(&self, low: f64, high: f64) -> f64 {
        self.mode.clamp(low, high)
    }

    fn ln_ratio(&self, place: &Place) -> f64 {
        // The anchor is the mode or, where that is cut off, on the same side of it as all of the law.
        let anchor = place.anchor_at(self.mode);
        if anchor < 0.0 || (anchor == 0.0 && place.from_anchor < 0.0) {
            place.ln_start_ratio()
        } else {
            place.ln_end_ratio()
        }
    }

    fn symmetry(&self, low: f64, high: f64) -> Option<f64> {
        (self.is_symmetric() && centred(low, self.mode, high)).then_some(self.mode)
    }
}
