//! Limits to where films can be glued on a tire.

use serde_json::{Value, json};

use crate::parts::film_place::FilmPlace;

/// Limits to where films can be glued.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct GluingLimits {
    /// Films that are glued on already: part of every layout that is made, and counted.
    pub taken: Vec<FilmPlace>,
    /// Sectors of the wheel where no film lies, each from one angle to another in the rolling direction, degrees.
    pub forbidden_deg: Vec<[f64; 2]>,
    /// Least distance between the middles of two films on the inner surface, mm.
    pub least_distance_mm: f64,
}

impl GluingLimits {
    /// Puts them into a table as in a document; films that are glued on already under this name.
    pub(super) fn write(&self, taken: &str, put: &mut impl FnMut(&str, Value)) {
        if !self.taken.is_empty() {
            put(taken, json!(self.taken));
        }
        if !self.forbidden_deg.is_empty() {
            put("forbidden_deg", json!(self.forbidden_deg));
        }
        if self.least_distance_mm > 0.0 {
            put("least_distance_mm", self.least_distance_mm.into());
        }
    }

    /// Joins two: what either forbids, and what either has glued on.
    pub(super) fn with(&self, other: &Self) -> Self {
        let mut both = self.clone();
        let news = |film: &&FilmPlace| !self.taken.contains(film);
        both.taken.extend(other.taken.iter().filter(news));
        both.forbidden_deg.extend(&other.forbidden_deg);
        both.least_distance_mm = self.least_distance_mm.max(other.least_distance_mm);
        both
    }
}
