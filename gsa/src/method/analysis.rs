//! Analysis of one output: sensitivity indices, their errors, and what stands behind them.
//!
//! Numbers that do not exist are `None`, with the reason beside them; nothing here is ever NaN or infinite.

use ndarray::ArrayView2;

use crate::form::composite::Decomposed;
pub(crate) use crate::form::composite::MOST_FOR_PAIRS;
use crate::form::scale::times_power_of_two;
use crate::form::section::Sections;
use crate::judge::index_error::{ByInput, ErrorParts};
use crate::judge::misses::Misses;
pub use crate::method::verdict::Form;

/// End of an output's analysis.
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
    /// States, all of them.
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
    /// `MOST_FOR_PAIRS` inputs, and only by methods that have it.
    pub second_order: Option<Vec<f64>>,
    /// The form behind the numbers above; `Mdrm`, as asked for, where there are none.
    pub method: Form,
    /// End of the analysis.
    pub status: Status,
    /// Reason why a number is missing or a form was given up, and what else a reader should know. Inputs are counted from 1, points from 0 as in the design.
    pub reason: Option<String>,
    /// S_i of the product form wherever it exists, chosen or not.
    pub mdrm_first_order: Option<Vec<f64>>,
    /// S_Ti of the product form wherever it exists, chosen or not.
    pub mdrm_total: Option<Vec<f64>>,
    /// Errors of `first_order`.
    pub error: ErrorParts,
    /// Misses of the form at the check points, by which two models' indices are compared; `None` without check points, and where another form than
    /// M-DRM's, the sum or the shifted product gave the indices.
    pub misses: Option<Misses>,
}

/// Answers for every column of `values`, one output after the other, each contiguous.
pub(crate) fn each_output(
    values: &ArrayView2<f64>,
    answer: impl Fn(&[f64]) -> Analysis,
) -> Vec<Analysis> {
    let by_output = values.t().as_standard_layout().into_owned();
    let outputs = by_output.rows().into_iter();
    outputs
        .map(|values| answer(values.as_slice().expect("standard layout")))
        .collect()
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

    /// Takes over what another method says of the output on its sections.
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

    /// Makes the analysis of an output whose variation is none of the model's own, for this reason; the mean remains.
    #[must_use]
    pub fn into_constant(self, reason: &str) -> Self {
        Self {
            mean: self.mean,
            variance: Some(0.0),
            status: Status::Constant,
            reason: Some(reason.to_owned()),
            ..Self::empty(1.0)
        }
    }

    pub(crate) fn note(&mut self, text: &str) {
        self.reason = Some(match self.reason.take() {
            Some(reason) => format!("{reason}; {text}"),
            None => text.to_owned(),
        });
    }

    /// Notes the inputs whose cut lines show nothing of what they may do: flat ones where no check point looks elsewhere, and those that are nothing
    /// beside what the check points show.
    pub(crate) fn note_hidden(&mut self, sections: &Sections) {
        let (hidden, unseen) = match (&self.misses, &self.first_order) {
            _ if sections.inputs() == 1 => return,
            (Some(misses), Some(first_order)) => (
                misses.hidden(first_order),
                "the share that this has in what is missed off the lines",
            ),
            _ => (
                sections.flat(),
                "what happens off the lines, and there is no check point",
            ),
        };
        let names: Vec<String> = hidden.iter().map(|i| (i + 1).to_string()).collect();
        let which = match &names[..] {
            [] => return,
            [input] => format!("line of input {input}"),
            inputs => format!("lines of inputs {}", inputs.join(", ")),
        };
        self.note(&format!(
            "the output hardly changes along the cut {which}, so that the cut tells nothing of {unseen}; the method auto does"
        ));
    }

    /// Notes which points have no finite value, and what that led to.
    pub(crate) fn note_lost(&mut self, text: &str, ordinals: &[usize]) {
        if !ordinals.is_empty() {
            let names: Vec<String> = ordinals.iter().map(usize::to_string).collect();
            self.note(&format!("{text}: {}", names.join(", ")));
        }
    }

    /// A method that doesn't rest on the product form isn't broken with it.
    pub(crate) fn without_verdict(self) -> Self {
        match self.status {
            Status::ProductFormBroken if self.first_order.is_some() => Self {
                status: Status::Ok,
                ..self
            },
            _ => self,
        }
    }

    /// A single input has all of the variance, whatever a method's sums say.
    pub(crate) fn of_one_input(self) -> Self {
        if self.first_order.as_ref().is_none_or(|s| s.len() > 1) {
            return self;
        }
        let none = Some(vec![0.0]);
        let parts = ByInput {
            quadrature: self.error.quadrature.and(none.clone()),
            decomposition: self.error.decomposition.and(none.clone()),
            sampling: self.error.sampling.and(none),
            ..ByInput::default()
        };
        Self {
            first_order: Some(vec![1.0]),
            total: Some(vec![1.0]),
            error: ErrorParts::new(parts, self.error.floor),
            ..self
        }
    }
}

/// (mean, variance) back from the units of the sections; `None` where double precision has no such number.
pub(crate) fn in_output_units(
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
