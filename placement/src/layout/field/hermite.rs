//! Piecewise cubic curves through samples: around the wheel, and over the depth.

/// A function of the wheel angle with a sample each degree from -180 to 179. Between samples it is the cubic through the values and slopes at both ends; slopes
/// are central differences of fourth order.
#[derive(Debug, Clone, PartialEq)]
pub struct Turn {
    samples: Vec<f64>,
    /// 1/degree.
    slopes: Vec<f64>,
}

/// Samples of a turn.
pub const DEGREES: usize = 360;

impl Turn {
    /// Through these samples.
    ///
    /// # Panics
    /// If there aren't 360.
    pub fn new(samples: Vec<f64>) -> Self {
        assert_eq!(samples.len(), DEGREES, "a sample each degree");
        let at = |i: usize, by: usize| samples[(i + by) % DEGREES];
        let slope = |i: usize| {
            let near = at(i, 1) - at(i, DEGREES - 1);
            let far = at(i, 2) - at(i, DEGREES - 2);
            (8.0 * near - far) / 12.0
        };
        let slopes = (0..DEGREES).map(slope).collect();
        Self { samples, slopes }
    }

    /// Value at an angle, degrees.
    pub fn at(&self, angle_deg: f64) -> f64 {
        let (cubic, t) = self.cubic(angle_deg);
        cubic.value(t)
    }

    /// Derivative by the angle, 1/degree.
    pub fn slope(&self, angle_deg: f64) -> f64 {
        let (cubic, t) = self.cubic(angle_deg);
        cubic.slope(t)
    }

    /// The samples, from -180 degrees.
    pub fn samples(&self) -> &[f64] {
        &self.samples
    }

    fn cubic(&self, angle_deg: f64) -> (Cubic, f64) {
        let place = (angle_deg + 180.0).rem_euclid(360.0);
        let i = place.floor() as usize % DEGREES;
        let j = (i + 1) % DEGREES;
        let ends = |list: &[f64]| [list[i], list[j]];
        let cubic = Cubic {
            values: ends(&self.samples),
            slopes: ends(&self.slopes),
            width: 1.0,
        };
        (cubic, place.fract())
    }
}

/// The cubic with these values and slopes at both ends of an interval.
#[derive(Debug, Clone, Copy)]
struct Cubic {
    values: [f64; 2],
    slopes: [f64; 2],
    width: f64,
}

impl Cubic {
    /// At a share of the width.
    fn value(&self, t: f64) -> f64 {
        let [value, _] = weights(t, self.width);
        self.weighted(&value)
    }

    fn slope(&self, t: f64) -> f64 {
        let [_, slope] = weights(t, self.width);
        self.weighted(&slope)
    }

    fn weighted(&self, weights: &[f64; 4]) -> f64 {
        let [a, b, c, d] = weights;
        a * self.values[0] + b * self.values[1] + c * self.slopes[0] + d * self.slopes[1]
    }
}

/// Weights of both values and both slopes in the value and in the derivative, at a share `t` of the width.
fn weights(t: f64, width: f64) -> [[f64; 4]; 2] {
    let s = 1.0 - t;
    let value = [
        s * s * (1.0 + 2.0 * t),
        t * t * (1.0 + 2.0 * s),
        s * s * t * width,
        -t * t * s * width,
    ];
    let rise = 6.0 * s * t / width;
    let slope = [-rise, rise, s * (s - 2.0 * t), t * (t - 2.0 * s)];
    [value, slope]
}

/// Increasing places of samples, between which a curve is cubic. Its slope at a sample is that of the parabola through it and its neighbours.
#[derive(Debug, Clone, PartialEq)]
pub struct Nodes(Vec<f64>);

/// Neighbouring samples that a value between two of them depends on.
const NEAR: usize = 4;

/// What each sample contributes to a value or a derivative: some in a row, the others nothing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shares {
    first: usize,
    count: usize,
    shares: [f64; NEAR],
}

impl Shares {
    fn add(&mut self, node: usize, share: f64) {
        self.shares[node - self.first] += share;
    }
}

impl Nodes {
    /// At least two places, which increase.
    ///
    /// # Panics
    /// If they don't.
    pub fn new(places: Vec<f64>) -> Self {
        let increase = places.windows(2).all(|pair| pair[0] < pair[1]);
        assert!(places.len() >= 2 && increase, "two places that increase");
        Self(places)
    }

    /// The places.
    pub fn places(&self) -> &[f64] {
        &self.0
    }

    /// The first and the last place.
    pub fn ends(&self) -> [f64; 2] {
        [self.0[0], self.0[self.0.len() - 1]]
    }

    /// Shares of the samples in the value and in the derivative at a place, which is taken into the range.
    pub fn shares(&self, place: f64) -> [Shares; 2] {
        let [low, high] = self.ends();
        let place = place.clamp(low, high);
        let last = self.0.len() - 2;
        let i = self.0.partition_point(|&node| node <= place);
        let i = i.saturating_sub(1).min(last);
        let width = self.0[i + 1] - self.0[i];
        let first = i.saturating_sub(1);
        let none = Shares {
            first,
            count: NEAR.min(self.0.len() - first),
            shares: [0.0; NEAR],
        };
        weights((place - self.0[i]) / width, width).map(|[a, b, c, d]| {
            let mut shares = none;
            shares.add(i, a);
            shares.add(i + 1, b);
            for (node, weight) in [(i, c), (i + 1, d)] {
                for (of, share) in self.slope_shares(node) {
                    shares.add(of, weight * share);
                }
            }
            shares
        })
    }

    /// The slope at a node by its neighbours' samples; at the ends by the parabola through the three nearest.
    fn slope_shares(&self, node: usize) -> [(usize, f64); 3] {
        let count = self.0.len();
        if count == 2 {
            let width = self.0[1] - self.0[0];
            return [(0, -1.0 / width), (1, 1.0 / width), (1, 0.0)];
        }
        let first = node.saturating_sub(1).min(count - 3);
        [0, 1, 2].map(|k| {
            let other = |by: usize| self.0[first + (k + by) % 3];
            let (own, at) = (other(0), self.0[node]);
            let rise = (own - other(1)) * (own - other(2));
            (first + k, (2.0 * at - other(1) - other(2)) / rise)
        })
    }
}

/// The sum of samples by their shares.
pub fn summed(shares: &Shares, sample: impl Fn(usize) -> f64) -> f64 {
    let near = shares.shares[..shares.count].iter().enumerate();
    near.map(|(k, share)| share * sample(shares.first + k))
        .sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angles_wrap_around_and_samples_are_met() {
        let turn = Turn::new((-180..180).map(|u| f64::from(u * u)).collect());
        assert_eq!(turn.at(-180.0), turn.at(180.0));
        assert_eq!(turn.at(540.0), turn.at(-180.0));
        assert_eq!((turn.at(359.0), turn.at(10.0)), (1.0, 100.0));
        // Parabolas are met between samples, too, away from the seam.
        assert!((turn.at(10.5) - 110.25).abs() < 1e-12);
        assert!((turn.slope(10.5) - 21.0).abs() < 1e-12);
    }

    #[test]
    fn a_smooth_function_is_met_to_the_fourth_order() {
        let (width, at) = (10.0, 3.37);
        let profile = |u: f64| (-0.5 * (u / width) * (u / width)).exp();
        let turn = Turn::new((-180..180).map(|u| profile(f64::from(u))).collect());
        // h^4 / 384 of a fourth derivative of 3 / s^4; slopes: h^4 / 30 of a fifth derivative of 8 / s^5, and of the cubic.
        assert!((turn.at(at) - profile(at)).abs() < 3.0 / 384.0 / width.powi(4) * 2.0);
        let slope = -at / (width * width) * profile(at);
        assert!((turn.slope(at) - slope).abs() < 1e-5);
    }

    #[test]
    fn a_slope_is_the_derivative_of_the_curve() {
        let turn = Turn::new((0..360).map(|u| (0.1 * f64::from(u)).sin()).collect());
        let nodes = Nodes::new(vec![0.25, 0.45, 0.5, 0.55, 1.0, 3.0]);
        let sample = |i: usize| nodes.places()[i].powf(1.7);
        let h = 1e-5;
        for k in 0..40 {
            let at = -170.3 + 8.7 * f64::from(k);
            let difference = (turn.at(at + h) - turn.at(at - h)) / (2.0 * h);
            assert!((difference - turn.slope(at)).abs() < 1e-9);
            let at = 0.26 + 0.068 * f64::from(k);
            let value = |at: f64| summed(&nodes.shares(at)[0], sample);
            let difference = (value(at + h) - value(at - h)) / (2.0 * h);
            assert!((difference - summed(&nodes.shares(at)[1], sample)).abs() < 1e-8);
        }
    }

    #[test]
    fn parabolas_over_uneven_nodes_are_met() {
        let nodes = Nodes::new(vec![0.25, 0.45, 0.5, 0.55, 1.0, 3.0]);
        let parabola = |d: f64| 3.0 - 2.0 * d + 0.7 * d * d;
        for place in [0.25, 0.3, 0.5, 0.7, 2.9, 3.0] {
            let [value, slope] = nodes.shares(place);
            let sample = |i: usize| parabola(nodes.places()[i]);
            assert!((summed(&value, sample) - parabola(place)).abs() < 1e-12);
            assert!((summed(&slope, sample) - (-2.0 + 1.4 * place)).abs() < 1e-12);
        }
        // Two nodes give a line, and places beyond the ends are taken to them.
        let two = Nodes::new(vec![1.0, 2.0]);
        assert_eq!(summed(&two.shares(1.5)[0], |i| i as f64), 0.5);
        assert_eq!(summed(&two.shares(9.0)[0], |i| i as f64), 1.0);
    }
}
