//! Models that are polynomials: the expansion finds them whole, whether it serves one output or thousands.

use std::collections::BTreeSet;

use gsa::campaign::Campaign;
use gsa::law::distribution::Distribution;
use gsa::method::analysis::{Analysis, Form, Status};
use gsa::method::{Kind, Method};
use ndarray::Array2;

/// Coefficients of x1, x2 and x1 x2, of inputs that are uniform on -1 to 1.
const COEFFICIENTS: [f64; 3] = [2.0, -1.0, 1.5];
/// Least squares of a dozen orthonormal terms on a hundred points loses two digits at most.
const ROUND_OFF: f64 = 100.0 * f64::EPSILON;

fn laws(inputs: usize) -> Vec<Distribution> {
    vec![Distribution::uniform(-1.0, 1.0).expect("a valid law"); inputs]
}

fn chaos(inputs: usize) -> Campaign {
    let method = Method {
        samples: 64,
        ..Method::of(Kind::Pce)
    };
    Campaign::new(&laws(inputs), method).expect("a valid campaign")
}

/// The model and ten times the model, which has the same indices.
fn values(points: &[Vec<f64>]) -> Array2<f64> {
    let [a, b, c] = COEFFICIENTS;
    let y = |x: &[f64]| 3.0 + a * x[0] + b * x[1] + c * x[0] * x[1];
    let values: Vec<f64> = points.iter().flat_map(|x| [y(x), 10.0 * y(x)]).collect();
    Array2::from_shape_vec((points.len(), 2), values).expect("two columns")
}

fn check(found: &Analysis) {
    let [a, b, c] = COEFFICIENTS;
    // E[x^2] = 1/3
    let parts = [a * a / 3.0, b * b / 3.0, c * c / 9.0];
    let variance: f64 = parts.iter().sum();
    let first_order = found.first_order.as_ref().expect("indices");
    let total = found.total.as_ref().expect("indices");
    for input in 0..2 {
        let alone = parts[input] / variance;
        let with_pairs = (parts[input] + parts[2]) / variance;
        assert!((first_order[input] - alone).abs() < ROUND_OFF, "{found:?}");
        assert!((total[input] - with_pairs).abs() < ROUND_OFF, "{found:?}");
    }
}

#[test]
fn analysis_and_survey_find_the_exact_indices() {
    let campaign = chaos(2);
    let values = values(campaign.points());
    let analyses = campaign.analyse(&values.view()).expect("rules exist");
    let surveyed = campaign.survey(&values.view()).expect("rules exist");
    for found in analyses.iter().chain(&surveyed) {
        assert_eq!((found.status, found.method), (Status::Ok, Form::Pce));
        check(found);
    }
}

/// Runs without a number are left out, for all outputs of a survey.
#[test]
fn a_failed_run_costs_a_survey_a_point_and_no_more() {
    let campaign = chaos(2);
    let mut values = values(campaign.points());
    values[[7, 0]] = f64::NAN;
    for found in campaign.survey(&values.view()).expect("rules exist") {
        check(&found);
    }
}

/// A single input has all of the variance, whatever the method's own sums say.
#[test]
fn a_single_input_has_all_of_the_variance() {
    for kind in Kind::ALL {
        let method = Method {
            samples: 64,
            ..Method::of(kind)
        };
        let campaign = Campaign::new(&laws(1), method).expect("a valid campaign");
        let values: Vec<f64> = campaign.points().iter().map(|x| x[0].exp()).collect();
        let values = Array2::from_shape_vec((values.len(), 1), values).expect("one column");
        let found = &campaign.analyse(&values.view()).expect("rules exist")[0];
        assert_eq!(found.first_order, Some(vec![1.0]), "{kind:?}");
        assert_eq!(found.total, Some(vec![1.0]), "{kind:?}");
    }
}

#[test]
fn every_form_has_a_name_of_its_own() {
    let names: BTreeSet<&str> = Form::ALL.into_iter().map(Form::as_str).collect();
    assert_eq!(names.len(), Form::ALL.len());
    let names: BTreeSet<&str> = Status::ALL.into_iter().map(Status::as_str).collect();
    assert_eq!(names.len(), Status::ALL.len());
}
