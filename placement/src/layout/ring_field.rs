//! The strain around the wheel at one meridional position, and how it changes with a uniform depth.

use std::collections::BTreeMap;

use fem_client::solver::direction::Direction;
use fem_client::solver::{Position, Response, Ring};
use gsa::design::{Design, Line};

use crate::run::archive::Outcome;
use crate::score::quantity::around;
use crate::study::Study;

/// The strains that are asked for around the wheel, sampled each degree from -180.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct RingField {
    /// Strains at the cut point, x before y.
    pub strain: Vec<Vec<f64>>,
    /// Their derivatives to a uniform depth, 1/mm.
    pub by_depth: Vec<Vec<f64>>,
}

/// The fields of all rings of a study, or why there is no derivative to the depth.
pub(crate) fn ring_fields(
    study: &Study,
    design: Option<&Design>,
    cut: &Response,
    outcomes: &[Outcome],
) -> Result<BTreeMap<Position, RingField>, String> {
    let design = design.ok_or(
        "this method has no lines through the means, so there is no derivative to the depth",
    )?;
    let differences = depth_differences(study, design, outcomes)?;
    let asked = study.directions.asked();
    let field = |(i, ring): (usize, &Ring)| {
        let by_depth = |&direction: &Direction| {
            let samples = |ring| &around(ring)[direction];
            let mut slope = vec![0.0; samples(ring).len()];
            for d in &differences {
                let (below, above) = (samples(&d.below.rings[i]), samples(&d.above.rings[i]));
                for ((slope, below), above) in slope.iter_mut().zip(below).zip(above) {
                    *slope += (above - below) / d.distance_mm;
                }
            }
            slope
        };
        let field = RingField {
            strain: asked.iter().map(|&d| around(ring)[d].clone()).collect(),
            by_depth: asked.iter().map(by_depth).collect(),
        };
        (ring.position, field)
    };
    Ok(cut.rings.iter().enumerate().map(field).collect())
}

/// The responses on either side of the cut point, along one depth.
struct Difference<'r> {
    below: &'r Response,
    above: &'r Response,
    distance_mm: f64,
}

/// By the chain rule the derivative to a uniform depth is the sum of those to each station's own.
fn depth_differences<'r>(
    study: &Study,
    design: &Design,
    outcomes: &'r [Outcome],
) -> Result<Vec<Difference<'r>>, String> {
    let depths = study
        .inputs
        .iter()
        .enumerate()
        .filter(|(_, input)| input.station().is_some());
    let cut = &design.points()[0];
    let differences: Option<Vec<Difference<'_>>> = depths
        .map(|(i, _)| central_difference(&design.lines()[i], cut[i], outcomes))
        .collect();
    match differences {
        None => Err(
            "along some depth no point on one side of the means has an equilibrium (one node per input has none there), so \
             there is no derivative to the depth"
                .to_owned(),
        ),
        Some(list) if list.len() < study.scene.ground.stations => Err(
            "not every station's depth is an input, so there is no derivative to a uniform depth"
                .to_owned(),
        ),
        Some(list) => Ok(list),
    }
}

/// The nodes nearest to the centre on both sides of it, of those with a response.
fn central_difference<'r>(
    line: &Line,
    centre: f64,
    outcomes: &'r [Outcome],
) -> Option<Difference<'r>> {
    let nodes = || {
        let nodes = line.rule().nodes.iter().zip(line.ordinals());
        nodes.filter_map(|(x, ordinal)| Some((*x, outcomes[*ordinal].as_ref().ok()?)))
    };
    let (below_mm, below) = nodes().rfind(|(x, _)| *x < centre)?;
    let (above_mm, above) = nodes().find(|(x, _)| *x > centre)?;
    Some(Difference {
        below,
        above,
        distance_mm: above_mm - below_mm,
    })
}

/// A sampled function of the angle, one sample each degree from -180, between samples by straight lines.
pub(crate) fn at_angle(samples: &[f64], angle_deg: f64) -> f64 {
    let position = (angle_deg + 180.0).rem_euclid(360.0);
    let (i, share) = (position.floor() as usize % samples.len(), position.fract());
    samples[i] + share * (samples[(i + 1) % samples.len()] - samples[i])
}

/// Its derivative to the angle by central differences over two degrees, 1/degree.
pub(crate) fn slope_at_angle(samples: &[f64], angle_deg: f64) -> f64 {
    (at_angle(samples, angle_deg + 1.0) - at_angle(samples, angle_deg - 1.0)) / 2.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angles_wrap_around() {
        let samples: Vec<f64> = (-180..180).map(f64::from).collect();
        assert_eq!(at_angle(&samples, 0.5), 0.5);
        assert_eq!(at_angle(&samples, -540.0), -180.0);
        assert_eq!(at_angle(&samples, 359.0), -1.0);
        assert_eq!(at_angle(&samples, 179.5), (179.0 - 180.0) / 2.0);
        assert_eq!(slope_at_angle(&samples, 10.0), 1.0);
    }
}
