//! Decisions on the form that answers, with their status and reason.

use gsa::campaign::Campaign;
use gsa::design::Design;
use gsa::law::distribution::Distribution;
use gsa::method::analysis::{Analysis, Form, Status};
use gsa::method::lines::analyse;
use gsa::method::{Kind, Method};
use ndarray::{Array2, Axis};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

fn design(inputs: usize, nodes: usize, check_points: usize) -> Design {
    let laws = vec![Distribution::normal(0.0, 1.0).expect("a valid law"); inputs];
    Design::new(
        &laws,
        nodes,
        check_points,
        &mut ChaCha8Rng::seed_from_u64(11),
    )
    .expect("a valid design")
}

fn run(design: &Design, model: impl Fn(&[f64]) -> f64) -> Array2<f64> {
    let values = design.points().iter().map(|x| model(x)).collect();
    Array2::from_shape_vec((design.points().len(), 1), values).expect("one value per point")
}

fn analysis(design: &Design, model: impl Fn(&[f64]) -> f64) -> Analysis {
    analyse(design, &run(design, model).view()).remove(0)
}

fn reason(analysis: &Analysis) -> &str {
    analysis.reason.as_deref().unwrap_or("")
}

/// A product whose first factor changes sign, with a cut value of 6.
fn sign_changing_product(x: &[f64]) -> f64 {
    (0.5 + x[0]) * (6.0 + x[1]) * (2.0 + x[2] * x[2])
}

#[test]
fn a_sign_change_alone_does_not_break_a_product_that_the_check_points_confirm() {
    let found = analysis(&design(3, 5, 6), sign_changing_product);
    assert_eq!((found.status, found.method), (Status::Ok, Form::Mdrm));
    assert!(
        reason(&found).contains("changes sign along the cut line of input 1"),
        "{found:?}"
    );
    assert!(reason(&found).contains("6 check points"), "{found:?}");
    // q = 4, 1/36, 2/9
    let whole = 5.0 * (37.0 / 36.0) * (11.0 / 9.0) - 1.0;
    let first_order = found.first_order.unwrap();
    for (s, q) in first_order.iter().zip([4.0, 1.0 / 36.0, 2.0 / 9.0]) {
        assert!((s - q / whole).abs() < 1e-14, "{s} {}", q / whole);
    }
    assert!(found.error.decomposition.unwrap() < 1e-14);
}

#[test]
fn a_sign_change_without_check_points_breaks_the_product() {
    let found = analysis(&design(3, 5, 0), sign_changing_product);
    assert_eq!(
        (found.status, found.method),
        (Status::ProductFormBroken, Form::Additive)
    );
    assert!(
        reason(&found).contains("input 1") && reason(&found).contains("no check point"),
        "{found:?}"
    );
    assert_eq!(found.first_order, found.total);
    assert!(found.mdrm_first_order.unwrap()[0] > 0.7);
    assert_eq!(found.error.decomposition, None);
    assert!(found.error.total.is_some());
}

#[test]
fn an_additive_output_is_recognised_by_its_check_points() {
    let found = analysis(&design(3, 5, 5), |x| 20.0 + x[0] + 2.0 * x[1] + 3.0 * x[2]);
    assert_eq!(
        (found.status, found.method),
        (Status::ProductFormBroken, Form::Additive)
    );
    assert!(reason(&found).contains("misses the model"), "{found:?}");
    let first_order = found.first_order.as_ref().unwrap();
    for (s, share) in first_order.iter().zip([1.0, 4.0, 9.0]) {
        assert!((s - share / 14.0).abs() < 1e-14);
    }
    assert_eq!(found.total, found.first_order);
    assert!(
        (found.mean.unwrap() - 20.0).abs() < 1e-13
            && (found.variance.unwrap() - 14.0).abs() < 1e-12
    );
    assert!(found.error.decomposition.unwrap() < 1e-14);
    // the product's own numbers are shown, and differ
    assert!(found.mdrm_total.unwrap()[0] > first_order[0]);
}

#[test]
fn a_small_reference_value_is_a_doubt_and_zero_a_fault() {
    // 0.005 against a spread of sqrt(6)
    let squares = |offset: f64| move |x: &[f64]| offset + x.iter().map(|x| x * x).sum::<f64>();
    let found = analysis(&design(3, 5, 0), squares(0.005));
    assert_eq!(found.status, Status::ProductFormBroken);
    assert!(
        reason(&found).contains("less than a hundredth"),
        "{found:?}"
    );
    assert!(found.mdrm_first_order.is_some());
    for check_points in [0, 5] {
        let found = analysis(&design(3, 5, check_points), squares(0.0));
        assert_eq!(found.status, Status::ProductFormBroken);
        assert!(found.mdrm_first_order.is_none() && found.mdrm_total.is_none());
        assert!(reason(&found).contains("cut point is zero"), "{found:?}");
        for s in found.first_order.unwrap() {
            assert!((s - 1.0 / 3.0).abs() < 1e-14);
        }
    }
}

#[test]
fn a_section_without_a_mean_has_no_product_form() {
    // E[1 - x^2] = 0 with h0 = 1
    let found = analysis(&design(2, 5, 4), |x| (1.0 - x[0] * x[0]) * (3.0 + x[1]));
    assert_eq!(found.status, Status::ProductFormBroken);
    assert!(
        reason(&found).contains("mean of the output along the cut line of input 1 is zero"),
        "{found:?}"
    );
    assert!(found.first_order.is_some() && found.mdrm_first_order.is_none());
}

#[test]
fn a_constant_has_no_indices() {
    for value in [0.0, 7.25, -1e300, 1e-320] {
        let found = analysis(&design(3, 5, 4), |_| value);
        assert_eq!(found.status, Status::Constant);
        assert_eq!((found.mean, found.variance), (Some(value), Some(0.0)));
        assert_eq!(
            (&found.first_order, &found.total, found.error.total),
            (&None, &None, None)
        );
        assert_eq!(found.error.floor, 1.0);
        assert!(!reason(&found).is_empty());
    }
    let rounded = |x: &[f64]| 3.0 + x[0] * f64::EPSILON;
    assert_eq!(analysis(&design(3, 5, 4), rounded).status, Status::Constant);
}

#[test]
fn an_interaction_that_vanishes_on_the_lines_is_not_a_constant() {
    let found = analysis(&design(3, 5, 8), |x| x[0] * x[1] * x[2] + 5.0);
    // at least one of the check points has three coordinates off the cut
    assert_eq!(found.status, Status::ProductFormBroken);
    assert_eq!((&found.first_order, &found.mean), (&None, &None));
    assert!(reason(&found).contains("not along any cut line"));
}

/// exp(-k^2 t) depends on t nowhere on t's line at k = 0. Indices by 200 x 200 Gauss points.
#[test]
fn a_flat_line_hides_an_effect_and_the_error_reaches_it() {
    let laws = [(-1.0, 1.0), (0.0, 5.0)].map(|(low, high)| Distribution::uniform(low, high));
    let laws = laws.map(|law| law.expect("a valid law"));
    let model = |x: &[f64]| (-x[0] * x[0] * x[1]).exp();
    for seed in 0..20 {
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        let design = Design::new(&laws, 5, 5, &mut rng).expect("a valid design");
        let found = analysis(&design, model);
        let errors = found.error.by_input.as_deref().unwrap_or_default();
        let first_order = found.first_order.as_deref().unwrap_or_default();
        for ((s, claimed), exact) in first_order.iter().zip(errors).zip([0.66992, 0.24509]) {
            assert!((s - exact).abs() <= *claimed, "{seed} {found:?}");
        }
        assert!(reason(&found).contains("input 2") && reason(&found).contains("auto"));
    }
    let mut rng = ChaCha8Rng::seed_from_u64(0);
    let unchecked = Design::new(&laws, 5, 0, &mut rng).expect("a valid design");
    assert!(reason(&analysis(&unchecked, model)).contains("there is no check point"));
}

/// x + y and x + y + 4 max(0, x - y)^2 are one model where x > y fails: S_x is 0.5 or 0.7237 (midpoints, 1000 x 1000).
#[test]
fn an_error_of_one_is_claimed_where_half_of_the_runs_failed() {
    let laws = vec![Distribution::uniform(0.0, 1.0).expect("a valid law"); 2];
    for kind in Kind::ALL {
        let campaign = Campaign::new(&laws, Method::of(kind)).expect("a valid campaign");
        let run = |x: &Vec<f64>| match x[0] > x[1] {
            true => f64::NAN,
            false => x[0] + x[1],
        };
        let values: Vec<f64> = campaign.points().iter().map(run).collect();
        let values = Array2::from_shape_vec((values.len(), 1), values).expect("a column");
        let found = campaign.analyse(&values.view()).expect("rules exist");
        assert_eq!(found[0].error.by_input, Some(vec![1.0; 2]), "{kind:?}");
        assert!(reason(&found[0]).contains("too many to say"), "{kind:?}");
    }
}

#[test]
fn a_failed_run_on_a_line_is_named_and_costs_accuracy() {
    let design = design(3, 5, 4);
    let model = |x: &[f64]| 5.0 + x[0] + (0.3 * x[1]).exp() + x[2];
    let whole = analysis(&design, model);
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let mut values = run(&design, model);
        let ordinal = design.lines()[1].ordinals()[4];
        values[[ordinal, 0]] = bad;
        let found = analyse(&design, &values.view()).remove(0);
        assert_eq!(found.status, whole.status);
        assert!(
            reason(&found).contains(&format!("their lines: {ordinal}")),
            "{found:?}"
        );
        let pairs = [(&found.first_order, &whole.first_order)];
        for (less, all) in pairs
            .into_iter()
            .flat_map(|(a, b)| a.iter().flatten().zip(b.iter().flatten()))
        {
            let claimed = found.error.total.unwrap();
            assert!(
                less != all && (less - all).abs() < claimed,
                "{less} {all} {claimed}"
            );
        }
        assert!(found.error.quadrature > whole.error.quadrature);
    }
}

#[test]
fn without_the_cut_point_or_half_a_line_an_output_is_unusable_and_the_point_named() {
    let design = design(3, 5, 4);
    let line = design.lines()[1].ordinals();
    for (lost, named) in [(&[0][..], 0), (&[line[0], line[1], line[4]][..], line[0])] {
        let mut values = run(&design, |x| 5.0 + x[0]);
        lost.iter()
            .for_each(|&ordinal| values[[ordinal, 0]] = f64::NAN);
        let found = analyse(&design, &values.view()).remove(0);
        assert_eq!(found.status, Status::Unusable);
        assert!(
            reason(&found).contains(&format!("point {named} ")),
            "{found:?}"
        );
        assert_eq!(
            (found.mean, found.variance, found.error.total),
            (None, None, None)
        );
        assert!(found.first_order.is_none() && found.mdrm_first_order.is_none());
    }
}

#[test]
fn a_failed_check_point_is_left_out_and_named() {
    let design = design(2, 5, 4);
    let lost = design.checks()[2].ordinal();
    let product = |x: &[f64]| (8.0 + x[0]) * (9.0 + x[1]);
    let mut values = run(&design, product);
    values[[lost, 0]] = f64::NAN;
    let found = analyse(&design, &values.view()).remove(0);
    assert_eq!(found.status, Status::Ok);
    assert!(reason(&found).contains(&lost.to_string()), "{found:?}");
    assert!(found.error.decomposition.unwrap() < 1e-13);
    for check in design.checks() {
        values[[check.ordinal(), 0]] = f64::NAN;
    }
    let found = analyse(&design, &values.view()).remove(0);
    assert_eq!(
        (found.status, found.error.decomposition),
        (Status::Ok, None)
    );
}

#[test]
fn a_check_point_out_of_all_proportion_is_an_error_of_one() {
    let design = design(2, 5, 4);
    let mut values = run(&design, |x| 1e-300 * (8.0 + x[0]) * (9.0 + x[1]));
    for check in design.checks() {
        values[[check.ordinal(), 0]] = 1e300;
    }
    let found = analyse(&design, &values.view()).remove(0);
    assert_eq!(
        (found.error.decomposition, found.error.total),
        (Some(1.0), Some(1.0))
    );
}

#[test]
fn a_single_input_has_all_of_the_variance() {
    for model in [|x: &[f64]| 3.0 + x[0] * x[0], |x: &[f64]| x[0] - 0.5] {
        let found = analysis(&design(1, 5, 4), model);
        assert_eq!(found.status, Status::Ok);
        let indices = [found.first_order.unwrap()[0], found.total.unwrap()[0]];
        assert!(
            indices.iter().all(|s| (s - 1.0).abs() < 4.0 * f64::EPSILON),
            "{indices:?}"
        );
        assert_eq!(
            (found.error.quadrature, found.error.decomposition),
            (Some(0.0), Some(0.0))
        );
    }
}

#[test]
fn rough_sections_show_in_the_quadrature_error() {
    let kink = |x: &[f64]| 1.0 + x[0].max(0.3) + 0.5 * x[1];
    let smooth = |x: &[f64]| 3.0 + 0.3 * x[0] + 0.5 * x[1];
    let error =
        |model: fn(&[f64]) -> f64, nodes| analysis(&design(2, nodes, 4), model).error.quadrature;
    assert!(error(kink, 5).unwrap() > 0.01);
    assert!(error(smooth, 5).unwrap() < 1e-14);
    assert_eq!(error(kink, 2), None);
}

#[test]
fn outputs_are_analysed_each_by_itself_and_fast() {
    let design = design(5, 5, 5);
    let outputs = 5000;
    let values = Array2::from_shape_fn((design.points().len(), outputs), |(point, output)| {
        let x = &design.points()[point];
        let weight = output as f64 / outputs as f64;
        (4.0 + weight * x[0])
            * (5.0 + (1.0 - weight) * x[1])
            * (9.0 + x[2])
            * (8.0 + x[3])
            * (7.0 + x[4])
    });
    let start = std::time::Instant::now();
    let all = analyse(&design, &values.view());
    let elapsed = start.elapsed();
    println!(
        "{outputs} outputs at {} points in {elapsed:?}",
        design.points().len()
    );
    assert_eq!(all.len(), outputs);
    let alone = analyse(&design, &values.select(Axis(1), &[1234]).view());
    assert_eq!(all[1234], alone[0]);
    // A thousand times what it takes, so that only a wrong order of growth fails.
    assert!(elapsed.as_secs() < 30, "{elapsed:?}");
}

#[test]
#[should_panic(expected = "3 rows of values for the 13 points")]
fn the_wrong_number_of_rows_is_a_mistake_of_the_caller() {
    analyse(&design(3, 5, 0), &Array2::zeros((3, 1)).view());
}

/// k^2 sqrt(t) at k = 0: the line along t is flat, and what other points show of it has an infinite slope. Judged by the line alone, a whole grid
/// claimed 8e-5 for 3e-3.
#[test]
fn a_singular_effect_behind_a_flat_line_is_covered() {
    let inputs = [
        Distribution::uniform(-1.0, 1.0).expect("a valid law"),
        Distribution::uniform(0.0, 1.0).expect("a valid law"),
    ];
    // E[k^2] = 1/3, E[k^4] = 1/5; E[sqrt t] = 2/3, E[t] = 1/2
    let variance = 1.0 / 10.0 - 4.0 / 81.0;
    let expected = [4.0 / 45.0 * 4.0 / 9.0, 1.0 / 9.0 / 18.0].map(|v| v / variance);
    for (kind, seed) in [Kind::Tensor, Kind::Bivariate, Kind::Auto]
        .into_iter()
        .flat_map(|kind| (1..6).map(move |seed| (kind, seed)))
    {
        let settings = Method {
            seed,
            ..Method::of(kind)
        };
        let mut campaign = Campaign::new(&inputs, settings).expect("a campaign");
        let found = loop {
            let points = campaign.points();
            let values: Vec<f64> = points.iter().map(|x| x[0] * x[0] * x[1].sqrt()).collect();
            let count = values.len();
            let values = Array2::from_shape_vec((count, 1), values).expect("a column");
            let found = campaign
                .tell(&values.view())
                .expect("an analysis")
                .remove(0);
            if campaign.points().len() == count {
                break found;
            }
        };
        let first_order = found.first_order.expect("indices");
        let claimed = found.error.by_input.expect("errors");
        for input in 0..2 {
            let error = (first_order[input] - expected[input]).abs();
            assert!(
                error <= claimed[input] && claimed[input] < 0.1,
                "{kind:?} {seed} {input}: {error} {claimed:?}"
            );
        }
    }
}
