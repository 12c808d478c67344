//! The best layouts that a search has seen.

/// Number of the best layouts that are kept.
pub const KEPT: usize = 10;

/// Films of a layout by their places, in increasing order, with its criterion, degrees.
#[derive(Debug, Clone, PartialEq)]
pub struct FoundLayout {
    /// Numbers of the places.
    pub places: Vec<usize>,
    /// Error that the search goes by, degrees.
    pub error_deg: f64,
}

/// Findings of a search.
#[derive(Debug, Clone, PartialEq)]
pub struct Findings {
    /// Best first, up to [`KEPT`].
    pub best: Vec<FoundLayout>,
    /// Whether all layouts were looked at.
    pub is_exhaustive: bool,
    /// Layouts whose criterion was computed.
    pub looked_at: usize,
}

/// Findings of searches from several starts as those of one, in the order of the starts; none of none.
pub fn joined(searches: impl IntoIterator<Item = Findings>) -> Option<Findings> {
    searches.into_iter().reduce(|one, other| {
        let mut best = Best::default();
        for found in one.best.iter().chain(&other.best) {
            best.offer(&found.places, found.error_deg);
        }
        Findings {
            looked_at: one.looked_at + other.looked_at,
            ..best.findings(one.is_exhaustive)
        }
    })
}

/// The best layouts so far, best first; of two equal ones the first in the order of places.
#[derive(Default)]
pub(crate) struct Best {
    kept: Vec<FoundLayout>,
    looked_at: usize,
}

impl Best {
    /// Looks at one more.
    pub(crate) fn offer(&mut self, places: &[usize], error_deg: f64) {
        self.looked_at += 1;
        let is_worse = |last: &FoundLayout| last.error_deg <= error_deg;
        if self.kept.len() == KEPT && self.kept.last().is_some_and(is_worse) {
            return;
        }
        if self.kept.iter().any(|kept| kept.places == places) {
            return;
        }
        let at = self
            .kept
            .partition_point(|kept| kept.error_deg <= error_deg);
        self.kept.insert(
            at,
            FoundLayout {
                places: places.to_vec(),
                error_deg,
            },
        );
        self.kept.truncate(KEPT);
    }

    /// All that was seen.
    pub(crate) fn findings(self, is_exhaustive: bool) -> Findings {
        Findings {
            best: self.kept,
            is_exhaustive,
            looked_at: self.looked_at,
        }
    }
}
