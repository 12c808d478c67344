//! Families with an infinite slope or value at an end of a range or inside, on lines that show it and on lines that hardly do.

use crate::families::draw::Draw;
use crate::families::frame::Families;
use crate::families::laws::{around, between};
use crate::families::model::Model;

pub const FAMILIES: Families = Families {
    source: 500,
    printed: |_| Vec::new(),
    flat,
    singular,
    failed: |_, _| Vec::new(),
};

fn flat(d: &mut Draw) -> Vec<Model> {
    let (a, b, c) = (d.range(0.3, 0.8), d.range(0.3, 0.8), d.range(0.1, 1.0));
    let (most, place) = (d.range(0.5, 5.0), d.range(0.2, 0.8));
    let near = d.range(-0.1, 0.1);
    let two = |at: f64| vec![around(at), between(0.0, most)];
    let three = |at: f64| vec![around(at), between(0.0, most), between(0.0, 1.0)];
    vec![
        Model::new("k^4 t^a, nearly", two(near), move |x| {
            1.0 + c * x[0] + x[0].powi(4) * x[1].powf(a)
        }),
        Model::new("k^4 t^a", two(0.0), move |x| {
            1.0 + c * x[0] + x[0].powi(4) * x[1].powf(a)
        }),
        Model::new("k^2 ln t", two(near), move |x| {
            2.0 + c * x[0] + x[0] * x[0] * x[1].ln()
        }),
        Model::new("k^2 |t - c|^a", two(near), move |x| {
            c * x[0] + x[0] * x[0] * (x[1] - place * most).abs().powf(a)
        }),
        Model::new("k^2 t^a s^b", three(near), move |x| {
            1.0 + x[0] * x[0] * x[1].powf(a) * x[2].powf(b)
        }),
        Model::new("k^2 t^a + s^b", three(0.0), move |x| {
            1.0 + x[0] * x[0] * x[1].powf(a) + c * x[2].powf(b)
        }),
        Model::new("exp(-k^2 t^a)", two(0.0), move |x| {
            (-x[0] * x[0] * x[1].powf(a)).exp()
        }),
        Model::new("|k| (1 - s)^b + t^a", three(near), move |x| {
            x[0].abs() * (1.0 - x[2]).powf(b) + c * x[1].powf(a)
        }),
    ]
}

fn singular(d: &mut Draw) -> Vec<Model> {
    let (a, b, c) = (d.range(0.3, 0.8), d.range(0.3, 0.8), d.range(0.1, 1.0));
    let (place, apart) = (d.range(0.2, 0.8), 10f64.powf(d.range(-3.0, -0.5)));
    let two = || vec![between(0.0, 1.0); 2];
    let three = || vec![between(0.0, 1.0); 3];
    vec![
        Model::new("t^a + k", two(), move |x| x[0].powf(a) + c * x[1]),
        Model::new("t^a s^b", two(), move |x| x[0].powf(a) * x[1].powf(b)),
        Model::new("ln t + k s", three(), move |x| {
            x[0].ln() + 3.0 * c * x[1] * x[2]
        }),
        Model::new("|t - c|^a + k", two(), move |x| {
            (x[0] - place).abs().powf(a) + c * x[1]
        }),
        Model::new("(t + d)^a exp k", two(), move |x| {
            (x[0] + apart).powf(a) * (c * x[1]).exp()
        }),
        Model::new("t^a + (1 - s)^b + t s", two(), move |x| {
            x[0].powf(a) + (1.0 - x[1]).powf(b) + c * x[0] * x[1]
        }),
        Model::new("(t - t^2)^a + k", two(), move |x| {
            (x[0] - x[0] * x[0]).powf(a) + c * x[1]
        }),
        Model::new("t^a + exp k - s", three(), move |x| {
            x[0].powf(a) + x[1].exp() - c * x[2]
        }),
    ]
}
