//! `auto`: from lines to whatever it takes.
//!
//! It starts with M-DRM's lines and a few check points and lets these choose among product, shifted product and sum. While
//! the claimed error of some output is above the tolerance it asks for more, and reuses all that was run:
//!
//! | largest part of the error | asked for |
//! |---|---|
//! | quadrature | nodes on the lines that contribute most: 5, 9, 17, 33 |
//! | decomposition | half as many check points again (near the tolerance a quarter), for sparse corrections of the form |
//! | the same, and little of the grid is left | the rest of the grid: tensor quadrature |
//!
//! It ends at the tolerance, at the budget, or when there is nothing left to ask for. Its errors are those of the method
//! that answers, by output.

use crate::design::Design;
use crate::form::corrected::{Corrected, Frame};
use crate::form::evidence::Evidence;
use crate::form::mdrm::Mdrm;
use crate::form::section::Sections;
use crate::form::shift;
use crate::method::Method;
use crate::method::analysis::{Analysis, Status, analyse_output};
use crate::method::verdict::Form;

/// Most nodes of a line.
const MOST_NODES: usize = 33;
/// A form that misses this share of the tolerance needs no correction.
const GOOD_ENOUGH: f64 = 0.25;
/// A product that misses so many times what the sum does would have to be cancelled by its corrections, beside whose
/// size the output is nothing.
const FAR_OFF: f64 = 3.0;
/// Fewest check points asked for at once.
const LEAST_BATCH: usize = 4;
/// How many check points more to mend a form, as a share of those there are: from afar, and once the error is less than
/// twice the tolerance.
const MORE: f64 = 0.5;
const A_LITTLE_MORE: f64 = 0.25;
/// To confirm one, and at most so many: chance plays a part where there are few.
const CONFIRMING: f64 = 0.34;
const MOST_TO_CONFIRM: usize = 16;

/// The best answer for one output from lines and check points. Without a tolerance no form is good enough where the grid is known.
pub(crate) fn analyse(
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

/// What to add to a design.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Step {
    /// Finer lines: inputs, with their nodes.
    Refine(Vec<(usize, usize)>),
    /// So many check points.
    Check(usize),
}

/// The next step; `None` if the tolerance is met, the budget is spent, or nothing is left. Corrections were chosen at the check
/// points that judge them, and the first time that they meet the tolerance may be by chance: they are `confirmed` by
/// meeting it again with further points.
pub(crate) fn next_step(
    design: &Design,
    analyses: &[Analysis],
    method: &Method,
    confirmed: &mut bool,
) -> Option<Step> {
    let budget = method.most_runs.checked_sub(design.points().len())?;
    let failing: Vec<&Analysis> = analyses
        .iter()
        .filter(|a| match a.status {
            Status::Ok | Status::ProductFormBroken => {
                a.error.total.is_none_or(|e| e > method.tolerance)
            }
            _ => false,
        })
        .collect();
    if failing.is_empty() {
        let by_chance = analyses.iter().any(|a| a.method == Form::Corrected);
        let again = by_chance && !*confirmed;
        *confirmed = true;
        let most = budget.min(MOST_TO_CONFIRM);
        return again.then(|| check(design, CONFIRMING, most)).flatten();
    }
    *confirmed = false;
    let rough: Vec<&&Analysis> = failing
        .iter()
        .filter(|a| a.error.quadrature > a.error.decomposition)
        .collect();
    if 2 * rough.len() > failing.len()
        && let Some(step) = refine(design, &rough, budget)
    {
        return Some(step);
    }
    if failing
        .iter()
        .all(|a| is_beyond_checks(a, method.tolerance))
    {
        return None;
    }
    let is_close = |a: &&Analysis| a.error.total.is_some_and(|e| e < 2.0 * method.tolerance);
    let share = match failing.iter().all(is_close) {
        true => A_LITTLE_MORE,
        false => MORE,
    };
    check(design, share, budget)
        .or_else(|| refine(design, &failing.iter().collect::<Vec<_>>(), budget))
}

/// Whether what is missing lies in lines that can't be refined any more: check points don't mend these.
fn is_beyond_checks(analysis: &Analysis, tolerance: f64) -> bool {
    let error = &analysis.error;
    let of_interactions: f64 = error.missing_of_interactions.iter().sum();
    let form_holds = error
        .decomposition
        .is_some_and(|e| e <= GOOD_ENOUGH * tolerance);
    form_holds && of_interactions <= GOOD_ENOUGH * tolerance
}

/// A share more check points, or all that the grid has left if they are hardly more.
fn check(design: &Design, share: f64, budget: usize) -> Option<Step> {
    let left = design.off_axis_left();
    let batch = ((design.checks().len() as f64 * share) as usize).max(LEAST_BATCH);
    let batch = if left <= batch + batch / 2 {
        left
    } else {
        batch
    };
    match batch.min(budget) {
        0 => None,
        batch => Some(Step::Check(batch)),
    }
}

/// Finer rules for the inputs that contribute at least half as much to the quadrature error as the worst does. Where that
/// is what interactions lack and the line is finer already than the check points know, these come first.
fn refine(design: &Design, rough: &[&&Analysis], budget: usize) -> Option<Step> {
    let finer = |input: usize| 2 * design.lines()[input].rule().len() - 1;
    let largest = |parts: fn(&Analysis) -> &[f64]| {
        let mut sums = vec![0.0f64; design.inputs().len()];
        for analysis in rough {
            for (sum, part) in sums.iter_mut().zip(parts(analysis)) {
                *sum = sum.max(*part);
            }
        }
        sums
    };
    let contribution = largest(|a| &a.error.missing);
    let of_interactions = largest(|a| &a.error.missing_of_interactions);
    let allowed = |input: &usize| finer(*input) <= MOST_NODES;
    let worst = (0..contribution.len())
        .filter(allowed)
        .fold(0.0, |max, i| contribution[i].max(max));
    let chosen = (0..contribution.len())
        .filter(allowed)
        .filter(|&input| contribution[input] > 0.0 && contribution[input] >= 0.5 * worst);
    let (unchecked, chosen): (Vec<usize>, Vec<usize>) = chosen.partition(|&input| {
        design.is_unchecked(input) && of_interactions[input] > 0.5 * contribution[input]
    });
    if chosen.is_empty() && !unchecked.is_empty() {
        return check(design, MORE, budget);
    }
    let chosen: Vec<(usize, usize)> = chosen.into_iter().map(|i| (i, finer(i))).collect();
    let cost: usize = chosen.iter().map(|(_, nodes)| nodes).sum();
    (!chosen.is_empty() && cost <= budget).then_some(Step::Refine(chosen))
}
