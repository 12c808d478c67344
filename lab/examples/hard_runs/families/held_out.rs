//! Held-out families, written when all constants of the claims were set, and looked at last: none may be set on them.

use std::f64::consts::PI;

use crate::families::draw::Draw;
use crate::families::frame::Families;
use crate::families::laws::{around, bell, between, triangle};
use crate::families::model::Model;
use crate::families::printing::Printing;

pub const FAMILIES: Families = Families {
    source: 130_000,
    printed,
    flat,
    singular,
    failed,
};

fn printed(d: &mut Draw) -> Vec<Model> {
    let level = 10f64.powi(d.count(0, 4) as i32);
    let (a, b, c) = (d.range(0.2, 1.5), d.range(0.2, 1.5), d.range(0.1, 0.9));
    let models = vec![
        Model::new(
            "beam",
            vec![between(0.9, 1.1), triangle(2.0, 2.1, 2.4), bell(1.0, 0.05)],
            move |x| level * x[0].powi(3) / (x[1] * x[2].powi(3)),
        ),
        Model::new(
            "damped swing",
            vec![between(0.0, 1.0), between(0.5, 1.5)],
            move |x| level * (-a * x[0]).exp() * (2.0 * x[1] * x[0]).cos(),
        ),
        Model::new(
            "radiation",
            vec![bell(300.0, 5.0), between(0.7, 0.95), between(280.0, 290.0)],
            move |x| 5.67e-8 * x[1] * (x[0].powi(4) - x[2].powi(4)) + a * x[1],
        ),
        Model::new("weir", vec![between(0.1, 0.5), bell(0.6, 0.02)], move |x| {
            level * x[1] * (x[0] + 0.1 * c).powf(1.5)
        }),
        Model::new("ratio of sums", vec![between(1.0, 2.0); 4], move |x| {
            1e3 * (x[0] + b * x[1]) / (x[2] + a * x[3])
        }),
        Model::new(
            "softened step",
            vec![around(c), bell(0.0, 0.4), between(0.0, 1.0)],
            move |x| 100.0 + (2.0 * x[0] + x[1]).tanh() + 0.3 * b * x[2] * x[2],
        ),
    ];
    models
        .into_iter()
        .map(|model| model.printed(Printing::any(d)))
        .collect()
}

fn flat(d: &mut Draw) -> Vec<Model> {
    let (a, b) = (d.range(0.1, 1.0), d.range(0.5, 3.0));
    let near = d.range(-0.07, 0.07);
    vec![
        Model::new(
            "k^2/(1 + k^2 + t)",
            vec![around(near), between(0.0, b)],
            move |x| a * x[0] + x[0] * x[0] / (1.0 + x[0] * x[0] + x[1]),
        ),
        Model::new(
            "sin(k) t^3, exactly",
            vec![around(0.0), between(0.0, b)],
            move |x| 1.0 + a * x[0] * x[0] + x[0].sin() * x[1].powi(3),
        ),
        Model::new(
            "ln(1 + k^2 t)",
            vec![bell(near, 0.8), between(0.0, b)],
            move |x| (1.0 + x[0] * x[0] * x[1]).ln(),
        ),
        Model::new(
            "k^4 cos(t) + s",
            vec![around(near), between(0.0, PI), between(0.0, 1.0)],
            move |x| x[0].powi(4) * x[1].cos() + 0.3 * a * x[2],
        ),
        Model::new("|k| t", vec![around(near), between(0.0, 1.0)], move |x| {
            3.0 + a * x[0] + x[0].abs() * x[1]
        }),
        Model::new(
            "(k - m)^2 exp(t u)",
            vec![around(0.0), between(-1.0, 1.0), between(0.0, 1.0)],
            move |x| (x[0] - near).powi(2) * (x[1] * x[2]).exp() + a * x[2],
        ),
        Model::new(
            "k^2 sqrt(1 - t)",
            vec![around(near), between(0.0, 1.0)],
            move |x| a * x[0] + x[0] * x[0] * (1.0 - x[1]).sqrt(),
        ),
        Model::new(
            "k u t",
            vec![around(near), bell(0.0, 1.0), triangle(0.0, 1.0, 2.0)],
            move |x| x[0] * x[1] * x[2] + a * x[1],
        ),
    ]
}

fn singular(d: &mut Draw) -> Vec<Model> {
    let (a, b, c) = (d.range(0.2, 1.0), d.range(0.3, 2.0), d.range(0.2, 0.8));
    let one = || between(0.0, 1.0);
    vec![
        Model::new("asin(t) + k", vec![one(), one()], move |x| {
            x[0].asin() + b * x[1]
        }),
        Model::new("t ln t + k s", vec![one(), one(), one()], move |x| {
            x[0] * x[0].ln() + a * x[1] * x[2]
        }),
        Model::new(
            "sqrt(1 - t^2) k",
            vec![between(-1.0, 1.0), between(0.5, 1.5)],
            move |x| (1.0 - x[0] * x[0]).sqrt() * x[1].powf(a),
        ),
        Model::new("|t - c|^0.6 + k^2", vec![one(), one()], move |x| {
            (x[0] - c).abs().powf(0.6) + a * x[1] * x[1]
        }),
        Model::new(
            "t^0.25 + s^0.8",
            vec![one(), triangle(0.0, 0.5, 1.0)],
            move |x| x[0].powf(0.25) + b * x[1].powf(0.8),
        ),
    ]
}

fn failed(d: &mut Draw, bends: f64) -> Vec<Model> {
    let bend = bends * d.range(0.3, 5.0);
    let (a, b) = (d.range(0.2, 1.5), d.range(0.2, 1.5));
    let mut models = Vec::new();
    let corner = d.range(0.9, 1.6);
    let above = move |x: &[f64]| x[0] + x[1] - corner;
    models.push(
        Model::new("a cut corner", vec![between(0.0, 1.0); 3], move |x| {
            (a * x[0]).exp() + b * x[1] * x[2] + bend * above(x).max(0.0)
        })
        .failing(move |x| above(x) > 0.0),
    );
    let deviations = d.range(0.8, 2.2);
    let below = move |x: &[f64]| -deviations - x[1];
    models.push(
        Model::new(
            "a lower tail",
            vec![between(0.0, 1.0), bell(0.0, 1.0)],
            move |x| a * x[0] * x[0] + b * (0.5 * x[1]).sin() + bend * below(x).max(0.0),
        )
        .failing(move |x| below(x) > 0.0),
    );
    let middle = d.range(0.2, 0.8);
    let slit = move |x: &[f64]| 0.12 - (x[0] - middle).abs();
    models.push(
        Model::new(
            "a slit",
            vec![between(0.0, 1.0), between(-1.0, 1.0)],
            move |x| 2.0 + a * x[0] + b * x[1].powi(3) - 4.0 * bend * slit(x).max(0.0),
        )
        .failing(move |x| slit(x) > 0.0),
    );
    let reach = d.range(0.75, 1.2);
    let outside = move |x: &[f64]| x.iter().map(|x| x * x).sum::<f64>() - reach * 1.5;
    models.push(
        Model::new("outside a ball", vec![around(0.0); 3], move |x| {
            (a * x[0] + b * x[1]).cos() + x[2] + bend * outside(x).max(0.0)
        })
        .failing(move |x| outside(x) > 0.0),
    );
    let ratio = d.range(1.2, 2.5);
    let steep = move |x: &[f64]| x[1] / x[0] - ratio;
    models.push(
        Model::new(
            "beyond a slope",
            vec![between(0.5, 1.5), triangle(0.5, 1.0, 1.5), bell(0.0, 1.0)],
            move |x| x[0] / x[1] + a * x[2] + bend * steep(x).max(0.0).powi(2),
        )
        .failing(move |x| steep(x) > 0.0),
    );
    models
}
