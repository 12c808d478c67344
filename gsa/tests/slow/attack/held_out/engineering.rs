//! Models of engineers: structures, circuits, floods, chemistry, and tires in a few lines.
//!
//! Sources: "wing weight" A. Forrester, A. Sobester, A. Keane, Engineering Design via Surrogate Modelling (2008); "otl circuit"
//! E. Ben-Ari, D. Steinberg, Quality Engineering 19 (2007) 327; "steel column" N. Kuschel, R. Rackwitz, Math. Meth. Oper. Res. 46
//! (1997) 309; "flood" B. Iooss, P. Lemaitre in Uncertainty Management in Simulation-Optimization (2015) 101; "cantilever" Y.-T.
//! Wu et al., AIAA-2001-1291; "oscillator" C. Bucher, U. Bourgund, Structural Safety 7 (1990) 57; "spill" N. Bliznyuk et al.,
//! J. Comput. Graph. Statist. 17 (2008) 270; "sulphur" R. Charlson et al., Science 255 (1992) 423; "short column" the first
//! of these on columns. Ranges are as published or near, and some are drawn.

use std::f64::consts::PI;

use gsa::law::distribution::Distribution;

use crate::attack::draw::{Draw, uniform, x};
use crate::attack::exact::{of, on_grid, on_grid_of, sum_of_products};
use crate::known::Known;

/// Draws a model of every kind.
pub fn all(d: &mut Draw) -> Vec<Known> {
    let mut models = structures(d);
    models.extend(fluids_and_circuits(d));
    models.extend(tires(d));
    models
}

fn between(low: f64, high: f64) -> Distribution {
    Distribution::uniform(low, high).expect("a valid law")
}

fn gaussian(mean: f64, std: f64) -> Distribution {
    Distribution::normal(mean, std).expect("a valid law")
}

/// Makes a lognormal law of the mean and standard deviation of the variable itself.
fn lognormal(mean: f64, std: f64) -> Distribution {
    let square = (std / mean).powi(2).ln_1p();
    Distribution::lognormal(mean.ln() - 0.5 * square, square.sqrt()).expect("a valid law")
}

fn triangle(low: f64, mode: f64, high: f64) -> Distribution {
    Distribution::triangular(low, mode, high).expect("a valid law")
}

fn power(input: usize, exponent: f64) -> crate::attack::exact::Factor {
    of(input, move |x| x.powf(exponent))
}

fn structures(d: &mut Draw) -> Vec<Known> {
    let truss = [
        (2e4, 0.07),
        (12.0, 0.01),
        (9.82e-4, 0.06),
        (0.04, 0.12),
        (1e11, 0.06),
        (2e10, 0.06),
    ];
    let truss = truss.map(|(mean, share)| lognormal(mean, d.range(1.0, 4.0) * share * mean));
    let (load, bending) = (d.range(150.0, 400.0), d.range(0.1, 0.3));
    vec![
        steel_column(),
        sum_of_products(
            "short column",
            vec![
                gaussian(500.0, load / 3.0),
                gaussian(2000.0, 2000.0 * bending),
                lognormal(5.0, 0.5),
            ],
            &[],
            vec![
                (1.0, vec![]),
                (-4.0 / (5.0 * 225.0), vec![x(1), power(2, -1.0)]),
                (-1.0 / (25.0 * 225.0), vec![power(0, 2.0), power(2, -2.0)]),
            ],
        ),
        // 4 L^3/(E w t) sqrt((Y/t^2)^2 + (X/w^2)^2)
        on_grid(
            "cantilever, deflection",
            vec![
                gaussian(2.9e7, 1.45e6),
                gaussian(500.0, 100.0),
                gaussian(1000.0, 100.0),
                between(2.4, 3.0),
                between(3.0, 3.6),
            ],
            12,
            |x| {
                let [e, side, down, w, t] = [x[0], x[1], x[2], x[3], x[4]];
                4e6 / (e * w * t) * (down / (t * t)).hypot(side / (w * w))
            },
        ),
        sum_of_products(
            "cantilever, margin of stress",
            vec![
                gaussian(4e4, 2e3),
                gaussian(500.0, 100.0),
                gaussian(1000.0, 100.0),
                between(2.0, 3.0),
                between(3.0, 4.0),
            ],
            &[],
            vec![
                (1.0, vec![x(0)]),
                (-600.0, vec![x(2), power(3, -1.0), power(4, -2.0)]),
                (-600.0, vec![x(1), power(3, -2.0), power(4, -1.0)]),
            ],
        ),
        sum_of_products(
            "roof truss",
            truss.to_vec(),
            &[],
            vec![
                (
                    1.905,
                    vec![x(0), power(1, 2.0), power(3, -1.0), power(5, -1.0)],
                ),
                (
                    0.565,
                    vec![x(0), power(1, 2.0), power(2, -1.0), power(4, -1.0)],
                ),
            ],
        ),
        oscillator(),
        wing_weight(),
    ]
}

/// F_s - P (1/(2 B D) + F_0 E_b/(B D H (E_b - P))), E_b = pi^2 E B D H^2/(2 L^2), P = P_1 + P_2 + P_3.
fn steel_column() -> Known {
    let inputs = vec![
        lognormal(400.0, 35.0),
        gaussian(30.0, 10.0),
        gaussian(5e5, 5e4),
        Distribution::gumbel(5.6e5, 7e4).expect("a valid law"),
        Distribution::gumbel(5.6e5, 7e4).expect("a valid law"),
        lognormal(300.0, 3.0),
        lognormal(20.0, 2.0),
        lognormal(300.0, 5.0),
        Distribution::weibull(60.0, 2.12e5).expect("a valid law"),
    ];
    // Linear in the second; the narrow ones are nearly so.
    let nodes = [6, 2, 4, 7, 7, 3, 7, 3, 4];
    on_grid_of("steel column", inputs, &nodes, |x| {
        let [strength, bow, b, depth, h, e] = [x[0], x[1], x[5], x[6], x[7], x[8]];
        let load = x[2] + x[3] + x[4];
        let buckling = PI * PI * e * b * depth * h * h / (2.0 * 7500.0f64.powi(2));
        let area = b * depth;
        strength - load * (0.5 / area + bow * buckling / (area * h * (buckling - load)))
    })
}

/// r - |2 F/(c_1 + c_2) sin(w T/2)|, w^2 = (c_1 + c_2)/m.
fn oscillator() -> Known {
    let inputs = vec![
        gaussian(0.5, 0.05),
        gaussian(1.0, 0.2),
        gaussian(1.0, 0.05),
        gaussian(1.0, 0.1),
        gaussian(0.1, 0.01),
        gaussian(1.0, 0.2),
    ];
    on_grid_of("oscillator", inputs, &[2, 2, 8, 10, 6, 12], |x| {
        let stiffness = x[3] + x[4];
        let frequency = (stiffness / x[2]).sqrt();
        x[0] - 2.0 * x[1] / stiffness * (0.5 * frequency * x[5]).sin()
    })
}

/// 0.036 S^0.758 W_f^0.0035 (A/cos^2 L)^0.6 q^0.006 l^0.04 (100 t/cos L)^-0.3 (N W)^0.49 + S W_p
fn wing_weight() -> Known {
    let inputs = [
        (150.0, 200.0),
        (220.0, 300.0),
        (6.0, 10.0),
        (-10.0, 10.0),
        (16.0, 45.0),
        (0.5, 1.0),
        (0.08, 0.18),
        (2.5, 6.0),
        (1700.0, 2500.0),
        (0.025, 0.08),
    ];
    let first = vec![
        power(0, 0.758),
        power(1, 0.0035),
        power(2, 0.6),
        of(3, |degrees: f64| degrees.to_radians().cos().powf(-0.9)),
        power(4, 0.006),
        power(5, 0.04),
        power(6, -0.3),
        power(7, 0.49),
        power(8, 0.49),
    ];
    sum_of_products(
        "wing weight",
        inputs.map(|(low, high)| between(low, high)).to_vec(),
        &[],
        vec![(0.036 * 100f64.powf(-0.3), first), (1.0, vec![x(0), x(9)])],
    )
}

fn fluids_and_circuits(d: &mut Draw) -> Vec<Known> {
    let (place, time) = (d.range(0.5, 2.5), d.range(34.0, 60.0));
    let widths = [
        (0.76, 1.2),
        (0.39, 1.1),
        (0.85, 1.1),
        (0.3, 1.3),
        (5.0, 1.4),
        (1.7, 1.2),
        (71.0, 1.15),
        (0.5, 1.5),
        (5.5, 1.5),
    ];
    let squared = |i: usize| if i == 0 || i == 2 { 2.0 } else { 1.0 };
    let (rate, span) = (d.range(2.0, 8.0), d.range(0.1, 0.3));
    vec![
        otl_circuit(),
        flood(),
        // Two spills into a channel: M at the start, and M at distance L after the time tau; linear in M.
        on_grid_of(
            "spill",
            vec![
                between(7.0, 13.0),
                between(0.02, 0.12),
                between(0.01, 3.0),
                between(30.01, 30.295),
            ],
            &[2, 40, 32, 4],
            move |x| {
                let plume = |distance: f64, time: f64| {
                    (-distance * distance / (4.0 * x[1] * time)).exp() / (x[1] * time).sqrt()
                };
                x[0] * (plume(place, time) + plume(place - x[2], time - x[3]))
            },
        ),
        sum_of_products(
            "sulphur",
            widths
                .map(|(centre, width): (f64, f64)| {
                    Distribution::lognormal(centre.ln(), width.ln()).expect("a valid law")
                })
                .to_vec(),
            &[],
            vec![(-1e-3, (0..9).map(|i| power(i, squared(i))).collect())],
        ),
        // What is left of a substance whose rate constant follows Arrhenius.
        on_grid(
            "arrhenius",
            vec![
                between(0.5, 1.5),
                between(8.0, 12.0),
                between(1.0 - span, 1.0 + span),
            ],
            32,
            move |x| (-rate * x[0] * (10.0 - x[1] / x[2]).exp()).exp(),
        ),
    ]
}

fn otl_circuit() -> Known {
    let inputs = [
        (50.0, 150.0),
        (25.0, 70.0),
        (0.5, 3.0),
        (1.2, 2.5),
        (0.25, 1.2),
        (50.0, 300.0),
    ];
    let inputs = inputs.map(|(low, high)| between(low, high)).to_vec();
    on_grid_of("otl circuit", inputs, &[10, 10, 7, 10, 7, 10], |x| {
        let [rb1, rb2, rf, rc1, rc2, beta] = [x[0], x[1], x[2], x[3], x[4], x[5]];
        let base = 12.0 * rb2 / (rb1 + rb2);
        let gain = beta * (rc2 + 9.0);
        ((base + 0.74) * gain + 11.35 * rf + 0.74 * rf * gain / rc1) / (gain + rf)
    })
}

/// Z_v + (Q/(B K_s sqrt((Z_m - Z_v)/L)))^0.6 - H_d - C_b: how far the river rises above the dyke.
fn flood() -> Known {
    let flow = Distribution::gumbel(1013.0, 558.0).and_then(|law| law.truncated(500.0, 3000.0));
    let friction = Distribution::normal(30.0, 8.0).and_then(|law| law.truncated(15.0, 70.0));
    let inputs = vec![
        flow.expect("a valid law"),
        friction.expect("a valid law"),
        triangle(49.0, 50.0, 51.0),
        triangle(54.0, 55.0, 56.0),
        triangle(4990.0, 5000.0, 5010.0),
        triangle(295.0, 300.0, 305.0),
        between(7.0, 9.0),
        triangle(55.0, 55.5, 56.0),
    ];
    on_grid_of("flood", inputs, &[12, 14, 8, 8, 2, 3, 2, 2], |x| {
        let slope = ((x[3] - x[2]) / x[4]).sqrt();
        let height = (x[0] / (x[5] * x[1] * slope)).powf(0.6);
        x[2] + height - x[6] - x[7]
    })
}

fn tires(d: &mut Draw) -> Vec<Known> {
    let (w, v) = (d.many(5, -0.4, 1.0), d.many(5, 0.0, 0.5));
    let curvature = d.range(0.2, 1.5);
    let (at, slopes) = (d.range(0.75, 1.1), d.many(3, 0.2, 1.0));
    let gap = move |x: f64| (x - at).max(0.0);
    vec![
        // Five depths bend one shell, which stiffens.
        on_grid("bent shell", uniform(0.7, 1.3, 5), 9, move |x| {
            let dot = |a: &[f64]| x.iter().zip(a).map(|(x, a)| a * (x - 1.0)).sum::<f64>();
            dot(&w) + curvature * dot(&v).powi(2) + (0.05 + (dot(&w) + 0.3).powi(2)).sqrt()
        }),
        // Two of three places touch only from a depth on, as Hertz's bodies do.
        sum_of_products(
            "tread that lifts off",
            uniform(0.7, 1.3, 3),
            &[at],
            vec![
                (
                    1.0,
                    vec![of(0, move |x| gap(x).powf(1.5)), of(1, |x| 1.0 + 0.3 * x)],
                ),
                (slopes[0], vec![x(1)]),
                (-slopes[1], vec![of(2, gap), x(1)]),
                (slopes[2], vec![of(0, gap), of(2, gap)]),
            ],
        ),
    ]
}
