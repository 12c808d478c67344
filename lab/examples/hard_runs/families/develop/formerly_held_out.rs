//! Held-out families, written when all constants of the claims were set, and looked at last: none may be set on them.

use std::f64::consts::{PI, TAU};

use gsa::law::distribution::Distribution;

use crate::families::draw::Draw;
use crate::families::model::Model;
use crate::families::printing::Printing;

/// Draws a model of every family for a seed.
pub fn all(seed: u64) -> Vec<Model> {
    let mut d = Draw::new(seed + 9000);
    let mut models = printed(&mut d);
    models.extend(flat(&mut d));
    models.extend(failed(&mut d));
    models
}

fn between(low: f64, high: f64) -> Distribution {
    Distribution::uniform(low, high).expect("a valid law")
}

fn bell(mean: f64, std: f64) -> Distribution {
    Distribution::normal(mean, std).expect("a valid law")
}

fn triangle(low: f64, mode: f64, high: f64) -> Distribution {
    Distribution::triangular(low, mode, high).expect("a valid law")
}

/// Three to eight digits, in any of the usual formats.
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
    let level = 10f64.powi(d.count(0, 4) as i32);
    let (a, b, c) = (d.range(0.2, 1.5), d.range(0.2, 1.5), d.range(0.1, 0.9));
    vec![
        Model::new(
            (group, "beam"),
            vec![bell(10.0, 1.0), between(0.9, 1.1), triangle(1.8, 2.0, 2.2)],
            move |x| level * a * x[0] * x[1].powi(3) / x[2].powi(3),
        )
        .printed(printing(d)),
        Model::new(
            (group, "temperature"),
            vec![between(0.0, 1.0), bell(0.0, 1.0)],
            move |x| 273.15 + a * x[0].sqrt() + b * (0.5 * x[1]).tanh(),
        )
        .printed(printing(d)),
        Model::new(
            (group, "frequency"),
            vec![between(1.0, 2.0), between(0.5, 1.5), bell(1.0, 0.05)],
            move |x| level * (x[0] * (1.0 + c * x[1])).sqrt() / (TAU * x[2]),
        )
        .printed(printing(d)),
        Model::new(
            (group, "polynomial"),
            vec![
                between(-1.0, 2.0),
                bell(0.0, 1.0),
                between(0.0, 1.0),
                between(0.0, 1.0),
            ],
            move |x| 50.0 + a * x[0].powi(3) - b * x[1] * x[2] + c * x[3],
        )
        .printed(printing(d)),
        Model::new(
            (group, "saturation"),
            vec![between(0.1, 3.0), triangle(0.2, 0.4, 1.0)],
            move |x| level * x[0] / (c + x[0]) + a * x[1],
        )
        .printed(printing(d)),
    ]
}

fn flat(d: &mut Draw) -> Vec<Model> {
    let group = "flat line at the cut";
    let (a, b) = (d.range(0.1, 1.0), d.range(0.5, 3.0));
    let near = d.range(-0.05, 0.05);
    let k = |shift: f64| between(shift - 1.0, shift + 1.0);
    vec![
        Model::new(
            (group, "ln(1 + k^2 t)"),
            vec![k(0.0), between(0.0, 10.0 * b)],
            |x| (x[0] * x[0] * x[1]).ln_1p(),
        ),
        Model::new(
            (group, "k^4 sqrt t"),
            vec![k(near), between(0.0, b)],
            move |x| 1.0 + a * x[0] + x[0].powi(4) * x[1].sqrt(),
        ),
        Model::new(
            (group, "(1 - cos k) t"),
            vec![bell(0.0, 1.0), between(0.0, b)],
            move |x| a + (1.0 - x[0].cos()) * (0.3 + x[1]),
        ),
        Model::new(
            (group, "tanh(k^2 t) + s"),
            vec![k(near), between(0.0, 3.0 * b), between(0.0, 1.0)],
            move |x| (x[0] * x[0] * x[1]).tanh() + a * x[2],
        ),
        Model::new(
            (group, "(k^2 + s^2) t"),
            vec![k(0.0), k(0.0), between(0.0, b)],
            move |x| 3.0 + a * x[0] + (x[0] * x[0] + x[1] * x[1]) * x[2],
        ),
        Model::new(
            (group, "hypot(k, t)"),
            vec![k(0.0), bell(0.0, 1.0)],
            move |x| 1.0 + b * x[0].hypot(a * x[1] * x[0]),
        ),
        Model::new(
            (group, "decay in four"),
            vec![
                k(0.0),
                between(0.0, b),
                between(0.0, 1.0),
                between(0.0, 1.0),
            ],
            move |x| (-(x[0] * x[0]) * (x[1] + x[2])).exp() + a * x[3],
        ),
    ]
}

fn failed(d: &mut Draw) -> Vec<Model> {
    let groups = ["failed runs", "failed runs, another law there"];
    let mut models = Vec::new();
    for (group, bends) in groups.into_iter().zip([0.0, 1.0]) {
        let bend = bends * d.range(0.3, 5.0);
        let (a, b) = (d.range(0.2, 1.5), d.range(0.2, 1.5));
        let height = d.range(0.2, 1.4);
        let above = move |x: &[f64]| x[1] - height * (1.0 - x[0] * x[0]).max(0.0) - 0.1;
        models.push(
            Model::new(
                (group, "above a curve"),
                vec![between(0.0, 1.0); 2],
                move |x| (a * x[0]).cosh() + b * x[1] + bend * above(x).max(0.0).powi(2),
            )
            .failing(move |x| above(x) > 0.0),
        );
        let load = d.range(1.2, 2.2);
        let overload = move |x: &[f64]| x[0] * x[1] / x[2] - load;
        models.push(
            Model::new(
                (group, "buckling"),
                vec![between(0.7, 1.3), between(0.7, 1.3), bell(1.0, 0.1)],
                move |x| x[0] * x[1] * x[1] / x[2] + bend * overload(x).max(0.0),
            )
            .failing(move |x| overload(x) > 0.0),
        );
        let share = d.range(0.03, 0.5);
        let below = move |x: &[f64]| share - x[2];
        models.push(
            Model::new(
                (group, "below a third"),
                vec![between(0.0, 1.0), bell(0.0, 1.0), between(0.0, 1.0)],
                move |x| 5.0 + x[0] + a * x[1] + b * x[2] * x[0] - bend * below(x).max(0.0),
            )
            .failing(move |x| below(x) > 0.0),
        );
        let deep = d.range(1.0, 3.0);
        let depth = move |x: &[f64]| x.iter().sum::<f64>() - deep;
        models.push(
            Model::new(
                (group, "four depths"),
                vec![between(0.0, 1.0); 4],
                move |x| {
                    (1.0 + a * x[0]) * (1.0 + b * x[1])
                        + x[2] * x[3]
                        + bend * depth(x).max(0.0).powi(2)
                },
            )
            .failing(move |x| depth(x) > 0.0 && depth(x) + deep > 2.1),
        );
        let every = d.range(0.02, 0.5);
        models.push(
            Model::new(
                (group, "stripes"),
                vec![between(0.0, 1.0), between(0.0, 1.0)],
                move |x| {
                    let inside =
                        (7.0 * PI * (x[0] + 0.6 * x[1])).sin() > (PI * (0.5 - every)).sin();
                    x[0].exp() + a * x[1] * x[0] + if inside { 0.1 * bend } else { 0.0 }
                },
            )
            .failing(move |x| (7.0 * PI * (x[0] + 0.6 * x[1])).sin() > (PI * (0.5 - every)).sin()),
        );
    }
    models
}
