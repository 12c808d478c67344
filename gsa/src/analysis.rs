//! From the values at a design's points to sensitivity indices, with their errors and what stands behind them.
//!
//! Numbers that do not exist are `None`, with the reason beside them; nothing here is ever NaN or infinite.

use ndarray::ArrayView2;

use crate::additive;
use crate::design::{Design, Line};
use crate::error::{self, ErrorParts};
use crate::evidence::Evidence;
use crate::mdrm::Mdrm;
use crate::scale::times_power_of_two;
use crate::section::Sections;
pub use crate::verdict::Form;
use crate::verdict::Verdict;

/// How an output's analysis ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Status {
    /// The product form gave the indices.
    Ok,
    /// The output does not vary beyond its rounding: it has no indices.
    Constant,
    /// The product form does not exist or does not hold; the additive form gave the indices.
    ProductFormBroken,
    /// A run on the cut lines gave no number: there are no indices.
    Unusable,
}

impl Status {
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
}

/// Analyses every output: `values` has a row per point of the design, in its order, and a column per output. A run
/// that failed is a row of NaN: on a cut line it makes the output unusable, at a check point it is left out.
///
/// # Panics
/// If the number of rows is not the number of points.
pub fn analyse(design: &Design, values: &ArrayView2<f64>) -> Vec<Analysis> {
    let (rows, points) = (values.nrows(), design.points().len());
    assert!(
        rows == points,
        "{rows} rows of values for the {points} points of the design"
    );
    values
        .columns()
        .into_iter()
        .map(|column| analyse_output(design, &column.to_vec()))
        .collect()
}

fn analyse_output(design: &Design, values: &[f64]) -> Analysis {
    let mut on_lines = [0]
        .iter()
        .chain(design.lines().iter().flat_map(Line::ordinals));
    if let Some(ordinal) = on_lines.find(|&&k| !values[k].is_finite()) {
        return unusable(*ordinal);
    }
    let sections = Sections::new(design, values);
    let mdrm = Mdrm::new(&sections);
    let evidence = Evidence::new(design, values, &sections, mdrm.as_ref().ok());
    let mut analysis = if sections.varies() {
        let verdict = Verdict::new(&sections, &mdrm, evidence.as_ref());
        with_indices(&sections, mdrm.ok().as_ref(), evidence.as_ref(), verdict)
    } else {
        without_spread(&sections, evidence.as_ref())
    };
    note_missing_checks(&mut analysis, design, values);
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
fn without_spread(sections: &Sections, evidence: Option<&Evidence>) -> Analysis {
    let (mean, _) = in_output_units(sections, additive::moments(sections));
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

fn with_indices(
    sections: &Sections,
    mdrm: Option<&Mdrm>,
    evidence: Option<&Evidence>,
    verdict: Verdict,
) -> Analysis {
    let product = mdrm.map(|mdrm| mdrm.moments(sections));
    let product_variance = product.map(|(_, variance)| variance);
    let mdrm_first_order = mdrm.map(Mdrm::first_order);
    let mdrm_total = mdrm.map(Mdrm::total);
    let chosen = mdrm.filter(|_| verdict.form == Form::Mdrm);
    let quadrature = error::quadrature(sections, |variances| match chosen {
        Some(mdrm) => mdrm.first_order_with(variances),
        None => additive::first_order(variances),
    });
    let misfit = |evidence: &Evidence| match chosen {
        Some(_) => evidence.product,
        None => evidence.additive,
    };
    let decomposition = error::decomposition(sections, evidence, misfit, product_variance);
    let moments = product
        .filter(|_| chosen.is_some())
        .unwrap_or_else(|| additive::moments(sections));
    let (mean, variance) = in_output_units(sections, moments);
    let additive_indices = || Some(additive::first_order(&sections.variances));
    let mut analysis = Analysis {
        mean,
        variance,
        first_order: chosen.map_or_else(additive_indices, |_| mdrm_first_order.clone()),
        total: chosen.map_or_else(additive_indices, |_| mdrm_total.clone()),
        method: verdict.form,
        status: match verdict.form {
            Form::Mdrm => Status::Ok,
            Form::Additive => Status::ProductFormBroken,
        },
        reason: verdict.reason,
        mdrm_first_order,
        mdrm_total,
        error: ErrorParts::new(quadrature, decomposition, sections.floor()),
    };
    if mean.is_none() || variance.is_none() {
        analysis.note("the mean or the variance is beyond the range of double precision");
    }
    analysis
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

fn note_missing_checks(analysis: &mut Analysis, design: &Design, values: &[f64]) {
    let missing: Vec<String> = design
        .checks()
        .iter()
        .filter(|check| !values[check.ordinal()].is_finite())
        .map(|check| check.ordinal().to_string())
        .collect();
    if !missing.is_empty() {
        let points = missing.join(", ");
        analysis.note(&format!(
            "left out check points without a finite value: {points}"
        ));
    }
}

impl Analysis {
    fn empty(floor: f64) -> Self {
        Self {
            mean: None,
            variance: None,
            first_order: None,
            total: None,
            method: Form::Mdrm,
            status: Status::Unusable,
            reason: None,
            mdrm_first_order: None,
            mdrm_total: None,
            error: ErrorParts::without_indices(floor),
        }
    }

    fn note(&mut self, text: &str) {
        self.reason = Some(match self.reason.take() {
            Some(reason) => format!("{reason}; {text}"),
            None => text.to_owned(),
        });
    }
}
