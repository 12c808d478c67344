//! Surfaces on which surrogates and indices are compared.
//!
//! Sources: "roos-arnold" and "sobol, polynomial" in T. Crestaux, O. Le Maitre, J.-M. Martinez, Reliab. Eng. Syst. Saf. 94 (2009)
//! 1161; "sobol-levitan" I. Sobol, Y. Levitan, Comput. Phys. Commun. 117 (1999) 52; "loeppky" J. Loeppky, D. Williams, B. Williams,
//! Technometrics 55 (2013) 90; "zhou" Y. Zhou (1998); "dette-pepelyshev" H. Dette, A. Pepelyshev, Technometrics 52 (2010) 421; "linkletter"
//! C. Linkletter et al., Technometrics 48 (2006) 478; "currin" C. Currin et al., ORNL-6498 (1988); "franke" R. Franke, NPS-53-79-003
//! (1979); "lim" Y. Lim et al., Canad. J. Statist. 30 (2002) 109; "park" J.-S. Park (1991); "gramacy-lee" R. Gramacy, H. Lee,
//! Technometrics 51 (2009) 130; "portfolio" A. Saltelli et al., Global Sensitivity Analysis: The Primer (2008); "branin", "camel",
//! "rosenbrock" and "griewank" are older.

use std::f64::consts::PI;

use gsa::law::distribution::Distribution;

use crate::attack::draw::{Draw, uniform, x};
use crate::attack::exact::{Factor, Term, of, on_grid, sum_of_products};
use crate::known::Known;

/// Draws a model of every surface.
pub fn all(d: &mut Draw) -> Vec<Known> {
    let mut models = products_and_sums(d);
    models.extend(dette_pepelyshev());
    models.extend(of_two_inputs(d));
    models.extend(of_more(d));
    models
}

fn power(input: usize, exponent: i32) -> Factor {
    of(input, move |x| x.powi(exponent))
}

fn exponential(input: usize, rate: f64) -> Factor {
    of(input, move |x| (rate * x).exp())
}

fn products_and_sums(d: &mut Draw) -> Vec<Known> {
    let n = d.count(2, 5);
    let b = d.many(6, 0.2, 1.5);
    let constant: f64 = b.iter().map(|b| b.exp_m1() / b).product();
    let (fast, slow) = (d.range(3.0, 8.0), d.range(0.5, 2.0));
    let decreasing = |i: i32| (0.2 / 2f64.powi(i), vec![x(i as usize)]);
    let loeppky: Vec<Term> = [6.0, 4.0, 5.5, 1.0, 0.5, 0.2, 0.1]
        .iter()
        .enumerate()
        .map(|(i, a)| (*a, vec![x(i)]))
        .chain([
            (3.0, vec![x(0), x(1)]),
            (2.2, vec![x(0), x(2)]),
            (1.4, vec![x(1), x(2)]),
        ])
        .collect();
    let kinked = |i: usize| of(i, |x: f64| (4.0 * x - 2.0).abs());
    let polynomial = |i: usize| of(i, |x| 0.5 * (3.0 * x * x + 1.0));
    vec![
        sum_of_products(
            "roos-arnold",
            uniform(0.0, 1.0, n),
            &[0.5],
            vec![(1.0, (0..n).map(kinked).collect())],
        ),
        sum_of_products(
            "sobol, polynomial",
            uniform(0.0, 1.0, n),
            &[],
            vec![(1.0, (0..n).map(polynomial).collect())],
        ),
        sum_of_products(
            "sobol-levitan",
            uniform(0.0, 1.0, 6),
            &[],
            vec![
                (1.0, (0..6).map(|i| exponential(i, b[i])).collect()),
                (-constant, vec![]),
            ],
        ),
        sum_of_products("loeppky", uniform(0.0, 1.0, 10), &[], loeppky),
        sum_of_products(
            "linkletter, sines",
            uniform(0.0, 1.0, 10),
            &[],
            vec![
                (1.0, vec![of(0, move |x| (slow * x).sin())]),
                (1.0, vec![of(1, move |x| (fast * x).sin())]),
            ],
        ),
        sum_of_products(
            "linkletter, decreasing",
            uniform(0.0, 1.0, 10),
            &[],
            (0..8).map(decreasing).collect(),
        ),
    ]
}

fn dette_pepelyshev() -> Vec<Known> {
    let decay = |i: usize, exponent: f64| of(i, move |x: f64| (-2.0 / x.powf(exponent)).exp());
    vec![
        on_grid("dette-pepelyshev, curved", uniform(0.0, 1.0, 3), 24, |x| {
            4.0 * (x[0] - 2.0 + 8.0 * x[1] * (1.0 - x[1])).powi(2)
                + (3.0 - 4.0 * x[1]).powi(2)
                + 16.0 * (x[2] + 1.0).sqrt() * (2.0 * x[2] - 1.0).powi(2)
        }),
        sum_of_products(
            "dette-pepelyshev, exponential",
            uniform(0.0, 1.0, 3),
            &[],
            [1.75, 1.5, 1.25]
                .iter()
                .enumerate()
                .map(|(i, e)| (100.0, vec![decay(i, *e)]))
                .collect(),
        ),
        // Logarithms of sums from 1 on: six nodes leave 1e-7.
        on_grid("dette-pepelyshev, eight", uniform(0.0, 1.0, 8), 6, |x| {
            let mut sum = 1.0 + x[2];
            let mut y = 4.0 * (x[0] - 2.0 + 8.0 * x[1] * (1.0 - x[1])).powi(2)
                + (3.0 - 4.0 * x[1]).powi(2)
                + 16.0 * (x[2] + 1.0).sqrt() * (2.0 * x[2] - 1.0).powi(2);
            for (i, x) in x.iter().enumerate().skip(3) {
                sum += x;
                y += (i + 1) as f64 * sum.ln();
            }
            y
        }),
    ]
}

fn of_two_inputs(d: &mut Draw) -> Vec<Known> {
    let bell = |i: usize, a: f64, b: f64, width: f64| {
        of(i, move |x: f64| (-(a * x + b).powi(2) / width).exp())
    };
    let rational = |x: f64| {
        let above = ((2300.0 * x + 1900.0) * x + 2092.0) * x + 60.0;
        above / (((100.0 * x + 500.0) * x + 4.0) * x + 20.0)
    };
    let constant = d.range(-2.0, 2.0);
    vec![
        sum_of_products(
            "currin",
            uniform(0.0, 1.0, 2),
            &[],
            vec![(
                1.0,
                vec![of(0, rational), of(1, |x: f64| -(-0.5 / x).exp_m1())],
            )],
        ),
        sum_of_products(
            "franke",
            uniform(0.0, 1.0, 2),
            &[],
            vec![
                (0.75, vec![bell(0, 9.0, -2.0, 4.0), bell(1, 9.0, -2.0, 4.0)]),
                (0.75, vec![bell(0, 9.0, 1.0, 49.0), exponential(1, -0.9)]),
                (0.5, vec![bell(0, 9.0, -7.0, 4.0), bell(1, 9.0, -3.0, 4.0)]),
                (-0.2, vec![bell(0, 9.0, -4.0, 1.0), bell(1, 9.0, -7.0, 1.0)]),
            ],
        ),
        on_grid(
            "branin",
            vec![
                Distribution::uniform(-5.0, 10.0).expect("a valid law"),
                Distribution::uniform(0.0, 15.0).expect("a valid law"),
            ],
            40,
            |x| {
                let valley = x[1] - 5.1 / (4.0 * PI * PI) * x[0] * x[0] + 5.0 / PI * x[0] - 6.0;
                valley.powi(2) + 10.0 * (1.0 - 0.125 / PI) * x[0].cos() + 10.0
            },
        ),
        sum_of_products(
            "camel",
            vec![
                Distribution::uniform(-2.0, 2.0).expect("a valid law"),
                Distribution::uniform(-1.0, 1.0).expect("a valid law"),
            ],
            &[],
            vec![
                (
                    1.0,
                    vec![of(0, |x| x * x * (4.0 - 2.1 * x * x + x.powi(4) / 3.0))],
                ),
                (1.0, vec![x(0), x(1)]),
                (4.0, vec![of(1, |x| x * x * (x * x - 1.0))]),
            ],
        ),
        sum_of_products(
            "lim, polynomial",
            uniform(0.0, 1.0, 2),
            &[],
            vec![
                (1.0, vec![of(0, |x| 9.0 + 2.5 * x - 7.5 * x.powi(3))]),
                (
                    1.0,
                    vec![of(1, |x| -17.5 * x + 19.0 * x * x - 5.5 * x.powi(4))],
                ),
                (2.5, vec![x(0), x(1)]),
                (-2.5, vec![x(0), power(1, 2)]),
                (1.0, vec![power(0, 3), power(1, 2)]),
            ],
        ),
        sum_of_products(
            "lim, shifted",
            uniform(0.0, 1.0, 2),
            &[],
            vec![
                (
                    1.0 / 6.0,
                    vec![
                        of(0, |x| 30.0 + 5.0 * x * (5.0 * x).sin()),
                        of(1, |x| 4.0 + (-5.0 * x).exp()),
                    ],
                ),
                (constant - 100.0 / 6.0, vec![]),
            ],
        ),
    ]
}

fn of_more(d: &mut Draw) -> Vec<Known> {
    let n = d.count(2, 3);
    let bell = |i: usize, at: f64| of(i, move |x: f64| (-50.0 * (x - at).powi(2)).exp());
    let peaks = [1.0 / 3.0, 2.0 / 3.0];
    let height = 0.5 * 10f64.powi(n as i32) / (2.0 * PI).powf(0.5 * n as f64);
    let peak = |at: &f64| (height, (0..n).map(|i| bell(i, *at)).collect());
    let zhou = sum_of_products(
        "zhou",
        uniform(0.0, 1.0, n),
        &peaks,
        peaks.iter().map(peak).collect(),
    );
    let m = d.count(3, 6);
    let valley = |i: usize| -> [Term; 3] {
        [
            (100.0, vec![power(i + 1, 2)]),
            (-200.0, vec![x(i + 1), power(i, 2)]),
            (1.0, vec![of(i, |x| 100.0 * x.powi(4) + (1.0 - x).powi(2))]),
        ]
    };
    let waves = (0..3).map(|i| of(i, move |x: f64| (x / ((i + 1) as f64).sqrt()).cos()));
    let mut griewank: Vec<Term> = vec![(-1.0, waves.collect())];
    griewank.extend((0..3).map(|i| (1.0 / 4000.0, vec![power(i, 2)])));
    let shares = d.many(3, -1.0, 2.0);
    let spread = d.many(3, 0.3, 1.5);
    let laws = (0..6).map(|k| match k {
        0..3 => Distribution::normal(shares[k], 0.5),
        _ => Distribution::normal(0.0, spread[k - 3]),
    });
    let laws: Vec<Distribution> = laws.map(|law| law.expect("a valid law")).collect();
    vec![
        zhou,
        sum_of_products(
            "rosenbrock",
            uniform(-2.0, 2.0, m),
            &[],
            (0..m - 1).flat_map(valley).collect(),
        ),
        sum_of_products("griewank", uniform(-5.0, 5.0, 3), &[], griewank),
        sum_of_products(
            "portfolio",
            laws,
            &[],
            (0..3).map(|i| (1.0, vec![x(i), x(i + 3)])).collect(),
        ),
        // Its root is singular where the first input vanishes: 32 nodes leave 1e-6.
        on_grid("park, first", uniform(0.0, 1.0, 4), 24, |x| {
            let root = (x[0] * x[0] + (x[1] + x[2] * x[2]) * x[3]).sqrt();
            0.5 * (root - x[0]) + (x[0] + 3.0 * x[3]) * (1.0 + x[2].sin()).exp()
        }),
        sum_of_products(
            "park, second",
            uniform(0.0, 1.0, 4),
            &[],
            vec![
                (2.0 / 3.0, vec![exponential(0, 1.0), exponential(1, 1.0)]),
                (-1.0, vec![x(3), of(2, f64::sin)]),
                (1.0, vec![x(2)]),
            ],
        ),
        sum_of_products(
            "gramacy-lee",
            uniform(0.0, 1.0, 6),
            &[],
            vec![
                (
                    1.0,
                    vec![of(0, |x| (0.9 * (x + 0.48)).powi(10).sin().exp())],
                ),
                (1.0, vec![x(1), x(2)]),
                (1.0, vec![x(3)]),
            ],
        ),
    ]
}
