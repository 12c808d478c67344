//! Random numbers by seed, run and purpose: those of one purpose don't move when another one draws more.

use std::f64::consts::TAU;

use layouts::simulate::normal_pairs::{normal_pair, uniform};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

/// Streams of random numbers, by what is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stream {
    /// Stances.
    Gait,
    /// Gains of films.
    Gain,
    /// Noise of films.
    Films,
    /// Noise of the force sensor.
    Force,
    /// Places where films really lie.
    Place,
    /// Quantities that contacts differ in besides: stances stay as they are where these are drawn.
    Contact,
}

impl Stream {
    /// Number of the streams that stand side by side.
    const COUNT: u64 = 5;

    /// Number of a run's stream.
    fn of_run(self, run: u64) -> u64 {
        match self {
            // Apart from the others, whose numbers stay as they were.
            Self::Contact => !run,
            _ => run.wrapping_mul(Self::COUNT) + self as u64,
        }
    }
}

/// A stream of random numbers.
#[derive(Debug, Clone)]
pub struct SeededDraws {
    rng: ChaCha8Rng,
    /// The second normal number of a pair.
    spare: Option<f64>,
}

impl SeededDraws {
    /// The stream of a purpose in a run.
    pub fn new(seed: u64, run: u64, stream: Stream) -> Self {
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        rng.set_stream(stream.of_run(run));
        Self { rng, spare: None }
    }

    /// Draws evenly between 0 and 1, never 0.
    pub fn uniform(&mut self) -> f64 {
        uniform(&mut self.rng)
    }

    /// Draws evenly between two.
    pub fn between(&mut self, [low, high]: [f64; 2]) -> f64 {
        low + (high - low) * self.uniform()
    }

    /// Draws evenly in the disc of radius 1.
    pub(crate) fn in_disc(&mut self) -> [f64; 2] {
        let (radius, angle) = (self.uniform().sqrt(), TAU * self.uniform());
        [radius * angle.cos(), radius * angle.sin()]
    }

    /// Standard normal, by Box and Muller.
    pub fn normal(&mut self) -> f64 {
        self.spare.take().unwrap_or_else(|| {
            let [normal, spare] = normal_pair(&mut self.rng);
            self.spare = Some(spare);
            normal
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_seed_run_and_purpose_has_numbers_of_its_own() {
        let first = |seed, run, stream| SeededDraws::new(seed, run, stream).uniform();
        assert_eq!(first(1, 2, Stream::Gait), first(1, 2, Stream::Gait));
        let mut all = Vec::new();
        for seed in 0..3 {
            for run in 0..3 {
                let streams = [Stream::Gait, Stream::Gain, Stream::Films, Stream::Force];
                for stream in streams.into_iter().chain([Stream::Place]) {
                    all.push(first(seed, run, stream));
                }
            }
        }
        all.sort_by(f64::total_cmp);
        assert!(all.windows(2).all(|pair| pair[0] < pair[1]));
    }

    #[test]
    fn normal_numbers_have_their_moments() {
        const DRAWS: usize = 100_000;
        let mut draws = SeededDraws::new(7, 0, Stream::Films);
        let normals: Vec<f64> = (0..DRAWS).map(|_| draws.normal()).collect();
        let moment = |power| normals.iter().map(|x| x.powi(power)).sum::<f64>() / DRAWS as f64;
        // Means of x^k have the variance (<x^2k> - <x^k>^2) / n: 1, 2, 15, 96 for k = 1 to 4. Within three standard errors.
        for (power, expected, variance) in
            [(1, 0.0, 1.0), (2, 1.0, 2.0), (3, 0.0, 15.0), (4, 3.0, 96.0)]
        {
            let bound = 3.0 * f64::sqrt(variance / DRAWS as f64);
            let found = moment(power);
            assert!((found - expected).abs() < bound, "{power}: {found}");
        }
        // Both numbers of a pair are independent: the mean of products of neighbours has variance 1 / n.
        let pairs = normals.chunks_exact(2).map(|pair| pair[0] * pair[1]);
        let found = pairs.sum::<f64>() / (DRAWS / 2) as f64;
        assert!(found.abs() < 3.0 * (2.0 / DRAWS as f64).sqrt(), "{found}");
    }

    #[test]
    fn the_disc_is_filled_evenly() {
        const DRAWS: usize = 20_000;
        let mut draws = SeededDraws::new(7, 0, Stream::Gait);
        let mut within_half = 0;
        for _ in 0..DRAWS {
            let [x, y] = draws.in_disc();
            assert!(x.hypot(y) <= 1.0 + 1e-15);
            within_half += usize::from(x.hypot(y) < 0.5);
        }
        // A quarter of the area; binomial, three standard errors.
        let share = within_half as f64 / DRAWS as f64;
        let bound = 3.0 * (0.25 * 0.75 / DRAWS as f64).sqrt();
        assert!((share - 0.25).abs() < bound, "{share}");
    }
}
