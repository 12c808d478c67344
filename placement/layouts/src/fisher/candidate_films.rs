//! Kinds of film by what one film of each knows.

use crate::arrangement::FilmKind;
use crate::field::film_field::{DepthFields, LoadField, Noise};
use documents::layouts::layout_settings::direction_name;
use results::CandidateFilm;

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
            angle_information_error: coarse.as_ref().map(|(loads, noise, factor)| {
                let [coarse, _] = information(k, loads, noise);
                factor * (coarse - angle).abs()
            }),
        }
    };
    kinds.iter().enumerate().map(candidate).collect()
}

/// Roots of the mean information on angle and depth over the turn and the loads.
fn information(kind: usize, loads: &[LoadField], noise: &Noise) -> [f64; 2] {
    let mut sums = [0.0; 2];
    for field in loads.iter().map(|load| &load.kinds[kind]) {
        for apart in (-180..180).map(f64::from) {
            let slope = field.signal.slope(apart);
            let variance = noise.variance(field.signal.at(apart), slope) + field.scatter(apart);
            sums[0] += slope * slope / variance;
            sums[1] += field.slopes[0].at(apart).powi(2) / variance;
        }
    }
    sums.map(|sum| (sum / (360 * loads.len()) as f64).sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fisher::bounds::tests::{NOISE, gaussian};

    #[test]
    fn a_bell_knows_less_of_the_angle_than_its_slope() {
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
        assert!((bell.signal - 1.0).abs() < 1e-12);
        // Means of squares over the turn: sqrt(pi) / (2 s) and sqrt(pi) 3 / (4 s) over 360 degrees.
        let expected = (std::f64::consts::PI.sqrt() / (2.0 * 15.0) / 360.0).sqrt() / NOISE.floor;
        assert!((bell.angle_information / expected - 1.0).abs() < 1e-4);
        assert!((slope.angle_information / bell.angle_information - 1.5f64.sqrt()).abs() < 1e-4);
        assert_eq!(bell.angle_information_error, Some(0.0));
    }
}
