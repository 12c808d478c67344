//! A thick neo-Hookean sphere close to its exact limit point, and beyond it.

use std::sync::atomic::AtomicBool;

use fem::newton::iteration::Newton;
use fem::newton::path::{Stability, follow};
use fem::newton::volume_control::{Ending, Inflated, LIMIT_TOLERANCE, VolumeControl};
use fem::problem::{Loads, Problem};

use crate::family::Unsolved;
use crate::known_case::Case;
use crate::mesh_refinement::Refinement;
use crate::sphere::{MESHES, NEO_HOOKEAN, RATIO, SLOPE, exact, octant, reference};

/// Outer over inner radius.
const OUTER: f64 = 2.0;
/// Stretch of the inner radius at the limit point, and limit pressure over shear modulus, to 16 digits.
const LIMIT: [f64; 2] = [1.8281473049363495, 0.8164236479554001];
/// Pressures below the limit, and beyond that of the mesh, over it.
const BELOW: [f64; 3] = [0.99, 0.999, 0.9999];
const BEYOND: [f64; 2] = [1.001, 100.0];
/// Volumes beyond the limit point's, over it, at which the way back begins.
const FAR_SIDE: [f64; 2] = [1.3, 1.2];
/// Secant steps on the way back.
const MOST_STEPS: usize = 12;
/// Volume over that of the reference state up to which a limit point is searched.
const LARGEST_VOLUME: f64 = 30.0;
const STRETCH_SOURCE: &str = "exact: root of the pressure below; tolerance: what the mesh's error of the pressure does to it";

/// Stretch of the inner radius at a pressure (over the shear modulus) on the rising path; at the limit and beyond the limit's.
fn exact_stretch(pressure: f64) -> f64 {
    let (mut low, mut high) = (1.0, LIMIT[0]);
    // Halvings to the last bit.
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if exact(&NEO_HOOKEAN, OUTER, middle) < pressure {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}

/// Inflates to a pressure, and says where that ends.
fn inflate(
    problem: &Problem,
    pressure: f64,
    stop: &AtomicBool,
) -> Result<(Inflated, Ending), Unsolved> {
    let mut control = VolumeControl::new(problem)?;
    let start = reference(&mut control, stop)?;
    let ending = control.inflate(&start, pressure, LARGEST_VOLUME * start.volume, stop);
    Ok((start, ending))
}

/// The maximum of the pressure approached from volumes larger than that of the limit point: secants of the slope.
fn from_beyond(problem: &Problem, limit: &Inflated, stop: &AtomicBool) -> Result<f64, Unsolved> {
    let mut control = VolumeControl::new(problem)?;
    let mut at = |near: &Inflated, volume: f64| {
        let solved = control.solve(near, volume, stop);
        solved.map_err(|failure| Unsolved::Volume {
            ratio: volume / limit.volume,
            cause: failure.cause,
        })
    };
    let mut before = at(limit, FAR_SIDE[0] * limit.volume)?;
    let mut now = at(&before, FAR_SIDE[1] * limit.volume)?;
    for _ in 0..MOST_STEPS {
        let step = now.slope * (now.volume - before.volume) / (now.slope - before.slope);
        if (now.slope * step).abs() <= LIMIT_TOLERANCE * now.pressure {
            return Ok(now.pressure);
        }
        let next = at(&now, now.volume - step)?;
        (before, now) = (now, next);
    }
    let lost = "the way back from beyond the limit doesn't end";
    Err(Unsolved::Other(lost.to_owned()))
}

/// The limit point that ends inflation to a higher pressure.
fn limit(problem: &Problem, pressure: f64, stop: &AtomicBool) -> Result<Inflated, Unsolved> {
    match inflate(problem, pressure, stop)?.1 {
        Ending::LimitPoint(limit) => Ok(limit),
        Ending::Lost { failure, .. } => Err(Unsolved::LimitPoint {
            cause: failure.cause,
        }),
        _ => Err(Unsolved::NoLimitPoint {
            ratio: LARGEST_VOLUME,
        }),
    }
}

/// Stretch of the inner radius in the equilibrium at a pressure.
fn stretch(problem: &Problem, pressure: f64, stop: &AtomicBool) -> Result<f64, Unsolved> {
    let (start, ending) = inflate(problem, pressure, stop)?;
    let Ending::Reached(near) = ending else {
        return Err(Unsolved::Other(format!(
            "inflation to {pressure} MPa doesn't get there"
        )));
    };
    let loads = |pressure| Loads {
        pressure,
        support_factor: 1.0,
        ..Loads::default()
    };
    let mut newton = Newton::new(problem)?;
    let mut state = near.state;
    let (from, to) = (loads(near.pressure), loads(pressure));
    let followed = follow(
        &mut newton,
        &mut state,
        &from,
        &to,
        Stability::Required,
        stop,
    );
    followed.map_err(|failure| Unsolved::Load {
        reached: failure.reached,
        cause: failure.cause,
    })?;
    let surface = problem.pressure.as_ref();
    let volume = surface.map(|s| s.enclosed_volume(|node| state.position(&problem.mesh, node)));
    Ok((volume.unwrap_or(f64::NAN) / start.volume).cbrt())
}

/// Stretches below the limit point, and the limit named from beyond it.
pub(super) fn cases(stop: &AtomicBool) -> Result<Vec<Case>, Unsolved> {
    let [coarse, fine] = MESHES.map(|n| octant(n, OUTER, NEO_HOOKEAN));
    let coarse = limit(&coarse, f64::INFINITY, stop)?.pressure;
    let from_below = limit(&fine, f64::INFINITY, stop)?;
    let own = from_below.pressure;
    let meshes = Refinement::new(vec![coarse], vec![own], RATIO);
    let bound = meshes.bound(SLOPE);
    let mut cases = Vec::new();
    for share in BELOW {
        let pressure = share * LIMIT[1];
        let expected = exact_stretch(pressure);
        let [low, high] = [1.0 - bound, 1.0 + bound].map(|factor| exact_stretch(factor * pressure));
        let name = format!("sphere B/A = 2 at {share} of its limit pressure: stretch");
        let case = Case::absolute(name, stretch(&fine, pressure, stop)?, expected);
        let tolerance = (high - expected).max(expected - low);
        cases.push(case.within(tolerance, STRETCH_SOURCE));
    }
    let name = "sphere B/A = 2, from larger volumes: limit / mu";
    let case = Case::relative(name, from_beyond(&fine, &from_below, stop)?, own);
    cases.push(case.within(
        2.0 * LIMIT_TOLERANCE,
        "from smaller volumes, same mesh; both searches end at 1e-6",
    ));
    for share in BEYOND {
        let computed = limit(&fine, share * own, stop)?.pressure;
        let name = format!("sphere B/A = 2 asked for {share} times its limit pressure: limit / mu");
        let case = Case::relative(name, computed, LIMIT[1]).within(
            bound,
            "exact: maximum of the pressure; tolerance: two meshes",
        );
        cases.push(case.ended("limit-point"));
    }
    Ok(cases)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_exact_stretch_has_its_pressure() {
        for share in BELOW {
            let stretch = exact_stretch(share * LIMIT[1]);
            let pressure = exact(&NEO_HOOKEAN, OUTER, stretch);
            assert!(
                (pressure / (share * LIMIT[1]) - 1.0).abs() < 1e-14,
                "{share}"
            );
        }
        assert!((exact_stretch(1.0) - LIMIT[0]).abs() < 1e-15);
    }
}
