//! The method that chooses for itself, on every closed model: runs, claimed and true error.

use gsa::campaign::Campaign;
use gsa::method::analysis::Analysis;
use gsa::method::{Kind, Method};

use super::closed_model::{self, Model};
use crate::asking::until_enough;

/// Asks and tells until the tolerance is met or 1000 runs are spent.
fn run(model: &Model, seed: u64) -> (Analysis, usize) {
    let method = Method {
        seed,
        ..Method::of(Kind::Auto)
    };
    let campaign = Campaign::new(&model.inputs, method).expect("a valid campaign");
    until_enough(campaign, |x| closed_model::value(&model.name, x))
}

/// The tolerance is 0.02. Sparse polynomial chaos of another library has a true error of 9e-3 for Ishigami at 500 runs, and of
/// 2.7e-2 for the piston at 51: there auto is no better, and needs several hundred runs until its own claim is small.
/// The g function with a = 0 is zero at its cut point, and its interactions are kinks: the budget ends before its claim is small.
#[test]
fn auto_meets_its_tolerance_in_few_runs() {
    let most = |name: &str| match name {
        "ishigami" => 120,
        "sobol_g_c" => 320,
        "poly_sign_change" => 40,
        "additive_linear_normal" | "shifted_product_plus" | "product_5_uniform" => 31,
        _ => 1000,
    };
    println!("model                        runs   claimed      true   (largest of 5 seeds each)");
    let (mut all_covered, mut all) = (0, 0);
    for model in closed_model::all() {
        let (mut runs, mut claimed, mut truth, mut covered) = (0, 0.0f64, 0.0f64, 0);
        for seed in 1..=5 {
            let (found, count) = run(&model, seed);
            runs = runs.max(count);
            let Some(first_order) = &found.first_order else {
                panic!("{}: {:?}", model.name, found.reason);
            };
            let pairs = first_order.iter().zip(&model.exact.first_order);
            let error = pairs
                .map(|(s, exact)| (s - exact).abs())
                .fold(0.0, f64::max);
            let claim = found.error.total.expect("an error");
            // the near-constant model has its rounding alone
            covered += usize::from(error <= claim.max(1e-9));
            (claimed, truth) = (claimed.max(claim), truth.max(error));
        }
        println!(
            "{:27} {runs:5}  {claimed:8.1e}  {truth:8.1e}  {covered} of 5 covered",
            model.name
        );
        assert!(runs <= most(&model.name), "{}: {runs} runs", model.name);
        // the kinks of this product need more than the 33 nodes a line can have, and more points elsewhere don't mend that
        let ends_early = model.name == "sobol_g_c";
        if runs < 1000 && !ends_early {
            assert!(claimed <= 0.02, "{}: {claimed}", model.name);
        }
        all_covered += covered;
        all += 5;
    }
    println!("covered {all_covered} of {all}");
    assert_eq!(all_covered, all);
}
