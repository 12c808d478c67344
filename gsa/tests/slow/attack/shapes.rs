//! Shapes chosen to mislead: kinks off the axes, rare events, heavy tails, effects that no line shows, offsets.

use std::f64::consts::PI;

use gsa::law::distribution::Distribution;

use super::draw::{Draw, normal, uniform, x};
use super::exact::{Factor, Term, of, on_grid, sum_of_products};
use crate::known::Known;

/// Draws a model of every shape.
pub fn all(d: &mut Draw) -> Vec<Known> {
    let mut models = kinks_and_steps(d);
    models.extend(tails(d));
    models.extend(hidden(d));
    models.extend(limits(d));
    models
}

/// The largest of n uniforms: E\[max|x\] = (n - 1)/n + x^n/n, Var\[max\] = n/((n + 1)^2 (n + 2)).
fn largest(family: &'static str, n: usize, sign: f64) -> Known {
    let m = n as f64;
    let main = (1.0 / (2.0 * m + 1.0) - 1.0 / (m + 1.0).powi(2)) / (m * m);
    let variance = m / ((m + 1.0).powi(2) * (m + 2.0));
    Known {
        family,
        inputs: uniform(0.0, 1.0, n),
        first_order: vec![main / variance; n],
        model: Box::new(move |x| {
            let turned = |x: &f64| if sign > 0.0 { *x } else { 1.0 - *x };
            3.0 + sign * x.iter().map(turned).fold(0.0, f64::max)
        }),
    }
}

fn kinks_and_steps(d: &mut Draw) -> Vec<Known> {
    let n = d.count(2, 5);
    let at = d.many(n, 0.5, 0.95);
    let below = |i: usize, t: f64| of(i, move |x| f64::from(x < t));
    let mut rare: Vec<Term> = (0..4).map(|i| (1.0, vec![x(i)])).collect();
    rare.push((
        d.range(5.0, 20.0),
        (0..4).map(|i| of(i, |x| f64::from(x > 0.8))).collect(),
    ));
    let slopes = d.many(3, 0.3, 1.0);
    let threshold = d.range(-0.5, 0.5);
    // A gap that closes: the first input presses, the others say where.
    let gate = move |x: f64| (x - threshold).max(0.0);
    vec![
        largest("maximum", d.count(2, 6), 1.0),
        largest("minimum", d.count(2, 6), -1.0),
        sum_of_products(
            "indicator of a box",
            uniform(0.0, 1.0, n),
            &at,
            vec![(1.0, (0..n).map(|i| below(i, at[i])).collect())],
        ),
        sum_of_products("rare corner", uniform(0.0, 1.0, 4), &[0.8], rare),
        sum_of_products(
            "switch",
            uniform(-1.0, 1.0, 3),
            &[0.0],
            vec![
                (1.0, vec![x(0), of(2, |x| f64::from(x > 0.0))]),
                (1.0, vec![x(1), of(2, |x| f64::from(x <= 0.0))]),
            ],
        ),
        sum_of_products(
            "contact",
            normal(3),
            &[threshold],
            vec![
                (slopes[0], vec![of(0, gate)]),
                (slopes[1], vec![of(0, gate), of(1, |x| (0.3 * x).exp())]),
                (slopes[2], vec![of(2, gate)]),
            ],
        ),
        sum_of_products(
            "rastrigin",
            uniform(-5.12, 5.12, 3),
            // Panels of half a wave.
            &[-4.0, -3.0, -2.0, -1.0, 1.0, 2.0, 3.0, 4.0],
            slopes
                .iter()
                .enumerate()
                .map(|(i, a)| {
                    let steep = [1.0, 0.6, 1.5][i];
                    (
                        *a,
                        vec![of(i, move |x| x * x - 10.0 * (2.0 * PI * steep * x).cos())],
                    )
                })
                .collect(),
        ),
    ]
}

fn tails(d: &mut Draw) -> Vec<Known> {
    let laws = || {
        [
            Distribution::lognormal(0.0, 1.5),
            Distribution::weibull(0.7, 1.0),
            Distribution::gumbel(2.0, 1.0),
            Distribution::exponential(1.0),
            Distribution::gamma(0.5, 2.0),
        ]
        .map(|law| law.expect("a valid law"))
        .to_vec()
    };
    let a = d.many(5, 0.2, 2.0);
    let sum = |a: &[f64]| (0..5).map(|i| (a[i], vec![x(i)])).collect::<Vec<Term>>();
    let mut mixed = sum(&a);
    mixed.push((0.3, vec![x(0), x(1)]));
    mixed.push((0.3, vec![x(2), x(4)]));
    let widths = d.many(3, 0.5, 1.5);
    let lognormals = |widths: &[f64]| -> Vec<Distribution> {
        widths
            .iter()
            .map(|s| Distribution::lognormal(0.0, *s).expect("a valid law"))
            .collect()
    };
    let ratio = Distribution::uniform(0.2, 3.0).expect("a valid law");
    vec![
        sum_of_products(
            "heavy tails, product",
            laws(),
            &[],
            vec![(1.0, (0..5).map(x).collect())],
        ),
        sum_of_products("heavy tails, sum", laws(), &[], sum(&a)),
        sum_of_products("heavy tails, pairs", laws(), &[], mixed),
        sum_of_products(
            "logarithms of lognormals",
            lognormals(&widths),
            &[],
            vec![
                (1.0, vec![of(0, f64::ln), x(1)]),
                (1.0, vec![of(1, f64::ln)]),
                (1.0, vec![of(2, |x| x.sqrt())]),
            ],
        ),
        sum_of_products(
            "squared tails",
            lognormals(&[0.6, 0.9]),
            &[],
            vec![
                (1.0, vec![of(0, |x| x * x)]),
                (1.0, vec![of(1, |x| x * x)]),
                (0.5, vec![x(0), x(1)]),
            ],
        ),
        on_grid("ratio", vec![ratio; 3], 24, |x| x[0] / (x[1] + x[2])),
    ]
}

fn hidden(d: &mut Draw) -> Vec<Known> {
    let n = d.count(3, 6);
    let a = d.many(n, 0.5, 2.0);
    let chain = |own: f64| -> Vec<Term> {
        let pair = |i: usize| (a[i], vec![x(i), x(i + 1)]);
        let alone = |i: usize| (own, vec![x(i)]);
        (0..n - 1).map(pair).chain((0..n).map(alone)).collect()
    };
    let centred = uniform(-1.0, 1.0, n);
    // Zero and flat at the cut point, large away from it.
    let well = |i: usize| of(i, |x: f64| x.powi(4));
    let everywhere: Vec<Factor> = (0..n).map(x).collect();
    vec![
        sum_of_products("pairs alone", centred.clone(), &[], chain(0.0)),
        sum_of_products("pairs and a little alone", centred.clone(), &[], chain(0.1)),
        sum_of_products(
            "all at once",
            centred.clone(),
            &[],
            vec![(20.0, everywhere), (1.0, vec![x(0)])],
        ),
        sum_of_products(
            "wells",
            centred,
            &[],
            vec![
                (10.0, vec![well(0), well(1)]),
                (1.0, vec![well(2)]),
                (3.0, vec![well(0), of(2, |x| x * x)]),
            ],
        ),
        sum_of_products(
            "waves that nodes alias",
            uniform(0.0, 1.0, 3),
            &[],
            (0..3)
                .map(|i| {
                    let f = d.range(3.0, 9.0);
                    (
                        1.0,
                        vec![
                            of(i, move |x| (2.0 * PI * f * x).sin()),
                            of((i + 1) % 3, |x| 1.0 + x),
                        ],
                    )
                })
                .collect(),
        ),
    ]
}

fn limits(d: &mut Draw) -> Vec<Known> {
    let ishigami = || {
        let terms = vec![
            (1.0, vec![of(0, f64::sin)]),
            (7.0, vec![of(1, |x| x.sin().powi(2))]),
            (0.1, vec![of(0, f64::sin), of(2, |x| x.powi(4))]),
        ];
        sum_of_products("", uniform(-PI, PI, 3), &[], terms)
    };
    let slopes = d.many(20, -0.4, 0.4);
    let many = (0..20).map(|i| {
        let a = slopes[i];
        of(i, move |x| 1.0 + a * x)
    });
    let (a, at) = (d.range(0.5, 3.0), d.range(0.1, 0.9));
    vec![
        ishigami().raised("ishigami and 1e3", 1e3),
        ishigami().raised("ishigami and 1e9", 1e9),
        sum_of_products(
            "one input",
            normal(1),
            &[],
            vec![(1.0, vec![of(0, move |x| (a * x).exp())])],
        ),
        sum_of_products(
            "one input, step",
            uniform(0.0, 1.0, 1),
            &[at],
            vec![(1.0, vec![of(0, move |x| f64::from(x < at))])],
        ),
        sum_of_products(
            "twenty inputs, product",
            uniform(-1.0, 1.0, 20),
            &[],
            vec![(1.0, many.collect())],
        ),
    ]
}
