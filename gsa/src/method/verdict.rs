//! Verdict on the forms: which of them speaks for an output, and why.
//!
//! The product form is broken where it does not exist, where the check points refute it, and, if there are no check
//! points, where the lines raise a doubt. A doubt alone never outweighs a check: a product with a factor that changes
//! sign is exact.

use std::fmt;

use crate::form::evidence::Evidence;
use crate::form::mdrm::{Mdrm, Undefined};
use crate::form::section::Sections;

/// Equation (1) of M-DRM divides n - 1 times by h0. Where that is a hundredth of the spread, a remainder of one percent
/// that is no product comes out as large as the output's variation.
const SMALL_REFERENCE: f64 = 0.01;

/// Source of an output's indices.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Form {
    /// product of the sections
    Mdrm,
    /// sum of the sections
    Additive,
    /// product of the sections after adding a constant
    Shifted,
    /// form on the lines, plus a sparse expansion of what it misses at the check points
    Corrected,
    /// form on the lines, plus all pairs of inputs
    Bivariate,
    /// every combination of the nodes
    Tensor,
    /// sparse polynomial chaos
    Pce,
    /// Sobol's indices from pairs of samples
    Saltelli,
}

impl Form {
    /// Forms, all of them.
    pub const ALL: [Self; 8] = [
        Self::Mdrm,
        Self::Additive,
        Self::Shifted,
        Self::Corrected,
        Self::Bivariate,
        Self::Tensor,
        Self::Pce,
        Self::Saltelli,
    ];

    /// Returns its name in documents:
    pub fn as_str(self) -> &'static str {
        match self {
            Self::Mdrm => "mdrm",
            Self::Additive => "additive",
            Self::Shifted => "shifted",
            Self::Corrected => "corrected",
            Self::Bivariate => "bivariate",
            Self::Tensor => "tensor",
            Self::Pce => "pce",
            Self::Saltelli => "saltelli",
        }
    }
}

/// The form that answers, and what a reader should know about the choice.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Verdict {
    pub(crate) form: Form,
    pub(crate) reason: Option<String>,
}

/// Doubt that the lines raise, as a product seldom does.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Doubt {
    SignChange { input: usize },
    SmallReference,
}

impl Doubt {
    fn of(sections: &Sections) -> Option<Self> {
        let small = sections.centre.abs() < SMALL_REFERENCE * sections.spread();
        let sign_change = sections
            .sign_change()
            .map(|input| Self::SignChange { input });
        sign_change.or(small.then_some(Self::SmallReference))
    }
}

impl fmt::Display for Doubt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::SignChange { input } => {
                write!(
                    f,
                    "the output changes sign along the cut line of input {}",
                    input + 1
                )
            }
            Self::SmallReference => f.write_str(
                "the value at the cut point is less than a hundredth of the output's spread",
            ),
        }
    }
}

impl fmt::Display for Undefined {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Reference => f.write_str("the value at the cut point is zero beside the others"),
            Self::SectionMean(input) => {
                write!(
                    f,
                    "the mean of the output along the cut line of input {} is zero",
                    input + 1
                )
            }
        }
    }
}

impl Verdict {
    pub(crate) fn new(
        sections: &Sections,
        mdrm: &Result<Mdrm, Undefined>,
        evidence: Option<&Evidence<'_>>,
    ) -> Self {
        let holds = |reason| Self {
            form: Form::Mdrm,
            reason,
        };
        let shifted = evidence.and_then(|evidence| evidence.shifted.as_ref());
        let broken = |reason: String| Self {
            form: shifted.map_or(Form::Additive, |_| Form::Shifted),
            reason: Some(match shifted {
                Some((_, misfit)) => format!(
                    "{reason}; the product form of the output plus a constant by {}",
                    in_deviations(sections, *misfit)
                ),
                None => reason,
            }),
        };
        if let Err(undefined) = mdrm {
            return broken(undefined.to_string());
        }
        if sections.inputs() == 1 {
            // A single section is the output itself, whatever its sign.
            return holds(None);
        }
        match (evidence, Doubt::of(sections)) {
            (Some(evidence), _) if evidence.refutes_product() || shifted.is_some() => {
                broken(refutation(sections, evidence))
            }
            (Some(evidence), Some(doubt)) => holds(Some(format!(
                "{doubt}, but the product form holds at {} check points better than the additive one",
                evidence.checks.len()
            ))),
            (None, Some(doubt)) => broken(format!(
                "{doubt}, and there is no check point to test the product form"
            )),
            (_, None) => holds(None),
        }
    }
}

fn in_deviations(sections: &Sections, misfit: f64) -> String {
    let ratio = misfit / sections.spread();
    // Beyond this the number tells nothing, and it may have overflowed.
    if ratio < 1e3 {
        format!("{ratio:.1e}")
    } else {
        "more than 1000".to_owned()
    }
}

fn refutation(sections: &Sections, evidence: &Evidence<'_>) -> String {
    format!(
        "the product form misses the model by {} standard deviations at {} check points, the additive form by {}",
        in_deviations(sections, evidence.product),
        evidence.checks.len(),
        in_deviations(sections, evidence.additive)
    )
}
