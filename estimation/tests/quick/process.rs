//! Gaussian processes against scikit-learn, whose figures `lab/peers/force/exact_figures.py` printed.

use estimation::model::ann::{Shape, train};
use estimation::model::contract::Prediction;
use estimation::model::gpr::{
    Bounds, Kernel, PointRows, Posterior, RowPairs, Search, log_likelihood, search,
};
use estimation::recipe::{Activation, Loss};
use ndarray::{Array1, Array2};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use serde_json::Value;

fn figures() -> Value {
    serde_json::from_str(include_str!("../data/gpr.json")).expect("figures")
}

fn numbers(value: &Value) -> Vec<f64> {
    let of = |value: &Value| value.as_f64().expect("a number");
    value.as_array().expect("a list").iter().map(of).collect()
}

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

/// The data set of the figures: 60 rows of 3 features, scaled forces, 5 new rows.
fn data() -> (Array2<f64>, Vec<f64>, Array2<f64>) {
    let x = Array2::from_shape_fn((60, 3), |(i, j)| {
        (0.7 * (i * (j + 1)) as f64 + j as f64).sin()
    });
    let of = |(i, x): (usize, ndarray::ArrayView1<'_, f64>)| {
        3.0 + 2.0 * (2.0 * x[0]).sin() + x[1] * x[2] + 0.2 * (5.0 * (i * i) as f64).sin()
    };
    let y: Vec<f64> = x.rows().into_iter().enumerate().map(of).collect();
    let mean = y.iter().sum::<f64>() / 60.0;
    let deviation = (y.iter().map(|y| (y - mean) * (y - mean)).sum::<f64>() / 60.0).sqrt();
    let z = y.iter().map(|y| (y - mean) / deviation).collect();
    let new = Array2::from_shape_fn((5, 3), |(k, j)| {
        0.9 * (1.3 * k as f64 + 2.0 * j as f64).cos()
    });
    (x, z, new)
}

fn kernel(figures: &Value) -> Kernel {
    Kernel {
        variance: number(&figures["variance"]),
        lengths: numbers(&figures["lengths"]),
        noise: number(&figures["noise"]),
        line: None,
    }
}

/// Rounding of a 60 x 60 system whose condition is some 1e3: far below 1e-9, the tolerance everywhere here.
const ROUNDING: f64 = 1e-9;

fn near(found: f64, expected: f64, what: &str) {
    assert!(
        (found - expected).abs() < ROUNDING * expected.abs().max(1.0),
        "{what}: {found} for {expected}"
    );
}

#[test]
fn likelihoods_means_deviations_and_left_out_rows_are_scikit_learn_s() {
    let figures = figures();
    let (x, z, new) = data();
    let rows = PointRows::from_rows(&x.view());
    let pairs = RowPairs::new(&rows);
    for kind in ["shared", "each"] {
        let expected = &figures["small"]["fixed"][kind];
        let kernel = kernel(expected);
        let likelihood = log_likelihood(&kernel, &pairs, &z).expect("a factor");
        near(
            likelihood.value,
            number(&expected["log_likelihood"]),
            "log likelihood",
        );
        for (g, expected) in likelihood
            .gradient
            .iter()
            .zip(numbers(&expected["gradient"]))
        {
            near(*g, expected, "gradient");
        }
        let posterior = Posterior::new(&kernel, &rows, &z).expect("a factor");
        let check = |found: Vec<Prediction>, means: &Value, deviations: &Value| {
            for ((found, mean), deviation) in
                found.iter().zip(numbers(means)).zip(numbers(deviations))
            {
                near(found.mean, mean, "mean");
                near(found.deviation, deviation, "deviation");
            }
        };
        let of_new = new
            .rows()
            .into_iter()
            .map(|row| posterior.predict(&kernel, &row.to_vec()))
            .collect();
        check(of_new, &expected["new_mean"], &expected["new_std"]);
        check(
            posterior.left_out(),
            &expected["left_out_mean"],
            &expected["left_out_std"],
        );
    }
}

/// Central differences of step h are off by h^2 times a third derivative of order 10, and by rounding over h: 1e-7 at 1e-4.
#[test]
fn gradients_are_those_of_differences() {
    let (x, z, _) = data();
    let rows = PointRows::from_rows(&x.view());
    let pairs = RowPairs::new(&rows);
    for logs in [
        vec![0.3, -0.2, -3.0, -0.5],
        vec![0.3, -0.2, 0.4, 0.9, -3.0, 0.7],
    ] {
        let at = |logs: &[f64]| {
            log_likelihood(&Kernel::from_logs(logs, true), &pairs, &z).expect("a factor")
        };
        for (place, g) in at(&logs).gradient.iter().enumerate() {
            let moved = |h: f64| {
                let mut moved = logs.clone();
                moved[place] += h;
                at(&moved).value
            };
            let difference = (moved(1e-4) - moved(-1e-4)) / 2e-4;
            assert!((g - difference).abs() < 1e-6, "{place}: {g} {difference}");
        }
    }
}

/// The likelihood is flat at its top: where its gradient is 1e-5, it is known to far better than 1e-6.
#[test]
fn the_search_finds_scikit_learn_s_optimum() {
    let figures = figures();
    let (x, z, _) = data();
    let rows = PointRows::from_rows(&x.view());
    let pairs = RowPairs::new(&rows);
    for (kind, each) in [("shared", false), ("each", true)] {
        let wanted = Search {
            each,
            line: false,
            restarts: 50,
            seed: 1,
            bounds: Bounds::default(),
        };
        let found = search(&rows, &z, &wanted).expect("a kernel");
        let value = log_likelihood(&found, &pairs, &z).expect("a factor").value;
        let expected = number(&figures["small"]["optimum"][kind]["log_likelihood"]);
        assert!(
            (value - expected).abs() < 1e-6,
            "{kind}: {value} for {expected}"
        );
    }
}

/// scikit-learn's least loss over ten starts, with 1 % for one more start than it had.
#[test]
fn networks_reach_scikit_learn_s_loss() {
    let (x, z, _) = data();
    let shape = Shape {
        sizes: vec![3, 8, 1],
        hidden: Activation::Tanh,
        output: Activation::Linear,
        loss: Loss::Mse,
        decay: 1e-3,
    };
    let targets = Array1::from(z);
    let reached = (0..10).filter_map(|seed| {
        let start = shape.drawn(&mut ChaCha8Rng::seed_from_u64(seed));
        train(&shape, &start, &x.view(), &targets.view(), 5000, &|_| true).map(|(_, loss)| loss)
    });
    let least = reached.fold(f64::INFINITY, f64::min);
    let expected = number(&figures()["small"]["network"]["least_loss"]);
    assert!(least <= expected, "{least} for {expected}");
}
