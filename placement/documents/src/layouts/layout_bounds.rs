//! Bounds of the fields of layouts.

use document::fields::Range;

pub(super) const SPACING: Range = Range::new(1.0, 360.0, "degrees");
pub(super) const ANGLE: Range = Range::new(-360.0, 360.0, "degrees");
pub(super) const DISTANCE: Range = Range::new(0.0, 1e4, "mm");
pub(super) const SHARE: Range = Range::new(1e-6, 1.0, "");
pub(super) const STRAIN: Range = Range::new(1e-9, 0.1, "");
pub(super) const VOLTS: Range = Range::new(1e-9, 1e4, "V");
pub(super) const GAIN: Range = Range::new(0.0, 1.0, "");
pub(super) const NOISE_FACTOR: Range = Range::new(0.01, 100.0, "");
pub(super) const DRIFT: Range = Range::new(0.0, 1.0, "");
pub(super) const CAMBER: Range = Range::new(-30.0, 30.0, "degrees");
pub(super) const TRACTION: Range = Range::new(-2.0, 2.0, "");
pub(super) const UNEVEN: Range = Range::new(-0.9, 0.9, "");
pub(super) const ROUGH: Range = Range::new(-1e4, 1e4, "mm");
pub(super) const FRICTION: Range = Range::new(0.0, 2.0, "");
pub(super) const PRESSURE_FACTOR: Range = Range::new(0.5, 2.0, "");
pub(super) const FRICTION_FACTOR: Range = Range::new(0.2, 4.0, "");
pub(super) const PLACE: Range = Range::new(0.0, 30.0, "degrees");
/// Most entries of a list of spacings, numbers of units, section angles or sets of directions.
pub(super) const MOST_ENTRIES: usize = 50;
pub(super) const MOST_UNITS: u64 = 120;
pub(super) const MOST_LOADS: usize = 8;
pub(super) const MOST_FREE: usize = 100;
/// Most films of one layout.
pub(crate) const MOST_FILMS: usize = 240;
pub(super) const MOST_SEARCHED: u64 = 48;
pub(super) const MOST_SLOTS: u64 = 120;
/// Most regular layouts: each takes about a second of a core at three loads on two meshes.
pub(super) const MOST_LAYOUTS: usize = 1000;
/// Most places that a search tries.
pub(super) const MOST_PLACES: usize = 2000;
/// Characters of a layout's name.
pub const LONGEST_LAYOUT: usize = 60;
pub(super) const SIDE: Range = Range::new(1e-3, 1e4, "mm");
/// Most further sizes of the candidates: each has a line around the wheel for every few degrees that it covers.
pub(super) const MOST_SIZES: usize = 4;
