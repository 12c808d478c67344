//! Test functions of the field, and shapes chosen to mislead. They came after the claims, which were since judged by them.
//!
//! Sources: "morris" M. D. Morris, Technometrics 33 (1991) 161; "oakley-o'hagan" J. Oakley and A. O'Hagan, J. R. Statist. Soc. B
//! 66 (2004) 751, coefficients drawn; "bratley" P. Bratley, B. L. Fox, H. Niederreiter, ACM TOMACS 2 (1992) 195; "welch"
//! W. J. Welch et al., Technometrics 34 (1992) 15; "friedman" J. H. Friedman, Ann. Statist. 19 (1991) 1; "G*" A. Saltelli et
//! al., Comput. Phys. Commun. 181 (2010) 259; "genz" A. Genz, Lecture Notes in Computer Science 201 (1984) 81.

use std::f64::consts::PI;

use super::draw::{Draw, normal, uniform, x};
use super::exact::{Factor, Term, of, on_grid, sum_of_products};
use super::shapes;
use crate::known::Known;

/// Draws a model of every family for a seed.
pub fn all(seed: u64) -> Vec<Known> {
    let mut d = Draw::new(seed);
    let mut models = classics(&mut d);
    models.extend(genz(&mut d));
    models.extend(shapes::all(&mut d));
    models
}

fn classics(d: &mut Draw) -> Vec<Known> {
    vec![
        morris(d),
        oakley_ohagan(d),
        bratley(d),
        welch(),
        friedman(d),
        g_star(d),
    ]
}

fn morris(d: &mut Draw) -> Known {
    let factor = |i: usize| match i {
        2 | 4 | 6 => of(i, |x| 2.0 * (1.1 * x / (x + 0.1) - 0.5)),
        _ => of(i, |x| 2.0 * (x - 0.5)),
    };
    let mut terms: Vec<Term> = Vec::new();
    for i in 0..20 {
        let a = if i < 10 { 20.0 } else { d.coefficient() };
        terms.push((a, vec![factor(i)]));
        for j in i + 1..20 {
            let a = if j < 6 { -15.0 } else { d.coefficient() };
            terms.push((a, vec![factor(i), factor(j)]));
            terms.extend((j + 1..5).map(|k| (-10.0, vec![factor(i), factor(j), factor(k)])));
        }
    }
    terms.push((5.0, (0..4).map(factor).collect()));
    sum_of_products("morris", uniform(0.0, 1.0, 20), &[], terms)
}

fn oakley_ohagan(d: &mut Draw) -> Known {
    let mut terms = Vec::new();
    for i in 0..15 {
        let size = [0.1, 0.5, 1.5][i / 5];
        let (a, b, c) = (
            size * d.coefficient(),
            size * d.coefficient(),
            size * d.coefficient(),
        );
        terms.push((1.0, vec![of(i, move |x| a * x + b * x.sin() + c * x.cos())]));
        for j in 0..15 {
            let a = 0.1 * d.coefficient();
            terms.push(match i == j {
                true => (a, vec![of(i, |x| x * x)]),
                false => (a, vec![x(i), x(j)]),
            });
        }
    }
    sum_of_products("oakley-o'hagan", normal(15), &[], terms)
}

fn bratley(d: &mut Draw) -> Known {
    let n = d.count(3, 10);
    let term = |i: usize| ((-1.0f64).powi(i as i32), (0..i).map(x).collect());
    sum_of_products(
        "bratley",
        uniform(0.0, 1.0, n),
        &[],
        (1..=n).map(term).collect(),
    )
}

fn welch() -> Known {
    let mut terms: Vec<Term> = vec![
        (5.0, vec![of(0, |x| 1.0 / (1.0 + x)), x(11)]),
        (5.0, vec![of(3, |x| x * x)]),
        (-10.0, vec![x(3), x(19)]),
        (5.0, vec![of(19, |x| x * x)]),
        (1.0, vec![of(18, |x| 40.0 * x * x * x - 5.0 * x)]),
        (0.25, vec![of(12, |x| x * x)]),
    ];
    let linear = [
        (4, 1.0),
        (1, 0.05),
        (2, 0.08),
        (5, -0.03),
        (6, 0.03),
        (8, -0.09),
        (9, -0.01),
        (10, -0.07),
        (13, -0.04),
        (14, 0.06),
        (16, -0.01),
        (17, -0.03),
    ];
    terms.extend(linear.map(|(i, a)| (a, vec![x(i)])));
    sum_of_products("welch", uniform(-0.5, 0.5, 20), &[], terms)
}

/// 10 sin(pi x1 x2) + 20 (x3 - 1/2)^2 + 10 x4 + 5 x5 with drawn weights; ten nodes leave 1e-12 of them.
fn friedman(d: &mut Draw) -> Known {
    let a = d.many(4, 0.5, 1.5);
    on_grid("friedman", uniform(0.0, 1.0, 5), 10, move |x| {
        10.0 * a[0] * (PI * x[0] * x[1]).sin()
            + 20.0 * a[1] * (x[2] - 0.5).powi(2)
            + 10.0 * a[2] * x[3]
            + 5.0 * a[3] * x[4]
    })
}

/// prod ((1 + alpha) |2 (x + d - floor(x + d)) - 1|^alpha + a)/(1 + a): V_i = alpha^2/((1 + 2 alpha)(1 + a)^2).
fn g_star(d: &mut Draw) -> Known {
    let n = d.count(2, 8);
    let alpha = [0.5, 1.0, 2.0][d.count(0, 2)];
    let (a, shift) = (d.many(n, 0.0, 9.0), d.many(n, 0.0, 1.0));
    let v: Vec<f64> = a
        .iter()
        .map(|a| alpha * alpha / ((1.0 + 2.0 * alpha) * (1.0 + a).powi(2)))
        .collect();
    let variance = v.iter().map(|v| 1.0 + v).product::<f64>() - 1.0;
    Known {
        family: "G*",
        inputs: uniform(0.0, 1.0, n),
        first_order: v.iter().map(|v| v / variance).collect(),
        model: Box::new(move |x| {
            let g = |i: usize| {
                let place = (x[i] + shift[i]).fract();
                ((1.0 + alpha) * (2.0 * place - 1.0).abs().powf(alpha) + a[i]) / (1.0 + a[i])
            };
            (0..x.len()).map(g).product()
        }),
    }
}

fn genz(d: &mut Draw) -> Vec<Known> {
    let n = d.count(2, 6);
    let (c, w) = (d.many(n, 0.5, 4.0), d.many(n, 0.2, 1.0));
    let (c, w) = (&c, &w);
    let phase = 2.0 * PI * w[0];
    // cos(p + sum c x) by angle addition: the real part of a product of n complex factors has 2^n real terms.
    let oscillating = (0..1usize << n).map(|sines| {
        let quarter = sines.count_ones() as usize;
        let sign = [phase.cos(), -phase.sin(), -phase.cos(), phase.sin()][quarter % 4];
        let factor = |i: usize| {
            let c = c[i];
            match sines >> i & 1 {
                1 => of(i, move |x| (c * x).sin()),
                _ => of(i, move |x| (c * x).cos()),
            }
        };
        (sign, (0..n).map(factor).collect())
    });
    let cube = || uniform(0.0, 1.0, n);
    let each = |f: &dyn Fn(f64, f64) -> Factor| {
        vec![(
            1.0,
            (0..n)
                .map(|i| {
                    let factor = f(c[i], w[i]);
                    Factor { input: i, ..factor }
                })
                .collect(),
        )]
    };
    let corner = d.many(3, 0.5, 3.0);
    vec![
        sum_of_products("genz oscillatory", cube(), &[], oscillating.collect()),
        sum_of_products(
            "genz product peak",
            cube(),
            &[],
            each(&|c, w| of(0, move |x| 1.0 / (c.powi(-2) + (x - w).powi(2)))),
        ),
        sum_of_products(
            "genz gaussian peak",
            cube(),
            &[],
            each(&|c, w| of(0, move |x| (-(c * (x - w)).powi(2)).exp())),
        ),
        sum_of_products(
            "genz continuous",
            cube(),
            w,
            each(&|c, w| of(0, move |x| (-c * (x - w).abs()).exp())),
        ),
        sum_of_products(
            "genz discontinuous",
            cube(),
            w,
            each(&|c, w| of(0, move |x| if x < w { (c * x).exp() } else { 0.0 })),
        ),
        on_grid("genz corner peak", uniform(0.0, 1.0, 3), 24, move |x| {
            (1.0 + x.iter().zip(&corner).map(|(x, c)| x * c).sum::<f64>()).powi(-4)
        }),
    ]
}
