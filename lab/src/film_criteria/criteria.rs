//! Kinds of film by several criteria, which order them differently.

use layouts::field::film_field::{DepthFields, LoadField};
use layouts::ranking::kendall::tau;
use results::CandidateFilm;

use crate::film_criteria::modes::leading_modes;
use crate::film_criteria::pivots::{effective_independence, pivot_order};

/// Share of the snapshots' sum of squares that the modes hold.
const OF_SNAPSHOTS: f64 = 0.99;
/// Distance of the snapshots around the wheel, degrees.
const STEP_DEG: usize = 5;
/// Depths over which the signal at the centre varies.
const DEPTHS: usize = 16;

/// Figures of a kind of film by criteria that no answer uses.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FilmFigures {
    /// Effective independence: its share in what all kinds together tell apart, 0 to 1.
    pub effective_independence: f64,
    /// Place among the kinds that pivoting picks, 1 first; none of those that add nothing.
    pub pivot_rank: Option<usize>,
    /// Standard deviation of the signal at the contact's centre over the solved depths: what the paper ranks by.
    pub centre_std: f64,
}

/// A criterion and each kind's figure by it; the greatest is best.
pub type Criterion = (&'static str, Vec<f64>);

/// Figures of kinds of film by what they read at loads of these depths.
pub fn figures(fields: &DepthFields, depths_mm: &[f64]) -> Vec<FilmFigures> {
    let loads: Vec<LoadField> = depths_mm.iter().map(|depth| fields.at(*depth)).collect();
    let modes = leading_modes(&snapshots(&loads), OF_SNAPSHOTS);
    let (order, leverage) = (pivot_order(&modes), effective_independence(&modes));
    let [low, high] = fields.depths.ends();
    let depths = (0..DEPTHS).map(|k| low + (high - low) * (k as f64 + 0.5) / DEPTHS as f64);
    let depths: Vec<LoadField> = depths.map(|depth| fields.at(depth)).collect();
    let figures_of = |(kind, effective_independence): (usize, f64)| FilmFigures {
        effective_independence,
        pivot_rank: order
            .iter()
            .position(|row| *row == kind)
            .map(|place| place + 1),
        centre_std: centre_std(kind, &depths),
    };
    leverage.into_iter().enumerate().map(figures_of).collect()
}

/// Returns what each kind reads every few degrees around the wheel, at all loads.
fn snapshots(loads: &[LoadField]) -> Vec<Vec<f64>> {
    let kinds = loads.first().map_or(0, |load| load.kinds.len());
    let around = |load: &LoadField, kind: usize| -> Vec<f64> {
        let samples = load.kinds[kind].signal.samples();
        samples.iter().step_by(STEP_DEG).copied().collect()
    };
    (0..kinds)
        .map(|kind| loads.iter().flat_map(|load| around(load, kind)).collect())
        .collect()
}

fn centre_std(kind: usize, depths: &[LoadField]) -> f64 {
    let at: Vec<f64> = depths
        .iter()
        .map(|load| load.kinds[kind].signal.at(0.0))
        .collect();
    let mean = at.iter().sum::<f64>() / at.len() as f64;
    let variance = at.iter().map(|value| (value - mean).powi(2)).sum::<f64>() / at.len() as f64;
    variance.sqrt()
}

/// Kinds of film by all criteria.
pub fn criteria(films: &[CandidateFilm], figures: &[FilmFigures]) -> [Criterion; 6] {
    let known = |of: fn(&CandidateFilm) -> f64| films.iter().map(of).collect();
    let said = |of: &dyn Fn(&FilmFigures) -> f64| figures.iter().map(of).collect();
    // The first that is taken stands highest.
    let pivot = |it: &FilmFigures| -(it.pivot_rank.unwrap_or(figures.len() + 1) as f64);
    [
        ("angle information", known(|film| film.angle_information)),
        ("depth information", known(|film| film.depth_information)),
        ("signal", known(|film| film.signal)),
        (
            "effective independence",
            said(&|it| it.effective_independence),
        ),
        ("pivots", said(&pivot)),
        ("variance at the centre", said(&|it| it.centre_std)),
    ]
}

/// Kendall's tau between each two criteria.
pub fn agreement(criteria: &[Criterion]) -> Vec<Vec<Option<f64>>> {
    let row = |(_, own): &Criterion| criteria.iter().map(|(_, other)| tau(own, other)).collect();
    criteria.iter().map(row).collect()
}

#[cfg(test)]
mod tests {
    use layouts::arrangement::FilmKind;
    use layouts::field::film_field::Noise;
    use layouts::field::hermite::Nodes;
    use layouts::fisher::candidate_films::candidates;

    use super::*;

    /// A bell of 15 degrees that grows with the depth, and its slope.
    fn bell_and_slope() -> DepthFields {
        let depths = [0.5, 0.9, 1.0, 1.1, 1.5];
        let bell = |u: f64| (-0.5 * (u / 15.0).powi(2)).exp();
        let over = |profile: &dyn Fn(f64) -> f64| -> Vec<Vec<f64>> {
            let around = |depth: &f64| {
                let degrees = (-180..180).map(f64::from);
                degrees.map(|u| depth * profile(u)).collect()
            };
            depths.iter().map(around).collect()
        };
        DepthFields {
            depths: Nodes::new(depths.to_vec()),
            forces_n: depths.iter().map(|depth| 13.0 * depth).collect(),
            signals: vec![over(&bell), over(&|u| -u / 15.0 * bell(u))],
            sheared: Vec::new(),
            contacts: None,
            spread: None,
            together: None,
            surface_error: None,
        }
    }

    #[test]
    fn criteria_see_different_things() {
        let (fields, loads) = (bell_and_slope(), [1.0]);
        let found = figures(&fields, &loads);
        let [bell, slope] = found[..] else {
            panic!("two kinds: {found:?}");
        };
        // The bell is largest where it says nothing of the angle; its slope vanishes there.
        assert!(slope.centre_std < 1e-12);
        // Depths are flat from 0.5 to 1.5: 1 / sqrt(12), less what sixteen middles miss.
        assert!((bell.centre_std - (1.0 / 12f64).sqrt()).abs() < 1e-3);
        assert!(bell.pivot_rank.is_some() && slope.pivot_rank.is_some());
        let kinds = [0.0, 90.0].map(|angle_deg| FilmKind::point(0.0, angle_deg));
        let noise = Noise {
            floor: 0.01,
            in_volts: false,
            gain_std: 0.0,
            place_std_deg: 0.0,
        };
        let films = candidates(&kinds, &fields, &loads, &noise, None);
        let taus = agreement(&criteria(&films, &found));
        assert_eq!(
            (taus[0][0], taus[0][5], taus[5][0]),
            (Some(1.0), Some(-1.0), Some(-1.0))
        );
    }
}
