//! Densities known up to a factor, as ratios that neither cancel nor overflow.
//!
//! A law that has no closed recurrence is described by f(x)/f(m) with m an anchor in its bulk. In logarithms, and from
//! the distance x - m instead of x, the ratio keeps its digits in the far tail of a law, on an interval of a few
//! eps and at an end where the density is infinite.

/// Place where a density is asked for: a point by its distances, each accurate by itself.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Place {
    /// x - m
    pub(crate) from_anchor: f64,
    /// x - start of the law's support, and its logarithm, which lives on where the distance underflows
    pub(crate) from_start: (f64, f64),
    /// end of the law's support - x, and its logarithm
    pub(crate) from_end: (f64, f64),
    anchor: f64,
    /// m - start and end - m
    anchor_distances: (f64, f64),
}

impl Place {
    /// A point m + d of a law supported on (start, end), not closer to an end than doubles resolve.
    pub(crate) fn new(support: (f64, f64), anchor: f64, from_anchor: f64) -> Self {
        let anchor_distances = (anchor - support.0, support.1 - anchor);
        let (from_start, from_end) = (
            (anchor_distances.0 + from_anchor).max(0.0),
            (anchor_distances.1 - from_anchor).max(0.0),
        );
        Self {
            from_anchor,
            from_start: (from_start, from_start.ln()),
            from_end: (from_end, from_end.ln()),
            anchor,
            anchor_distances,
        }
    }

    /// m - reference
    pub(crate) fn anchor_at(&self, reference: f64) -> f64 {
        self.anchor - reference
    }

    /// Returns this point, with its distance from the start, from the end, or both, known better than x itself.
    pub(crate) fn refined(
        mut self,
        from_start: Option<(f64, f64)>,
        from_end: Option<(f64, f64)>,
    ) -> Self {
        self.from_start = from_start.unwrap_or(self.from_start);
        self.from_end = from_end.unwrap_or(self.from_end);
        self
    }

    /// ln((x - start)/(m - start))
    pub(crate) fn ln_start_ratio(&self) -> f64 {
        ln_ratio(self.from_anchor, self.from_start.1, self.anchor_distances.0)
    }

    /// ln((end - x)/(end - m))
    pub(crate) fn ln_end_ratio(&self) -> f64 {
        ln_ratio(-self.from_anchor, self.from_end.1, self.anchor_distances.1)
    }
}

fn ln_ratio(change: f64, ln_distance: f64, reference: f64) -> f64 {
    if change.abs() < 0.5 * reference {
        (change / reference).ln_1p()
    } else {
        ln_distance - reference.ln()
    }
}

/// The logarithm of ratio^exponent; a power of zero is no factor at all.
pub(crate) fn power(exponent: f64, ln_ratio: f64) -> f64 {
    if exponent == 0.0 {
        0.0
    } else {
        exponent * ln_ratio
    }
}

/// A density with at most one peak inside, or none and its largest values at the ends.
pub(crate) trait Density {
    /// The ends of the whole law, possibly infinite.
    fn support(&self) -> (f64, f64);

    /// A length on which the whole law changes; only its order of magnitude matters.
    fn width(&self) -> f64;

    /// A point of \[low, high\] with finite positive density near which the law restricted to it has its mass.
    fn anchor(&self, low: f64, high: f64) -> f64;

    /// ln(f(x)/f(m))
    fn ln_ratio(&self, place: &Place) -> f64;

    /// The centre about which the law restricted to \[low, high\] is symmetric.
    fn symmetry(&self, _low: f64, _high: f64) -> Option<f64> {
        None
    }
}

/// Whether an interval is centred on a point as well as doubles can say.
pub(crate) fn centred(low: f64, centre: f64, high: f64) -> bool {
    let rounding = 4.0 * f64::EPSILON * low.abs().max(high.abs());
    rounding.is_finite() && ((high - centre) - (centre - low)).abs() <= rounding
}
