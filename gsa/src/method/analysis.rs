//! From the values at a design's points to sensitivity indices, with their errors and what stands behind them.
//!
//! Numbers that do not exist are `None`, with the reason beside them; nothing here is ever NaN or infinite.

use ndarray::ArrayView2;

use crate::design::Design;
use crate::form::additive;
use crate::form::composite::Decomposed;
pub use crate::form::composite::MOST_FOR_PAIRS;
use crate::form::evidence::Evidence;
use crate::form::mdrm::Mdrm;
use crate::form::scale::times_power_of_two;
use crate::form::section::Sections;
use crate::judge::index_error::{self, ByInput, ErrorParts};
use crate::judge::misses::{Effects, Misses};
pub use crate::method::verdict::Form;
use crate::method::verdict::Verdict;

/// How an output's analysis ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Status {
    /// The product form gave the indices.
    Ok,
    /// The output does not vary beyond its rounding: it has no indices.
    Constant,
    /// The product form does not exist or does not hold; another form gave the indices.
    ProductFormBroken,
    /// The cut point, or too many nodes of a line, gave no number: there are no indices.
    Unusable,
}

impl Status {
    /// All of them.
    pub const ALL: [Self; 4] = [
        Self::Ok,
        Self::Constant,
        Self::ProductFormBroken,
        Self::Unusable,
    ];

    /// `ok`, `constant`, `product-form-broken` or `unusable`.
    pub fn as_str(self) -> &'static str {
        match self {
            Self::Ok => "ok",
            Self::Constant => "constant",
            Self::ProductFormBroken => "product-form-broken",
            Self::Unusable => "unusable",
        }
    }
}

/// The sensitivity of one output.
#[derive(Debug, Clone, PartialEq)]
pub struct Analysis {
    /// E\[Y\] in the output's units, by the chosen form.
    pub mean: Option<f64>,
    /// Var\[Y\] in the output's units squared, by the chosen form.
    pub variance: Option<f64>,
    /// S_i = Var\[E\[Y|X_i\]\]/Var\[Y\], per input.
    pub first_order: Option<Vec<f64>>,
    /// S_Ti = 1 - Var\[E\[Y|all but X_i\]\]/Var\[Y\], per input.
    pub total: Option<Vec<f64>>,
    /// S_ij, the share of each pair of inputs alone, pairs in the order 12, 13, .., 23, ..; for up to
    /// [`MOST_FOR_PAIRS`] inputs, and only by methods that have it.
    pub second_order: Option<Vec<f64>>,
    /// The form behind the numbers above; `Mdrm`, as asked for, where there are none.
    pub method: Form,
    /// How the analysis ended.
    pub status: Status,
    /// Why a number is missing or a form was given up, and what else a reader should know. Inputs are counted from 1,
    /// points from 0 as in the design.
    pub reason: Option<String>,
    /// S_i of the product form wherever it exists, chosen or not.
    pub mdrm_first_order: Option<Vec<f64>>,
    /// S_Ti of the product form wherever it exists, chosen or not.
    pub mdrm_total: Option<Vec<f64>>,
    /// Errors of `first_order`.
    pub error: ErrorParts,
    /// What the form misses at the check points, by which two models' indices are compared; `None` without check points, and where
    /// another form than M-DRM's, the sum or the shifted product gave the indices.
    pub misses: Option<Misses>,
}

/// Analyses every output: `values` has a row per point of the design, in its order, and a column per output. A run
/// that failed is a row of NaN: on a cut line the section is refitted from its other nodes, at a check point it is left
/// out.
///
/// # Panics
/// If the number of rows is not the number of points.
pub fn analyse(design: &Design, values: &ArrayView2<f64>) -> Vec<Analysis> {
    let (rows, points) = (values.nrows(), design.points().len());
    assert!(
        rows == points,
        "{rows} rows of values for the {points} points of the design"
    );
    let pair_weight = design.weight_of_interactions(2);
    // One output after the other, each contiguous.
    let by_output = values.t().as_standard_layout().into_owned();
    by_output
        .rows()
        .into_iter()
        .map(|values| {
            let values = values.as_slice().expect("standard layout");
            analyse_output(design, values, pair_weight)
        })
        .collect()
}

/// One output on lines and check points.
pub(crate) fn analyse_output(design: &Design, values: &[f64], pair_weight: f64) -> Analysis {
    let sections = match Sections::new(design, values) {
        Ok(sections) => sections,
        Err(ordinal) => return unusable(ordinal),
    };
    let mdrm = Mdrm::new(&sections);
    let evidence = Evidence::new(design, values, &sections, mdrm.as_ref().ok());
    let mut analysis = if sections.varies() {
        let verdict = Verdict::new(&sections, &mdrm, evidence.as_ref());
        let forms = Forms {
            mdrm: mdrm.ok(),
            evidence,
            pair_weight,
        };
        forms.with_indices(&sections, verdict)
    } else {
        without_spread(&sections, evidence.as_ref())
    };
    note_missing(&mut analysis, design, values, &sections);
    analysis
}

fn unusable(ordinal: usize) -> Analysis {
    Analysis {
        status: Status::Unusable,
        reason: Some(format!(
            "the value at point {ordinal} is not a finite number"
        )),
        ..Analysis::empty(1.0)
    }
}

/// Nothing happens on the lines. That is a constant, unless a check point shows an interaction that vanishes on them.
fn without_spread(sections: &Sections, evidence: Option<&Evidence<'_>>) -> Analysis {
    let (mean, _) = in_output_units(sections, additive::moments(sections));
    if (0..sections.inputs()).all(|input| sections.differences(input).len() == 1) {
        return Analysis {
            reason: Some("a single node of each input shows no variation".to_owned()),
            ..Analysis::empty(1.0)
        };
    }
    match evidence {
        Some(evidence) if evidence.departure > sections.noise() => Analysis {
            status: Status::ProductFormBroken,
            method: Form::Additive,
            reason: Some(
                "the output varies at the check points but not along any cut line: \
                 only interactions that vanish at the cut point are there"
                    .to_owned(),
            ),
            ..Analysis::empty(sections.floor())
        },
        _ => Analysis {
            mean,
            variance: Some(0.0),
            status: Status::Constant,
            reason: Some("the output does not vary beyond the rounding of its values".to_owned()),
            ..Analysis::empty(sections.floor())
        },
    }
}

/// What the forms need beside the sections.
struct Forms<'a> {
    mdrm: Option<Mdrm>,
    evidence: Option<Evidence<'a>>,
    pair_weight: f64,
}

impl Forms<'_> {
    /// The product that was chosen; `None` for the sum.
    fn chosen(&self, form: Form) -> Option<&Mdrm> {
        let shifted = || self.evidence.as_ref()?.shifted.as_ref();
        match form {
            Form::Mdrm => self.mdrm.as_ref(),
            Form::Shifted => shifted().map(|(product, _)| product),
            _ => None,
        }
    }

    fn with_indices(self, sections: &Sections, verdict: Verdict) -> Analysis {
        let chosen = self.chosen(verdict.form);
        let (first_order, total, moments) = match chosen {
            Some(product) => (
                product.first_order(),
                product.total(),
                product.moments(sections),
            ),
            None => {
                let shares = additive::first_order(&sections.variances);
                (shares.clone(), shares, additive::moments(sections))
            }
        };
        let misses = self.misses(sections, verdict.form, &first_order, moments);
        let errors = ByInput {
            quadrature: index_error::quadrature(sections.missing.as_deref(), &first_order, &total),
            // A single section is the output itself.
            decomposition: match sections.inputs() {
                1 => Some(vec![0.0]),
                _ => misses.as_ref().map(Misses::errors),
            },
            sampling: None,
            missing: index_error::missing(sections.missing.as_deref(), &total),
            missing_of_interactions: Vec::new(),
        };
        let second_order = (sections.inputs() <= MOST_FOR_PAIRS).then(|| match chosen {
            Some(product) => product.second_order(&first_order),
            None => vec![0.0; first_order.len() * (first_order.len() - 1) / 2],
        });
        let (mean, variance) = in_output_units(sections, moments);
        let mut analysis = Analysis {
            mean,
            variance,
            first_order: Some(first_order),
            total: Some(total),
            second_order,
            method: verdict.form,
            status: match verdict.form {
                Form::Mdrm => Status::Ok,
                _ => Status::ProductFormBroken,
            },
            reason: verdict.reason,
            mdrm_first_order: self.mdrm.as_ref().map(Mdrm::first_order),
            mdrm_total: self.mdrm.as_ref().map(Mdrm::total),
            error: ErrorParts::new(errors, sections.floor()),
            misses,
        };
        if mean.is_none() || variance.is_none() {
            analysis.note("the mean or the variance is beyond the range of double precision");
        }
        analysis
    }

    fn misses(
        &self,
        sections: &Sections,
        form: Form,
        first_order: &[f64],
        (mean, variance): (f64, f64),
    ) -> Option<Misses> {
        let checks = &self.evidence.as_ref()?.checks;
        let chosen = self.chosen(form);
        let predictions: Vec<f64> = checks
            .iter()
            .map(|(check, _)| match chosen {
                Some(product) => product.predict(sections, check),
                None => additive::predict(sections, check),
            })
            .collect();
        // g_i over the standard deviation of the output is d_i - dbar_i times sqrt(S_i/v_i), and a sign.
        let signs = chosen.map(|product| product.main_effect_signs(sections));
        let scale: Vec<f64> = (0..first_order.len())
            .map(|i| {
                let sign = signs.as_ref().map_or(1.0, |signs| signs[i]);
                let variance = sections.variances[i];
                if variance > 0.0 {
                    sign * (first_order[i] / variance).sqrt()
                } else {
                    0.0
                }
            })
            .collect();
        let main = |input: usize, k: usize| {
            let d = sections.difference_at(input, checks[k].0.nodes()[input]);
            scale[input] * (d - sections.shifts[input])
        };
        let effects = Effects {
            first_order,
            mean,
            variance,
            main: &main,
        };
        let fitted = usize::from(form == Form::Shifted);
        let values: Vec<f64> = checks.iter().map(|(_, h)| *h).collect();
        let nodes = checks.iter().flat_map(|(check, _)| check.nodes()).copied();
        Some(Misses::new(
            nodes.collect(),
            (&values, &predictions),
            &effects,
            self.pair_weight,
            fitted,
        ))
    }
}

/// (mean, variance) back from the units of the sections; `None` where double precision has no such number.
fn in_output_units(
    sections: &Sections,
    (mean, variance): (f64, f64),
) -> (Option<f64>, Option<f64>) {
    let mean = times_power_of_two(mean, sections.exponent);
    let variance = times_power_of_two(variance, 2 * sections.exponent);
    (
        mean.is_finite().then_some(mean),
        (variance.is_finite() && variance > 0.0).then_some(variance),
    )
}

fn note_missing(analysis: &mut Analysis, design: &Design, values: &[f64], sections: &Sections) {
    let listed = |ordinals: &[usize]| {
        let names: Vec<String> = ordinals.iter().map(usize::to_string).collect();
        names.join(", ")
    };
    if !sections.lost.is_empty() {
        analysis.note(&format!(
            "points without a finite value, taken from the other nodes of their lines: {}",
            listed(&sections.lost)
        ));
    }
    let checks = design.checks().iter().map(|check| check.ordinal());
    let missing: Vec<usize> = checks
        .chain(design.probes().iter().copied())
        .filter(|&ordinal| !values[ordinal].is_finite())
        .collect();
    if !missing.is_empty() {
        analysis.note(&format!(
            "left out check points without a finite value: {}",
            listed(&missing)
        ));
    }
}

impl Analysis {
    pub(crate) fn empty(floor: f64) -> Self {
        Self {
            mean: None,
            variance: None,
            first_order: None,
            total: None,
            second_order: None,
            method: Form::Mdrm,
            status: Status::Unusable,
            reason: None,
            mdrm_first_order: None,
            mdrm_total: None,
            error: ErrorParts::without_indices(floor),
            misses: None,
        }
    }

    /// The same output by another method on its sections.
    pub(crate) fn with(
        self,
        sections: &Sections,
        found: Decomposed,
        method: Form,
        errors: ByInput,
    ) -> Self {
        let (mean, variance) = in_output_units(sections, (found.mean, found.variance));
        Self {
            mean,
            variance,
            error: ErrorParts::new(errors, sections.floor_for(found.variance.sqrt())),
            first_order: Some(found.first_order),
            total: Some(found.total),
            second_order: found.second_order,
            method,
            status: Status::ProductFormBroken,
            misses: None,
            ..self
        }
    }

    pub(crate) fn note(&mut self, text: &str) {
        self.reason = Some(match self.reason.take() {
            Some(reason) => format!("{reason}; {text}"),
            None => text.to_owned(),
        });
    }
}
