//! Bounds of layouts where the ground was dragged: what they tell of the forces along the wheel and across it.

use crate::arrangement::Arrangement;
use crate::field::film_field::{DepthFields, Noise};
use crate::fisher::bounds::bounds;
use results::ShearScore;

/// Bounds with the ground's shifts unknown, too, where it was dragged.
pub(super) fn shear(
    fields: &DepthFields,
    noise: &Noise,
    depth_mm: f64,
    arrangement: &Arrangement,
) -> Option<ShearScore> {
    let (field, shear) = fields.with_shear(depth_mm)?;
    let bounds = match bounds(&field, arrangement, noise) {
        Ok(bounds) => bounds,
        Err(reason) => {
            return Some(ShearScore {
                reason: Some(reason),
                ..ShearScore::default()
            });
        }
    };
    let of_shift = |axis: usize| {
        let shift = bounds.worst_shift_mm[axis]?;
        Some(shift * shear.force_slopes[axis].abs())
    };
    let of_depth = bounds.worst_depth_mm * field.force_slope.abs();
    let forces = [of_shift(0), of_shift(1), Some(of_depth)];
    Some(ShearScore {
        worst_angle_error_deg: Some(bounds.worst_angle_deg),
        worst_force_error_n: Some(forces),
        error: None,
        reason: untold(&forces, shear.sliding_n),
    })
}

/// Says which force isn't felt, or known no better than that the ground doesn't slide.
fn untold(forces_n: &[Option<f64>; 3], sliding_n: f64) -> Option<String> {
    let which = |is: &dyn Fn(&Option<f64>) -> bool| -> String {
        let forces = ["along", "across"].into_iter().zip(forces_n);
        let names: Vec<&str> = forces
            .filter(|(_, force)| is(force))
            .map(|(name, _)| name)
            .collect();
        names.join(" and ")
    };
    let unfelt = which(&|force| force.is_none());
    let unknown = which(&|force| force.is_some_and(|error| error >= sliding_n));
    let reasons = [
        (!unfelt.is_empty()).then(|| format!("no film feels the force {unfelt}")),
        (!unknown.is_empty()).then(|| {
            format!("the force {unknown} isn't known within the {sliding_n:.1} N at which the ground slides")
        }),
    ];
    let reasons: Vec<String> = reasons.into_iter().flatten().collect();
    (!reasons.is_empty()).then(|| reasons.join("; "))
}
