//! Fields of films around the wheel, at one load and over all loads of a study.

use crate::field::hermite::{Nodes, Turn, summed};
use crate::field::response_surface::{Drawn, ResponseSurface};
use crate::field::scatter_modes::ScatterModes;

/// A force presses to depths that differ by less between meshes, relative.
const SAME_LOAD: f64 = 0.05;

/// Share of the slopes over a shift along below which those over one across are rounding.
const FELT: f64 = 1e-9;

/// Signals of every kind of film over depth and wheel angle.
#[derive(Debug, Clone, PartialEq)]
pub struct DepthFields {
    /// Solved depths, mm.
    pub depths: Nodes,
    /// Vertical force at each, N.
    pub forces_n: Vec<f64>,
    /// Signals by kind and depth: a sample each degree from -180.
    pub signals: Vec<Vec<Vec<f64>>>,
    /// Loads at which the ground was dragged.
    pub sheared: Vec<ShearField>,
    /// Surface over contacts; none: they are always the usual one. Forces and signals are means over them.
    pub contacts: Option<ResponseSurface>,
    /// Variances of the signals over contacts by kind and depth.
    pub spread: Option<Vec<Vec<Vec<f64>>>>,
    /// Quantities whose scatter an estimate knows of all films together; none: it takes each film's for its own.
    pub together: Option<Drawn>,
    /// Error of the surface over contacts; none where it isn't known, or contacts don't differ.
    pub surface_error: Option<SurfaceError>,
}

/// Standard deviation of a response surface's error at contacts that it wasn't made from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SurfaceError {
    /// Error of a signal near the contact at the largest load, in its unit.
    pub signal: f64,
    /// Error of the vertical force, N.
    pub force_n: f64,
}

/// Changes with a small shift of the ground at one load.
#[derive(Debug, Clone, PartialEq)]
pub struct ShearField {
    /// Depth, mm.
    pub depth_mm: f64,
    /// Forces along the wheel and across it by the shifts that way, N/mm.
    pub force_slopes: [f64; 2],
    /// Derivatives of the signals by both shifts, 1/mm, by kind: a sample each degree from -180.
    pub slopes: Vec<[Vec<f64>; 2]>,
    /// Force from which the ground slides, N.
    pub sliding_n: f64,
}

/// Signals of every kind of film at one depth.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadField {
    /// Height of the ground above the inflated outer radius, mm.
    pub depth_mm: f64,
    /// Vertical force, N.
    pub force_n: f64,
    /// Derivative of the force by the depth, N/mm.
    pub force_slope: f64,
    /// A field for each kind of film.
    pub kinds: Vec<KindField>,
    /// Modes in which films scatter together; none where an estimate doesn't know it.
    pub modes: ScatterModes,
}

/// Signal of one kind of film at one depth.
#[derive(Debug, Clone, PartialEq)]
pub struct KindField {
    /// The signal over the wheel angle from the contact to the film.
    pub signal: Turn,
    /// Derivatives of the readings by the depth, 1/mm, and by further unknowns.
    pub slopes: Vec<Turn>,
    /// Variance over contacts; none where all are the usual one.
    pub spread: Option<Turn>,
}

impl DepthFields {
    /// The fields at a depth, taken into the solved range.
    pub fn at(&self, depth_mm: f64) -> LoadField {
        let [value, slope] = self.depths.shares(depth_mm);
        let over_turn = |shares, samples: &Vec<Vec<f64>>| {
            let sample = |degree: usize| summed(shares, |node| samples[node][degree]);
            Turn::new((0..samples[0].len()).map(sample).collect())
        };
        let kind = |(kind, samples): (usize, &Vec<Vec<f64>>)| KindField {
            signal: over_turn(&value, samples),
            slopes: vec![over_turn(&slope, samples)],
            spread: self
                .spread
                .as_ref()
                .map(|spread| over_turn(&value, &spread[kind])),
        };
        let force_n = summed(&value, |node| self.forces_n[node]);
        let together = self.contacts.as_ref().zip(self.together);
        LoadField {
            depth_mm,
            force_n,
            force_slope: summed(&slope, |node| self.forces_n[node]),
            kinds: self.signals.iter().enumerate().map(kind).collect(),
            modes: together.map_or_else(ScatterModes::default, |(surface, drawn)| {
                ScatterModes::of(surface, depth_mm, drawn, force_n)
            }),
        }
    }
}

impl DepthFields {
    /// The fields that readings have over contacts of which this is drawn: the means, and beside the noise the variances; `together`: and what films scatter in
    /// together.
    pub fn over_contacts(surface: ResponseSurface, drawn: Drawn, together: bool) -> Self {
        let (means, spread) = surface.over_contacts(drawn);
        Self {
            depths: means.depths,
            forces_n: means.forces_n,
            signals: means.signals,
            sheared: Vec::new(),
            contacts: Some(surface),
            spread: Some(spread),
            together: together.then_some(drawn),
            surface_error: None,
        }
    }

    /// Vertical force at a depth, taken into the solved range, N.
    pub fn force_n(&self, depth_mm: f64) -> f64 {
        let [value, _] = self.depths.shares(depth_mm);
        summed(&value, |node| self.forces_n[node])
    }

    /// Depth that bears a vertical force, N, within the solved range, mm.
    pub fn depth_mm(&self, force_n: f64) -> f64 {
        self.depths.place_of(force_n, |node| self.forces_n[node])
    }

    /// The fields at so many depths, two or more, evenly from the least solved one to the largest.
    pub fn evenly(&self, count: usize) -> Vec<LoadField> {
        let [low, high] = self.depths.ends();
        (0..count)
            .map(|k| self.at(low + (high - low) * k as f64 / (count - 1) as f64))
            .collect()
    }

    /// The fields at a depth at which the ground was dragged, with its shift along the wheel as a further unknown, and the one across, if any film feels it.
    pub fn with_shear(&self, depth_mm: f64) -> Option<(LoadField, &ShearField)> {
        let apart = |shear: &ShearField| (shear.depth_mm - depth_mm).abs();
        let nearest = |a: &&ShearField, b: &&ShearField| apart(a).total_cmp(&apart(b));
        let shear = self.sheared.iter().min_by(nearest)?;
        if apart(shear) > SAME_LOAD * depth_mm {
            return None;
        }
        let mut field = self.at(depth_mm);
        let axes = if shear.feels_across() { 2 } else { 1 };
        for (kind, slopes) in field.kinds.iter_mut().zip(&shear.slopes) {
            let felt = slopes.iter().take(axes).cloned();
            kind.slopes.extend(felt.map(Turn::new));
        }
        Some((field, shear))
    }

    /// The fields of some kinds alone, in their order.
    pub fn of_kinds(&self, kinds: &[usize]) -> Self {
        let some = |all: &Vec<Vec<Vec<f64>>>| kinds.iter().map(|&kind| all[kind].clone()).collect();
        Self {
            signals: some(&self.signals),
            spread: self.spread.as_ref().map(some),
            contacts: self
                .contacts
                .as_ref()
                .map(|surface| surface.of_kinds(kinds)),
            sheared: self
                .sheared
                .iter()
                .map(|shear| shear.of_kinds(kinds))
                .collect(),
            ..self.clone()
        }
    }
}

impl ShearField {
    /// Whether any film feels a shift across: those along x and y at the crown don't, by symmetry.
    fn feels_across(&self) -> bool {
        let largest = |axis: usize| {
            let slopes = self.slopes.iter().flat_map(|slopes| &slopes[axis]);
            slopes.fold(0.0, |largest: f64, slope| largest.max(slope.abs()))
        };
        largest(1) > FELT * largest(0)
    }

    fn of_kinds(&self, kinds: &[usize]) -> Self {
        Self {
            slopes: kinds
                .iter()
                .map(|&kind| self.slopes[kind].clone())
                .collect(),
            ..*self
        }
    }
}

impl LoadField {
    /// Variance over contacts of a kind of film's signal beside the modes, of a film this far from them, degrees: all of its scatter where there are none.
    pub(crate) fn scatter(&self, kind: usize, apart_deg: f64) -> f64 {
        match self.modes.count() {
            0 => self.kinds[kind].scatter(apart_deg),
            _ => self.modes.left(kind, apart_deg),
        }
    }
}

impl KindField {
    /// Variance of the signal over contacts, of a film this far from them, degrees; the noise's comes on top.
    pub fn scatter(&self, apart_deg: f64) -> f64 {
        // A cubic through variances may fall below zero between two of them.
        let variance = |spread: &Turn| spread.at(apart_deg).max(0.0);
        self.spread.as_ref().map_or(0.0, variance)
    }

    /// Derivatives of the signal by the contact angle (1/degree), the depth (1/mm), and further unknowns, of a film this far from the contact, degrees.
    pub fn derivatives(&self, apart_deg: f64) -> impl Iterator<Item = f64> + '_ {
        let by_angle = -self.signal.slope(apart_deg);
        std::iter::once(by_angle).chain(self.slopes.iter().map(move |slope| slope.at(apart_deg)))
    }
}

/// Errors of a film's reading, in the unit of its signal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Noise {
    /// Standard deviation whatever the signal, in its unit.
    pub floor: f64,
    /// Whether signals are volts of glued films, not strains.
    pub in_volts: bool,
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
