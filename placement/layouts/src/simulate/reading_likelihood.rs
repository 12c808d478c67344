//! Likelihood of readings, whatever the layout. Where each film scatters on its own, ln p is a sum of products of a function of the depth and one of the angle.

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
    pub(super) scatter: KnownScatter,
}

/// KnownScatter over contacts, as an estimate knows it.
pub(super) enum KnownScatter {
    /// Each film's for its own.
    Each(Products),
    /// Fields at the finest parts of depths with what all films scatter in together, made where they are asked for.
    Together(Vec<OnceLock<LoadField>>),
}

/// Parts of ln p as sums of products.
pub(super) struct Products {
    /// Factors of the products.
    pub coefficients: Coefficients,
    pub parts: Parts,
}

/// Likelihood of contacts of which one quantity alone is drawn, or none.
pub(crate) type Alone = (Drawn, Option<ContactQuantity>, Likelihood);

/// Factors of the products by part of a depth, those of readings first, then those of squared readings. Each row ends with zeros, up to a multiple of [`LANES`].
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

/// The three parts of ln p as separated fields; that of squared readings is left out where the noise is the same everywhere.
pub(super) struct Parts {
    pub linear: Separated,
    pub quadratic: Option<Separated>,
    pub constant: Separated,
}

impl Likelihood {
    /// Prepares films of these fields; depths are flat between the ends of the solved ones.
    pub fn new(fields: DepthFields, noise: Noise) -> Self {
        let depths_mm = middles(fields.depths.ends(), DEPTH_CELLS * MOST_PARTS);
        let scatter = match fields.together {
            Some(_) => KnownScatter::Together(depths_mm.iter().map(|_| OnceLock::new()).collect()),
            None => {
                let parts = separate(&fields, &depths_mm, &noise);
                KnownScatter::Each(Products {
                    coefficients: joined(&parts),
                    parts,
                })
            }
        };
        Self {
            fields,
            noise,
            alone: OnceLock::new(),
            scatter,
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

/// 1 / S, h / S and h^2 / S + ln S of every kind at every depth.
fn separate(fields: &DepthFields, depths_mm: &[f64], noise: &Noise) -> Parts {
    let loads: Vec<LoadField> = depths_mm.iter().map(|depth| fields.at(*depth)).collect();
    let over = |part: &dyn Fn(f64, f64) -> f64| -> Separated {
        let kind = |kind: &KindField| -> Vec<f64> {
            let angles = (-180..180).map(f64::from).zip(kind.signal.samples());
            angles
                .map(|(u, signal)| {
                    let own = noise.variance(*signal, kind.signal.slope(u));
                    part(*signal, own + kind.scatter(u))
                })
                .collect()
        };
        let fields: Vec<Vec<Vec<f64>>> = loads
            .iter()
            .map(|load| load.kinds.iter().map(kind).collect())
            .collect();
        Separated::of(&fields, TOLERANCE)
    };
    Parts {
        linear: over(&|signal, variance| signal / variance),
        quadratic: (!noise.is_plain() || fields.spread.is_some())
            .then(|| over(&|_, variance| 1.0 / variance)),
        constant: over(&|signal, variance| {
            signal * signal / variance + (variance / (noise.floor * noise.floor)).ln()
        }),
    }
}

/// The factors of all products by depth.
fn joined(parts: &Parts) -> Coefficients {
    let of = |field: &Separated| field.rank();
    let rank = of(&parts.linear) + parts.quadratic.as_ref().map_or(0, of) + of(&parts.constant);
    let all = |depth: usize| {
        let quadratic = parts
            .quadratic
            .iter()
            .flat_map(move |field| &field.coefficients[depth]);
        let linear = parts.linear.coefficients[depth].iter();
        let factors = linear
            .chain(quadratic)
            .chain(&parts.constant.coefficients[depth]);
        let zeros = rank.next_multiple_of(LANES) - rank;
        factors.copied().chain(std::iter::repeat_n(0.0, zeros))
    };
    let depths = 0..parts.linear.coefficients.len();
    Coefficients {
        rank,
        values: depths.flat_map(all).collect(),
    }
}
