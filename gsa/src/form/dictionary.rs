//! Candidate corrections: products of the factors of two or three inputs.
//!
//! A product's degree is the sum of its factors', a section counting as one. Which products are candidates depends on the
//! number of inputs alone, so that all outputs share them: the degree goes as high as [`MOST_CANDIDATES`] allows (total degree
//! for pairs; triples of first degree where there is room). With many inputs pairs alone are too many; then none is a
//! candidate, and the forms must do.

use crate::design::CheckPoint;
use crate::form::factors::{Factor, Tables};
use crate::form::regression::Candidates;
use crate::form::section::Sections;

/// Most candidates: a fit of some hundred points still takes milliseconds with them.
const MOST_CANDIDATES: usize = 2500;
/// Highest total degree of a pair.
const HIGHEST_DEGREE: usize = 6;
/// Each degree more is preferred this much less, so that of two columns that explain as much the simpler wins.
const PREFERENCE: f64 = 0.9;

/// A product: inputs ascending, each with its factor (0 the section, k the k-th polynomial).
type Product = Vec<(usize, usize)>;

/// The candidate products of a design.
#[derive(Debug, Clone)]
pub(crate) struct Dictionary {
    products: Vec<Product>,
    /// polynomial factors by input and k - 1
    polynomials: Vec<Vec<Factor>>,
}

impl Dictionary {
    pub(crate) fn new(tables: &Tables, inputs: usize) -> Self {
        let degrees: Vec<usize> = (0..inputs).map(|i| tables.degrees(i)).collect();
        let highest = (2..=HIGHEST_DEGREE)
            .rev()
            .find(|&degree| pairs(&degrees, degree).len() <= MOST_CANDIDATES);
        let mut products = highest.map_or(Vec::new(), |degree| pairs(&degrees, degree));
        let triples = triples(&degrees);
        if highest.is_some() && products.len() + triples.len() <= MOST_CANDIDATES {
            products.extend(triples);
        }
        let polynomial = |i: usize| (1..=degrees[i]).map(move |k| tables.polynomial(i, k));
        Self {
            products,
            polynomials: (0..inputs).map(|i| polynomial(i).collect()).collect(),
        }
    }

    /// The factors of one output, by input: its section first, then the polynomials.
    pub(crate) fn factors(
        &self,
        tables: &Tables,
        sections: &Sections,
        modes: &[Vec<f64>],
    ) -> Vec<Vec<Factor>> {
        let of_input = |(input, polynomials): (usize, &Vec<Factor>)| {
            let mut factors = vec![tables.section(sections, modes, input)];
            factors.extend_from_slice(polynomials);
            factors
        };
        self.polynomials.iter().enumerate().map(of_input).collect()
    }

    /// The factors' products at the check points.
    pub(crate) fn candidates(&self, factors: &[Vec<Factor>], checks: &[&CheckPoint]) -> Candidates {
        let preference = |product: &Product| {
            let degree: usize = product.iter().map(|(_, k)| (*k).max(1)).sum();
            PREFERENCE.powi(degree as i32)
        };
        let preference = self.products.iter().map(preference).collect();
        Candidates::new(preference, checks.len(), |product, k| {
            let factor = |&(input, factor): &(usize, usize)| {
                factors[input][factor].values[checks[k].nodes()[input]]
            };
            self.products[product].iter().map(factor).product()
        })
    }

    /// The product's coefficients on the orthonormal polynomials, each with its multi-index.
    pub(crate) fn expand(
        &self,
        factors: &[Vec<Factor>],
        product: usize,
    ) -> Vec<(Vec<(usize, usize)>, f64)> {
        let mut terms = vec![(Vec::new(), 1.0)];
        for &(input, k) in &self.products[product] {
            let factor = &factors[input][k];
            let mut longer = Vec::with_capacity(terms.len() * (1 + factor.modes.len()));
            for (index, c) in terms {
                for (degree, mode) in factor.modes.iter().enumerate().filter(|(_, m)| **m != 0.0) {
                    let mut with: Vec<(usize, usize)> = index.clone();
                    with.push((input, degree + 1));
                    longer.push((with, c * mode));
                }
                longer.push((index, c * factor.mean));
            }
            terms = longer;
        }
        terms
    }
}

/// Products of two inputs up to a total degree.
fn pairs(degrees: &[usize], highest: usize) -> Vec<Product> {
    let mut products = Vec::new();
    for i in 0..degrees.len() {
        for j in i + 1..degrees.len() {
            for k in 0..=degrees[i].min(highest - 1) {
                let left = highest - k.max(1);
                products.extend((0..=degrees[j].min(left)).map(|l| vec![(i, k), (j, l)]));
            }
        }
        if products.len() > MOST_CANDIDATES {
            break;
        }
    }
    products
}

/// Products of three first degrees, and of three sections.
fn triples(degrees: &[usize]) -> Vec<Product> {
    let mut products = Vec::new();
    for i in 0..degrees.len() {
        for j in i + 1..degrees.len() {
            for l in j + 1..degrees.len() {
                products.push(vec![(i, 0), (j, 0), (l, 0)]);
                if [i, j, l].iter().all(|input| degrees[*input] > 0) {
                    products.push(vec![(i, 1), (j, 1), (l, 1)]);
                }
                if products.len() > MOST_CANDIDATES {
                    return products;
                }
            }
        }
    }
    products
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn candidates_stay_within_bounds() {
        for inputs in [2, 3, 7, 20, 60, 1000] {
            let degrees = vec![4; inputs];
            let found = (2..=HIGHEST_DEGREE)
                .rev()
                .find(|&degree| pairs(&degrees, degree).len() <= MOST_CANDIDATES);
            assert_eq!(found.is_some(), inputs <= 20, "{inputs} {found:?}");
        }
        // of total degree 2: section or first polynomial each
        assert_eq!(pairs(&[4, 4], 2).len(), 4);
        assert_eq!(triples(&[4, 4, 4, 0]).len(), 5);
    }
}
