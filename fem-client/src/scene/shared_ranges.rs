//! Ranges of fields in several parts of a scene.

use document::fields::Range;

pub(super) const LENGTH: Range = Range::new(1e-3, 1e4, "mm");
pub(super) const MODULUS: Range = Range::new(1e-6, 1e6, "MPa");
pub(super) const MODULUS_OR_ZERO: Range = Range::new(0.0, 1e6, "MPa");
