//! Strain rings to ranked layouts.
//!
//! A layout is `units` pairs of films (x and y, or the one that is asked for) at equal angles around the wheel, at one meridional position. A film at
//! theta_i reads h(u) + noise with u = theta_i - phi, phi the contact angle: one contact solution gives the reading for
//! every contact angle by rotation, and dh/dphi = -h'(u). With g = dh/dd for a uniform depth d and noise of standard
//! deviation s in every film, the Fisher information of (phi, d) is
//!
//! ```text
//! I = s^-2 sum over films [ h'^2   -h' g ]
//!                         [ -h' g   g^2  ]
//! ```
//!
//! and the inverse's diagonal bounds the variances of any unbiased estimate from below (Cramer and Rao). The scores are
//! over contact angles in one sector [0, spacing), a degree apart. They hold near the cut point's load.

pub(crate) mod ring_field;

use fem_client::solver::direction::Direction;
use fem_client::solver::{Position, Response};
use gsa::campaign::Campaign;

use crate::layout::ring_field::{RingField, at_angle, ring_fields, slope_at_angle};
use crate::result::{LayoutScore, RankedLayout};
use crate::run::archive::Outcome;
use crate::score::quantity::around;
use crate::study::{Study, position_name};

/// Noise of a film relative to the largest strain around the crown at the cut point.
pub const NOISE_SHARE: f64 = 0.02;
/// An angle known no better than this isn't known: half a turn.
const BLIND_DEG: f64 = 180.0;
/// Determinant over the product of the diagonal below which angle and depth can't be told apart: rounding of the sums.
const SINGULAR: f64 = 1e-12;

/// Scores every layout of the study and ranks them, best first; `cut` is the response of the plan's first point.
///
/// The order is by the worst angle error times the square root of the number of units: the variance falls as one over
/// the number of films, so this compares what a film contributes. Layouts that are blind somewhere come last, the
/// strongest weakest signal first. Ties go to fewer units, then to the position nearest to the crown.
///
/// # Panics
/// If there is not one outcome for each point.
pub fn rank_layouts(
    study: &Study,
    campaign: &Campaign,
    cut: &Response,
    outcomes: &[Outcome],
) -> Vec<RankedLayout> {
    assert_eq!(
        outcomes.len(),
        campaign.points().len(),
        "one outcome for each point"
    );
    let noise = noise_strain(cut);
    let fields = ring_fields(study, campaign.design(), cut, outcomes);
    let mut scored = Vec::new();
    for &position in &study.layouts.positions {
        for &spacing in &study.layouts.spacings_deg {
            let score = match &fields {
                Ok(fields) => score(&fields[&position], spacing, noise),
                Err(reason) => empty_score(noise, reason.clone()),
            };
            let films = study.directions.asked();
            scored.push((position, layout(position, spacing, films, score)));
        }
    }
    scored.sort_by(|(p, a), (q, b)| order(a, b).then(p.cmp(q)));
    let mut layouts: Vec<RankedLayout> = scored.into_iter().map(|(_, layout)| layout).collect();
    for (i, layout) in layouts.iter_mut().enumerate() {
        layout.rank = i + 1;
    }
    layouts
}

fn order(a: &RankedLayout, b: &RankedLayout) -> std::cmp::Ordering {
    let per_film = |layout: &RankedLayout| {
        layout
            .score
            .worst_angle_error_deg
            .map_or(f64::INFINITY, |error| error * (layout.units as f64).sqrt())
    };
    let signal = |layout: &RankedLayout| match layout.score.worst_angle_error_deg {
        Some(_) => 0.0,
        None => layout.score.weakest_signal.unwrap_or(0.0),
    };
    per_film(a)
        .total_cmp(&per_film(b))
        .then(signal(b).total_cmp(&signal(a)))
        .then(a.units.cmp(&b.units))
}

fn noise_strain(cut: &Response) -> f64 {
    let crown = cut
        .rings
        .iter()
        .find(|ring| ring.position == Position::Crown);
    let strains = crown.iter().flat_map(|ring| around(ring).iter().flatten());
    NOISE_SHARE * strains.fold(0.0, |largest: f64, strain| largest.max(strain.abs()))
}

fn layout(
    position: Position,
    spacing_deg: f64,
    films: &[Direction],
    score: LayoutScore,
) -> RankedLayout {
    RankedLayout {
        rank: 0,
        spacing_deg,
        units: units(spacing_deg),
        position: position_name(position).to_owned(),
        films: films.to_vec(),
        score,
    }
}

fn units(spacing_deg: f64) -> usize {
    (360.0 / spacing_deg).round() as usize
}

fn empty_score(noise_strain: f64, reason: String) -> LayoutScore {
    LayoutScore {
        weakest_signal: None,
        worst_angle_error_deg: None,
        rms_angle_error_deg: None,
        worst_depth_error_mm: None,
        noise_strain,
        reason: Some(reason),
    }
}

fn score(field: &RingField, spacing_deg: f64, noise: f64) -> LayoutScore {
    let angles: Vec<f64> = (0..spacing_deg.ceil() as usize)
        .map(|degree| degree as f64)
        .collect();
    let strongest = |angle: &f64| strongest_signal(field, spacing_deg, *angle);
    let weakest_signal = angles.iter().map(strongest).fold(f64::INFINITY, f64::min);
    let mut score = LayoutScore {
        weakest_signal: Some(weakest_signal),
        ..empty_score(noise, String::new())
    };
    let bounds: Result<Vec<Bound>, String> = angles
        .iter()
        .map(|angle| bound(field, spacing_deg, *angle, noise))
        .collect();
    match bounds {
        Err(reason) => score.reason = Some(reason),
        Ok(bounds) => {
            let worst = |part: fn(&Bound) -> f64| bounds.iter().map(part).fold(0.0, f64::max);
            let squares = bounds
                .iter()
                .map(|b| b.angle_deg * b.angle_deg)
                .sum::<f64>();
            score.reason = None;
            score.worst_angle_error_deg = Some(worst(|b| b.angle_deg));
            score.rms_angle_error_deg = Some((squares / bounds.len() as f64).sqrt());
            score.worst_depth_error_mm = Some(worst(|b| b.depth_mm));
        }
    }
    score
}

/// Where the units are seen from the contact, degrees.
fn unit_angles(spacing_deg: f64, contact_deg: f64) -> impl Iterator<Item = f64> {
    (0..units(spacing_deg)).map(move |i| i as f64 * spacing_deg - contact_deg)
}

fn strongest_signal(field: &RingField, spacing_deg: f64, contact_deg: f64) -> f64 {
    let signals = unit_angles(spacing_deg, contact_deg).flat_map(|u| {
        field
            .strain
            .iter()
            .map(move |samples| at_angle(samples, u).abs())
    });
    signals.fold(0.0, f64::max)
}

/// Least standard deviations of an unbiased estimate.
struct Bound {
    angle_deg: f64,
    depth_mm: f64,
}

fn bound(
    field: &RingField,
    spacing_deg: f64,
    contact_deg: f64,
    noise: f64,
) -> Result<Bound, String> {
    let (mut angle, mut cross, mut depth) = (0.0, 0.0, 0.0);
    for u in unit_angles(spacing_deg, contact_deg) {
        for (strain, by_depth) in field.strain.iter().zip(&field.by_depth) {
            // In units of the noise, so that the sums don't underflow.
            let slope = -slope_at_angle(strain, u) / noise;
            let growth = at_angle(by_depth, u) / noise;
            angle += slope * slope;
            cross += slope * growth;
            depth += growth * growth;
        }
    }
    let determinant = angle * depth - cross * cross;
    // Not `<=`: NaN, as from a tire that feels nothing and so has no noise, must come here too.
    if !(determinant > SINGULAR * angle * depth && determinant.is_finite()) {
        return Err(format!(
            "with the contact at {contact_deg} degrees the films can't tell its angle from its depth"
        ));
    }
    let bound = Bound {
        angle_deg: (depth / determinant).sqrt(),
        depth_mm: (angle / determinant).sqrt(),
    };
    if !(bound.angle_deg <= BLIND_DEG && bound.depth_mm.is_finite()) {
        return Err(format!(
            "with the contact at {contact_deg} degrees the films see too little of it: the angle's error is beyond half a turn"
        ));
    }
    Ok(bound)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A Gaussian contact of depth 1: h = d exp(-u^2 / 2 s^2) in x, nothing in y.
    fn gaussian(width_deg: f64) -> RingField {
        let profile = |u: i32| (-0.5 * (f64::from(u) / width_deg).powi(2)).exp();
        let x: Vec<f64> = (-180..180).map(profile).collect();
        RingField {
            strain: vec![x.clone(), vec![0.0; 360]],
            by_depth: vec![x, vec![0.0; 360]],
        }
    }

    #[test]
    fn dense_films_reach_the_closed_form_of_the_bound() {
        // Spacing D much below the width s: sum h'^2 -> integral / D, and the bound is (noise/d) sqrt(2 s D / sqrt(pi)).
        let (width, spacing, noise) = (20.0, 5.0, 0.02);
        let expected = noise * (2.0 * width * spacing / std::f64::consts::PI.sqrt()).sqrt();
        let score = score(&gaussian(width), spacing, noise);
        // The central difference over +-1 degree flattens slopes by 1/(6 s^2) of h'''/h' ~ 3: 1.3e-3.
        let worst = score.worst_angle_error_deg.unwrap();
        assert!(
            (worst / expected - 1.0).abs() < 3e-3,
            "{worst} for {expected}"
        );
        let rms = score.rms_angle_error_deg.unwrap();
        assert!(rms <= worst && (rms / worst - 1.0).abs() < 1e-3);
    }

    #[test]
    fn a_contact_between_distant_films_goes_unseen() {
        let score = score(&gaussian(5.0), 180.0, 0.02);
        assert_eq!(score.worst_angle_error_deg, None);
        assert!(score.reason.unwrap().contains("degrees"));
        // Midway the nearest film is 90 degrees off: exp(-162).
        assert!(score.weakest_signal.unwrap() < 1e-60);
    }

    #[test]
    fn no_strain_at_all_gives_reasons_and_no_numbers() {
        let nothing = || vec![vec![0.0; 360]; 2];
        let score = score(
            &RingField {
                strain: nothing(),
                by_depth: nothing(),
            },
            60.0,
            0.0,
        );
        assert_eq!(
            (score.weakest_signal, score.worst_depth_error_mm),
            (Some(0.0), None)
        );
        assert!(score.reason.is_some());
    }

    #[test]
    fn sevenths_of_a_turn_are_seven_units() {
        assert_eq!(units(360.0 / 7.0), 7);
        assert_eq!(unit_angles(360.0 / 7.0, 0.0).count(), 7);
    }
}
