//! Random functions: samples of Gaussian processes, series, boxes, and W. Becker's metafunctions (Reliab. Eng. Syst. Saf. 204
//! (2020) 107189).

use std::f64::consts::PI;

use crate::attack::draw::{Draw, normal, uniform};
use crate::attack::exact::{Factor, Term, of, on_grid, sum_of_products};
use crate::known::Known;

/// Draws a model of every kind.
pub fn all(d: &mut Draw) -> Vec<Known> {
    vec![
        on_normals(d),
        on_uniforms(d),
        fourier(d),
        legendre(d),
        rational(d),
        logistic(d),
        boxes(d),
        metafunction(d),
    ]
}

/// Waves w_k and phases of a Gaussian process with a squared exponential kernel, a length for each input.
struct Waves {
    waves: Vec<Vec<f64>>,
    phases: Vec<f64>,
}

impl Waves {
    /// Forty waves of inputs whose lengths are drawn from a decade and more, in units of `width`.
    fn draw(d: &mut Draw, inputs: usize, width: f64) -> Self {
        let lengths: Vec<f64> = d
            .many(inputs, 0.0, 1.2)
            .iter()
            .map(|u| 0.8 * width * 10f64.powf(*u))
            .collect();
        let waves = (0..40).map(|_| lengths.iter().map(|l| d.coefficient() / l).collect());
        Self {
            waves: waves.collect(),
            phases: d.many(40, 0.0, 2.0 * PI),
        }
    }

    fn at(&self, x: &[f64]) -> f64 {
        let terms = self.waves.iter().zip(&self.phases);
        let angle =
            |(w, p): (&Vec<f64>, &f64)| w.iter().zip(x).map(|(w, x)| w * x).sum::<f64>() + p;
        terms.map(|term| angle(term).cos()).sum()
    }
}

/// Waves on standard normals: E\[cos(w.x + p)\] = cos(p) exp(-|w|^2/2), and every moment of two waves is one of their sum and difference.
fn on_normals(d: &mut Draw) -> Known {
    let n = d.count(2, 6);
    let sample = Waves::draw(d, n, 3.0);
    let square = |w: &[f64]| w.iter().map(|w| w * w).sum::<f64>();
    let number = sample.phases.len();
    let pairs = || (0..number).flat_map(|k| (0..number).map(move |l| (k, l)));
    let (w, p) = (&sample.waves, &sample.phases);
    // E over `shared` inputs of the product of the two waves' means over all others.
    let moment = |k: usize, l: usize, shared: &dyn Fn(usize) -> bool| {
        let of_sign = |sign: f64| {
            let exponent: f64 = (0..n)
                .map(|i| match shared(i) {
                    true => (w[k][i] + sign * w[l][i]).powi(2),
                    false => w[k][i].powi(2) + w[l][i].powi(2),
                })
                .sum();
            0.5 * (p[k] + sign * p[l]).cos() * (-0.5 * exponent).exp()
        };
        of_sign(1.0) + of_sign(-1.0)
    };
    let mean: f64 = (0..number)
        .map(|k| p[k].cos() * (-0.5 * square(&w[k])).exp())
        .sum();
    let part = |shared: &dyn Fn(usize) -> bool| {
        pairs().map(|(k, l)| moment(k, l, shared)).sum::<f64>() - mean * mean
    };
    let variance = part(&|_| true);
    Known {
        family: "gaussian process, normals",
        inputs: normal(n),
        first_order: (0..n).map(|i| part(&|k| k == i) / variance).collect(),
        model: Box::new(move |x| sample.at(x)),
    }
}

fn on_uniforms(d: &mut Draw) -> Known {
    let sample = Waves::draw(d, 3, 1.0);
    let offset = d.range(-5.0, 20.0);
    on_grid(
        "gaussian process, uniforms",
        uniform(0.0, 1.0, 3),
        40,
        move |x| offset + sample.at(x),
    )
}

/// sum_k a_k cos(2 pi k.x + p) with whole k: each term belongs to the inputs that it has.
fn fourier(d: &mut Draw) -> Known {
    let n = d.count(2, 4);
    let terms: Vec<(f64, Vec<f64>, f64)> = (0..8)
        .map(|_| {
            let k: Vec<f64> = (0..n).map(|_| d.count(0, 2) as f64).collect();
            let size: f64 = 1.0 + k.iter().sum::<f64>();
            (d.coefficient() / size, k, d.range(0.0, 2.0 * PI))
        })
        .collect();
    let mut first_order = vec![0.0; n];
    let mut variance = 0.0;
    // Terms of the same k are one wave.
    for (m, (a, k, p)) in terms.iter().enumerate() {
        if k.iter().all(|k| *k == 0.0) {
            continue;
        }
        for (b, _, q) in terms.iter().filter(|(_, l, _)| l == k) {
            let energy = 0.5 * a * b * (p - q).cos();
            variance += energy;
            let mut inside = (0..n).filter(|i| terms[m].1[*i] != 0.0);
            if let (Some(input), None) = (inside.next(), inside.next()) {
                first_order[input] += energy;
            }
        }
    }
    Known {
        family: "fourier series",
        inputs: uniform(0.0, 1.0, n),
        first_order: first_order.iter().map(|v| v / variance).collect(),
        model: Box::new(move |x| {
            let angle = |k: &[f64]| 2.0 * PI * k.iter().zip(x).map(|(k, x)| k * x).sum::<f64>();
            2.0 + terms
                .iter()
                .map(|(a, k, p)| a * (angle(k) + p).cos())
                .sum::<f64>()
        }),
    }
}

/// A dozen monomials of up to three inputs and total degree four.
fn legendre(d: &mut Draw) -> Known {
    let n = d.count(3, 8);
    let monomial = |d: &mut Draw| {
        let mut degrees = vec![0i32; n];
        for _ in 0..d.count(1, 4) {
            degrees[d.count(0, n - 1)] += 1;
        }
        let factors = degrees.into_iter().enumerate().filter(|(_, k)| *k > 0);
        let factors = factors.map(|(i, k)| of(i, move |x: f64| x.powi(k)));
        let factors: Vec<Factor> = factors.collect();
        (d.coefficient() / factors.len() as f64, factors)
    };
    let mut terms: Vec<Term> = (0..12).map(|_| monomial(d)).collect();
    terms.push((d.range(-3.0, 3.0), vec![]));
    sum_of_products("random polynomial", uniform(-1.0, 1.0, n), &[], terms)
}

fn rational(d: &mut Draw) -> Known {
    let (a, b) = (d.many(6, -1.0, 1.0), d.many(6, 0.0, 1.5));
    on_grid("random rational", uniform(-1.0, 1.0, 3), 32, move |x| {
        let form = |a: &[f64]| {
            let squares = x.iter().zip(&a[..3]).map(|(x, a)| a * x * x);
            squares.sum::<f64>() + a[3] * x[0] + a[4] * x[1] + a[5] * x[2]
        };
        (0.5 + form(&a)) / (1.0 + form(&b).powi(2))
    })
}

fn logistic(d: &mut Draw) -> Known {
    let a = d.many(4, -3.0, 3.0);
    let threshold = d.range(-1.0, 1.0);
    on_grid("logistic", uniform(-1.0, 1.0, 4), 20, move |x| {
        1.0 / (1.0 + (threshold - x.iter().zip(&a).map(|(x, a)| a * x).sum::<f64>()).exp())
    })
}

/// A slope and four boxes on it.
fn boxes(d: &mut Draw) -> Known {
    let n = d.count(2, 4);
    let ends: Vec<f64> = [0.1, 0.2, 0.35, 0.45, 0.6, 0.7, 0.85].to_vec();
    let mut terms: Vec<Term> = (0..n)
        .map(|i| (d.coefficient(), vec![of(i, |x| x)]))
        .collect();
    for _ in 0..4 {
        let mut inside = Vec::new();
        for i in 0..n {
            let (low, high) = (ends[d.count(0, 3)], ends[d.count(4, 6)]);
            if d.count(0, 1) == 1 {
                inside.push(of(i, move |x| f64::from(x > low && x < high)));
            }
        }
        terms.push((0.5 * d.coefficient(), inside));
    }
    sum_of_products("boxes", uniform(0.0, 1.0, n), &ends, terms)
}

/// Returns a shape of nine on \[0, 1\].
fn shape(kind: usize, input: usize) -> Factor {
    match kind {
        0 => of(input, |x| x),
        1 => of(input, |x| x * x),
        2 => of(input, |x| x.powi(3)),
        3 => of(input, |x| x.exp() / (1f64.exp() - 1.0)),
        4 => of(input, |x| 0.5 * (2.0 * PI * x).sin()),
        5 => of(input, |x| f64::from(x > 0.5)),
        6 => of(input, |_| 0.0),
        7 => of(input, |x| 4.0 * (x - 0.5).powi(2)),
        _ => of(input, |x| 1.0 / ((10.0 - 1.0 / 1.1) * (x + 0.1))),
    }
}

/// A shape for each input, pairs of half as many, triples of a fifth as many; coefficients of two normals, one wide.
fn metafunction(d: &mut Draw) -> Known {
    let n = d.count(4, 10);
    let kinds: Vec<usize> = (0..n).map(|_| d.count(0, 8)).collect();
    let coefficient = |d: &mut Draw| {
        let wide = d.range(0.0, 1.0) < 0.3;
        d.coefficient() * if wide { 5.0 } else { 0.5 }
    };
    let mut terms: Vec<Term> = vec![(d.range(-5.0, 5.0), vec![])];
    // The last input's effect is never nothing, so that there is a variance.
    let of_input = |i: usize| {
        shape(
            if i + 1 == n {
                kinds[i].min(5)
            } else {
                kinds[i]
            },
            i,
        )
    };
    for i in 0..n {
        terms.push((coefficient(d), vec![of_input(i)]));
    }
    for (count, order) in [(n / 2, 2), (n / 5, 3)] {
        for _ in 0..count {
            let first = d.count(0, n - 1);
            let stride = d.count(1, n / order);
            let inputs: std::collections::BTreeSet<usize> =
                (0..order).map(|k| (first + k * stride) % n).collect();
            terms.push((coefficient(d), inputs.into_iter().map(of_input).collect()));
        }
    }
    sum_of_products("metafunction", uniform(0.0, 1.0, n), &[0.5], terms)
}
