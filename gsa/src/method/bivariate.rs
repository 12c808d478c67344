//! `bivariate`, bivariate dimension reduction: a form, and for every pair of inputs what it misses on the grid of both.
//!
//! ```text
//! h(x) ~ F(x) + sum_{i<j} e_ij(x_i, x_j),   e_ij = h - F with all other inputs at the cut
//! ```
//!
//! With the additive F this is the bivariate reduction of H. Xu and S. Rahman ("A generalized dimension-reduction method for
//! multidimensional integration in stochastic mechanics", International Journal for Numerical Methods in Engineering 61 (2004)
//! 1992-2019), which is cut-HDMR of second order; with a product F what a product does to three and more inputs at once is kept.
//! Of the forms the one with the least misfit at the check points is taken. Exact where no more than two inputs interact
//! beyond F. Cost: n(n-1)/2 grids of (N-1)^2 runs for odd N where the mean is a node, else N^2; check points on the nodes, which see
//! interactions of three and more, and as many off them, which see whether the nodes resolve the model.

use ndarray::ArrayView2;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

use crate::design::pair_grid::PairGrid;
use crate::design::{CheckPoint, Design, DesignError, Line, MAX_CHECK_POINTS};
use crate::form::composite::{Composite, Decomposed, Known, Missing};
use crate::form::corrected::{Frame, add_unresolved};
use crate::form::evidence::{Checks, Evidence};
use crate::form::mdrm::{Mdrm, departure};
use crate::form::scale::times_power_of_two;
use crate::form::section::Sections;
use crate::law::distribution::Distribution;
use crate::method::Method;
use crate::method::analysis::{Analysis, Form, each_output};
use crate::method::correction;
use crate::method::lines::analyse_output;
use crate::method::procedure::{Procedure, Runs};

/// Share of the residuals that weighs on main effects: what pairs leave are interactions of three inputs and more, which weigh less than pairs do.
const OF_TRIPLES: f64 = 0.5;

/// Lines, check points, and the grids of all pairs.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Bivariate {
    design: Design,
    grids: Vec<PairGrid>,
}

impl Procedure for Bivariate {
    fn begin(inputs: &[Distribution], settings: &Method) -> Result<Self, DesignError> {
        let asked = most_pair_points(inputs.len(), settings.nodes);
        if asked > MAX_CHECK_POINTS {
            return Err(DesignError::TooManyCheckPoints { asked });
        }
        let mut rng = ChaCha8Rng::seed_from_u64(settings.seed);
        let mut design = Design::new(inputs, settings.nodes, settings.check_points, &mut rng)?;
        let grids = design.add_pairs();
        design.add_probes(settings.check_points, &mut rng);
        Ok(Self { design, grids })
    }

    fn most_first_points(inputs: usize, settings: &Method) -> usize {
        let pairs = most_pair_points(inputs, settings.nodes);
        Design::most_line_points(inputs, settings.nodes).saturating_add(pairs)
    }

    fn runs(&self) -> Runs<'_> {
        Runs::Lines(&self.design)
    }

    fn on(&self, design: Design) -> Option<Box<dyn Procedure>> {
        Some(Box::new(Self {
            design,
            grids: self.grids.clone(),
        }))
    }

    fn analyse(&self, values: &ArrayView2<f64>) -> Result<Vec<Analysis>, DesignError> {
        let frame = Frame::new(&self.design);
        Ok(each_output(values, |values| {
            let analysis = answer(&self.design, &frame, &self.grids, values);
            analysis.without_verdict().of_one_input()
        }))
    }
}

/// The whole grids, saturating.
fn most_pair_points(inputs: usize, nodes: usize) -> usize {
    let pairs = inputs.saturating_mul(inputs.saturating_sub(1)) / 2;
    pairs.saturating_mul(nodes.saturating_pow(2))
}

/// Indices of the bivariate form, the error of each first-order index beside quadrature, and the pair points without a
/// finite value, where e_ij is taken as zero.
struct Reduced {
    found: Decomposed,
    decomposition: Option<Vec<f64>>,
    missing: Option<Missing>,
    lost: Vec<usize>,
}

/// e_ij at the nodes of each pair.
struct Excess(Vec<((usize, usize), Vec<f64>)>);

/// Analyses one output with the best of the forms at `candidates` (values of t).
fn reduce(
    design: &Design,
    frame: &Frame,
    grids: &[PairGrid],
    sections: &Sections,
    (values, checks): (&[f64], &Checks<'_>),
    candidates: &[f64],
) -> Option<Reduced> {
    let attempts = candidates.iter().map(|&t| {
        let (excess, lost) = excess(grids, sections, values, t);
        let unseen = residuals(design, sections, checks, t, &excess);
        let square: f64 = unseen.iter().map(|r| r * r).sum();
        (t, excess, lost, unseen, square)
    });
    let finite = attempts.filter(|attempt| attempt.4.is_finite());
    let (t, excess, lost, unseen, _) = finite.min_by(|a, b| a.4.total_cmp(&b.4))?;
    let mut composite = Composite::new(sections, frame.tables.modes(sections), t);
    for (pair, table) in &excess.0 {
        add(&mut composite, design.lines(), frame, *pair, table);
    }
    let found = composite.decompose()?;
    let mut decomposition = (!checks.is_empty()).then(|| {
        frame.errors(
            OF_TRIPLES * design.weight_of_interactions(3),
            &composite,
            &found,
            checks,
            (&unseen, 0),
        )
    });
    let beyond = frame.beyond(&composite, &found, sections, values);
    if let Some(errors) = &mut decomposition {
        add_unresolved(errors, beyond.as_ref());
    }
    Some(Reduced {
        missing: composite.missing(&Known::Nodes, beyond.map(|b| b.by_input).as_deref()),
        found,
        decomposition,
        lost,
    })
}

fn excess(grids: &[PairGrid], sections: &Sections, values: &[f64], t: f64) -> (Excess, Vec<usize>) {
    let mut lost = Vec::new();
    let mut of_grid = |grid: &PairGrid| {
        let (i, j) = grid.inputs;
        let columns = sections.differences(j).len();
        let excess = |(at, &ordinal): (usize, &usize)| {
            let pair = [
                sections.differences(i)[at / columns],
                sections.differences(j)[at % columns],
            ];
            let e = times_power_of_two(values[ordinal], -sections.exponent)
                - sections.centre
                - departure(t, pair.into_iter());
            if e.is_finite() {
                return e;
            }
            if !sections.lost.contains(&ordinal) {
                lost.push(ordinal);
            }
            0.0
        };
        let table = grid.ordinals.iter().enumerate().map(excess).collect();
        (grid.inputs, table)
    };
    let tables = grids.iter().map(&mut of_grid).collect();
    (Excess(tables), lost)
}

/// Returns what is missed at the check points.
fn residuals(
    design: &Design,
    sections: &Sections,
    checks: &Checks<'_>,
    t: f64,
    excess: &Excess,
) -> Vec<f64> {
    let residual = |(check, h): &(&CheckPoint, f64)| {
        let nodes = check.nodes();
        let pairs = excess.0.iter().map(|((i, j), table)| {
            let columns = design.lines()[*j].rule().len();
            table[nodes[*i] * columns + nodes[*j]]
        });
        let form = sections.centre + departure(t, sections.differences_at(check));
        h - form - pairs.sum::<f64>()
    };
    checks.iter().map(residual).collect()
}

/// Adds the coefficients of e_ij, mean and main effects included.
fn add(
    composite: &mut Composite<'_>,
    lines: &[Line],
    frame: &Frame,
    (i, j): (usize, usize),
    table: &[f64],
) {
    let (rows, columns) = (lines[i].rule().len(), lines[j].rule().len());
    for l in 0..columns {
        let along = frame.tables.projection(&lines[j], j, l);
        let column: Vec<f64> = table
            .chunks(columns)
            .map(|row| row.iter().zip(along).map(|(e, w)| e * w).sum())
            .collect();
        for k in 0..rows {
            let across = frame.tables.projection(&lines[i], i, k);
            let c: f64 = column.iter().zip(across).map(|(e, w)| e * w).sum();
            let index = [(i, k), (j, l)]
                .into_iter()
                .filter(|(_, degree)| *degree > 0);
            composite.add(index.collect(), c);
        }
    }
}

/// The answer for one output.
fn answer(design: &Design, frame: &Frame, grids: &[PairGrid], values: &[f64]) -> Analysis {
    let analysis = analyse_output(design, values, frame.pair_weight);
    let Ok(sections) = Sections::new(design, values) else {
        return analysis;
    };
    let mdrm = Mdrm::new(&sections).ok();
    let evidence = Evidence::new(design, values, &sections, mdrm.as_ref());
    let (bases, checks) = match &evidence {
        Some(evidence) => (
            correction::bases(&sections, evidence, mdrm.is_some()),
            evidence.checks.clone(),
        ),
        None => (vec![0.0], Vec::new()),
    };
    let found = reduce(design, frame, grids, &sections, (values, &checks), &bases);
    let Some(found) = found.filter(|f| f.found.variance.sqrt() > sections.noise()) else {
        return analysis;
    };
    let errors = found
        .found
        .errors(found.missing.as_ref(), found.decomposition);
    let mut answer = analysis.with(&sections, found.found, Form::Bivariate, errors);
    answer.note_lost(
        "pair points without a finite value, taken from the form",
        &found.lost,
    );
    answer
}
