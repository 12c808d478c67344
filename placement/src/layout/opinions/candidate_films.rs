//! Kinds of film by several criteria, which order them differently.

use crate::layout::arrangement::FilmKind;
use crate::layout::field::film_field::{DepthFields, KindField, LoadField, Noise};
use crate::layout::layout_settings::direction_name;
use crate::layout::opinions::kendall::tau;
use crate::layout::opinions::modes::leading_modes;
use crate::layout::opinions::pivots::{effective_independence, pivot_order};
use crate::result::{CandidateFilm, OrderAgreement};

/// Share of the snapshots' sum of squares that the modes hold.
const OF_SNAPSHOTS: f64 = 0.99;
/// Distance of the snapshots around the wheel, degrees.
const STEP_DEG: usize = 5;
/// Depths over which the signal at the centre varies.
const DEPTHS: usize = 16;

/// Figures of every kind of film; those with the error of the information by a coarser mesh come with its factor.
pub fn candidates(
    kinds: &[FilmKind],
    fields: &DepthFields,
    depths_mm: &[f64],
    noise: &Noise,
    coarser: Option<(&DepthFields, &Noise, f64)>,
) -> Vec<CandidateFilm> {
    let loads: Vec<LoadField> = depths_mm.iter().map(|depth| fields.at(*depth)).collect();
    let coarse = coarser.map(|(fields, noise, factor)| {
        let loads: Vec<LoadField> = depths_mm.iter().map(|depth| fields.at(*depth)).collect();
        (loads, *noise, factor)
    });
    let modes = leading_modes(&snapshots(kinds.len(), &loads), OF_SNAPSHOTS);
    let (order, leverage) = (pivot_order(&modes), effective_independence(&modes));
    let candidate = |(k, kind): (usize, &FilmKind)| {
        let [angle, depth] = information(k, &loads, noise);
        CandidateFilm {
            section_deg: kind.phi_deg,
            direction: direction_name(kind.angle_deg),
            length_mm: kind.extent.map(|extent| extent.length_mm),
            width_mm: kind.extent.map(|extent| extent.width_mm),
            signal: loads
                .iter()
                .flat_map(|load| load.kinds[k].signal.samples())
                .fold(0.0, |largest, x| largest.max(x.abs())),
            angle_information: angle,
            depth_information: depth,
            effective_independence: leverage[k],
            pivot_rank: order
                .iter()
                .position(|&row| row == k)
                .map(|place| place + 1),
            centre_std: centre_std(k, fields),
            angle_information_error: coarse.as_ref().map(|(loads, noise, factor)| {
                let [coarse, _] = information(k, loads, noise);
                factor * (coarse - angle).abs()
            }),
        }
    };
    kinds.iter().enumerate().map(candidate).collect()
}

/// How far each two criteria agree.
pub fn agreement(candidates: &[CandidateFilm]) -> Vec<OrderAgreement> {
    let figures =
        |of: &dyn Fn(&CandidateFilm) -> f64| -> Vec<f64> { candidates.iter().map(of).collect() };
    // The first that is taken stands highest.
    let pivot = |film: &CandidateFilm| -(film.pivot_rank.unwrap_or(candidates.len() + 1) as f64);
    let criteria: [(&str, Vec<f64>); 6] = [
        ("angle information", figures(&|film| film.angle_information)),
        ("depth information", figures(&|film| film.depth_information)),
        ("signal", figures(&|film| film.signal)),
        (
            "effective independence",
            figures(&|film| film.effective_independence),
        ),
        ("pivots", figures(&pivot)),
        ("variance at the centre", figures(&|film| film.centre_std)),
    ];
    let pairs = (0..criteria.len()).flat_map(|i| (i + 1..6).map(move |j| (i, j)));
    pairs
        .map(|(i, j)| OrderAgreement {
            first: criteria[i].0.to_owned(),
            second: criteria[j].0.to_owned(),
            tau: tau(&criteria[i].1, &criteria[j].1),
        })
        .collect()
}

/// Roots of the mean information on angle and depth over the turn and the loads.
fn information(kind: usize, loads: &[LoadField], noise: &Noise) -> [f64; 2] {
    let mut sums = [0.0; 2];
    for field in loads.iter().map(|load| &load.kinds[kind]) {
        for apart in (-180..180).map(f64::from) {
            let slope = field.signal.slope(apart);
            let variance = noise.variance(field.signal.at(apart), slope);
            sums[0] += slope * slope / variance;
            sums[1] += field.slopes[0].at(apart).powi(2) / variance;
        }
    }
    sums.map(|sum| (sum / (360 * loads.len()) as f64).sqrt())
}

fn snapshots(kinds: usize, loads: &[LoadField]) -> Vec<Vec<f64>> {
    let around = |field: &KindField| -> Vec<f64> {
        field
            .signal
            .samples()
            .iter()
            .step_by(STEP_DEG)
            .copied()
            .collect()
    };
    (0..kinds)
        .map(|k| {
            loads
                .iter()
                .flat_map(|load| around(&load.kinds[k]))
                .collect()
        })
        .collect()
}

/// Standard deviation of the signal at the contact's centre over the depths of the study.
fn centre_std(kind: usize, fields: &DepthFields) -> f64 {
    let [low, high] = fields.depths.ends();
    let depth = |k: usize| low + (high - low) * (k as f64 + 0.5) / DEPTHS as f64;
    let at: Vec<f64> = (0..DEPTHS)
        .map(|k| fields.signal_at_centre(kind, depth(k)))
        .collect();
    let mean = at.iter().sum::<f64>() / DEPTHS as f64;
    (at.iter().map(|value| (value - mean).powi(2)).sum::<f64>() / DEPTHS as f64).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layout::fisher::bounds::tests::{NOISE, gaussian};

    #[test]
    fn criteria_see_different_things() {
        let kinds = [0.0, 90.0].map(|angle_deg| FilmKind::point(0.0, angle_deg));
        let fields = gaussian(15.0);
        let found = candidates(
            &kinds,
            &fields,
            &[1.0],
            &NOISE,
            Some((&fields, &NOISE, 2.0)),
        );
        let [bell, slope] = [&found[0], &found[1]];
        // The bell is largest where it says nothing of the angle; its slope vanishes there.
        assert!((bell.signal - 1.0).abs() < 1e-12 && slope.centre_std < 1e-12);
        // Depths are flat from 0.5 to 1.5: 1 / sqrt(12), less what sixteen middles miss.
        assert!((bell.centre_std - (1.0 / 12f64).sqrt()).abs() < 1e-3);
        // Means of squares over the turn: sqrt(pi) / (2 s) and sqrt(pi) 3 / (4 s) over 360 degrees.
        let expected = (std::f64::consts::PI.sqrt() / (2.0 * 15.0) / 360.0).sqrt() / NOISE.floor;
        assert!((bell.angle_information / expected - 1.0).abs() < 1e-4);
        assert!((slope.angle_information / bell.angle_information - 1.5f64.sqrt()).abs() < 1e-4);
        assert_eq!(bell.angle_information_error, Some(0.0));
        assert_eq!(
            found
                .iter()
                .filter(|film| film.pivot_rank.is_some())
                .count(),
            2
        );
        let taus = agreement(&found);
        assert_eq!(taus.len(), 15);
        let tau = taus
            .iter()
            .find(|tau| tau.first == "angle information" && tau.second == "variance at the centre");
        assert_eq!(tau.and_then(|tau| tau.tau), Some(-1.0));
    }
}
