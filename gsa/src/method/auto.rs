//! `auto`: from lines to whatever it takes.
//!
//! It starts with M-DRM's lines and a few check points and lets these choose among product, shifted product and sum. While
//! the claimed error of some output is above the tolerance it asks for more, and reuses all that was run:
//!
//! | largest part of the error | asked for |
//! |---|---|
//! | quadrature | nodes on the lines that contribute most: 5, 9, 17, 33 |
//! | decomposition | half as many check points again (near the tolerance a quarter), for sparse corrections of the form |
//! | decomposition, and little of the grid is left | the rest of the grid: tensor quadrature |
//!
//! It ends at the tolerance, at the budget, or when there is nothing left to ask for. Its errors are those of the method
//! that answers, by output.

use ndarray::ArrayView2;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

use crate::design::{Design, DesignError};
use crate::form::corrected::Frame;
use crate::law::distribution::Distribution;
use crate::method::Method;
use crate::method::analysis::{Analysis, Form, Status, each_output};
use crate::method::correction::{self, GOOD_ENOUGH};
use crate::method::lines;
use crate::method::procedure::{Procedure, Runs};

/// Most nodes of a line.
const MOST_NODES: usize = 33;
/// Fewest check points asked for at once.
const LEAST_BATCH: usize = 4;
/// Further check points to mend a form, as a share of those there are: from afar, and once the error is less than twice the tolerance.
const MORE: f64 = 0.5;
const A_LITTLE_MORE: f64 = 0.25;
/// Further check points to confirm that the tolerance is met, as a share and at most. Only few points meet it by chance.
const CONFIRMING: f64 = 0.34;
const MOST_TO_CONFIRM: usize = 16;

/// Lines and check points, and what decides on more of them.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Auto {
    settings: Method,
    design: Design,
    rng: ChaCha8Rng,
    /// whether the tolerance was met before the last points were asked for
    confirmed: bool,
}

impl Procedure for Auto {
    fn begin(inputs: &[Distribution], settings: &Method) -> Result<Self, DesignError> {
        let mut rng = ChaCha8Rng::seed_from_u64(settings.seed);
        let design = Design::new(inputs, settings.nodes, settings.check_points, &mut rng)?;
        Ok(Self {
            settings: *settings,
            design: design.refined_on_demand(),
            rng,
            confirmed: false,
        })
    }

    fn most_first_points(inputs: usize, settings: &Method) -> usize {
        Design::most_line_points(inputs, settings.nodes)
    }

    fn is_adaptive() -> bool {
        true
    }

    fn runs(&self) -> Runs<'_> {
        Runs::Lines(&self.design)
    }

    fn extend(&mut self, analyses: &[Analysis]) -> Result<(), DesignError> {
        match next_step(&self.design, analyses, &self.settings, &mut self.confirmed) {
            None => {}
            Some(Step::Check(count)) => {
                self.design.add_checks(count, &mut self.rng)?;
            }
            Some(Step::Refine(inputs)) => {
                for (input, nodes) in inputs {
                    // A law may have no rule of so many nodes: its line then stays as it is.
                    let _ = self.design.refine(input, nodes);
                }
            }
        }
        Ok(())
    }

    fn on(&self, design: Design) -> Option<Box<dyn Procedure>> {
        Some(Box::new(Self {
            design,
            ..self.clone()
        }))
    }

    fn analyse(&self, values: &ArrayView2<f64>) -> Result<Vec<Analysis>, DesignError> {
        let frame = Frame::new(&self.design);
        let tolerance = Some(self.settings.tolerance);
        Ok(each_output(values, |values| {
            correction::best(&self.design, &frame, values, tolerance).of_one_input()
        }))
    }

    /// The best form on the lines, in milliseconds: check points show that form's error, and aren't used to correct it.
    fn survey(&self, values: &ArrayView2<f64>) -> Result<Vec<Analysis>, DesignError> {
        Ok(lines::on_lines(&self.design, values))
    }
}

/// Addition to a design.
#[derive(Debug, Clone, PartialEq)]
enum Step {
    /// Finer lines: inputs, with their nodes.
    Refine(Vec<(usize, usize)>),
    /// Further check points, by number.
    Check(usize),
}

/// The next step; `None` if the tolerance is met, the budget is spent, or nothing is left. Corrections were chosen at the check
/// points that judge them, and the first time that they meet the tolerance may be by chance: they are `confirmed` by
/// meeting it again with further points.
fn next_step(
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

/// Finer rules for the inputs that contribute at least half as much to the quadrature error as the worst does. Check points come
/// first where interactions are what is missing and no check point has been on the present line yet.
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
