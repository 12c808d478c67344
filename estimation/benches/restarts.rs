//! Time that the hyperparameters of 1500 rows with 15 features take, with 50 starts, and whether they are those that scikit-learn found with 50 full
//! starts (`lab/peers/force/exact_figures.py --large`, which took it 1231 s of one core).
//!
//! Run it with `cargo bench -p estimation --bench restarts`, on one thread.

use std::time::Instant;

use estimation::model::gpr::{Bounds, Kernel, PointRows, RowPairs, Search, log_likelihood, search};
use ndarray::Array2;

/// Greatest log likelihood that scikit-learn found, and where: the logarithms of variance, length and noise.
const EXPECTED: f64 = 3577.974730661618;
const EXPECTED_LOGS: [f64; 3] = [4.876861928758158, 3.0639675928226358, -7.786010270773344];

/// Presses felt by 15 signals, and scaled forces, from the formulas of the script.
fn data() -> (Array2<f64>, Vec<f64>) {
    let press = |i: usize| 1.0 - (0.05 * i as f64).cos();
    let place = |i: usize| ((0.0071 * i as f64).sin(), (0.0113 * i as f64).cos());
    let x = Array2::from_shape_fn((1500, 15), |(i, j)| {
        let ((a, b), channel) = (place(i), j as f64);
        let felt = 1.0 + 0.5 * (channel + 2.0 * a).sin() + 0.3 * (2.0 * channel + b).cos();
        press(i) * felt + 0.02 * (((j + 3) * i * i) as f64).sin()
    });
    let force = |i: usize| {
        let ((a, b), p) = (place(i), press(i));
        8.0 * p + 3.0 * p * p * (1.0 + 0.2 * a * b) + 0.5 * ((7 * i * i) as f64).sin()
    };
    let y: Vec<f64> = (0..1500).map(force).collect();
    let mean = y.iter().sum::<f64>() / 1500.0;
    let deviation = (y.iter().map(|y| (y - mean) * (y - mean)).sum::<f64>() / 1500.0).sqrt();
    (x, y.iter().map(|y| (y - mean) / deviation).collect())
}

fn main() {
    let (x, z) = data();
    let rows = PointRows::from_rows(&x.view());
    let at = |kernel: &Kernel| {
        log_likelihood(kernel, &RowPairs::new(&rows), &z).map_or(f64::NAN, |found| found.value)
    };
    println!(
        "at scikit-learn's optimum {:.6}, it says {EXPECTED:.6}",
        at(&Kernel::from_logs(&EXPECTED_LOGS, false))
    );
    for line in [false, true] {
        let wanted = Search {
            each: false,
            line,
            restarts: 50,
            seed: 1,
            bounds: Bounds::default(),
        };
        let begun = Instant::now();
        let found = search(&rows, &z, &wanted);
        let seconds = begun.elapsed().as_secs_f64();
        match found {
            Some(kernel) => println!(
                "50 starts{}: {seconds:.1} s, log likelihood {:.6}, {kernel:?}",
                if line { " with a line" } else { "" },
                at(&kernel)
            ),
            None => println!("no covariance has a Cholesky factor"),
        }
    }
}
