//! Recordings of a made-up sensor: four signals of a press, with offsets and gains of each session, and noise.

use estimation::recording::Recording;
use ndarray::Array2;
use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

/// Rows a second.
pub const RATE_HZ: f64 = 20.0;

/// A run of so many rows: the force is a row of presses of 1 s to 3 s; the signals are nonlinear in it.
pub fn run(session: u64, rows: usize) -> Recording {
    let mut generator = ChaCha8Rng::seed_from_u64(session);
    let mut normal = |deviation: f64| {
        let sum: f64 = (0..12).map(|_| generator.random_range(-0.5..0.5)).sum();
        deviation * sum
    };
    let offsets: Vec<f64> = (0..4).map(|_| normal(5.0)).collect();
    let gains: Vec<f64> = (0..4).map(|_| 1.0 + normal(0.02)).collect();
    let mut signals = Array2::zeros((rows, 4));
    let mut forces = Array2::zeros((rows, 1));
    let mut phase: f64 = 0.0;
    for row in 0..rows {
        // Presses of a force and a length of their own.
        let press = phase.floor();
        let most = 6.0 + 4.0 * (press * 2.4 + session as f64).sin();
        phase += (0.5 + 0.3 * (press * 1.7).cos()) / RATE_HZ;
        let force = most * (std::f64::consts::PI * phase.fract()).sin().powi(2);
        forces[[row, 0]] = force;
        let pure = [
            force,
            0.3 * force * force,
            (0.3 * force).tanh() * 5.0,
            -0.8 * force,
        ];
        for (channel, x) in pure.into_iter().enumerate() {
            signals[[row, channel]] = offsets[channel] + gains[channel] * x + normal(0.05);
        }
    }
    Recording {
        name: format!("run{session}.csv"),
        time_s: (0..rows).map(|row| row as f64 / RATE_HZ).collect(),
        signals,
        forces,
        cycle: None,
    }
}
