//! Families that the constants of claims were set on from the beginning.

use std::f64::consts::PI;

use crate::families::draw::Draw;
use crate::families::frame::Families;
use crate::families::laws::{around, between};
use crate::families::model::Model;
use crate::families::printing::Printing;

pub const FAMILIES: Families = Families {
    source: 100,
    printed,
    flat,
    singular: |_| Vec::new(),
    failed,
};

fn printed(d: &mut Draw) -> Vec<Model> {
    let offset = [0.0, 10.0, 100.0, 1000.0][d.count(0, 3)];
    let (a, b, c) = (d.range(0.1, 2.0), d.range(0.1, 2.0), d.range(0.1, 1.0));
    vec![
        Model::new("sum", vec![between(0.0, 1.0); 2], move |x| {
            offset + a * x[0] + b * x[1]
        })
        .printed(Printing::any(d)),
        Model::new("sum of three", vec![between(0.0, 1.0); 3], move |x| {
            offset + a * x[0] + b * x[1] * x[1] + c * (PI * x[2]).sin()
        })
        .printed(Printing::any(d)),
        Model::new("product", vec![between(0.5, 1.5); 3], move |x| {
            10.0 * x[0].powf(a) * x[1].powf(b) / x[2].powf(c)
        })
        .printed(Printing::any(d)),
        Model::new("interaction", vec![between(-1.0, 1.0); 2], move |x| {
            offset + a * x[0] + b * x[1] + c * x[0] * x[1]
        })
        .printed(Printing::any(d)),
        Model::new("exponential", vec![between(0.0, 1.0); 3], move |x| {
            (a * x[0] - b * x[1] + c * x[2]).exp()
        })
        .printed(Printing::any(d)),
    ]
}

fn flat(d: &mut Draw) -> Vec<Model> {
    let laws = |at: f64, most: f64| vec![around(at), between(0.0, most)];
    let (most, a) = (d.range(1.0, 8.0), d.range(0.0, 1.0));
    let near = d.range(-0.1, 0.1);
    let three = |at: f64| {
        let mut laws = laws(at, most);
        laws.push(between(0.0, 1.0));
        laws
    };
    vec![
        Model::new("exp(-k^2 t)", laws(0.0, most), |x| {
            (-x[0] * x[0] * x[1]).exp()
        }),
        Model::new("exp(-k^2 t), nearly", laws(near, most), |x| {
            (-x[0] * x[0] * x[1]).exp()
        }),
        Model::new("k^2 t", laws(0.0, most), move |x| {
            1.0 + a * x[0] + x[0] * x[0] * x[1]
        }),
        Model::new("|k| t", laws(0.0, most), move |x| {
            2.0 + x[0].abs() * (a + x[1])
        }),
        Model::new("cos(k t)", laws(0.0, most), |x| (x[0] * x[1]).cos()),
        Model::new("1/(1 + k^2 t)", laws(near, most), |x| {
            1.0 / (1.0 + x[0] * x[0] * x[1])
        }),
        Model::new("k^2 t + s", three(0.0), move |x| {
            1.0 + x[0] * x[0] * x[1] + a * x[2]
        }),
        Model::new("exp(-k^2 t s)", three(near), |x| {
            (-x[0] * x[0] * x[1] * x[2]).exp()
        }),
    ]
}

fn failed(d: &mut Draw, rough: f64) -> Vec<Model> {
    let mut models = Vec::new();
    let beyond = rough * d.range(0.5, 4.0);
    let (a, b) = (d.range(0.2, 1.0), d.range(0.2, 1.0));
    let edge = d.range(0.5, 0.97);
    models.push(
        Model::new("slab", vec![between(0.0, 1.0); 2], move |x| {
            1.0 + a * x[0] + b * x[1] + beyond * (x[0] - edge).max(0.0).powi(2)
        })
        .failing(move |x| x[0] > edge),
    );
    let level = d.range(1.0, 1.8);
    models.push(
        Model::new("corner", vec![between(0.0, 1.0); 2], move |x| {
            (a * x[0]).exp() * (1.0 + b * x[1]) + beyond * (x[0] + x[1] - level).max(0.0)
        })
        .failing(move |x| x[0] + x[1] > level),
    );
    let gap = d.range(-0.2, 0.7);
    models.push(
        Model::new("half", vec![between(0.0, 1.0); 3], move |x| {
            x[0] + a * x[1] + b * x[1] * x[2] + beyond * (x[0] - x[1] - gap).max(0.0).powi(2)
        })
        .failing(move |x| x[0] - x[1] > gap),
    );
    let radius = d.range(0.9, 1.3);
    models.push(
        Model::new("outside a ball", vec![between(-1.0, 1.0); 3], move |x| {
            let r = x.iter().map(|x| x * x).sum::<f64>().sqrt();
            2.0 + x[0] + a * x[1] * x[1] - b * x[2] - beyond * (r - radius).max(0.0)
        })
        .failing(move |x| x.iter().map(|x| x * x).sum::<f64>().sqrt() > radius),
    );
    let share = d.range(0.02, 0.3);
    models.push(
        Model::new("anywhere", vec![between(0.0, 1.0); 3], move |x| {
            (a * x[0] + x[1]).exp() + b * x[2]
        })
        .failing(move |x| {
            let mixed: f64 = x.iter().map(|x| 1e4 * x.sin()).sum();
            mixed.rem_euclid(1.0) < share
        }),
    );
    models
}
