//! Criteria of a search.
//!
//! Both criteria are sums over films before they are one number, so that each place's share is computed once and a layout costs an addition.
//!
//! - The bound: that of the contact angle with a flat prior, mean square over contact angles and loads. It is finite for any layout, and knows slopes alone.
//! - Interval errors: beside it, a contact may be taken for one far off. Two contacts whose readings are d standard deviations apart are mistaken for each other
//!   with a probability of at most exp(-d^2/8) / 2 (A. Bhattacharyya, 1943); the angle is then as wrong as one of which nothing is known. The sum of both is
//!   the method of interval errors (H. L. van Trees, 1968), here with the nearest contact alone.

use crate::arrangement::{Arrangement, LaidFilm};
use crate::field::film_field::{LoadField, Noise};
use crate::fisher::bounds::{PRIOR_ANGLE_DEG, PRIOR_DEPTH_MM, information};
use crate::search::best_layouts::KEPT;
use crate::simulate::simulation::LOST_DEG;

/// Contact angles over the turn at which information is summed.
const CONTACTS: usize = 90;
/// Contact angles that may be mistaken, and those that they may be taken for; layouts that mistake some have bounds of several degrees there.
const MISTAKEN: usize = 36;
const OTHERS: usize = 72;

/// Criterion of a search.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SearchCriterion {
    /// The bound of the contact angle.
    Bound,
    /// The bound, and contacts that are mistaken for others.
    IntervalErrors,
}

/// The loads, and the depths that contacts may be taken for.
pub struct SearchFields<'f> {
    /// Fields at which layouts are scored.
    pub loads: &'f [LoadField],
    /// Fields over the depths of the study.
    pub others: &'f [LoadField],
}

/// A film's share in the criterion of a layout.
#[derive(Debug, Clone, Default)]
pub struct Share {
    /// Information on angle and depth, for every load and contact angle: [angle angle, angle depth, depth depth].
    information: Vec<[f64; 3]>,
    /// Squared distances, in variances of the noise, of each contact at the weakest load from each other one: rows of [`OTHERS`] times the depths.
    distances: Vec<f32>,
    /// Length of such a row.
    row: usize,
}

impl SearchCriterion {
    /// Criteria, all of them.
    pub const ALL: [Self; 2] = [Self::Bound, Self::IntervalErrors];

    /// Returns its name.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Bound => "bound",
            Self::IntervalErrors => "interval errors",
        }
    }

    /// Returns how many of the best layouts are simulated: those found by the bound are often all misled alike.
    pub const fn simulated(self) -> usize {
        match self {
            Self::Bound => KEPT,
            Self::IntervalErrors => 3,
        }
    }

    /// The share of a film.
    pub fn share(self, film: &LaidFilm, fields: &SearchFields<'_>, noise: &Noise) -> Share {
        let (row, distances) = match self {
            Self::Bound => (1, Vec::new()),
            Self::IntervalErrors => (OTHERS * fields.others.len(), distances(film, fields, noise)),
        };
        Share {
            information: of_contacts(film, fields.loads, noise),
            distances,
            row: row.max(1),
        }
    }
}

impl Share {
    /// Returns nothing, for a sum of shares as this one.
    pub fn nothing(&self) -> Self {
        Self {
            information: vec![[0.0; 3]; self.information.len()],
            distances: vec![0.0; self.distances.len()],
            row: self.row,
        }
    }

    /// Makes this the sum of two.
    pub(crate) fn set_to_sum(&mut self, a: &Self, b: &Self) {
        let information = a.information.iter().zip(&b.information);
        for (sum, (a, b)) in self.information.iter_mut().zip(information) {
            *sum = std::array::from_fn(|k| a[k] + b[k]);
        }
        let distances = a.distances.iter().zip(&b.distances);
        for (sum, (a, b)) in self.distances.iter_mut().zip(distances) {
            *sum = a + b;
        }
    }

    /// Adds another one.
    pub fn add(&mut self, other: &Self) {
        for (sum, added) in self.information.iter_mut().zip(&other.information) {
            for k in 0..3 {
                sum[k] += added[k];
            }
        }
        for (sum, added) in self.distances.iter_mut().zip(&other.distances) {
            *sum += added;
        }
    }

    /// The criterion of the layout whose films' shares these two sum up to, degrees. The sum isn't kept: of most layouts nothing but this is wanted.
    pub(crate) fn error_of_sum_deg(&self, other: &Self) -> f64 {
        (self.local(other) + self.mistaken(other)).sqrt()
    }

    /// The first part of the criterion of the layout whose films' shares this is the sum of, degrees.
    pub fn bound_deg(&self) -> f64 {
        self.local(&self.nothing()).sqrt()
    }

    /// Mean square of the angle's bound with the prior added.
    fn local(&self, other: &Self) -> f64 {
        let (of_angle, of_depth) = (PRIOR_ANGLE_DEG.powi(-2), PRIOR_DEPTH_MM.powi(-2));
        let variance = |(a, b): (&[f64; 3], &[f64; 3])| {
            let [angle, cross, depth] = std::array::from_fn(|k| a[k] + b[k]);
            let (angle, depth) = (angle + of_angle, depth + of_depth);
            depth / (angle * depth - cross * cross)
        };
        let pairs = self.information.iter().zip(&other.information);
        pairs.map(variance).sum::<f64>() / self.information.len() as f64
    }

    /// Mean square of the angle's error where contacts are mistaken for others.
    fn mistaken(&self, other: &Self) -> f64 {
        if self.distances.is_empty() {
            return 0.0;
        }
        let probability = |(a, b)| 0.5 * (-0.125 * f64::from(least_sum(a, b))).exp();
        let rows = self.distances.chunks_exact(self.row);
        let count = rows.len() as f64;
        let pairs = rows.zip(other.distances.chunks_exact(self.row));
        PRIOR_ANGLE_DEG.powi(2) * pairs.map(probability).sum::<f64>() / count
    }
}

/// The least sum of two numbers at one place; eight side by side, as one alone would wait for each comparison.
fn least_sum(a: &[f32], b: &[f32]) -> f32 {
    let mut lanes = [f32::INFINITY; 8];
    let (a, b) = (a.chunks_exact(8), b.chunks_exact(8));
    let rest = a.remainder().iter().zip(b.remainder());
    let rest = rest.fold(f32::INFINITY, |least, (a, b)| least.min(a + b));
    for (a, b) in a.zip(b) {
        for k in 0..8 {
            let sum = a[k] + b[k];
            lanes[k] = if sum < lanes[k] { sum } else { lanes[k] };
        }
    }
    lanes.into_iter().fold(rest, f32::min)
}

fn of_contacts(film: &LaidFilm, loads: &[LoadField], noise: &Noise) -> Vec<[f64; 3]> {
    let alone = Arrangement::free(vec![*film]);
    let at = |load: &LoadField, contact: usize| {
        let angle = contact as f64 * 360.0 / CONTACTS as f64;
        let information = information(load, &alone, noise, angle);
        [(0, 0), (0, 1), (1, 1)].map(|(i, j)| information.entry(i, j))
    };
    loads
        .iter()
        .flat_map(|load| (0..CONTACTS).map(move |contact| at(load, contact)))
        .collect()
}

/// Distances of one film's readings. Those of contacts that count as one are infinite.
fn distances(film: &LaidFilm, fields: &SearchFields<'_>, noise: &Noise) -> Vec<f32> {
    let weakest = fields
        .loads
        .iter()
        .min_by(|a, b| a.force_n.total_cmp(&b.force_n));
    let Some(weakest) = weakest else {
        return Vec::new();
    };
    let angles = |count: usize| (0..count).map(move |k| k as f64 * 360.0 / count as f64);
    let reading = |load: &LoadField, contact: f64| {
        let turn = &load.kinds[film.kind].signal;
        (
            turn.at(film.theta_deg - contact),
            turn.slope(film.theta_deg - contact),
        )
    };
    let others: Vec<(f64, f64)> = fields
        .others
        .iter()
        .flat_map(|load| angles(OTHERS).map(move |angle| (angle, reading(load, angle).0)))
        .collect();
    let of_contact = |contact: f64| {
        let (own, slope) = reading(weakest, contact);
        let apart = film.theta_deg - contact;
        let variance = noise.variance(own, slope) + weakest.kinds[film.kind].scatter(apart);
        others.iter().map(move |(angle, other)| {
            let apart = (angle - contact).rem_euclid(360.0);
            match apart.min(360.0 - apart) > LOST_DEG {
                true => ((own - other).powi(2) / variance) as f32,
                false => f32::INFINITY,
            }
        })
    };
    angles(MISTAKEN).flat_map(of_contact).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fisher::bounds::bayes_angle_deg;
    use crate::fisher::bounds::tests::{NOISE, gaussian};
    use crate::simulate::alike::alike;

    fn error_deg(criterion: SearchCriterion, arrangement: &Arrangement, width_deg: f64) -> f64 {
        let fields = gaussian(width_deg);
        let fields = SearchFields {
            loads: &[fields.at(1.0)],
            others: &fields.evenly(8),
        };
        let shares = arrangement
            .films
            .iter()
            .map(|film| criterion.share(film, &fields, &NOISE));
        let sum = shares.reduce(|mut sum, share| {
            sum.add(&share);
            sum
        });
        let sum = sum.expect("a film");
        sum.error_of_sum_deg(&sum.nothing())
    }

    #[test]
    fn the_bound_is_that_of_the_layout() {
        let films = [(0.0, 0), (82.5, 1), (97.5, 1), (225.0, 0), (352.5, 1)];
        let films = films.map(|(theta_deg, kind)| LaidFilm { theta_deg, kind });
        let arrangement = Arrangement::free(films.to_vec());
        // By every fourth degree for whole ones.
        let bound = bayes_angle_deg(&gaussian(14.0).at(1.0), &arrangement, &NOISE);
        let found = error_deg(SearchCriterion::Bound, &arrangement, 14.0);
        assert!((found / bound.expect("finite") - 1.0).abs() < 0.02);
    }

    #[test]
    fn contacts_that_no_film_sees_are_mistaken_and_others_are_not() {
        let both = |arrangement: &Arrangement, width: f64| {
            SearchCriterion::ALL.map(|criterion| error_deg(criterion, arrangement, width))
        };
        // Two thirds of the contacts are out of sight of three narrow films: even odds there, 104 degrees off.
        let [bound, errors] = both(&Arrangement::regular(3, &[0], false), 6.0);
        let mistaken = (errors * errors - bound * bound) / PRIOR_ANGLE_DEG.powi(2);
        assert!((0.25..0.5).contains(&mistaken), "{mistaken}");
        // Dense films tell all contacts apart.
        let dense = Arrangement::regular(24, &[0, 1], false);
        let [bound, errors] = both(&dense, 14.0);
        let pair = alike(&gaussian(14.0), 1.0, &dense, &NOISE).expect("a pair");
        assert!(pair.sigmas > 20.0 && (errors / bound - 1.0).abs() < 1e-9);
    }

    #[test]
    fn the_least_sum_of_two_rows_is_found_wherever_it_stands() {
        for at in 0..19 {
            let row: Vec<f32> = (0..19).map(|k| if k == at { 1.0 } else { 2.0 }).collect();
            assert_eq!(least_sum(&row, &[0.5; 19]), 1.5, "{at}");
        }
    }
}
