//! Time of M-DRM with its errors for many outputs at once, and how it grows with outputs and runs; beside it the least arithmetic there is, variances
//! of the sections and nothing else, in a plain loop.
//!
//! Run it with `cargo bench -p gsa --bench analysis`, on one thread. Where the throughput, in values a second, stays what it is, time is
//! linear. It is so in the outputs, and better in the runs of the same inputs; check points in proportion to the inputs make these
//! enter squared.

use std::hint::black_box;
use std::time::Instant;

use gsa::design::Design;
use gsa::law::distribution::Distribution;
use gsa::method::lines::analyse;
use ndarray::Array2;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

/// Size of an analysis with as many check points as inputs: n N + 1 runs for odd N.
#[derive(Debug, Clone, Copy)]
struct Size {
    inputs: usize,
    nodes: usize,
    outputs: usize,
}

const fn size(inputs: usize, nodes: usize, outputs: usize) -> Size {
    Size {
        inputs,
        nodes,
        outputs,
    }
}

const SIZES: [Size; 7] = [
    size(5, 5, 1_000),
    size(5, 5, 10_000),
    size(5, 5, 100_000),
    size(5, 11, 10_000),
    size(5, 21, 10_000),
    size(10, 5, 10_000),
    size(20, 5, 10_000),
];

/// A design, and values at its points.
fn study(size: Size) -> (Design, Array2<f64>) {
    let law = Distribution::uniform(0.5, 1.5).expect("a law");
    let mut rng = ChaCha8Rng::seed_from_u64(1);
    let laws = vec![law; size.inputs];
    let design = Design::new(&laws, size.nodes, size.inputs, &mut rng).expect("a design");
    let shape = (design.points().len(), size.outputs);
    let values = Array2::from_shape_fn(shape, |(point, output)| {
        // products for some outputs, sums for others, and all between
        let share = output as f64 / size.outputs as f64;
        let x = &design.points()[point];
        share * x.iter().product::<f64>() + (1.0 - share) * x.iter().sum::<f64>()
    });
    (design, values)
}

/// Sum of the variances of each section of each output, textbook form.
fn variances(design: &Design, values: &Array2<f64>) -> f64 {
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

/// Medians of both in milliseconds, taken in turns so that what disturbs one disturbs the other.
fn in_turns(size: Size) -> (f64, f64) {
    let (design, values) = study(size);
    let (mut whole, mut plain) = (Vec::new(), Vec::new());
    for _ in 0..21 {
        whole.push(milliseconds(|| analyse(&design, &values.view())));
        plain.push(milliseconds(|| variances(&design, &values)));
    }
    (median(whole), median(plain))
}

fn milliseconds<T>(work: impl Fn() -> T) -> f64 {
    let begun = Instant::now();
    black_box(work());
    begun.elapsed().as_secs_f64() * 1e3
}

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

fn main() {
    println!("inputs  runs  outputs  analysis ms  values/s  plain loop ms  ratio");
    for size in SIZES {
        let (whole, plain) = in_turns(size);
        let runs = size.inputs * size.nodes + 1;
        let throughput = (runs * size.outputs) as f64 / whole * 1e3;
        println!(
            "{:6} {runs:5} {:8} {whole:12.1} {throughput:9.1e} {plain:14.2} {:6.0}",
            size.inputs,
            size.outputs,
            whole / plain
        );
    }
}
