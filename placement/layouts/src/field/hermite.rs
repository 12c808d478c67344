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
    /// Makes a curve through these samples.
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
        let place = within_turn(angle_deg + 180.0);
        let whole = place as usize;
        let i = whole % DEGREES;
        let j = (i + 1) % DEGREES;
        let ends = |list: &[f64]| [list[i], list[j]];
        let cubic = Cubic {
            values: ends(&self.samples),
            slopes: ends(&self.slopes),
            width: 1.0,
        };
        (cubic, place - whole as f64)
    }
}

/// An angle from 0 to 360 degrees: the same remainder, without a division for those that are there already.
fn within_turn(angle_deg: f64) -> f64 {
    match angle_deg {
        0.0..360.0 => angle_deg,
        _ => angle_deg.rem_euclid(360.0),
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
    /// Returns the value at a share of the width.
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

/// Increasing places of samples, between which a curve is cubic. Its slope at a sample is that of the polynomial through the nearest samples.
#[derive(Debug, Clone, PartialEq)]
pub struct Nodes {
    places: Vec<f64>,
    /// Shares of the nearest samples in the slope at each place.
    slopes: Vec<NodeSlope>,
}

/// Samples that a slope depends on at most.
const STENCIL: usize = 5;

/// Contributions of samples in a row to the slope at one of them.
#[derive(Debug, Clone, Copy, PartialEq)]
struct NodeSlope {
    first: usize,
    count: usize,
    shares: [f64; STENCIL],
}

impl NodeSlope {
    /// Derivatives of Lagrange's polynomials through the nearest places, by barycentric weights (Berrut and Trefethen 2004, section 9.3).
    fn new(places: &[f64], node: usize, most: usize) -> Self {
        let count = most.min(places.len());
        let first = node.saturating_sub(most / 2).min(places.len() - count);
        let near = &places[first..first + count];
        let own = node - first;
        let weight = |k: usize| {
            let others = (0..count).filter(|other| *other != k);
            1.0 / others.map(|other| near[k] - near[other]).product::<f64>()
        };
        let mut shares = [0.0; STENCIL];
        for k in (0..count).filter(|k| *k != own) {
            shares[k] = weight(k) / weight(own) / (near[own] - near[k]);
            shares[own] -= shares[k];
        }
        Self {
            first,
            count,
            shares,
        }
    }
}

/// Samples that a value between two of them depends on.
const NEAR: usize = STENCIL + 1;

/// Contributions of each sample to a value or a derivative: some in a row, the others nothing.
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
    /// Makes nodes at two or more places, which increase. A slope is that of the parabola through a sample and its neighbours, however uneven they are.
    ///
    /// # Panics
    /// If they don't.
    pub fn new(places: Vec<f64>) -> Self {
        Self::with_slopes_of(3, places)
    }

    /// Makes nodes as [`Nodes::new`] does, of places whose distances differ little: a slope is that of the polynomial through five samples, so that the curve
    /// converges with the fourth power of the distances. Where places cluster it would swing beside them.
    ///
    /// # Panics
    /// As [`Nodes::new`].
    pub fn about_even(places: Vec<f64>) -> Self {
        Self::with_slopes_of(STENCIL, places)
    }

    fn with_slopes_of(most: usize, places: Vec<f64>) -> Self {
        let increase = places.windows(2).all(|pair| pair[0] < pair[1]);
        assert!(places.len() >= 2 && increase, "two places that increase");
        let slopes = (0..places.len()).map(|node| NodeSlope::new(&places, node, most));
        Self {
            slopes: slopes.collect(),
            places,
        }
    }

    /// The places.
    pub fn places(&self) -> &[f64] {
        &self.places
    }

    /// The first and the last place.
    pub fn ends(&self) -> [f64; 2] {
        [self.places[0], self.places[self.places.len() - 1]]
    }

    /// The place at which samples that grow from node to node reach a value, within the ends.
    pub fn place_of(&self, value: f64, of_node: impl Fn(usize) -> f64) -> f64 {
        let [mut low, mut high] = self.ends();
        // Halved until nothing is between both.
        while low < 0.5 * (low + high) && 0.5 * (low + high) < high {
            let middle = 0.5 * (low + high);
            if summed(&self.shares(middle)[0], &of_node) < value {
                low = middle;
            } else {
                high = middle;
            }
        }
        high
    }

    /// Shares of the samples in the value and in the derivative at a place, which is taken into the range.
    pub fn shares(&self, place: f64) -> [Shares; 2] {
        let [low, high] = self.ends();
        let place = place.clamp(low, high);
        let last = self.places.len() - 2;
        let i = self.places.partition_point(|&node| node <= place);
        let i = i.saturating_sub(1).min(last);
        let width = self.places[i + 1] - self.places[i];
        let slopes = [self.slopes[i], self.slopes[i + 1]];
        let first = slopes[0].first;
        let none = Shares {
            first,
            count: NEAR.min(self.places.len() - first),
            shares: [0.0; NEAR],
        };
        weights((place - self.places[i]) / width, width).map(|[a, b, c, d]| {
            let mut shares = none;
            shares.add(i, a);
            shares.add(i + 1, b);
            for (slope, weight) in slopes.iter().zip([c, d]) {
                for (k, share) in slope.shares[..slope.count].iter().enumerate() {
                    shares.add(slope.first + k, weight * share);
                }
            }
            shares
        })
    }
}

impl Shares {
    /// Numbers of the samples, each with its share.
    pub fn each(&self) -> impl Iterator<Item = (usize, f64)> + '_ {
        let near = self.shares[..self.count].iter().enumerate();
        near.map(|(k, share)| (self.first + k, *share))
            .filter(|(_, share)| *share != 0.0)
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

    /// Asserts that values and slopes of a polynomial are met at all places.
    fn assert_met(nodes: &Nodes, [a, b, c, d]: [f64; 4]) {
        for k in 0..=20 {
            let place = 0.25 + 2.75 * f64::from(k) / 20.0;
            let [value, slope] = nodes.shares(place);
            let polynomial = |x: f64| a + x * (b + x * (c + x * d));
            let sample = |i: usize| polynomial(nodes.places()[i]);
            assert!((summed(&value, sample) - polynomial(place)).abs() < 1e-12);
            let expected = b + place * (2.0 * c + place * 3.0 * d);
            assert!((summed(&slope, sample) - expected).abs() < 1e-11);
        }
    }

    #[test]
    fn parabolas_over_uneven_nodes_are_met_and_cubics_by_five() {
        let places = [0.25, 0.45, 0.5, 0.55, 1.0, 3.0];
        assert_met(&Nodes::new(places.to_vec()), [3.0, -2.0, 0.7, 0.0]);
        for count in [4, 5, 6] {
            let places = places[6 - count..].to_vec();
            let places = [vec![0.25], places[1..].to_vec()].concat();
            assert_met(&Nodes::about_even(places), [3.0, -2.0, 0.7, -0.2]);
        }
        // Two nodes give a line, and places beyond the ends are taken to them.
        let two = Nodes::new(vec![1.0, 2.0]);
        assert_eq!(summed(&two.shares(1.5)[0], |i| i as f64), 0.5);
        assert_eq!(summed(&two.shares(9.0)[0], |i| i as f64), 1.0);
    }

    #[test]
    fn curves_through_nodes_converge_with_the_fourth_power_of_their_distance() {
        // h^4 / 384 of the fourth derivative in the middle; slopes at both ends are off by h^4 / 30 of the fifth, weigh h / 8 and cancel but for a higher order.
        let error = |count: u32| {
            let place = |k| f64::from(k) / f64::from(count);
            let nodes = Nodes::about_even((0..=count).map(place).collect());
            let middle = 0.5 + 0.5 / f64::from(count);
            let found = summed(&nodes.shares(middle)[0], |i| nodes.places()[i].exp());
            (found / middle.exp() - 1.0).abs()
        };
        for count in [8, 16, 32] {
            let h = 1.0 / f64::from(count);
            assert!(error(count) < 1.1 * h.powi(4) / 384.0, "{count}");
            assert!((error(count) / error(2 * count) / 16.0 - 1.0).abs() < 0.1);
        }
    }
}
