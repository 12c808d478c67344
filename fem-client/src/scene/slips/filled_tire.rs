//! Pressures in other units, and tires in metres.

use super::rubber_constants::RUBBER;
use super::slip::{Slip, rounded};
use crate::scene::Scene;

/// Pressures to which tires are filled, MPa: from a soft robot's to an aircraft's.
const FILLED: std::ops::RangeInclusive<f64> = 0.005..=1.6;
/// Most that a rubber wall bears, in shear moduli.
const MOST_BORNE: f64 = 10.0;
/// Units in which pressures are typed instead of MPa, in one MPa.
const UNITS: [(&str, f64); 4] = [("bar", 10.0), ("kPa", 1e3), ("psi", 145.038), ("hPa", 1e4)];
/// Smallest outer radius of a wheel, mm.
const SMALLEST: f64 = 1.0;

pub(super) fn slips(scene: &Scene) -> Vec<Slip> {
    [pressure(scene), size(scene)]
        .into_iter()
        .flatten()
        .collect()
}

/// A pressure that no tire is filled to, or that its rubber can't bear.
fn pressure(scene: &Scene) -> Option<Slip> {
    let pressure = scene.pressure.internal_mpa;
    let modulus = scene.material.law.shear_modulus_mpa();
    // A modulus in another unit has its own note.
    let is_borne = pressure <= MOST_BORNE * modulus || !RUBBER.contains(&modulus);
    if pressure <= *FILLED.end() && is_borne {
        return None;
    }
    let likely = |mpa: f64| FILLED.contains(&mpa) && (0.01..=MOST_BORNE).contains(&(mpa / modulus));
    let meant: Vec<String> = UNITS
        .iter()
        .map(|(unit, in_mpa)| (unit, pressure / in_mpa))
        .filter(|(_, mpa)| likely(*mpa))
        .map(|(unit, mpa)| format!(" Typed in {unit}? In MPa that is {}.", rounded(mpa)))
        .collect();
    let beside = match is_borne {
        true => String::new(),
        false => format!(
            ", and {} times the rubber's shear modulus, where some {MOST_BORNE} are borne",
            rounded(pressure / modulus)
        ),
    };
    let detail = format!(
        "{} MPa is {} bar{beside}; tires are filled to {} MPa at most.{}",
        rounded(pressure),
        rounded(10.0 * pressure),
        FILLED.end(),
        meant.concat()
    );
    Some(Slip::of("pressure.internal_mpa", detail))
}

/// A wheel smaller than a rice grain.
fn size(scene: &Scene) -> Option<Slip> {
    let radius = scene.geometry.outer_radius_mm;
    (radius < SMALLEST).then(|| {
        let detail = format!(
            "the tire's radius is {} mm. Typed in metres? In mm that is {}.",
            rounded(radius),
            rounded(1e3 * radius)
        );
        Slip::of("geometry.outer_radius_mm", detail)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(pressure: f64, radius: f64) -> Vec<String> {
        let mut scene = Scene::default();
        scene.pressure.internal_mpa = pressure;
        scene.geometry.outer_radius_mm = radius;
        slips(&scene).iter().map(Slip::to_string).collect()
    }

    #[test]
    fn a_pressure_in_another_unit_is_told_with_the_value_in_mpa() {
        for (typed, meant) in [
            (2.0, "Typed in bar? In MPa that is 0.2."),
            (200.0, "Typed in kPa? In MPa that is 0.2."),
            (29.0, "Typed in psi? In MPa that is 0.1999."),
        ] {
            let found = of(typed, 50.0);
            assert!(found.len() == 1 && found[0].contains(meant), "{found:?}");
        }
        for usual in [0.0, 1e-3, 0.2, 1.6] {
            assert!(of(usual, 50.0).is_empty(), "{usual}");
        }
    }

    #[test]
    fn a_tire_in_metres_is_told() {
        let found = of(0.2, 0.05);
        assert!(
            found.len() == 1 && found[0].ends_with("In mm that is 50."),
            "{found:?}"
        );
    }
}
