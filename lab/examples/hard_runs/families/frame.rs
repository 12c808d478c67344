//! Frame of a set of families: its groups, and the source of its parameters.

use crate::families::draw::Draw;
use crate::families::model::Model;

/// Values that are printed with few digits.
const PRINTED: &str = "printed digits";
/// Lines through the cut that show nothing of their input, or nearly.
const FLAT: &str = "flat line at the cut";
/// Sections with an infinite slope, or an infinite value, at an end of their range or inside.
const SINGULAR: &str = "singular section";
/// Runs that fail: where the function goes on, and where it is another one.
const FAILED: [(&str, f64); 2] = [
    ("failed runs", 0.0),
    ("failed runs, another law there", 1.0),
];

/// Models of one group.
type Group = fn(&mut Draw) -> Vec<Model>;

/// A set of families, a model of each for a seed.
pub struct Families {
    /// Number that is added to seeds, so that no two sets draw alike.
    pub source: u64,
    pub printed: Group,
    pub flat: Group,
    pub singular: Group,
    /// Models whose function has another law, so many times as strong, where runs fail.
    pub failed: fn(&mut Draw, f64) -> Vec<Model>,
}

impl Families {
    /// Draws a model of every family.
    pub fn all(&self, seed: u64) -> Vec<Model> {
        let mut d = Draw::new(seed + self.source);
        let groups = [
            (PRINTED, self.printed),
            (FLAT, self.flat),
            (SINGULAR, self.singular),
        ];
        let mut models = Vec::new();
        for (group, draw) in groups {
            models.extend(draw(&mut d).into_iter().map(|model| model.of(group)));
        }
        for (group, bends) in FAILED {
            let failed = (self.failed)(&mut d, bends);
            models.extend(failed.into_iter().map(|model| model.of(group)));
        }
        models
    }
}
