//! Forms with corrections: what a form misses at the check points, as a sparse expansion, and on a whole grid, exactly.
//!
//! The residuals r of a form vanish on the lines. A few products of factors that do so too ([`crate::form::dictionary`]) are fitted
//! to them at the check points, and cross-validated residuals say what is still missed. Once the check points fill the grid, r
//! is known at all of its nodes, and its coefficients are sums over them: full tensor quadrature, by way of the form.
//!
//! Reusing the lines this way is cut-HDMR (H. Rabitz, O. F. Alis, "General foundations of high-dimensional model
//! representations", Journal of Mathematical Chemistry 25 (1999) 197-233) with the higher-order terms taken from sparse
//! regression (G. Blatman, B. Sudret, "Adaptive sparse polynomial chaos expansion based on least angle regression", Journal of
//! Computational Physics 230 (2011) 2345-2367) in place of grids.

use crate::design::Design;
use crate::form::composite::{Composite, Decomposed, Known, Missing};
use crate::form::dictionary::Dictionary;
use crate::form::evidence::{self, Checks};
use crate::form::factors::Tables;
use crate::form::mdrm::departure;
use crate::form::regression;
use crate::form::scale::times_power_of_two;
use crate::form::section::Sections;
use crate::form::whole_grid::WholeGrid;
use crate::judge::index_error;
use crate::judge::misses::{Effects, Misses};

/// Fewer check points say nothing about what was fitted to them.
const LEAST_POINTS: usize = 4;
/// The least of several corrected forms' errors is taken, which favours one that looks better than it is.
const BEST_OF_SEVERAL: f64 = 1.5;
/// Share of the mean square missed off the nodes by which an index may be wrong: all of it in one main effect would be 1.
const OFF_NODES: f64 = 0.25;
/// Misfit of rounding size is not to be explained.
const NOISE_IN_EPS: f64 = 16.0;

/// Tables and settings that all outputs of a design share.
#[derive(Debug, Clone)]
pub(crate) struct Frame {
    pub(crate) tables: Tables,
    dictionary: Dictionary,
    pub(crate) pair_weight: f64,
    /// the grid of the lines, if check points fill it
    whole_grid: Option<WholeGrid>,
    known: Known,
    /// points off the nodes: ordinal, and p_1, p_2, .. of each input there
    probes: Vec<(usize, Vec<Vec<f64>>)>,
}

/// Misses off the nodes.
pub(crate) struct Beyond {
    /// mean square over the variance
    pub(crate) variance: f64,
    /// root mean square over the part of the standard deviation that each input has
    pub(crate) by_input: Vec<f64>,
}

/// Adds to the errors of the indices what is missed off the nodes, in whichever effects it is.
pub(crate) fn add_unresolved(errors: &mut [f64], beyond: Option<&Beyond>) {
    let unresolved = beyond.map_or(0.0, |beyond| OFF_NODES * beyond.variance);
    for error in errors {
        *error = index_error::at_most_one(*error + unresolved);
    }
}

/// Indices of a corrected form, and the error of each first-order index beside quadrature.
pub(crate) struct Corrected {
    pub(crate) found: Decomposed,
    pub(crate) decomposition: Vec<f64>,
    pub(crate) missing: Option<Missing>,
    /// whether the whole grid is behind it
    pub(crate) exhaustive: bool,
}

impl Corrected {
    /// Returns the largest error of all first-order indices, beside quadrature.
    pub(crate) fn largest_error(&self) -> f64 {
        self.decomposition.iter().copied().fold(0.0, f64::max)
    }
}

impl Frame {
    pub(crate) fn new(design: &Design) -> Self {
        let tables = Tables::new(design);
        let whole_grid = WholeGrid::new(design, &tables);
        Self {
            known: match &whole_grid {
                Some(_) => Known::Nodes,
                None => Known::Coordinates(design.checked_coordinates()),
            },
            whole_grid,
            dictionary: Dictionary::new(&tables, design.inputs().len()),
            pair_weight: design.weight_of_interactions(2),
            probes: probes(design),
            tables,
        }
    }

    /// Returns what a surrogate misses off the nodes; `None` if no point there has a value.
    pub(crate) fn beyond(
        &self,
        composite: &Composite<'_>,
        found: &Decomposed,
        sections: &Sections,
        values: &[f64],
    ) -> Option<Beyond> {
        let known = self.probes.iter().filter(|(k, _)| values[*k].is_finite());
        let miss = |(k, polynomials): &(usize, Vec<Vec<f64>>)| {
            let value = times_power_of_two(values[*k], -sections.exponent);
            (value - composite.predict(polynomials)).powi(2)
        };
        let squares: Vec<f64> = known.map(miss).collect();
        let mean = squares.iter().sum::<f64>() / squares.len() as f64;
        let of_input = |total: &f64| (mean / (total * found.variance)).sqrt();
        mean.is_finite().then(|| Beyond {
            variance: mean / found.variance,
            by_input: found.total.iter().map(of_input).collect(),
        })
    }

    /// Whether the check points fill their grid.
    pub(crate) fn is_whole(&self) -> bool {
        self.whole_grid.is_some()
    }

    /// The form at t, corrected by what it misses at the check points; `None` if there is nothing to go by.
    pub(crate) fn correct(
        &self,
        sections: &Sections,
        (values, checks): (&[f64], &Checks<'_>),
        t: f64,
    ) -> Option<Corrected> {
        if self.whole_grid.is_none() && evidence::draws(checks) < LEAST_POINTS {
            return None;
        }
        let residuals: Vec<f64> = checks
            .iter()
            .map(|(check, h)| h - sections.centre - departure(t, sections.differences_at(check)))
            .collect();
        if residuals.iter().any(|r| !r.is_finite()) {
            return None;
        }
        let modes = self.tables.modes(sections);
        let mut composite = Composite::new(sections, modes.clone(), t);
        let (unseen, fitted) = match &self.whole_grid {
            Some(grid) => {
                grid.add_to(&mut composite, checks, &residuals);
                (vec![0.0; checks.len()], 0)
            }
            None => self.add_sparse(&mut composite, sections, &modes, checks, &residuals),
        };
        let found = composite.decompose()?;
        let grid = self.whole_grid.as_ref();
        let missed = grid.map_or(0.0, |grid| grid.weight_missing(checks));
        let mut decomposition = self.errors(
            self.pair_weight,
            &composite,
            &found,
            checks,
            (&unseen, fitted),
        );
        for error in &mut decomposition {
            *error = index_error::at_most_one(BEST_OF_SEVERAL * *error);
        }
        if missed > 0.0 {
            // Nodes without a value have the form's; as many deviations off as their probability allows.
            let form = residuals.iter().map(|r| r * r).sum::<f64>() / checks.len() as f64;
            let error = 2.0 * (missed * form / found.variance).sqrt();
            decomposition
                .iter_mut()
                .for_each(|e| *e = index_error::at_most_one(*e + error));
        }
        let beyond = self.beyond(&composite, &found, sections, values);
        add_unresolved(&mut decomposition, beyond.as_ref());
        Some(Corrected {
            missing: composite.missing(&self.known, beyond.map(|b| b.by_input).as_deref()),
            found,
            decomposition,
            exhaustive: self.whole_grid.is_some(),
        })
    }

    fn add_sparse(
        &self,
        composite: &mut Composite<'_>,
        sections: &Sections,
        modes: &[Vec<f64>],
        checks: &Checks<'_>,
        residuals: &[f64],
    ) -> (Vec<f64>, usize) {
        let factors = self.dictionary.factors(&self.tables, sections, modes);
        let points: Vec<_> = checks.iter().map(|(check, _)| *check).collect();
        let candidates = self.dictionary.candidates(&factors, &points);
        let noise = NOISE_IN_EPS * f64::EPSILON * sections.largest;
        let images = evidence::images(checks);
        let (fit, unseen) = regression::fit(&candidates, residuals, noise, &images);
        for &(product, coefficient) in &fit.terms {
            for (index, c) in self.dictionary.expand(&factors, product) {
                composite.add(index, coefficient * c);
            }
        }
        (unseen, fit.terms.len())
    }

    /// `weight`: of the residuals' interactions.
    pub(crate) fn errors(
        &self,
        weight: f64,
        composite: &Composite<'_>,
        found: &Decomposed,
        checks: &Checks<'_>,
        (unseen, fitted): (&[f64], usize),
    ) -> Vec<f64> {
        let effects: Vec<Vec<f64>> = (0..found.first_order.len())
            .map(|input| composite.main_effect(input))
            .collect();
        let deviation = found.variance.sqrt();
        let main = |input: usize, k: usize| {
            let p = self.tables.at_node(input, checks[k].0.nodes()[input]);
            let terms = effects[input].iter().zip(p);
            terms.map(|(c, p)| c * p).sum::<f64>() / deviation
        };
        let predictions: Vec<f64> = checks.iter().zip(unseen).map(|((_, h), r)| h - r).collect();
        let effects = Effects {
            first_order: &found.first_order,
            mean: found.mean,
            variance: found.variance,
            main: &main,
        };
        let values: Vec<f64> = checks.iter().map(|(_, h)| *h).collect();
        let nodes = checks.iter().flat_map(|(check, _)| check.nodes()).copied();
        let forms = (&values[..], &predictions[..]);
        let points = (nodes.collect(), evidence::images(checks));
        Misses::new(points, forms, &effects, weight, fitted).errors_of(&found.first_order)
    }
}

fn probes(design: &Design) -> Vec<(usize, Vec<Vec<f64>>)> {
    let at = |&ordinal: &usize| {
        let inputs = design.points()[ordinal].iter().zip(design.lines());
        let polynomials =
            inputs.map(|(&x, line)| line.polynomials().evaluate(x, line.rule().len() - 1));
        (ordinal, polynomials.collect())
    };
    design.probes().iter().map(at).collect()
}
