//! Random models, a family each: products, sums, what lies between, and what no form has a place for.

use gsa::law::distribution::Distribution;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

use super::gaussian_ridge::{self, Profile};
use super::small_grid;
use super::sum_of_products::{Factor, Term, known};
use crate::known::Known;

/// A source of random parameters.
struct Draw {
    rng: ChaCha8Rng,
    /// Source of the parameters' moves, one of its own, and how far they go, as a share of their range.
    nudge: Option<(ChaCha8Rng, f64)>,
}

fn unit(rng: &mut ChaCha8Rng) -> f64 {
    (rng.next_u64() >> 11) as f64 * (0.5 * f64::EPSILON)
}

impl Draw {
    fn range(&mut self, low: f64, high: f64) -> f64 {
        let drawn = low + (high - low) * unit(&mut self.rng);
        let nudge = self.nudge.as_mut();
        let by = nudge.map_or(0.0, |(rng, size)| *size * (2.0 * unit(rng) - 1.0));
        (drawn + (high - low) * by).clamp(low, high)
    }

    fn count(&mut self, low: usize, high: usize) -> usize {
        low + (unit(&mut self.rng) * (high - low + 1) as f64) as usize
    }

    fn law(&mut self) -> Distribution {
        match self.count(0, 2) {
            0 => Distribution::uniform(-1.0, 1.0),
            1 => Distribution::normal(0.0, 0.6),
            _ => Distribution::lognormal(-0.2, 0.3),
        }
        .expect("a valid law")
    }

    fn laws(&mut self, n: usize) -> Vec<Distribution> {
        (0..n).map(|_| self.law()).collect()
    }

    /// 1 + a x + b x^2 + c x^3, moderate slopes.
    fn polynomial(&mut self, size: f64) -> Factor {
        let degree = self.count(1, 3);
        let mut c = vec![1.0];
        for k in 1..=degree {
            c.push(self.range(-size, size) / k as f64);
        }
        Factor::Polynomial(c)
    }

    fn shape(&mut self) -> Factor {
        match self.count(0, 2) {
            0 => self.polynomial(1.0),
            1 => Factor::Exponential(self.range(-1.0, 1.0)),
            _ => Factor::Sine {
                offset: self.range(1.2, 3.0),
                frequency: self.range(0.5, 2.0),
                phase: self.range(-1.0, 1.0),
            },
        }
    }
}

fn ones(n: usize) -> Vec<Factor> {
    vec![Factor::One; n]
}

fn constant(n: usize, a: f64) -> Term {
    (a, ones(n))
}

fn product(n: usize, mut factor: impl FnMut(usize) -> Factor) -> Term {
    (1.0, (0..n).map(&mut factor).collect())
}

fn sum(n: usize, mut factor: impl FnMut(usize) -> Factor) -> Vec<Term> {
    let term = |i: usize| {
        let mut factors = ones(n);
        factors[i] = factor(i);
        (1.0, factors)
    };
    (0..n).map(term).collect()
}

fn scaled(mut terms: Vec<Term>, by: f64) -> Vec<Term> {
    terms.iter_mut().for_each(|term| term.0 *= by);
    terms
}

/// x - mean
fn centred(law: &Distribution) -> Factor {
    Factor::Polynomial(vec![-law.mean(), 1.0])
}

fn joined(mut a: Vec<Term>, b: Vec<Term>) -> Vec<Term> {
    a.extend(b);
    a
}

/// Draws a model of every family for a seed.
pub fn all(seed: u64) -> Vec<Known> {
    drawn(seed, None)
}

/// Draws the same models of the same inputs, every parameter moved by up to this share of its range.
pub fn neighbours(seed: u64, size: f64) -> Vec<Known> {
    drawn(seed, Some((ChaCha8Rng::seed_from_u64(!seed), size)))
}

/// Models of inputs whose laws are alike from both ends, a pair of each family: an output at a place off the centre, and one at the centre,
/// which is its own mirror image.
pub fn symmetric(seed: u64) -> Vec<[Known; 2]> {
    let rng = ChaCha8Rng::seed_from_u64(seed);
    let d = &mut Draw { rng, nudge: None };
    let mut models = Vec::new();
    for family in SYMMETRIC {
        let n = d.count(3, 7);
        let half = d.laws(n.div_ceil(2));
        let laws: Vec<Distribution> = (0..n).map(|i| half[i.min(n - 1 - i)]).collect();
        let terms = off_centre(d, family, &laws);
        let mut image = terms.clone();
        image.iter_mut().for_each(|(_, factors)| factors.reverse());
        let centre = joined(terms.clone(), image);
        models.push([
            known(family, laws.clone(), terms),
            known(family, laws, centre),
        ]);
    }
    models
}

const SYMMETRIC: [&str; 6] = [
    "product and sum",
    "two products",
    "nearly a sum",
    "quadratic form",
    "pairs and a triple that vanish on the lines",
    "product of kinks",
];

fn off_centre(d: &mut Draw, family: &str, laws: &[Distribution]) -> Vec<Term> {
    let n = laws.len();
    match family {
        "product and sum" => {
            let sum = sum(n, |_| d.shape());
            joined(vec![product(n, |_| d.polynomial(0.7))], scaled(sum, 0.4))
        }
        "two products" => (0..2).map(|_| product(n, |_| d.polynomial(0.7))).collect(),
        "nearly a sum" => {
            let product = vec![product(n, |_| d.polynomial(0.7))];
            joined(sum(n, |_| d.shape()), scaled(product, 0.1))
        }
        "quadratic form" => {
            let mut terms = sum(n, |_| d.polynomial(1.0));
            for (i, j) in (0..n).flat_map(|i| (i + 1..n).map(move |j| (i, j))) {
                let mut factors = ones(n);
                factors[i] = Factor::Polynomial(vec![0.0, 1.0]);
                factors[j] = Factor::Polynomial(vec![0.0, 1.0]);
                terms.push((d.range(-1.0, 1.0), factors));
            }
            terms
        }
        "product of kinks" => vec![product(n, |_| Factor::Kink {
            offset: d.range(0.0, 2.0),
            at: d.range(-0.5, 1.2),
        })],
        _ => {
            let mut terms = sum(n, |_| d.shape());
            for inputs in [&[0, 1][..], &[1, 2], &[0, 1, 2]] {
                let mut factors = ones(n);
                inputs.iter().for_each(|&i| factors[i] = centred(&laws[i]));
                terms.push((d.range(0.3, 1.5), factors));
            }
            terms
        }
    }
}

fn drawn(seed: u64, nudge: Option<(ChaCha8Rng, f64)>) -> Vec<Known> {
    let rng = ChaCha8Rng::seed_from_u64(seed);
    let mut d = Draw { rng, nudge };
    let mut models = separable(&mut d);
    models.extend(interactions(&mut d));
    models.extend(rough(&mut d));
    models.extend(ridges(&mut d));
    models.extend(grids(&mut d));
    models
}

fn separable(d: &mut Draw) -> Vec<Known> {
    let mut models = Vec::new();
    for (family, n) in [
        ("product, few inputs", d.count(2, 4)),
        ("product, many inputs", d.count(5, 20)),
    ] {
        let terms = vec![product(n, |_| d.shape())];
        models.push(known(family, d.laws(n), terms));
    }
    let n = d.count(2, 20);
    let terms = joined(
        vec![constant(n, d.range(-5.0, 20.0))],
        sum(n, |_| d.shape()),
    );
    models.push(known("sum", d.laws(n), terms));
    let n = d.count(2, 10);
    let terms = vec![constant(n, d.range(-5.0, 20.0)), product(n, |_| d.shape())];
    models.push(known("shifted product", d.laws(n), terms));
    let n = d.count(3, 10);
    let share = d.range(0.1, 0.6);
    let terms = joined(
        vec![product(n, |_| d.polynomial(0.7))],
        scaled(sum(n, |_| d.shape()), share),
    );
    models.push(known("product and sum", d.laws(n), terms));
    let n = d.count(3, 10);
    let terms = joined(
        vec![product(n, |_| d.polynomial(0.7))],
        scaled(sum(n, |_| d.shape()), 0.03),
    );
    models.push(known("nearly a product", d.laws(n), terms));
    let n = d.count(3, 10);
    let terms = joined(
        sum(n, |_| d.shape()),
        scaled(vec![product(n, |_| d.polynomial(0.7))], 0.1),
    );
    models.push(known("nearly a sum", d.laws(n), terms));
    let n = d.count(2, 8);
    let terms = vec![
        product(n, |_| d.polynomial(0.7)),
        product(n, |_| d.polynomial(0.7)),
    ];
    models.push(known("two products", d.laws(n), terms));
    let terms = vec![product(20, |i| {
        if i % 7 == 0 { d.shape() } else { Factor::One }
    })];
    models.push(known("three of twenty inputs act", d.laws(20), terms));
    models
}

fn interactions(d: &mut Draw) -> Vec<Known> {
    let mut models = Vec::new();
    let n = d.count(2, 6);
    let laws = d.laws(n);
    let mut terms = scaled(sum(n, |_| d.shape()), 1.0);
    let mut pair = ones(n);
    (pair[0], pair[1]) = (centred(&laws[0]), centred(&laws[1]));
    terms.push((d.range(0.5, 2.0), pair));
    models.push(known("a pair that vanishes on the lines", laws, terms));
    let n = d.count(3, 8);
    let laws = d.laws(n);
    let mut terms = sum(n, |_| d.shape());
    let mut triple = ones(n);
    for i in 0..3 {
        triple[i] = centred(&laws[i]);
    }
    terms.push((d.range(1.0, 4.0), triple));
    models.push(known("a triple that vanishes on the lines", laws, terms));
    let n = d.count(3, 6);
    let laws = d.laws(n);
    let mut terms = sum(n, |_| d.polynomial(1.0));
    for i in 0..n {
        for j in i + 1..n {
            let mut factors = ones(n);
            (factors[i], factors[j]) = (
                Factor::Polynomial(vec![0.0, 1.0]),
                Factor::Polynomial(vec![0.0, 1.0]),
            );
            terms.push((d.range(-1.0, 1.0), factors));
        }
    }
    models.push(known("quadratic form", laws, terms));
    let laws = vec![Distribution::uniform(-3.0, 3.0).expect("a valid law"); 3];
    let mut terms = sum(3, |_| Factor::Sine {
        offset: 0.0,
        frequency: d.range(0.5, 1.2),
        phase: d.range(-1.0, 1.0),
    });
    let mut pair = ones(3);
    pair[0] = Factor::Sine {
        offset: 0.0,
        frequency: 1.0,
        phase: 0.0,
    };
    pair[2] = Factor::Polynomial(vec![0.0, 0.0, 0.0, 0.0, d.range(0.01, 0.05)]);
    terms.push((1.0, pair));
    models.push(known("like Ishigami", laws, terms));
    models
}

fn rough(d: &mut Draw) -> Vec<Known> {
    let mut models = Vec::new();
    let kink = |d: &mut Draw| Factor::Kink {
        offset: d.range(0.0, 2.0),
        at: d.range(-0.5, 1.2),
    };
    let n = d.count(2, 6);
    let terms = sum(n, |_| kink(d));
    models.push(known("sum of kinks", d.laws(n), terms));
    let n = d.count(2, 6);
    let terms = vec![product(n, |_| kink(d))];
    models.push(known("product of kinks", d.laws(n), terms));
    let step = |d: &mut Draw| Factor::Step {
        at: d.range(0.0, 1.0),
        low: d.range(0.5, 2.0),
        high: d.range(0.5, 2.0),
    };
    let n = d.count(2, 5);
    let terms = sum(n, |_| step(d));
    models.push(known("sum of steps", d.laws(n), terms));
    let n = d.count(2, 5);
    let terms = vec![product(n, |i| if i == 0 { step(d) } else { d.shape() })];
    models.push(known("product with a step", d.laws(n), terms));
    let n = d.count(2, 6);
    let terms = sum(n, |_| Factor::Sine {
        offset: 0.0,
        frequency: d.range(1.0, 6.0),
        phase: d.range(-1.0, 1.0),
    });
    models.push(known("oscillating sum", d.laws(n), terms));
    let n = d.count(2, 4);
    let terms = vec![product(n, |_| {
        let mut c = vec![0.0; d.count(5, 8)];
        (c[0], *c.last_mut().expect("not empty")) = (1.0, d.range(0.1, 0.5));
        Factor::Polynomial(c)
    })];
    models.push(known("product of high degree", d.laws(n), terms));
    models
}

fn ridges(d: &mut Draw) -> Vec<Known> {
    let profiles = [
        ("tanh ridge", Profile::Tanh),
        ("bell ridge", Profile::Bell),
        ("root ridge", Profile::Root),
        ("kink ridge", Profile::Kink),
        ("step ridge", Profile::Step),
    ];
    let ridge = |(family, profile)| {
        let slopes: Vec<f64> = (0..d.count(2, 8)).map(|_| d.range(-1.0, 1.0)).collect();
        gaussian_ridge::known(family, profile, &slopes)
    };
    profiles.into_iter().map(ridge).collect()
}

fn grids(d: &mut Draw) -> Vec<Known> {
    let laws = [Distribution::uniform(-1.0, 1.0).expect("a valid law"); 3];
    let a: Vec<f64> = (0..6).map(|_| d.range(0.2, 1.0)).collect();
    let b = a.clone();
    vec![
        small_grid::known("rational", laws, move |x| {
            (1.0 + a[0] * x[0]) / (3.0 + a[1] * x[1] + a[2] * x[0] * x[2])
        }),
        small_grid::known("distance", laws, move |x| {
            ((x[0] - 2.0 * b[0]).powi(2)
                + (x[1] + 2.0 * b[1]).powi(2)
                + (x[2] * b[2]).powi(2)
                + 0.5)
                .sqrt()
        }),
    ]
}
