//! Families that the constants of claims were set on.

use std::f64::consts::PI;

use gsa::law::distribution::Distribution;

use crate::families::draw::Draw;
use crate::families::model::Model;
use crate::families::printing::Printing;

/// Draws a model of every family for a seed.
pub fn all(seed: u64) -> Vec<Model> {
    let mut d = Draw::new(seed + 100);
    let mut models = printed(&mut d);
    models.extend(flat(&mut d));
    models.extend(failed(&mut d));
    models
}

fn uniform(low: f64, high: f64, n: usize) -> Vec<Distribution> {
    vec![Distribution::uniform(low, high).expect("a valid law"); n]
}

fn printing(d: &mut Draw) -> Printing {
    let digits = d.count(3, 8);
    match d.count(0, 2) {
        0 => Printing::Significant(digits),
        1 => Printing::Scientific(digits),
        _ => Printing::Decimals(digits - 2),
    }
}

fn printed(d: &mut Draw) -> Vec<Model> {
    let group = "printed digits";
    let offset = [0.0, 10.0, 100.0, 1000.0][d.count(0, 3)];
    let (a, b, c) = (d.range(0.1, 2.0), d.range(0.1, 2.0), d.range(0.1, 1.0));
    vec![
        Model::new((group, "sum"), uniform(0.0, 1.0, 2), move |x| {
            offset + a * x[0] + b * x[1]
        })
        .printed(printing(d)),
        Model::new((group, "sum of three"), uniform(0.0, 1.0, 3), move |x| {
            offset + a * x[0] + b * x[1] * x[1] + c * (PI * x[2]).sin()
        })
        .printed(printing(d)),
        Model::new((group, "product"), uniform(0.5, 1.5, 3), move |x| {
            10.0 * x[0].powf(a) * x[1].powf(b) / x[2].powf(c)
        })
        .printed(printing(d)),
        Model::new((group, "interaction"), uniform(-1.0, 1.0, 2), move |x| {
            offset + a * x[0] + b * x[1] + c * x[0] * x[1]
        })
        .printed(printing(d)),
        Model::new((group, "exponential"), uniform(0.0, 1.0, 3), move |x| {
            (a * x[0] - b * x[1] + c * x[2]).exp()
        })
        .printed(printing(d)),
    ]
}

fn flat(d: &mut Draw) -> Vec<Model> {
    let group = "flat line at the cut";
    let laws = |at: f64, most: f64| {
        vec![
            Distribution::uniform(at - 1.0, at + 1.0).expect("a valid law"),
            Distribution::uniform(0.0, most).expect("a valid law"),
        ]
    };
    let (most, a) = (d.range(1.0, 8.0), d.range(0.0, 1.0));
    let near = d.range(-0.1, 0.1);
    let three = |at: f64| {
        let mut laws = laws(at, most);
        laws.extend(uniform(0.0, 1.0, 1));
        laws
    };
    vec![
        Model::new((group, "exp(-k^2 t)"), laws(0.0, most), |x| {
            (-x[0] * x[0] * x[1]).exp()
        }),
        Model::new((group, "exp(-k^2 t), nearly"), laws(near, most), |x| {
            (-x[0] * x[0] * x[1]).exp()
        }),
        Model::new((group, "k^2 t"), laws(0.0, most), move |x| {
            1.0 + a * x[0] + x[0] * x[0] * x[1]
        }),
        Model::new((group, "|k| t"), laws(0.0, most), move |x| {
            2.0 + x[0].abs() * (a + x[1])
        }),
        Model::new((group, "cos(k t)"), laws(0.0, most), |x| {
            (x[0] * x[1]).cos()
        }),
        Model::new((group, "1/(1 + k^2 t)"), laws(near, most), |x| {
            1.0 / (1.0 + x[0] * x[0] * x[1])
        }),
        Model::new((group, "k^2 t + s"), three(0.0), move |x| {
            1.0 + x[0] * x[0] * x[1] + a * x[2]
        }),
        Model::new((group, "exp(-k^2 t s)"), three(near), |x| {
            (-x[0] * x[0] * x[1] * x[2]).exp()
        }),
    ]
}

fn failed(d: &mut Draw) -> Vec<Model> {
    let groups = ["failed runs", "failed runs, another law there"];
    let mut models = Vec::new();
    for (group, rough) in groups.into_iter().zip([0.0, 1.0]) {
        let beyond = rough * d.range(0.5, 4.0);
        let (a, b) = (d.range(0.2, 1.0), d.range(0.2, 1.0));
        let edge = d.range(0.5, 0.97);
        models.push(
            Model::new((group, "slab"), uniform(0.0, 1.0, 2), move |x| {
                1.0 + a * x[0] + b * x[1] + beyond * (x[0] - edge).max(0.0).powi(2)
            })
            .failing(move |x| x[0] > edge),
        );
        let level = d.range(1.0, 1.8);
        models.push(
            Model::new((group, "corner"), uniform(0.0, 1.0, 2), move |x| {
                (a * x[0]).exp() * (1.0 + b * x[1]) + beyond * (x[0] + x[1] - level).max(0.0)
            })
            .failing(move |x| x[0] + x[1] > level),
        );
        let gap = d.range(-0.2, 0.7);
        models.push(
            Model::new((group, "half"), uniform(0.0, 1.0, 3), move |x| {
                x[0] + a * x[1] + b * x[1] * x[2] + beyond * (x[0] - x[1] - gap).max(0.0).powi(2)
            })
            .failing(move |x| x[0] - x[1] > gap),
        );
        let radius = d.range(0.9, 1.3);
        models.push(
            Model::new((group, "outside a ball"), uniform(-1.0, 1.0, 3), move |x| {
                let r = x.iter().map(|x| x * x).sum::<f64>().sqrt();
                2.0 + x[0] + a * x[1] * x[1] - b * x[2] - beyond * (r - radius).max(0.0)
            })
            .failing(move |x| x.iter().map(|x| x * x).sum::<f64>().sqrt() > radius),
        );
        let share = d.range(0.02, 0.3);
        models.push(
            Model::new((group, "anywhere"), uniform(0.0, 1.0, 3), move |x| {
                (a * x[0] + x[1]).exp() + b * x[2]
            })
            .failing(move |x| {
                let mixed: f64 = x.iter().map(|x| 1e4 * x.sin()).sum();
                mixed.rem_euclid(1.0) < share
            }),
        );
    }
    models
}
