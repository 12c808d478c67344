//! Likelihood of readings, whatever the layout. Where noise is the same everywhere, ln p is a sum of products of a function of the depth and one of the angle.
//!
//! A variance that goes by the signal or its slope falls to the floor wherever these pass through zero, in a tenth of a degree: no sum of smooth products follows that, and ln p is
//! worked out at each point.

use std::sync::OnceLock;

use documents::layouts::contact_laws::ContactQuantity;

use crate::field::film_field::{DepthFields, KindField, LoadField, Noise};
use crate::field::response_surface::Drawn;
use crate::field::separated::Separated;
use crate::simulate::lanes::LANES;
use crate::simulate::posterior_grid::{DEPTH_CELLS, MOST_PARTS, middles};

/// Share of the largest field that separation may leave out: of a signal 100 times the noise it changes ln p by some hundredths.
const TOLERANCE: f64 = 3e-6;

/// The likelihood of readings of some kinds of film, whatever their layout.
pub struct Likelihood {
    fields: DepthFields,
    /// Likelihoods of contacts that differ in less; made where they are asked for.
    alone: OnceLock<Vec<Alone>>,
    noise: Noise,
    /// Middles of the finest parts of the depth cells, mm.
    pub(super) depths_mm: Vec<f64>,
    pub(super) prepared: Prepared,
}

/// Parts that the densities of all layouts are made of.
pub(super) enum Prepared {
    /// Products, where noise is the same everywhere and contacts don't differ.
    Separated(Products),
    /// Fields at the finest parts of depths, made where they are asked for.
    AtPoints(Vec<OnceLock<LoadField>>),
}

/// Parts of ln p as sums of products.
pub(super) struct Products {
    /// Factors of the products.
    pub coefficients: Coefficients,
    pub parts: Parts,
}

/// Likelihood of contacts of which one quantity alone is drawn, or none.
pub(crate) type Alone = (Drawn, Option<ContactQuantity>, Likelihood);

/// Factors of the products by part of a depth, those of readings first. Each row ends with zeros, up to a multiple of [`LANES`].
pub(super) struct Coefficients {
    rank: usize,
    values: Vec<f64>,
}

impl Coefficients {
    /// Length of a row.
    pub(super) fn row_len(&self) -> usize {
        self.rank.next_multiple_of(LANES)
    }

    /// The row of a part of a depth, with its zeros.
    pub fn row(&self, depth: usize) -> &[f64] {
        &self.values[depth * self.row_len()..][..self.row_len()]
    }

    /// The factors at a part of a depth.
    pub fn at(&self, depth: usize) -> &[f64] {
        &self.row(depth)[..self.rank]
    }
}

/// The two parts of ln p as separated fields.
pub(super) struct Parts {
    pub linear: Separated,
    pub constant: Separated,
}

impl Likelihood {
    /// Prepares films of these fields; depths are flat between the ends of the solved ones.
    pub fn new(fields: DepthFields, noise: Noise) -> Self {
        let depths_mm = middles(fields.depths.ends(), DEPTH_CELLS * MOST_PARTS);
        let prepared = if noise.is_plain() && fields.spread.is_none() {
            let parts = separate(&fields, &depths_mm, noise.floor);
            Prepared::Separated(Products {
                coefficients: joined(&parts),
                parts,
            })
        } else {
            Prepared::AtPoints(depths_mm.iter().map(|_| OnceLock::new()).collect())
        };
        Self {
            fields,
            noise,
            alone: OnceLock::new(),
            prepared,
            depths_mm,
        }
    }

    /// Likelihoods of contacts that differ in nothing, and in each quantity alone; none where contacts don't differ.
    pub(crate) fn alone(&self) -> &[Alone] {
        self.alone.get_or_init(|| {
            let Some(surface) = &self.fields.contacts else {
                return Vec::new();
            };
            let quantities = surface.laws().iter().map(|law| Some(law.quantity));
            let only = quantities
                .enumerate()
                .map(|(law, own)| (Drawn::Only(law), own));
            let of = |(drawn, own): (Drawn, Option<ContactQuantity>)| {
                let together = self.fields.together.is_some();
                let fields = DepthFields::over_contacts(surface.clone(), drawn, together);
                (drawn, own, Self::new(fields, self.noise))
            };
            std::iter::once((Drawn::Nothing, None))
                .chain(only)
                .map(of)
                .collect()
        })
    }

    /// The fields.
    pub fn fields(&self) -> &DepthFields {
        &self.fields
    }

    /// The fields at a depth, mm.
    pub fn field(&self, depth_mm: f64) -> LoadField {
        self.fields.at(depth_mm)
    }

    /// Vertical force that is believed at a depth, N: its mean over contacts.
    pub(super) fn force_n(&self, depth_mm: f64) -> f64 {
        self.fields.force_n(depth_mm)
    }

    /// Errors of readings.
    pub fn noise(&self) -> &Noise {
        &self.noise
    }
}

/// h / S and h^2 / S of every kind at every depth, with S the square of the noise.
fn separate(fields: &DepthFields, depths_mm: &[f64], noise: f64) -> Parts {
    let loads: Vec<LoadField> = depths_mm.iter().map(|depth| fields.at(*depth)).collect();
    let over = |part: &dyn Fn(f64) -> f64| -> Separated {
        let kind = |kind: &KindField| -> Vec<f64> {
            let signals = kind.signal.samples().iter();
            signals.map(|signal| part(*signal)).collect()
        };
        let fields: Vec<Vec<Vec<f64>>> = loads
            .iter()
            .map(|load| load.kinds.iter().map(kind).collect())
            .collect();
        Separated::of(&fields, TOLERANCE)
    };
    Parts {
        linear: over(&|signal| signal / (noise * noise)),
        constant: over(&|signal| (signal / noise) * (signal / noise)),
    }
}

/// The factors of all products by depth.
fn joined(parts: &Parts) -> Coefficients {
    let rank = parts.linear.rank() + parts.constant.rank();
    let all = |depth: usize| {
        let linear = parts.linear.coefficients[depth].iter();
        let factors = linear.chain(&parts.constant.coefficients[depth]);
        let zeros = rank.next_multiple_of(LANES) - rank;
        factors.copied().chain(std::iter::repeat_n(0.0, zeros))
    };
    let depths = 0..parts.linear.coefficients.len();
    Coefficients {
        rank,
        values: depths.flat_map(all).collect(),
    }
}
