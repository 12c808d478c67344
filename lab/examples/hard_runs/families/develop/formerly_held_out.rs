//! Families that were held out until `auto` was seen to claim too little for k^4 sqrt t.

use std::f64::consts::{PI, TAU};

use crate::families::draw::Draw;
use crate::families::frame::Families;
use crate::families::laws::{around, bell, between, triangle};
use crate::families::model::Model;
use crate::families::printing::Printing;

pub const FAMILIES: Families = Families {
    source: 9000,
    printed,
    flat,
    singular: |_| Vec::new(),
    failed,
};

fn printed(d: &mut Draw) -> Vec<Model> {
    let level = 10f64.powi(d.count(0, 4) as i32);
    let (a, b, c) = (d.range(0.2, 1.5), d.range(0.2, 1.5), d.range(0.1, 0.9));
    vec![
        Model::new(
            "beam",
            vec![bell(10.0, 1.0), between(0.9, 1.1), triangle(1.8, 2.0, 2.2)],
            move |x| level * a * x[0] * x[1].powi(3) / x[2].powi(3),
        )
        .printed(Printing::any(d)),
        Model::new(
            "temperature",
            vec![between(0.0, 1.0), bell(0.0, 1.0)],
            move |x| 273.15 + a * x[0].sqrt() + b * (0.5 * x[1]).tanh(),
        )
        .printed(Printing::any(d)),
        Model::new(
            "frequency",
            vec![between(1.0, 2.0), between(0.5, 1.5), bell(1.0, 0.05)],
            move |x| level * (x[0] * (1.0 + c * x[1])).sqrt() / (TAU * x[2]),
        )
        .printed(Printing::any(d)),
        Model::new(
            "polynomial",
            vec![
                between(-1.0, 2.0),
                bell(0.0, 1.0),
                between(0.0, 1.0),
                between(0.0, 1.0),
            ],
            move |x| 50.0 + a * x[0].powi(3) - b * x[1] * x[2] + c * x[3],
        )
        .printed(Printing::any(d)),
        Model::new(
            "saturation",
            vec![between(0.1, 3.0), triangle(0.2, 0.4, 1.0)],
            move |x| level * x[0] / (c + x[0]) + a * x[1],
        )
        .printed(Printing::any(d)),
    ]
}

fn flat(d: &mut Draw) -> Vec<Model> {
    let (a, b) = (d.range(0.1, 1.0), d.range(0.5, 3.0));
    let near = d.range(-0.05, 0.05);
    vec![
        Model::new(
            "ln(1 + k^2 t)",
            vec![around(0.0), between(0.0, 10.0 * b)],
            |x| (x[0] * x[0] * x[1]).ln_1p(),
        ),
        Model::new(
            "k^4 sqrt t",
            vec![around(near), between(0.0, b)],
            move |x| 1.0 + a * x[0] + x[0].powi(4) * x[1].sqrt(),
        ),
        Model::new(
            "(1 - cos k) t",
            vec![bell(0.0, 1.0), between(0.0, b)],
            move |x| a + (1.0 - x[0].cos()) * (0.3 + x[1]),
        ),
        Model::new(
            "tanh(k^2 t) + s",
            vec![around(near), between(0.0, 3.0 * b), between(0.0, 1.0)],
            move |x| (x[0] * x[0] * x[1]).tanh() + a * x[2],
        ),
        Model::new(
            "(k^2 + s^2) t",
            vec![around(0.0), around(0.0), between(0.0, b)],
            move |x| 3.0 + a * x[0] + (x[0] * x[0] + x[1] * x[1]) * x[2],
        ),
        Model::new("hypot(k, t)", vec![around(0.0), bell(0.0, 1.0)], move |x| {
            1.0 + b * x[0].hypot(a * x[1] * x[0])
        }),
        Model::new(
            "decay in four",
            vec![
                around(0.0),
                between(0.0, b),
                between(0.0, 1.0),
                between(0.0, 1.0),
            ],
            move |x| (-(x[0] * x[0]) * (x[1] + x[2])).exp() + a * x[3],
        ),
    ]
}

fn failed(d: &mut Draw, bends: f64) -> Vec<Model> {
    let mut models = Vec::new();
    let bend = bends * d.range(0.3, 5.0);
    let (a, b) = (d.range(0.2, 1.5), d.range(0.2, 1.5));
    let height = d.range(0.2, 1.4);
    let above = move |x: &[f64]| x[1] - height * (1.0 - x[0] * x[0]).max(0.0) - 0.1;
    models.push(
        Model::new("above a curve", vec![between(0.0, 1.0); 2], move |x| {
            (a * x[0]).cosh() + b * x[1] + bend * above(x).max(0.0).powi(2)
        })
        .failing(move |x| above(x) > 0.0),
    );
    let load = d.range(1.2, 2.2);
    let overload = move |x: &[f64]| x[0] * x[1] / x[2] - load;
    models.push(
        Model::new(
            "buckling",
            vec![between(0.7, 1.3), between(0.7, 1.3), bell(1.0, 0.1)],
            move |x| x[0] * x[1] * x[1] / x[2] + bend * overload(x).max(0.0),
        )
        .failing(move |x| overload(x) > 0.0),
    );
    let share = d.range(0.03, 0.5);
    let below = move |x: &[f64]| share - x[2];
    models.push(
        Model::new(
            "below a third",
            vec![between(0.0, 1.0), bell(0.0, 1.0), between(0.0, 1.0)],
            move |x| 5.0 + x[0] + a * x[1] + b * x[2] * x[0] - bend * below(x).max(0.0),
        )
        .failing(move |x| below(x) > 0.0),
    );
    let deep = d.range(1.0, 3.0);
    let depth = move |x: &[f64]| x.iter().sum::<f64>() - deep;
    models.push(
        Model::new("four depths", vec![between(0.0, 1.0); 4], move |x| {
            (1.0 + a * x[0]) * (1.0 + b * x[1]) + x[2] * x[3] + bend * depth(x).max(0.0).powi(2)
        })
        .failing(move |x| depth(x) > 0.0 && depth(x) + deep > 2.1),
    );
    let every = d.range(0.02, 0.5);
    models.push(
        Model::new(
            "stripes",
            vec![between(0.0, 1.0), between(0.0, 1.0)],
            move |x| {
                let inside = (7.0 * PI * (x[0] + 0.6 * x[1])).sin() > (PI * (0.5 - every)).sin();
                x[0].exp() + a * x[1] * x[0] + if inside { 0.1 * bend } else { 0.0 }
            },
        )
        .failing(move |x| (7.0 * PI * (x[0] + 0.6 * x[1])).sin() > (PI * (0.5 - every)).sin()),
    );
    models
}
