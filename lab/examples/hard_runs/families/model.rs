//! Models whose indices are known by quadrature: whole, as printed, and with runs that fail.

use gsa::law::distribution::Distribution;

use crate::families::printing::Printing;

/// Inputs to output.
type Run = Box<dyn Fn(&[f64]) -> f64>;
/// Whether a run fails.
type Fails = Box<dyn Fn(&[f64]) -> bool>;

/// A model of a family, and how its runs end.
pub struct Model {
    pub group: &'static str,
    pub name: &'static str,
    pub inputs: Vec<Distribution>,
    run: Run,
    printing: Printing,
    fails: Fails,
    /// Indices of the function, and of what is printed of it.
    truths: Vec<Vec<f64>>,
}

impl Model {
    pub fn new(
        name: &'static str,
        inputs: Vec<Distribution>,
        run: impl Fn(&[f64]) -> f64 + 'static,
    ) -> Self {
        let truths = vec![first_order(&inputs, &run)];
        Self {
            group: "",
            name,
            inputs,
            run: Box::new(run),
            printing: Printing::Whole,
            fails: Box::new(|_| false),
            truths,
        }
    }

    /// The model in a group.
    pub fn of(self, group: &'static str) -> Self {
        Self { group, ..self }
    }

    /// The model whose values are printed so: the claim is for the function, and for what is printed of it.
    pub fn printed(mut self, printing: Printing) -> Self {
        let printed = |x: &[f64]| printing.text((self.run)(x)).parse().unwrap_or(f64::NAN);
        self.truths.push(first_order(&self.inputs, &printed));
        self.printing = printing;
        self
    }

    /// The model whose runs fail there, where its function goes on.
    pub fn failing(mut self, fails: impl Fn(&[f64]) -> bool + 'static) -> Self {
        self.fails = Box::new(fails);
        self
    }

    /// Text of a run in a table of values.
    pub fn written(&self, x: &[f64]) -> String {
        match (self.fails)(x) {
            true => "nan".to_owned(),
            false => self.printing.text((self.run)(x)),
        }
    }

    /// Error of each index, from whichever truth it is farther.
    pub fn errors(&self, first_order: &[f64]) -> Vec<f64> {
        let error = |(i, s): (usize, &f64)| {
            let errors = self.truths.iter().map(|truth| (s - truth[i]).abs());
            errors.fold(0.0, f64::max)
        };
        first_order.iter().enumerate().map(error).collect()
    }
}

/// Values of an input, with their probabilities.
type Nodes = Vec<(f64, f64)>;

/// Probability beyond the parts on either side.
const BEYOND: f64 = 1e-12;

/// Two Gauss nodes in each of some parts of the law's range: of fourth order in the parts, and as fine for functions with steps. Parts of bounded
/// laws are quadratically finer at both ends, where functions may be singular.
fn nodes(law: &Distribution, parts: usize) -> Nodes {
    let bounds = (law.inverse_cdf(0.0), law.inverse_survival(0.0));
    let is_bounded = bounds.0.is_finite() && bounds.1.is_finite();
    let (low, high) = match is_bounded {
        true => bounds,
        false => (law.inverse_cdf(BEYOND), law.inverse_survival(BEYOND)),
    };
    let end = |k: usize| {
        let share = k as f64 / parts as f64;
        let graded = share * share * (3.0 - 2.0 * share);
        low + (high - low) * if is_bounded { graded } else { share }
    };
    let of_part = |k: usize| {
        let part = law.truncated(end(k), end(k + 1)).ok();
        let rule = part.and_then(|part| part.gauss_rule(2).ok());
        let rule = rule.expect("a part of a bounded law");
        let probability = law.cdf(end(k + 1)) - law.cdf(end(k));
        let weights = rule.weights.into_iter().map(move |w| w * probability);
        rule.nodes.into_iter().zip(weights).collect::<Nodes>()
    };
    (0..parts).flat_map(of_part).collect()
}

/// First-order indices by the grid of all nodes.
fn first_order(inputs: &[Distribution], run: &impl Fn(&[f64]) -> f64) -> Vec<f64> {
    let n = inputs.len();
    let parts = [0, 1, 300, 48, 18][n];
    let grid: Vec<Nodes> = inputs.iter().map(|law| nodes(law, parts)).collect();
    let per_input = 2 * parts;
    let digit = |cell: usize, i: usize| cell / per_input.pow(i as u32) % per_input;
    let mut sections = vec![vec![0.0; per_input]; n];
    let mut values = Vec::with_capacity(per_input.pow(n as u32));
    for cell in 0..per_input.pow(n as u32) {
        let at = |i: usize| grid[i][digit(cell, i)];
        let x: Vec<f64> = (0..n).map(|i| at(i).0).collect();
        let weight: f64 = (0..n).map(|i| at(i).1).product();
        let y = run(&x);
        for (i, section) in sections.iter_mut().enumerate() {
            section[digit(cell, i)] += y * weight / at(i).1;
        }
        values.push((y, weight));
    }
    let mean: f64 = values.iter().map(|(y, w)| y * w).sum();
    let variance: f64 = values.iter().map(|(y, w)| w * (y - mean).powi(2)).sum();
    let share = |(section, nodes): (&Vec<f64>, &Nodes)| {
        let terms = section.iter().zip(nodes);
        terms.map(|(s, (_, w))| w * (s - mean).powi(2)).sum::<f64>() / variance
    };
    sections.iter().zip(&grid).map(share).collect()
}
