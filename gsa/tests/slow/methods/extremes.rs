//! Extremes where methods break: each is right to its error there, or says what is wrong.

use gsa::campaign::Campaign;
use gsa::design::DesignError;
use gsa::law::distribution::Distribution;
use gsa::method::analysis::{Analysis, Status};
use gsa::method::{Kind, Method};

use super::contract::fault;
use crate::asking::{to_the_end, until_enough};
use crate::known::Known;

fn uniforms(n: usize) -> Vec<Distribution> {
    vec![Distribution::uniform(-1.0, 1.0).expect("a law"); n]
}

fn normals(n: usize) -> Vec<Distribution> {
    vec![Distribution::normal(0.0, 1.0).expect("a law"); n]
}

fn shares(parts: &[f64]) -> Vec<f64> {
    let whole: f64 = parts.iter().sum();
    parts.iter().map(|part| part / whole).collect()
}

const SLOPES: [f64; 4] = [0.9, 0.5, -0.4, 0.2];

/// A product of 1 + a_i x_i with x_i uniform on [-1, 1]: q_i = a_i^2/3.
fn product(x: &[f64]) -> f64 {
    x.iter().zip(SLOPES).map(|(x, a)| 1.0 + a * x).product()
}

fn product_exact() -> Vec<f64> {
    let q = SLOPES.map(|a| a * a / 3.0);
    let whole = q.iter().map(|q| 1.0 + q).product::<f64>() - 1.0;
    q.iter().map(|q| q / whole).collect()
}

fn case(
    family: &'static str,
    inputs: Vec<Distribution>,
    first_order: Vec<f64>,
    model: impl Fn(&[f64]) -> f64 + 'static,
) -> Known {
    Known {
        family,
        inputs,
        model: Box::new(model),
        first_order,
    }
}

fn cases() -> Vec<Known> {
    // sum a_i x_i: V_i is proportional to a_i^2
    let squares = shares(&SLOPES.map(|a| a * a));
    let sum = |x: &[f64]| -> f64 { x.iter().zip(SLOPES).map(|(x, a)| a * x).sum() };
    let variance: f64 = SLOPES.iter().map(|a| a * a / 3.0).sum();
    let size = (1e-15 / variance).sqrt();
    // |4u - 2| has variance 1/3 over its squared mean of 1
    let kinks = [0.5, 1.0, 2.0].map(|a: f64| 1.0 / 3.0 / (1.0 + a).powi(2));
    let whole = kinks.iter().map(|v| 1.0 + v).product::<f64>() - 1.0;
    let kink = |(x, a): (&f64, f64)| ((2.0 * x).abs() + a) / (1.0 + a);
    vec![
        case("1e300 times a product", uniforms(4), product_exact(), |x| {
            1e300 * product(x)
        }),
        case(
            "1e-300 times a product",
            uniforms(4),
            product_exact(),
            |x| 1e-300 * product(x),
        ),
        case(
            "relative variance 1e-15",
            uniforms(4),
            squares.clone(),
            move |x| 1.0 + size * sum(x),
        ),
        case("h0 = 0: squares", normals(3), vec![1.0 / 3.0; 3], |x| {
            x.iter().map(|x| x * x).sum()
        }),
        case("h0 = 0: a sum", uniforms(4), squares, sum),
        // E[(1 - x^2)^2] = 2: V_1 = 9 2, V_12 = 2 1
        case("rho_1 = 0", normals(2), vec![0.9, 0.0], |x| {
            (1.0 - x[0] * x[0]) * (3.0 + x[1])
        }),
        // V_1 = V_2 = 0 and V_12 = 1
        case("an interaction alone", normals(2), vec![0.0, 0.0], |x| {
            x[0] * x[1]
        }),
        case(
            "kinks, a product",
            uniforms(3),
            kinks.map(|v| v / whole).to_vec(),
            move |x| x.iter().zip([0.5, 1.0, 2.0]).map(kink).product(),
        ),
        // E[Y | x_1] = (1 + x_1)^2/4: V_1 = 1/5 - 1/9 of Var = 1/3 - 1/9
        case(
            "a kink across two inputs",
            uniforms(2),
            vec![0.4, 0.4],
            |x| (x[0] + x[1]).max(0.0),
        ),
        // P(x > 0.3) = 0.35: V_2 = 0.35 0.65 beside V_1 = 1/12
        case(
            "a step",
            uniforms(2),
            shares(&[1.0 / 12.0, 0.35 * 0.65]),
            |x| 0.5 * x[0] + f64::from(x[1] > 0.3),
        ),
        case("one input", normals(1), vec![1.0], |x| x[0].exp()),
    ]
}

/// Rounding of the model's own few operations, beside the errors that are claimed.
const ROUNDING: f64 = 1e-13;

fn run(kind: Kind, case: &Known) -> (Analysis, usize) {
    let method = Method {
        samples: 256,
        most_runs: 300,
        ..Method::of(kind)
    };
    let campaign = Campaign::new(&case.inputs, method).expect("a design");
    until_enough(campaign, |x| (case.model)(x))
}

fn error_of(found: &Analysis, known: &Known) -> Option<f64> {
    found.first_order.as_deref().map(|s| known.error_of(s))
}

#[test]
fn every_method_is_right_to_its_error_or_names_its_state() {
    let mut wrong = Vec::new();
    println!("case                       method       runs  status               true     claimed");
    for case in cases() {
        for kind in Kind::ALL {
            let (found, runs) = run(kind, &case);
            if let Some(fault) = fault(&found) {
                wrong.push(format!("{} by {}: {fault}", case.family, kind.as_str()));
            }
            let error = error_of(&found, &case);
            let claimed = found.error.total;
            println!(
                "{:26} {:10} {runs:6}  {:19} {:>8} {:>8}",
                case.family,
                kind.as_str(),
                found.status.as_str(),
                error.map_or("-".to_owned(), |e| format!("{e:.1e}")),
                claimed.map_or("-".to_owned(), |e| format!("{e:.1e}")),
            );
            let right = match error.zip(claimed) {
                Some((error, claimed)) => error <= claimed + ROUNDING,
                None => found.first_order.is_none() && found.status != Status::Ok,
            };
            if !right {
                wrong.push(format!("{} by {}: {found:?}", case.family, kind.as_str()));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn moments_beyond_double_precision_are_left_out_with_a_reason() {
    for (unit, kind) in [1e300, 1e-300]
        .into_iter()
        .flat_map(|unit| Kind::ALL.map(|kind| (unit, kind)))
    {
        let case = case("", uniforms(4), Vec::new(), move |x| unit * product(x));
        let (found, _) = run(kind, &case);
        assert_eq!(found.variance, None, "{kind:?}");
        let mean = found.mean.expect("a mean");
        assert!((mean / unit - 1.0).abs() < 0.2, "{kind:?}: {mean:e}");
        let reason = found.reason.as_deref().unwrap_or("");
        assert!(reason.contains("beyond the range"), "{kind:?}: {reason}");
    }
}

#[test]
fn a_single_input_has_all_of_the_variance_and_the_lines_know_it() {
    let known = case("one input", normals(1), vec![1.0], |x| x[0].exp());
    for kind in [Kind::Mdrm, Kind::Bivariate, Kind::Tensor, Kind::Auto] {
        let (found, runs) = run(kind, &known);
        assert_eq!(runs, 5, "{kind:?}");
        assert!(
            error_of(&found, &known) <= Some(ROUNDING),
            "{kind:?} {found:?}"
        );
        assert!(found.error.total <= Some(ROUNDING), "{kind:?} {found:?}");
    }
}

#[test]
fn a_constant_has_no_indices_by_any_method() {
    for value in [0.0, 7.25, -1e300, 1e-320] {
        for kind in Kind::ALL {
            let case = case("constant", uniforms(3), Vec::new(), move |_| value);
            let (found, _) = run(kind, &case);
            assert_eq!(found.status, Status::Constant, "{kind:?} {found:?}");
            assert_eq!(
                (found.mean, found.variance),
                (Some(value), Some(0.0)),
                "{kind:?}"
            );
            assert!(
                found.first_order.is_none() && fault(&found).is_none(),
                "{kind:?} {found:?}"
            );
        }
    }
}

/// Some points of each sort: the cut point, and for a method on lines one of the second line and two off the lines, else
/// two samples and the last one.
fn victims(campaign: &Campaign) -> Vec<usize> {
    let last = campaign.points().len() - 1;
    match campaign.design() {
        Some(design) => {
            let checks = design.checks().iter().map(|check| check.ordinal());
            let mut victims = vec![0, design.lines()[1].ordinals()[4]];
            victims.extend(checks.take(2));
            victims.push(last);
            victims
        }
        None => vec![0, 1, 17, last],
    }
}

#[test]
fn a_failed_run_of_any_sort_is_named_and_costs_accuracy() {
    let known = case("a product", uniforms(4), product_exact(), product);
    for kind in Kind::ALL {
        let method = Method {
            samples: 256,
            most_runs: 300,
            ..Method::of(kind)
        };
        let start = Campaign::new(&known.inputs, method).expect("a design");
        for victim in victims(&start) {
            for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
                let (found, _) = to_the_end(start.clone(), |ordinal, x| {
                    if ordinal == victim { bad } else { product(x) }
                });
                let context = format!("{kind:?}, point {victim} {bad}: {found:?}");
                assert_eq!(fault(&found), None, "{context}");
                let reason = found.reason.as_deref().unwrap_or("");
                let scattered = matches!(kind, Kind::Pce | Kind::Saltelli);
                if victim == 0 && !scattered {
                    assert_eq!(found.status, Status::Unusable, "{context}");
                    assert!(reason.contains("point 0 "), "{context}");
                    continue;
                }
                assert!(reason.contains(&victim.to_string()), "{context}");
                let error = error_of(&found, &known).expect("indices");
                let claimed = found.error.total.expect("an error");
                assert!(error <= claimed, "{error:e} {context}");
            }
        }
    }
}

#[test]
fn when_every_run_fails_nothing_is_said() {
    for kind in Kind::ALL {
        for bad in [f64::NAN, f64::INFINITY] {
            let case = case("failed", uniforms(3), Vec::new(), move |_| bad);
            let (found, _) = run(kind, &case);
            assert_eq!(found.status, Status::Unusable, "{kind:?} {found:?}");
            assert_eq!(fault(&found), None, "{kind:?} {found:?}");
            assert_eq!((found.mean, found.first_order), (None, None), "{kind:?}");
        }
    }
}

#[test]
fn a_thousand_inputs_are_analysed_or_refused() {
    let slope = |i: usize| if i < 3 { 1.0 } else { 0.01 };
    let parts: Vec<f64> = (0..1000).map(|i| slope(i) * slope(i)).collect();
    let known = case("a sum", uniforms(1000), shares(&parts), move |x| {
        5.0 + x.iter().enumerate().map(|(i, x)| slope(i) * x).sum::<f64>()
    });
    for kind in Kind::ALL {
        let method = Method {
            samples: if kind == Kind::Saltelli { 16 } else { 200 },
            ..Method::of(kind)
        };
        let campaign = match Campaign::new(&known.inputs, method) {
            Ok(campaign) => campaign,
            Err(refused) => {
                println!("{}: {refused}", kind.as_str());
                let too_many = matches!(refused, DesignError::TooManyCheckPoints { .. });
                assert!(too_many && matches!(kind, Kind::Tensor | Kind::Bivariate));
                continue;
            }
        };
        let (found, runs) = until_enough(campaign, &known.model);
        assert_eq!(fault(&found), None, "{kind:?}");
        let error = error_of(&found, &known).expect("indices");
        let claimed = found.error.total.expect("an error");
        println!(
            "{}: {runs} runs, {error:.1e} of {claimed:.1e}",
            kind.as_str()
        );
        assert!(
            error <= claimed + ROUNDING,
            "{kind:?}: {error:e} of {claimed:e}"
        );
    }
}

#[test]
fn one_or_two_nodes_or_samples_say_what_they_cannot_know() {
    let known = case("a product", uniforms(4), product_exact(), product);
    for kind in Kind::ALL {
        for size in [1, 2] {
            let method = Method {
                nodes: size,
                samples: size,
                most_runs: 40,
                ..Method::of(kind)
            };
            let campaign = Campaign::new(&known.inputs, method).expect("a design");
            let (found, runs) = until_enough(campaign, &known.model);
            println!(
                "{} of {size}: {runs} runs, {} {:?}",
                kind.as_str(),
                found.status.as_str(),
                found.error
            );
            assert_eq!(fault(&found), None, "{kind:?} {found:?}");
            assert_ne!(
                found.status,
                Status::Constant,
                "{kind:?} of {size} doesn't know that"
            );
            let Some(error) = error_of(&found, &known) else {
                assert_eq!(found.status, Status::Unusable, "{kind:?} of {size}");
                continue;
            };
            // A rule of two nodes can't tell what it misses, and says so.
            let claimed = found.error.total.expect("an error");
            let unknown = found.error.quadrature.is_none() && found.error.sampling.is_none();
            assert!(
                unknown || error <= claimed,
                "{kind:?} of {size}: {error:e} of {claimed:e}"
            );
        }
    }
}
