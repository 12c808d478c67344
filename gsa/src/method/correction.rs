//! The best of all forms on lines and check points: those that M-DRM has, and each with a sparse expansion of what it misses, which is
//! the whole grid's tensor quadrature once check points fill it.

use crate::design::Design;
use crate::form::corrected::{Corrected, Frame};
use crate::form::evidence::Evidence;
use crate::form::mdrm::Mdrm;
use crate::form::section::Sections;
use crate::form::shift;
use crate::method::analysis::{Analysis, Form, Status};
use crate::method::lines::analyse_output;

/// A form that misses this share of the tolerance needs no correction.
pub(crate) const GOOD_ENOUGH: f64 = 0.25;
/// A product that misses so many times what the sum does would have to be cancelled by its corrections, beside whose
/// size the output is nothing.
const FAR_OFF: f64 = 3.0;

/// The best answer for one output from lines and check points. Without a tolerance no form is good enough where the grid is known.
pub(crate) fn best(
    design: &Design,
    frame: &Frame,
    values: &[f64],
    tolerance: Option<f64>,
) -> Analysis {
    let analysis = analyse_output(design, values, frame.pair_weight);
    let misses = |e: f64| tolerance.is_none_or(|tolerance| e > GOOD_ENOUGH * tolerance);
    let improvable = match analysis.status {
        Status::Ok | Status::ProductFormBroken => analysis.error.decomposition.is_none_or(misses),
        _ => false,
    };
    if !improvable {
        return analysis;
    }
    let Ok(sections) = Sections::new(design, values) else {
        return analysis;
    };
    match best_correction(design, frame, values, &sections) {
        Some(corrected) if tolerance.is_none() || is_better(&corrected, &analysis) => {
            with_correction(analysis, &sections, corrected)
        }
        _ => analysis,
    }
}

fn is_better(corrected: &Corrected, analysis: &Analysis) -> bool {
    let largest = corrected.largest_error();
    analysis.first_order.is_none()
        || analysis
            .error
            .decomposition
            .is_none_or(|form| largest < form)
}

/// Every form with its corrections; the least error wins.
fn best_correction(
    design: &Design,
    frame: &Frame,
    values: &[f64],
    sections: &Sections,
) -> Option<Corrected> {
    let mdrm = Mdrm::new(sections).ok();
    let evidence = Evidence::new(design, values, sections, mdrm.as_ref())?;
    // Once the grid is known, the form doesn't matter, and the sum is the simplest.
    let forms = match frame.is_whole() {
        true => vec![0.0],
        false => bases(sections, &evidence, mdrm.is_some()),
    };
    let attempts = forms
        .into_iter()
        .filter_map(|t| frame.correct(sections, (values, &evidence.checks), t));
    attempts.min_by(|a, b| a.largest_error().total_cmp(&b.largest_error()))
}

/// The values of t worth a correction.
pub(crate) fn bases(sections: &Sections, evidence: &Evidence<'_>, product: bool) -> Vec<f64> {
    let mut forms = vec![0.0];
    if product && evidence.product <= FAR_OFF * evidence.additive {
        forms.push(1.0 / sections.centre);
    }
    if evidence.shifted.is_some() {
        forms.push(shift::fit(sections, &evidence.checks));
    }
    forms
}

fn with_correction(analysis: Analysis, sections: &Sections, corrected: Corrected) -> Analysis {
    let form = if corrected.exhaustive {
        Form::Tensor
    } else {
        Form::Corrected
    };
    let text = match form {
        Form::Tensor => "the check points fill the grid, which gave the indices",
        _ => "what that form misses at the check points is added as a sparse expansion",
    };
    let (missing, decomposition) = (corrected.missing.as_ref(), Some(corrected.decomposition));
    let errors = corrected.found.errors(missing, decomposition);
    let mut analysis = analysis.with(sections, corrected.found, form, errors);
    analysis.note(text);
    analysis
}
