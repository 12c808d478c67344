//! Waves of rough ground, drawn from its seed.

use std::f64::consts::{PI, SQRT_2, TAU};

use fem::load::ground_shape::{Wave, Waves};
use fem_client::scene::Roughness;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

/// Waves of rough ground. Heights of so many are normal but for an excess of -1.5 over their number in the fourth moment.
const WAVES: u32 = 64;

/// Draws waves whose heights, over all seeds, have the deviation of a roughness and the correlation exp(-(r / length)^2): wave vectors are then normal with
/// the deviation sqrt(2) / length (the correlation's Fourier transform), phases uniform (Shinozuka and Deodatis, 1996). Each direction is
/// drawn from a sector of its own, so that no draw prefers one.
pub(super) fn waves(rough: &Roughness, centre: [f64; 2]) -> Waves {
    let mut rng = ChaCha8Rng::seed_from_u64(rough.seed);
    let count = f64::from(WAVES);
    let amplitude = rough.rms_mm * (2.0 / count).sqrt();
    let drawn = (0..WAVES).map(|sector| {
        let (sin, cos) = (PI * (f64::from(sector) + uniform(&mut rng)) / count).sin_cos();
        let number = SQRT_2 / rough.correlation_mm * (-2.0 * (1.0 - uniform(&mut rng)).ln()).sqrt();
        let vector = [number * cos, number * sin];
        let phase = TAU * uniform(&mut rng) - vector[0] * centre[0] - vector[1] * centre[1];
        Wave {
            amplitude,
            vector,
            phase,
        }
    });
    Waves::new(drawn.collect())
}

/// A number from 0 up to 1, which is left out.
fn uniform(rng: &mut ChaCha8Rng) -> f64 {
    (rng.next_u64() >> 11) as f64 * 0.5f64.powi(53)
}

#[cfg(test)]
mod tests {
    use fem::load::ground_shape::Profile;

    use super::*;

    const LENGTH: f64 = 4.0;

    fn ground(seed: u64, centre: [f64; 2]) -> Profile {
        let rough = Roughness {
            rms_mm: 0.2,
            correlation_mm: LENGTH,
            seed,
        };
        Profile::Waves(waves(&rough, centre))
    }

    /// Variances of normal heights are known to sqrt(2 / 4000) = 2.2 % by 4000 seeds, correlations to 1.6 %; four of these are allowed.
    #[test]
    fn heights_have_the_deviation_and_the_correlation_that_are_asked_for() {
        let seeds = 4000;
        let places = [
            [0.0; 2],
            [0.5 * LENGTH, 0.0],
            [0.0, LENGTH],
            [0.6 * LENGTH, -0.8 * LENGTH],
            [1.5 * LENGTH, 0.0],
        ];
        let mut products = [0.0; 5];
        let mut slopes = [0.0; 2];
        for seed in 0..seeds {
            let ground = ground(seed, [0.0; 2]);
            let heights = places.map(|place| ground.at(place));
            for (sum, height) in products.iter_mut().zip(&heights) {
                *sum += heights[0].value * height.value / seeds as f64 / 0.04;
            }
            for (sum, slope) in slopes.iter_mut().zip(heights[3].slope) {
                *sum += slope * slope / seeds as f64;
            }
        }
        let expected = [
            1.0,
            (-0.25f64).exp(),
            (-1.0f64).exp(),
            (-1.0f64).exp(),
            (-2.25f64).exp(),
        ];
        for (found, expected) in products.into_iter().zip(expected) {
            assert!((found - expected).abs() < 0.09, "{products:?}");
        }
        // Slopes along an axis have a variance of 2 (rms / length)^2.
        for slope in slopes {
            assert!((slope / 0.005 - 1.0).abs() < 0.09, "{slopes:?}");
        }
    }

    #[test]
    fn a_place_moves_the_ground_and_a_seed_draws_another() {
        let (resting, moved) = (ground(3, [0.0; 2]), ground(3, [1.5, -0.5]));
        for place in [[0.0, 0.0], [2.0, 7.0]] {
            let [x, y] = place;
            let expected = resting.at(place).value;
            assert!((moved.at([x + 1.5, y - 0.5]).value - expected).abs() < 1e-14);
            assert!((ground(4, [0.0; 2]).at(place).value - expected).abs() > 1e-3);
        }
        assert_eq!(resting, ground(3, [0.0; 2]));
    }
}
