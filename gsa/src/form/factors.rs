//! Functions of one input from which corrections are built, each zero at the cut so that products of two vanish on the
//! lines, where the forms are right already.
//!
//! | factor | function |
//! |---|---|
//! | 0 | the output's own section, d_i(x) |
//! | k > 0 | p_ik(x) - p_ik(c_i) |
//!
//! The section is among them because interactions often repeat the shape of the main effect: sin(x_1) x_3^4 is one product
//! with it, and a slow series in polynomials alone.

use crate::design::{Design, Line};
use crate::form::section::Sections;

/// Tables of one input that all outputs share.
#[derive(Debug, Clone)]
struct Table {
    /// w_j p_k(x_j) by k - 1 and node of the line
    projection: Vec<Vec<f64>>,
    /// p_k(x_j) by node, counted through the lines of the input, and k - 1
    at_known: Vec<Vec<f64>>,
    /// p_k(c)
    at_cut: Vec<f64>,
}

/// The polynomials of a design, at its nodes.
#[derive(Debug, Clone)]
pub(crate) struct Tables(Vec<Table>);

/// A factor: its values at the nodes of all lines of its input, its mean, and its coefficients on p_1, p_2, ..
#[derive(Debug, Clone)]
pub(crate) struct Factor {
    pub(crate) values: Vec<f64>,
    pub(crate) mean: f64,
    pub(crate) modes: Vec<f64>,
}

impl Tables {
    pub(crate) fn new(design: &Design) -> Self {
        let cut = &design.points()[0];
        let table = |(input, line): (usize, &Line)| {
            let degrees = line.rule().len() - 1;
            let at = |x: f64| line.polynomials().evaluate(x, degrees);
            let at_nodes: Vec<Vec<f64>> = line.rule().nodes.iter().map(|&x| at(x)).collect();
            let weights = &line.rule().weights;
            let row = |k: usize| {
                let terms = at_nodes.iter().zip(weights);
                terms.map(|(p, w)| w * p[k]).collect()
            };
            let known = design.lines_of(input).flat_map(|line| &line.rule().nodes);
            Table {
                projection: (0..degrees).map(row).collect(),
                at_known: known.map(|&x| at(x)).collect(),
                at_cut: at(cut[input]),
            }
        };
        Self(design.lines().iter().enumerate().map(table).collect())
    }

    /// m_ik of all sections.
    pub(crate) fn modes(&self, sections: &Sections) -> Vec<Vec<f64>> {
        let modes = |(input, table): (usize, &Table)| {
            // Centred, so that a large mean costs no digits.
            let shift = sections.shifts[input];
            let d = sections.differences(input);
            let row = |row: &Vec<f64>| row.iter().zip(d).map(|(w, d)| w * (d - shift)).sum();
            table.projection.iter().map(row).collect()
        };
        self.0.iter().enumerate().map(modes).collect()
    }

    /// p_1 .. at a node, counted through the lines of the input.
    pub(crate) fn at_node(&self, input: usize, node: usize) -> &[f64] {
        &self.0[input].at_known[node]
    }

    /// The rule's weights for k = 0, and w_j p_k(x_j) above, by node of the line.
    pub(crate) fn projection<'a>(&'a self, line: &'a Line, input: usize, k: usize) -> &'a [f64] {
        match k {
            0 => &line.rule().weights,
            _ => &self.0[input].projection[k - 1],
        }
    }

    /// Highest degree that the present line can tell apart.
    pub(crate) fn degrees(&self, input: usize) -> usize {
        self.0[input].projection.len()
    }

    /// Factor 0 of an input; zero where the section is rounding alone, which no correction should be built from.
    pub(crate) fn section(&self, sections: &Sections, modes: &[Vec<f64>], input: usize) -> Factor {
        let nodes = 0..sections.known(input);
        let size = if sections.variances[input].sqrt() > sections.noise() {
            1.0
        } else {
            0.0
        };
        Factor {
            values: nodes
                .map(|j| size * sections.difference_at(input, j))
                .collect(),
            mean: size * sections.shifts[input],
            modes: modes[input].iter().map(|m| size * m).collect(),
        }
    }

    /// Factor k of an input, 1 <= k <= degrees.
    pub(crate) fn polynomial(&self, input: usize, k: usize) -> Factor {
        let table = &self.0[input];
        let mut modes = vec![0.0; table.at_cut.len()];
        modes[k - 1] = 1.0;
        Factor {
            values: table
                .at_known
                .iter()
                .map(|p| p[k - 1] - table.at_cut[k - 1])
                .collect(),
            mean: -table.at_cut[k - 1],
            modes,
        }
    }
}
