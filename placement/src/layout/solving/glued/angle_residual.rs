//! Residual of a glued film's transfer, between the wheel angles and the depths where films were solved with the tire.

use layouts::field::hermite::{Nodes, summed};

/// Signals of one kind of film, less what its transfer says, V; cubic in the wheel angle, and in the depth from none.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct AngleResidual {
    /// Angles from -180 to 180 degrees.
    angles: Nodes,
    /// Depths of the undragged ground, mm, none first.
    depths: Nodes,
    /// Residuals by angle, then depth.
    missing: Vec<Vec<f64>>,
}

impl AngleResidual {
    /// Interpolates the residuals of a film solved at these angles from the contact, degrees, 180 among them, under loads with these depths, mm, by angle and
    /// then load. Where no angle is negative, the film reads the same on both sides.
    ///
    /// # Panics
    /// If the depths don't increase from above zero.
    pub fn new(solved_deg: &[f64], depths_mm: &[f64], missing: &[Vec<f64>]) -> Self {
        let own = solved_deg.iter().copied().zip(missing);
        let is_even = solved_deg.iter().all(|angle| *angle >= 0.0);
        let image = |angle: f64| (is_even && angle > 0.0) || angle == 180.0;
        let images = own.clone().filter(|(angle, _)| image(*angle));
        let mut all: Vec<(f64, &Vec<f64>)> = images.map(|(angle, of)| (-angle, of)).collect();
        all.extend(own);
        all.sort_by(|a, b| a.0.total_cmp(&b.0));
        let with_none = |none: f64, of: &[f64]| [&[none], of].concat();
        Self {
            angles: Nodes::new(all.iter().map(|(angle, _)| *angle).collect()),
            depths: Nodes::new(with_none(0.0, depths_mm)),
            missing: all.iter().map(|(_, of)| with_none(0.0, of)).collect(),
        }
    }

    /// Returns the residual at a depth, mm, and a wheel angle from the contact, degrees.
    pub fn at(&self, depth_mm: f64, angle_deg: f64) -> f64 {
        let [over_angle, _] = self.angles.shares(angle_deg);
        let [over_depth, _] = self.depths.shares(depth_mm);
        summed(&over_angle, |angle| {
            summed(&over_depth, |depth| self.missing[angle][depth])
        })
    }

    /// Adds the residual at a depth, mm, to samples around the wheel, one each degree from -180.
    pub fn add_to(&self, depth_mm: f64, samples: &mut [f64]) {
        for (sample, degree) in samples.iter_mut().zip(-180..) {
            *sample += self.at(depth_mm, f64::from(degree));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ANGLES: [f64; 6] = [0.0, 5.0, 12.0, 30.0, 90.0, 180.0];
    const DEPTHS: [f64; 3] = [0.5, 1.5, 3.0];

    fn residual(solved_deg: &[f64], of: impl Fn(f64, f64) -> f64) -> AngleResidual {
        let row = |angle: &f64| DEPTHS.iter().map(|depth| of(*depth, *angle)).collect();
        let missing: Vec<Vec<f64>> = solved_deg.iter().map(row).collect();
        AngleResidual::new(solved_deg, &DEPTHS, &missing)
    }

    /// Parabolas over uneven nodes are met.
    #[test]
    fn a_film_that_reads_the_same_on_both_sides_is_mirrored() {
        let of =
            |depth: f64, angle: f64| (depth - 0.2 * depth * depth) * (1.0 - 3e-4 * angle * angle);
        let even = residual(&ANGLES, of);
        for (depth, angle) in [
            (0.0, 7.0),
            (0.3, 0.0),
            (1.1, -4.0),
            (2.2, 11.9),
            (3.0, -180.0),
        ] {
            let (found, expected) = (even.at(depth, angle), of(depth, angle));
            assert!(
                (found - expected).abs() < 1e-12,
                "{depth} {angle}: {found} {expected}"
            );
        }
    }

    #[test]
    fn an_askew_film_has_two_sides() {
        let of = |depth: f64, angle: f64| depth * (angle - 0.01 * angle * angle + 324.0);
        let solved = [-90.0, -30.0, -5.0, 0.0, 5.0, 30.0, 90.0, 180.0];
        let skew = residual(&solved, of);
        for angle in [-17.0, -5.0, 2.0, 40.0] {
            let (found, expected) = (skew.at(1.0, angle), of(1.0, angle));
            assert!(
                (found - expected).abs() < 1e-9,
                "{angle}: {found} {expected}"
            );
        }
        // Both ends of a turn are one place.
        assert_eq!(skew.at(1.0, -180.0), skew.at(1.0, 180.0));
    }
}
