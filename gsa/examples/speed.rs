//! How long the analysis of many outputs takes, and how that compares with the least arithmetic there is: variances of the
//! sections, and nothing else, in a plain loop.
//!
//! Run it with `cargo run --release -p gsa --example speed`. Times are medians of eleven.

use std::time::Instant;

use gsa::analysis::analyse;
use gsa::design::Design;
use gsa::distribution::Distribution;
use ndarray::Array2;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

/// Median time in milliseconds.
fn time(mut work: impl FnMut()) -> f64 {
    let mut times: Vec<f64> = (0..11)
        .map(|_| {
            let start = Instant::now();
            work();
            start.elapsed().as_secs_f64() * 1e3
        })
        .collect();
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

/// Variance of each section of each output, textbook form.
fn plain_loop(design: &Design, values: &Array2<f64>) -> f64 {
    let mut sum = 0.0;
    for output in 0..values.ncols() {
        for line in design.lines() {
            let (mut mean, mut square) = (0.0, 0.0);
            for (&point, w) in line.ordinals().iter().zip(&line.rule().weights) {
                let h = values[[point, output]];
                mean += w * h;
                square += w * h * h;
            }
            sum += square - mean * mean;
        }
    }
    sum
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!("inputs   runs  outputs   analysis ms   plain loop ms   ratio");
    for (inputs, outputs) in [
        (5, 1000),
        (5, 10_000),
        (5, 40_000),
        (10, 10_000),
        (20, 10_000),
    ] {
        let laws = vec![Distribution::uniform(0.5, 1.5)?; inputs];
        let design = Design::new(&laws, 5, 5, &mut ChaCha8Rng::seed_from_u64(1))?;
        let values = Array2::from_shape_fn((design.points().len(), outputs), |(point, output)| {
            let share = output as f64 / outputs as f64;
            let x = &design.points()[point];
            // products for some outputs, sums for others, and all between
            share * x.iter().product::<f64>() + (1.0 - share) * x.iter().sum::<f64>()
        });
        let whole = time(|| {
            std::hint::black_box(analyse(&design, &values.view()));
        });
        let plain = time(|| {
            std::hint::black_box(plain_loop(&design, &values));
        });
        println!(
            "{inputs:6} {:6} {outputs:8} {whole:13.1} {plain:15.2} {:7.0}",
            design.points().len(),
            whole / plain
        );
    }
    Ok(())
}
