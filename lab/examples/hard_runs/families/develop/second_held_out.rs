//! Families that were held out until `auto` was seen to claim too little for acos t, sqrt |z| and a law's tail.

use std::f64::consts::TAU;

use crate::families::draw::Draw;
use crate::families::frame::Families;
use crate::families::laws::{around, bell, between, triangle};
use crate::families::model::Model;
use crate::families::printing::Printing;

pub const FAMILIES: Families = Families {
    source: 70_000,
    printed,
    flat,
    singular,
    failed,
};

fn printed(d: &mut Draw) -> Vec<Model> {
    let level = 10f64.powi(d.count(0, 4) as i32);
    let (a, b, c) = (d.range(0.2, 1.5), d.range(0.2, 1.5), d.range(0.1, 0.9));
    vec![
        Model::new(
            "pendulum",
            vec![between(0.8, 1.2), bell(9.81, 0.1), between(0.0, 1.0)],
            move |x| level * TAU * (x[0] / x[1]).sqrt() * (1.0 + a * x[2] * x[2] / 16.0),
        )
        .printed(Printing::any(d)),
        Model::new(
            "rate",
            vec![triangle(280.0, 300.0, 340.0), between(0.5, 1.5)],
            move |x| level * x[1].powf(b) * (-a * (3000.0 / x[0] - 10.0)).exp(),
        )
        .printed(Printing::any(d)),
        Model::new(
            "springs in series",
            vec![between(1.0, 2.0), between(0.5, 1.5), bell(3.0, 0.3)],
            move |x| level / (1.0 / x[0] + a / x[1] + b / x[2]),
        )
        .printed(Printing::any(d)),
        Model::new("logit", vec![bell(0.0, 1.0), bell(0.3, 0.7)], move |x| {
            1.0 / (1.0 + (-a * x[0] - b * x[1]).exp())
        })
        .printed(Printing::any(d)),
        Model::new(
            "mixture",
            vec![
                between(0.0, 1.0),
                between(-1.0, 1.0),
                triangle(0.0, 0.5, 1.0),
                bell(0.0, 0.5),
            ],
            move |x| {
                298.15 + a * x[0] * (1.0 - x[0]) + b * x[1] * x[2] + c * x[3] + x[3].powi(2) * x[0]
            },
        )
        .printed(Printing::any(d)),
    ]
}

fn flat(d: &mut Draw) -> Vec<Model> {
    let (a, b) = (d.range(0.1, 1.0), d.range(0.5, 3.0));
    let near = d.range(-0.07, 0.07);
    vec![
        Model::new(
            "sinh(k)^2 acos t",
            vec![around(near), between(0.0, 1.0)],
            move |x| a * x[0] + x[0].sinh().powi(2) * x[1].acos(),
        ),
        Model::new(
            "k^2 asinh(1/t)",
            vec![around(near), between(0.0, b)],
            move |x| 1.0 + a * x[0] + x[0] * x[0] * (1.0 / x[1]).asinh(),
        ),
        Model::new(
            "k^6 cbrt t, exactly",
            vec![around(0.0), between(0.0, b)],
            move |x| 2.0 - a * x[0] + x[0].powi(6) * x[1].cbrt(),
        ),
        Model::new(
            "(1 - sech k) t",
            vec![bell(near, 1.0), between(0.0, b)],
            move |x| a + (1.0 - 1.0 / x[0].cosh()) * (0.2 + x[1]),
        ),
        Model::new(
            "atan(k^2 t) + s^2",
            vec![around(near), between(0.0, 4.0 * b), between(0.0, 1.0)],
            move |x| (x[0] * x[0] * x[1]).atan() + a * x[2] * x[2],
        ),
        Model::new(
            "k s (1 + t) + k",
            vec![around(0.0), around(near), between(0.0, b)],
            move |x| x[0] * x[1] * (1.0 + x[2]) + a * x[0],
        ),
        Model::new(
            "1 - exp(-k^2 sqrt(t + s))",
            vec![around(near), between(0.0, b), between(0.0, 1.0)],
            |x| 1.0 - (-x[0] * x[0] * (x[1] + x[2]).sqrt()).exp(),
        ),
        Model::new(
            "(k^2 + u^2) sqrt t + s",
            vec![
                around(near),
                around(0.0),
                between(0.0, b),
                between(0.0, 1.0),
            ],
            move |x| (x[0] * x[0] + x[1] * x[1]) * x[2].sqrt() + a * x[3],
        ),
    ]
}

fn singular(d: &mut Draw) -> Vec<Model> {
    let (a, b, c) = (d.range(0.2, 1.0), d.range(0.3, 2.0), d.range(0.2, 0.8));
    let one = || between(0.0, 1.0);
    vec![
        Model::new("acos(t) exp(a k)", vec![one(), one()], move |x| {
            x[0].acos() * (a * x[1]).exp()
        }),
        Model::new("cbrt(t - c) + k", vec![one(), one()], move |x| {
            (x[0] - c).cbrt() + a * x[1]
        }),
        Model::new("ln(t + s)", vec![one(), one()], |x| (x[0] + x[1]).ln()),
        Model::new(
            "exp(-b sqrt t) + k s",
            vec![one(), one(), one()],
            move |x| (-b * x[0].sqrt()).exp() + a * x[1] * x[2],
        ),
        Model::new(
            "sqrt t + tanh k, other laws",
            vec![triangle(0.0, 0.3, 1.0), bell(0.0, 1.0)],
            move |x| x[0].sqrt() + a * (b * x[1]).tanh(),
        ),
        Model::new(
            "sqrt |z| + k",
            vec![bell(0.0, 1.0), between(0.0, 1.0)],
            move |x| x[0].abs().sqrt() + b * x[1],
        ),
        Model::new(
            "t^0.4/(1 + k) + ln s",
            vec![one(), one(), one()],
            move |x| b * x[0].powf(0.4) / (1.0 + x[1]) + a * x[2].ln(),
        ),
        Model::new("t^0.7 (1 - s)^0.35", vec![one(), one()], |x| {
            x[0].powf(0.7) * (1.0 - x[1]).powf(0.35)
        }),
    ]
}

fn failed(d: &mut Draw, bends: f64) -> Vec<Model> {
    let bend = bends * d.range(0.3, 5.0);
    let (a, b) = (d.range(0.2, 1.5), d.range(0.2, 1.5));
    let mut models = Vec::new();
    let level = d.range(0.2, 0.8);
    let product = move |x: &[f64]| x[0] * x[1] - level;
    models.push(
        Model::new("beyond a hyperbola", vec![between(0.0, 1.0); 2], move |x| {
            (1.0 + a * x[0]).ln() + b * x[1].powi(3) + bend * product(x).max(0.0)
        })
        .failing(move |x| product(x) > 0.0),
    );
    let deviations = d.range(0.3, 1.8);
    let far = move |x: &[f64]| x[0] - deviations;
    models.push(
        Model::new(
            "a law's tail",
            vec![bell(0.0, 1.0), between(-1.0, 1.0), triangle(0.0, 0.2, 1.0)],
            move |x| (0.3 * a * x[0]).exp() + b * x[1] * x[2] + bend * far(x).max(0.0).powi(2),
        )
        .failing(move |x| far(x) > 0.0),
    );
    let radius = d.range(0.3, 0.8);
    let inside = move |x: &[f64]| radius - (x[0] - 0.3).hypot(x[1] + 0.2);
    models.push(
        Model::new(
            "inside a disc",
            vec![around(0.0), around(0.0), between(0.0, 1.0)],
            move |x| 4.0 + a * x[0] + b * x[1] * x[1] + x[2] - bend * inside(x).max(0.0),
        )
        .failing(move |x| inside(x) > 0.0),
    );
    let share = d.range(0.05, 0.4);
    let low = move |x: &[f64]| share - x[0].min(x[3]);
    models.push(
        Model::new(
            "two slabs of four inputs",
            vec![between(0.0, 1.0); 4],
            move |x| {
                (a * x[0] + b * x[1]).sin() + x[2] * (1.0 + x[3]) + bend * low(x).max(0.0).powi(2)
            },
        )
        .failing(move |x| low(x) > 0.0),
    );
    let width = d.range(0.05, 0.5);
    let on_tooth = move |x: &[f64]| (5.0 * x[0] - 3.0 * x[1]).rem_euclid(1.0) < width;
    models.push(
        Model::new("teeth", vec![between(0.0, 1.0); 2], move |x| {
            let there = if on_tooth(x) { 0.1 * bend } else { 0.0 };
            (a * x[0]).cosh() * (1.0 + b * x[1]) + there
        })
        .failing(on_tooth),
    );
    models
}
