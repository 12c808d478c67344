//! Bivariate dimension reduction: a form, and for every pair of inputs what it misses on the grid of both.
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

use std::collections::HashMap;

use crate::design::{Design, Line};
use crate::form::composite::{Composite, Decomposed, Missing};
use crate::form::corrected::{Frame, add_unresolved};
use crate::form::evidence::{Checks, Evidence};
use crate::form::mdrm::{Mdrm, departure};
use crate::form::scale::times_power_of_two;
use crate::form::section::Sections;
use crate::method::analysis::{Analysis, analyse_output};
use crate::method::auto;
use crate::method::verdict::Form;

/// What pairs leave has three inputs and more, and a smaller share in main effects than pairs have.
const OF_TRIPLES: f64 = 0.5;

/// The runs of one pair of inputs.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct PairGrid {
    inputs: (usize, usize),
    /// point at node j of the first and l of the second, row by row
    ordinals: Vec<usize>,
}

/// Adds the grids of all pairs to a design; check points and lines that lie on them are reused.
pub(crate) fn add_pairs(design: &mut Design) -> Vec<PairGrid> {
    let bits = |point: &[f64]| point.iter().map(|x| x.to_bits()).collect::<Vec<u64>>();
    let known = design.points().iter().enumerate();
    let mut known: HashMap<Vec<u64>, usize> = known.map(|(k, x)| (bits(x), k)).collect();
    let inputs = design.inputs().len();
    let mut grids = Vec::new();
    for i in 0..inputs {
        for j in i + 1..inputs {
            let nodes = |input: usize| design.lines()[input].rule().nodes.clone();
            let (first, second) = (nodes(i), nodes(j));
            let mut ordinals = Vec::with_capacity(first.len() * second.len());
            for &x in &first {
                for &y in &second {
                    let mut point = design.points()[0].clone();
                    (point[i], point[j]) = (x, y);
                    let key = bits(&point);
                    let ordinal = known
                        .get(&key)
                        .copied()
                        .unwrap_or_else(|| design.add_point(point));
                    known.insert(key, ordinal);
                    ordinals.push(ordinal);
                }
            }
            grids.push(PairGrid {
                inputs: (i, j),
                ordinals,
            });
        }
    }
    grids
}

/// Indices of the bivariate form, the error of each first-order index beside quadrature, and the pair points without a
/// finite value, where e_ij is taken as zero.
pub(crate) struct Bivariate {
    pub(crate) found: Decomposed,
    pub(crate) decomposition: Option<Vec<f64>>,
    missing: Option<Missing>,
    pub(crate) lost: Vec<usize>,
}

/// e_ij at the nodes of each pair.
struct Excess(Vec<((usize, usize), Vec<f64>)>);

/// Analyses one output with the best of the forms at `candidates` (values of t).
pub(crate) fn analyse(
    design: &Design,
    frame: &Frame,
    grids: &[PairGrid],
    sections: &Sections,
    (values, checks): (&[f64], &Checks<'_>),
    candidates: &[f64],
) -> Option<Bivariate> {
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
    let sizes: Vec<usize> = design
        .lines()
        .iter()
        .map(|line| line.rule().len())
        .collect();
    let beyond = frame.beyond(&composite, &found, sections, values);
    if let Some(errors) = &mut decomposition {
        add_unresolved(errors, beyond.as_ref());
    }
    Some(Bivariate {
        missing: composite.missing(&sizes, beyond.map(|b| b.by_input).as_deref()),
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

/// What is missed at the check points.
fn residuals(
    design: &Design,
    sections: &Sections,
    checks: &Checks<'_>,
    t: f64,
    excess: &Excess,
) -> Vec<f64> {
    let residual = |(check, h): &(&crate::design::CheckPoint, f64)| {
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
pub(crate) fn answer(
    design: &Design,
    frame: &Frame,
    grids: &[PairGrid],
    values: &[f64],
) -> Analysis {
    let analysis = analyse_output(design, values, frame.pair_weight);
    let Ok(sections) = Sections::new(design, values) else {
        return analysis;
    };
    let mdrm = Mdrm::new(&sections).ok();
    let evidence = Evidence::new(design, values, &sections, mdrm.as_ref());
    let (bases, checks) = match &evidence {
        Some(evidence) => (
            auto::bases(&sections, evidence, mdrm.is_some()),
            evidence.checks.clone(),
        ),
        None => (vec![0.0], Vec::new()),
    };
    let found = analyse(design, frame, grids, &sections, (values, &checks), &bases);
    let Some(found) = found.filter(|f| f.found.variance.sqrt() > sections.noise()) else {
        return analysis;
    };
    let errors = found
        .found
        .errors(found.missing.as_ref(), found.decomposition);
    let mut answer = analysis.with(&sections, found.found, Form::Bivariate, errors);
    if !found.lost.is_empty() {
        let names: Vec<String> = found.lost.iter().map(usize::to_string).collect();
        answer.note(&format!(
            "pair points without a finite value, taken from the form: {}",
            names.join(", ")
        ));
    }
    answer
}
