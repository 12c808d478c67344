//! `mdrm`: runs on lines through the cut point, and a few off them. Product, shifted product or sum, whichever holds.

use ndarray::ArrayView2;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

use crate::design::{Design, DesignError};
use crate::form::additive;
use crate::form::evidence::{self, Evidence};
use crate::form::mdrm::Mdrm;
use crate::form::section::Sections;
use crate::judge::index_error::{self, ByInput, ErrorParts};
use crate::judge::misses::{Effects, Misses};
use crate::law::distribution::Distribution;
use crate::method::Method;
use crate::method::analysis::{
    Analysis, Form, MOST_FOR_PAIRS, Status, each_output, in_output_units,
};
use crate::method::procedure::{Procedure, Runs};
use crate::method::verdict::Verdict;

/// Lines and check points, all known from the start.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Lines {
    design: Design,
}

impl Procedure for Lines {
    fn begin(inputs: &[Distribution], settings: &Method) -> Result<Self, DesignError> {
        let mut rng = ChaCha8Rng::seed_from_u64(settings.seed);
        let design = Design::new(inputs, settings.nodes, settings.check_points, &mut rng)?;
        Ok(Self { design })
    }

    fn most_first_points(inputs: usize, settings: &Method) -> usize {
        Design::most_line_points(inputs, settings.nodes)
    }

    fn runs(&self) -> Runs<'_> {
        Runs::Lines(&self.design)
    }

    fn on(&self, design: Design) -> Option<Box<dyn Procedure>> {
        Some(Box::new(Self { design }))
    }

    fn analyse(&self, values: &ArrayView2<f64>) -> Result<Vec<Analysis>, DesignError> {
        Ok(on_lines(&self.design, values))
    }
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
    Runs::Lines(design).judged(on_lines(design, values), values)
}

/// Analyses as [`analyse`] does, without what outputs may do where runs failed.
pub(crate) fn on_lines(design: &Design, values: &ArrayView2<f64>) -> Vec<Analysis> {
    let pair_weight = design.weight_of_interactions(2);
    each_output(values, |values| analyse_output(design, values, pair_weight))
}

/// Analyses an output on lines and check points.
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

/// Analyses an output that doesn't vary on the lines. That is a constant, unless a check point shows an interaction that vanishes on them.
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
                 only interactions that vanish at the cut point are there, and the method auto finds them"
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

/// Forms, and what they need beside the sections.
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
                _ => misses.as_ref().map(|misses| misses.errors_of(&first_order)),
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
        analysis.note_hidden(sections);
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
            (nodes.collect(), evidence::images(checks)),
            (&values, &predictions),
            &effects,
            self.pair_weight,
            fitted,
        ))
    }
}

fn note_missing(analysis: &mut Analysis, design: &Design, values: &[f64], sections: &Sections) {
    analysis.note_lost(
        "points without a finite value, taken from the other nodes of their lines",
        &sections.lost,
    );
    let checks = design.checks().iter().map(|check| check.ordinal());
    let missing: Vec<usize> = checks
        .chain(design.probes().iter().copied())
        .filter(|&ordinal| ordinal < design.to_run() && !values[ordinal].is_finite())
        .collect();
    analysis.note_lost("left out check points without a finite value", &missing);
}
