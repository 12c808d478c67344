//! The rubber of a scene.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use document::fault::{Fault, member};
use document::fields::{Fields, Range, alternatives, plain, shown};
use document::json_schema::{Properties, Schemas};
use document::typed::field_value::Field;
use document::typed::kinds::{describe_variants, write_variant};
use document::{Map, Table, Value, Variants};

use super::shared_ranges::{MODULUS, MODULUS_OR_ZERO};

const COMPRESSIBILITY: Range = Range::new(0.0, 1e6, "1/MPa");
/// Weights that may soften the rubber.
const WEIGHT: Range = Range::new(-1e6, 1e6, "MPa");
const EXPONENT: Range = Range::new(-30.0, 30.0, "");
/// Least size of an exponent: the terms are divided by its square.
const SMALLEST_EXPONENT: f64 = 1e-3;
const MOST_TERMS: usize = 6;
const D1: &str = "d1_per_mpa";

/// Rubber: an isochoric law and its compressibility.
#[derive(Debug, Clone, PartialEq)]
pub struct Material {
    /// Isochoric law with its parameters.
    pub law: Law,
    /// Compressibility, 1/MPa: the bulk modulus is 2/d1; 0 is exactly incompressible.
    pub d1_per_mpa: f64,
}

/// Isochoric laws, in the invariants I1, I2 and principal stretches l1, l2, l3 of J^(-1/3) F. The default parameters are those of the paper's rubber, or the
/// nearest to it with the same shear modulus.
#[derive(Debug, Clone, PartialEq, Variants)]
#[variants(tag = "model")]
pub enum Law {
    /// W = c10 (I1 - 3) + c01 (I2 - 3).
    MooneyRivlin {
        /// First constant, MPa.
        #[field(default = 0.144, within = MODULUS)]
        c10_mpa: f64,
        /// Second constant, MPa.
        #[field(default = 0.036, within = MODULUS_OR_ZERO)]
        c01_mpa: f64,
    },
    /// W = c10 (I1 - 3).
    NeoHookean {
        /// Half of the shear modulus, MPa.
        #[field(default = 0.18, within = MODULUS)]
        c10_mpa: f64,
    },
    /// W = c10 (I1 - 3) + c20 (I1 - 3)^2 + c30 (I1 - 3)^3.
    Yeoh {
        /// Half of the initial shear modulus, MPa.
        #[field(default = 0.18, within = MODULUS)]
        c10_mpa: f64,
        /// Weight of the square, MPa.
        #[field(default = 0.0, within = WEIGHT)]
        c20_mpa: f64,
        /// Weight of the cube, MPa.
        #[field(default = 0.0, within = WEIGHT)]
        c30_mpa: f64,
    },
    /// W = sum of (2 mu / alpha^2) (l1^alpha + l2^alpha + l3^alpha - 3).
    Ogden {
        /// Terms; their mu add up to the initial shear modulus.
        #[field(default = usual_terms(), with = terms)]
        terms: Vec<OgdenTerm>,
    },
}

/// A term of Ogden's law.
#[derive(Debug, Clone, Copy, PartialEq, Table)]
#[table(rule = check_exponent(alpha))]
pub struct OgdenTerm {
    /// Share of the initial shear modulus, MPa.
    #[field(required = "a number", within = WEIGHT)]
    pub mu_mpa: f64,
    /// Exponent.
    #[field(required = "a number", within = EXPONENT)]
    pub alpha: f64,
}

impl Default for Material {
    /// The paper's rubber.
    fn default() -> Self {
        Self {
            law: Law::usual(),
            d1_per_mpa: 0.0,
        }
    }
}

impl Field for Material {
    type Within = ();

    fn read(value: &Value, at: &str, (): &(), faults: &mut Vec<Fault>) -> Option<Self> {
        let law = match value.get(Law::TAG) {
            None => Law::usual(),
            Some(model) => match model.as_str().and_then(Law::of_name) {
                Some(law) => law,
                None => return unknown_model(model, at, faults),
            },
        };
        let fields = open(value, at, &law, faults)?;
        let law = law.read_own(&fields, faults);
        let d1 = fields.number(D1, COMPRESSIBILITY, Self::default().d1_per_mpa, faults);
        Some(Self {
            law: law?,
            d1_per_mpa: d1?,
        })
    }

    fn write(&self) -> Option<Value> {
        let mut table = Map::new();
        write_variant(&self.law, &mut table);
        table.insert(D1.to_owned(), self.d1_per_mpa.into());
        Some(Value::Object(table))
    }

    fn schema((): &(), schemas: &mut Schemas) -> Value {
        schemas.define("Material", |schemas| {
            let mut properties = Properties::default();
            describe_variants(&Law::usual(), &mut properties, schemas);
            let doc =
                "Compressibility, 1/MPa: the bulk modulus is 2/d1; 0 is exactly incompressible.";
            properties.add(D1, doc, COMPRESSIBILITY.schema(), Some(0.0.into()), false);
            properties.table("Rubber: an isochoric law and its compressibility.")
        })
    }
}

/// Opens the table; a parameter of another law gets a fault that says so.
fn open<'v>(value: &'v Value, at: &str, law: &Law, faults: &mut Vec<Fault>) -> Option<Fields<'v>> {
    let own = [&[Law::TAG], law.own_names(), &[D1]].concat();
    let laws = Law::all();
    let is_foreign = |name: &&str| {
        !own.contains(name) && laws.iter().any(|other| other.own_names().contains(name))
    };
    let names = value.as_object().into_iter().flat_map(|table| table.keys());
    let foreign: Vec<&str> = names.map(String::as_str).filter(is_foreign).collect();
    let fields = Fields::open(value, at, &[own.as_slice(), &foreign].concat(), faults)?;
    for name in foreign {
        let detail = format!(
            "is no parameter of model \"{}\", which has {}",
            law.name(),
            law.own_names().join(", ")
        );
        Fault::add(faults, &fields.at(name), detail);
    }
    Some(fields)
}

/// Tells of an unknown law: nobody knows then which fields are right, so there is one fault, whatever the others are.
fn unknown_model(model: &Value, at: &str, faults: &mut Vec<Fault>) -> Option<Material> {
    let detail = format!(
        "must be {}; it is {}",
        alternatives(Law::all().iter().map(Law::name)),
        shown(model)
    );
    Fault::add(faults, &member(at, Law::TAG), detail);
    None
}

/// Ogden's form of the paper's rubber.
fn usual_terms() -> Vec<OgdenTerm> {
    let term = |mu_mpa, alpha| OgdenTerm { mu_mpa, alpha };
    vec![term(0.288, 2.0), term(0.072, -2.0)]
}

/// Terms whose shear modulus is above zero.
mod terms {
    use document::typed::lists::Entries;

    use super::*;

    const WITHIN: Entries<()> = Entries::of(1, MOST_TERMS, "terms { mu_mpa, alpha }", ());

    pub fn read(value: &Value, at: &str, faults: &mut Vec<Fault>) -> Option<Vec<OgdenTerm>> {
        let terms = Vec::read(value, at, &WITHIN, faults)?;
        let modulus: f64 = terms.iter().map(|term: &OgdenTerm| term.mu_mpa).sum();
        if modulus < MODULUS.low {
            let detail = format!(
                "the rubber is unstable: its initial shear modulus, the sum of mu_mpa, must be at least {} MPa; it is {}",
                plain(MODULUS.low),
                plain(modulus)
            );
            Fault::add(faults, at, detail);
        }
        Some(terms)
    }

    pub fn write(terms: &Vec<OgdenTerm>) -> Option<Value> {
        terms.write()
    }

    pub fn schema(schemas: &mut Schemas) -> Value {
        Vec::<OgdenTerm>::schema(&WITHIN, schemas)
    }
}

fn check_exponent(alpha: &f64, fields: &Fields<'_>, faults: &mut Vec<Fault>) {
    if alpha.abs() < SMALLEST_EXPONENT {
        let detail = format!(
            "must be at least {SMALLEST_EXPONENT} away from 0; it is {}",
            plain(*alpha)
        );
        Fault::add(faults, &fields.at("alpha"), detail);
    }
}

impl Law {
    /// The name for people.
    pub fn title(&self) -> &'static str {
        match self {
            Self::NeoHookean { .. } => "neo-Hookean",
            Self::MooneyRivlin { .. } => "Mooney-Rivlin",
            Self::Yeoh { .. } => "Yeoh",
            Self::Ogden { .. } => "Ogden",
        }
    }

    /// Shear modulus in the reference state, MPa.
    pub fn shear_modulus_mpa(&self) -> f64 {
        match self {
            Self::NeoHookean { c10_mpa } | Self::Yeoh { c10_mpa, .. } => 2.0 * c10_mpa,
            Self::MooneyRivlin { c10_mpa, c01_mpa } => 2.0 * (c10_mpa + c01_mpa),
            Self::Ogden { terms } => terms.iter().map(|term| term.mu_mpa).sum(),
        }
    }
}
