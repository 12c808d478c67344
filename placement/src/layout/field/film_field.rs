//! What films read around the wheel, at one load and over all loads of a study.

use crate::layout::field::hermite::{Nodes, Turn, summed};

/// Signals of every kind of film over depth and wheel angle.
#[derive(Debug, Clone, PartialEq)]
pub struct DepthFields {
    /// Solved depths, mm.
    pub depths: Nodes,
    /// Vertical force at each, N.
    pub forces_n: Vec<f64>,
    /// Signals by kind and depth: a sample each degree from -180.
    pub signals: Vec<Vec<Vec<f64>>>,
}

/// Signals of every kind of film at one depth.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadField {
    /// How far the ground stands above the inflated outer radius, mm.
    pub depth_mm: f64,
    /// Vertical force, N.
    pub force_n: f64,
    /// Its derivative by the depth, N/mm.
    pub force_slope: f64,
    /// A field for each kind of film.
    pub kinds: Vec<KindField>,
}

/// Signal of one kind of film at one depth.
#[derive(Debug, Clone, PartialEq)]
pub struct KindField {
    /// The signal over the wheel angle from the contact to the film.
    pub signal: Turn,
    /// Its derivatives by the depth, 1/mm, and by further unknowns.
    pub slopes: Vec<Turn>,
}

impl DepthFields {
    /// The fields at a depth, taken into the solved range.
    pub fn at(&self, depth_mm: f64) -> LoadField {
        let [value, slope] = self.depths.shares(depth_mm);
        let over_turn = |shares, samples: &Vec<Vec<f64>>| {
            let sample = |degree: usize| summed(shares, |node| samples[node][degree]);
            Turn::new((0..samples[0].len()).map(sample).collect())
        };
        let kind = |samples: &Vec<Vec<f64>>| KindField {
            signal: over_turn(&value, samples),
            slopes: vec![over_turn(&slope, samples)],
        };
        LoadField {
            depth_mm,
            force_n: summed(&value, |node| self.forces_n[node]),
            force_slope: summed(&slope, |node| self.forces_n[node]),
            kinds: self.signals.iter().map(kind).collect(),
        }
    }
}

impl DepthFields {
    /// The signal of a kind of film above the contact's centre, at a depth taken into the solved range.
    pub fn signal_at_centre(&self, kind: usize, depth_mm: f64) -> f64 {
        let [value, _] = self.depths.shares(depth_mm);
        summed(&value, |node| self.signals[kind][node][180])
    }

    /// The fields of some kinds alone, in their order.
    pub fn of_kinds(&self, kinds: &[usize]) -> Self {
        Self {
            signals: kinds
                .iter()
                .map(|&kind| self.signals[kind].clone())
                .collect(),
            ..self.clone()
        }
    }
}

impl KindField {
    /// Derivatives of the signal by the contact angle (1/degree), the depth (1/mm), and further unknowns, of a film this far from the contact, degrees.
    pub fn derivatives(&self, apart_deg: f64) -> impl Iterator<Item = f64> + '_ {
        let by_angle = -self.signal.slope(apart_deg);
        std::iter::once(by_angle).chain(self.slopes.iter().map(move |slope| slope.at(apart_deg)))
    }
}

/// Errors of a film's reading, in the unit of its signal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Noise {
    /// Standard deviation whatever the signal.
    pub floor: f64,
    /// Standard deviation of the gain, relative.
    pub gain_std: f64,
    /// Standard deviation of the film's place around the wheel, degrees.
    pub place_std_deg: f64,
}

impl Noise {
    /// Variance of a reading of this size and slope over the angle (1/degree).
    pub fn variance(&self, signal: f64, slope: f64) -> f64 {
        let of_gain = self.gain_std * signal;
        let of_place = self.place_std_deg * slope;
        self.floor * self.floor + of_gain * of_gain + of_place * of_place
    }

    /// Whether it is the same for every reading.
    pub fn is_plain(&self) -> bool {
        self.gain_std == 0.0 && self.place_std_deg == 0.0
    }
}
