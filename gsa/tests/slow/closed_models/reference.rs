//! M-DRM against 50-digit arithmetic, on every closed model, cut point and rule size.

use gsa::method::analysis::{Analysis, Status};
use gsa::method::lines::analyse;

use super::closed_model::{self, Model, Reference};

/// Indices come from some N n sums of products, each off by a few eps, and the model's own rounding.
const TOLERANCE: f64 = 1e-11;

/// Relative standard deviation 6e-8: rounding of the model itself is eps/6e-8 = 4e-9 of it, averaged over the nodes.
const TOLERANCE_AT_THE_FLOOR: f64 = 1e-9;

fn tolerance(model: &Model) -> f64 {
    match model.name.as_str() {
        "nearly_constant_1e-14" => TOLERANCE_AT_THE_FLOOR,
        _ => TOLERANCE,
    }
}

fn largest_difference(found: &[f64], expected: &[f64]) -> f64 {
    assert_eq!(found.len(), expected.len());
    let differences = found.iter().zip(expected).map(|(f, e)| (f - e).abs());
    differences.fold(0.0, f64::max)
}

fn assert_numbers_exist(analysis: &Analysis, context: &str) {
    let lists = [
        &analysis.first_order,
        &analysis.total,
        &analysis.mdrm_first_order,
        &analysis.mdrm_total,
    ];
    let parts = [
        analysis.mean,
        analysis.variance,
        analysis.error.quadrature,
        analysis.error.decomposition,
        analysis.error.total,
        Some(analysis.error.floor),
    ];
    let in_lists = lists.into_iter().flatten().flatten();
    assert!(
        in_lists
            .chain(parts.iter().flatten())
            .all(|x| x.is_finite()),
        "{context}: {analysis:?}"
    );
}

#[test]
fn formulas_are_those_of_the_reference() {
    for model in closed_model::all() {
        for (x, expected) in &model.values {
            let found = closed_model::value(&model.name, x);
            // Points are printed with six digits but meant exactly; a value adds a few eps per operation.
            assert!(
                (found / expected - 1.0).abs() < 1e-12,
                "{}: {found:e} for {expected:e}",
                model.name
            );
        }
    }
}

#[test]
fn indices_agree_with_extended_precision() {
    let (mut cases, mut worst) = (0, 0.0f64);
    for model in closed_model::all() {
        let mut worst_of_model = 0.0f64;
        for reference in &model.references {
            if reference.indices.is_some() {
                worst_of_model = worst_of_model.max(compare(&model, reference));
                cases += 1;
            }
        }
        println!("{:28} {worst_of_model:.1e}", model.name);
        worst = worst.max(worst_of_model);
    }
    println!(
        "{cases} cases of {} models, largest difference {worst:.1e}",
        closed_model::all().len()
    );
    assert!(cases >= 60, "only {cases} cases were compared");
}

fn compare(model: &Model, reference: &Reference) -> f64 {
    let context = format!(
        "{} at {} with {} nodes",
        model.name, reference.cut, reference.nodes
    );
    let expected = reference
        .indices
        .as_ref()
        .expect("a reference with indices");
    let design = model.design(&reference.cut, reference.nodes, 0, 1);
    let analysis = &analyse(&design, &model.run(&design).view())[0];
    assert_numbers_exist(analysis, &context);
    let first_order = analysis
        .mdrm_first_order
        .as_ref()
        .expect("a defined product form");
    let total = analysis
        .mdrm_total
        .as_ref()
        .expect("a defined product form");
    let difference = largest_difference(first_order, &expected.first_order)
        .max(largest_difference(total, &expected.total));
    assert!(difference <= tolerance(model), "{context}: {difference:e}");
    if analysis.status == Status::Ok {
        let relative = |found: Option<f64>, expected: Option<f64>| {
            (found.expect("a moment") / expected.expect("its reference") - 1.0).abs()
        };
        // a variance near the floor has lost what its indices have
        let moments = relative(analysis.mean, reference.mean)
            .max(relative(analysis.variance, reference.variance));
        assert!(
            moments <= 10.0 * tolerance(model),
            "{context}: moments off by {moments:e}"
        );
    }
    difference
}

#[test]
fn status_follows_the_cut_lines_where_nothing_else_speaks() {
    let mut cases = 0;
    for model in closed_model::all() {
        for reference in &model.references {
            let design = model.design(&reference.cut, reference.nodes, 0, 1);
            let analysis = &analyse(&design, &model.run(&design).view())[0];
            let context = format!(
                "{} at {} with {} nodes",
                model.name, reference.cut, reference.nodes
            );
            assert_numbers_exist(analysis, &context);
            let expected = match reference.status.as_str() {
                "ok" => Status::Ok,
                "sign_change" | "rho_zero" => Status::ProductFormBroken,
                // a product of three zeros shows nothing at all on its lines
                "h0_zero" if model.name == "product_zero_means" => Status::Constant,
                "h0_zero" => Status::ProductFormBroken,
                // the sections are refitted from their other nodes
                "node_outside_domain" => Status::Ok,
                other => panic!("unknown status {other}"),
            };
            assert_eq!(
                analysis.status, expected,
                "{context}: {:?}",
                analysis.reason
            );
            assert_eq!(
                analysis.reason.is_some(),
                expected != Status::Ok || reference.status == "node_outside_domain",
                "{context}"
            );
            cases += 1;
        }
    }
    println!("{cases} statuses checked");
}

#[test]
fn undefined_product_forms_come_out_broken_and_without_product_numbers() {
    let mut cases = 0;
    for model in closed_model::all() {
        for reference in model
            .references
            .iter()
            .filter(|r| r.status == "h0_zero" || r.status == "rho_zero")
        {
            let design = model.design(&reference.cut, reference.nodes, 5, 1);
            let analysis = &analyse(&design, &model.run(&design).view())[0];
            let context = format!(
                "{} at {} with {} nodes",
                model.name, reference.cut, reference.nodes
            );
            assert_numbers_exist(analysis, &context);
            assert_eq!(
                analysis.status,
                Status::ProductFormBroken,
                "{context}: {:?}",
                analysis.reason
            );
            assert!(
                analysis.mdrm_first_order.is_none() && analysis.mdrm_total.is_none(),
                "{context}"
            );
            cases += 1;
        }
    }
    println!("{cases} undefined product forms checked");
}

#[test]
fn outputs_at_the_ends_of_double_precision_keep_their_indices() {
    let models = closed_model::all();
    let model = models
        .iter()
        .find(|m| m.name == "scale_huge_1e150")
        .expect("the model is in the data");
    let reference = model
        .references
        .iter()
        .find(|r| r.nodes == 7)
        .expect("seven nodes");
    let expected = &reference.indices.as_ref().expect("indices").first_order;
    let design = model.design("mean", 7, 5, 1);
    // Factors in two steps: some are out of range where their product with the output is not.
    for (first, second) in [(1e150, 1.0), (1e157, 1.0), (1e-223, 1e-224)] {
        let values = model.run(&design).mapv(|y| y * first * second);
        let analysis = &analyse(&design, &values.view())[0];
        let context = format!("factor {first:e} times {second:e}: {analysis:?}");
        assert_numbers_exist(analysis, &context);
        let first_order = analysis.first_order.as_ref().expect("indices");
        assert!(
            largest_difference(first_order, expected) <= TOLERANCE,
            "{context}"
        );
        // Var is 6e300 for a factor of one: it leaves the range where E does not.
        assert!(
            analysis.mean.is_some() && analysis.variance.is_none(),
            "{context}"
        );
        assert!(
            analysis
                .reason
                .as_ref()
                .expect("a reason")
                .contains("beyond the range"),
            "{context}"
        );
    }
}
