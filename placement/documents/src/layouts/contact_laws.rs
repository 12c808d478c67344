//! Laws of what a contact is beside its angle and depth: the table `layouts.contacts`.

use gsa::law::distribution::Distribution;
use serde_json::{Map, Value};

use document::Choice;
use document::fields::Range;

use crate::layouts::layout_bounds::{
    CAMBER, FRICTION_FACTOR, PRESSURE_FACTOR, ROUGH, TRACTION, UNEVEN,
};
use crate::parts::distribution_reader::distribution_value;

/// Field of how an estimate takes the scatter.
pub(super) const SCATTER: &str = "scatter";
/// Field of how many contacts judge the surface.
pub(super) const CHECKS: &str = "checks";
/// Least and largest number of them.
pub(super) const CHECKS_WITHIN: (u64, u64) = (1, 1000);
/// Share of a law beyond either of its ends: nothing is drawn from there.
const BEYOND: f64 = 1e-3;

/// Quantity of a contact that layouts' estimates don't know.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ContactQuantity {
    /// Inclination of the wheel, degrees.
    Camber,
    /// Force along the wheel over the vertical one.
    Traction,
    /// Force across the wheel over the vertical one.
    SideTraction,
    /// Depth of each station of the ground over the contact's, less one.
    Uneven,
    /// Height of each station of the ground over the contact's plane, mm.
    Rough,
    /// Internal pressure over the scene's.
    Pressure,
    /// Friction of the ground over the scene's.
    Friction,
}

impl ContactQuantity {
    /// Quantities, all of them.
    pub const ALL: [Self; 7] = [
        Self::Camber,
        Self::Traction,
        Self::SideTraction,
        Self::Uneven,
        Self::Rough,
        Self::Pressure,
        Self::Friction,
    ];

    /// Returns its name in a document.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Camber => "camber_deg",
            Self::Traction => "traction",
            Self::SideTraction => "side_traction",
            Self::Uneven => "uneven",
            Self::Rough => "rough_mm",
            Self::Pressure => "pressure_factor",
            Self::Friction => "friction_factor",
        }
    }

    /// Returns its name for people.
    pub const fn words(self) -> &'static str {
        match self {
            Self::Camber => "camber",
            Self::Traction => "traction",
            Self::SideTraction => "side traction",
            Self::Uneven => "uneven ground",
            Self::Rough => "rough ground",
            Self::Pressure => "pressure",
            Self::Friction => "friction",
        }
    }

    /// Value of the contact for which a scene is made: upright, not dragged, on flat ground, at the scene's pressure and friction.
    pub const fn usual(self) -> f64 {
        match self {
            Self::Pressure | Self::Friction => 1.0,
            _ => 0.0,
        }
    }

    /// Values that it takes.
    pub(super) const fn range(self) -> Range {
        match self {
            Self::Camber => CAMBER,
            Self::Traction | Self::SideTraction => TRACTION,
            Self::Uneven => UNEVEN,
            Self::Rough => ROUGH,
            Self::Pressure => PRESSURE_FACTOR,
            Self::Friction => FRICTION_FACTOR,
        }
    }

    /// Returns its description in a schema.
    pub(super) const fn doc(self) -> &'static str {
        match self {
            Self::Camber => "Law of the wheel's inclination, degrees, within -30 to 30.",
            Self::Traction => {
                "Law of the force along the wheel over the vertical one, within four fifths of the least friction."
            }
            Self::SideTraction => {
                "Law of the force across the wheel over the vertical one, within four fifths of the least friction."
            }
            Self::Uneven => {
                "Law of each station's depth over the contact's, less one: independent of the others."
            }
            Self::Rough => {
                "Law of each station's height over the contact's plane, mm, independent of the others: rough ground of that deviation, whatever the depth. Takes the place of `uneven`."
            }
            Self::Pressure => "Law of the internal pressure over the scene's.",
            Self::Friction => "Law of the ground's friction over the scene's.",
        }
    }
}

/// Law of one quantity.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactLaw {
    /// Quantity that it is the law of.
    pub quantity: ContactQuantity,
    /// The law.
    pub law: Distribution,
}

impl ContactLaw {
    /// Least and largest value that are drawn: a thousandth of the law lies beyond either.
    pub fn ends(&self) -> [f64; 2] {
        [self.value_at(0.0), self.value_at(1.0)]
    }

    /// Value at a share of what is drawn, from 0 to 1.
    pub fn value_at(&self, share: f64) -> f64 {
        self.law.inverse_cdf(BEYOND + (1.0 - 2.0 * BEYOND) * share)
    }

    /// Returns what it is the law of, and what it reaches from and to, in words.
    pub fn described(&self) -> String {
        let [low, high] = self.ends();
        let unit = match self.quantity {
            ContactQuantity::Camber => " degrees",
            ContactQuantity::Rough => " mm",
            _ => "",
        };
        format!("{} {low:.2} to {high:.2}{unit}", self.quantity.words())
    }

    /// Largest distance of a drawn value from the usual one.
    pub fn reach(&self) -> f64 {
        let apart = |end: f64| (end - self.quantity.usual()).abs();
        let [low, high] = self.ends();
        apart(low).max(apart(high))
    }
}

/// Scatter of films over contacts, as an estimate takes it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Choice)]
pub enum Scatter {
    /// Known of all films together: what contacts differ in is estimated beside angle and depth.
    #[default]
    Together,
    /// Noise of each film for its own: averaged over.
    Each,
}

/// Contacts as they come: the table `layouts.contacts`.
#[derive(Debug, Clone, PartialEq)]
pub struct Contacts {
    /// Laws of what a contact is beside its angle and depth; none: it is upright, on flat ground, not dragged.
    pub laws: Vec<ContactLaw>,
    /// Scatter over these contacts, as an estimate takes it.
    pub scatter: Scatter,
    /// Number of contacts that are solved to judge the response surface, and left out of it.
    pub checks: u32,
}

impl Default for Contacts {
    fn default() -> Self {
        Self {
            laws: Vec::new(),
            scatter: Scatter::default(),
            checks: 3,
        }
    }
}

impl Contacts {
    /// Writes the table in a document.
    pub(super) fn to_value(&self) -> Value {
        let entry = |law: &ContactLaw| {
            let name = law.quantity.as_str().to_owned();
            (name, distribution_value(&law.law))
        };
        let mut table: Map<_, _> = self.laws.iter().map(entry).collect();
        let usual = Self::default();
        if self.scatter != usual.scatter {
            table.insert(SCATTER.to_owned(), self.scatter.as_str().into());
        }
        if self.checks != usual.checks {
            table.insert(CHECKS.to_owned(), self.checks.into());
        }
        Value::Object(table)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_law_is_drawn_but_for_its_ends() {
        let law = |quantity, law: Result<Distribution, _>| ContactLaw {
            quantity,
            law: law.expect("a law"),
        };
        let camber = law(
            ContactQuantity::Camber,
            Distribution::uniform(-10.0, 5.0).map_err(|_| ()),
        );
        let [low, high] = camber.ends();
        assert!((low + 9.985).abs() < 1e-12 && (high - 4.985).abs() < 1e-12);
        assert!((camber.reach() - 9.985).abs() < 1e-12);
        let pressure = law(
            ContactQuantity::Pressure,
            Distribution::uniform(0.9, 1.0).map_err(|_| ()),
        );
        assert!((pressure.reach() - 0.0999).abs() < 1e-12);
        // Of a bell the reach is finite: 3.09 standard deviations.
        let bell = law(
            ContactQuantity::Uneven,
            Distribution::normal(0.0, 0.1).map_err(|_| ()),
        );
        assert!((bell.reach() - 0.309_023).abs() < 1e-6);
    }
}
