//! What a small shift of the ground changes in every film's signal, along the wheel and across it, of one solve a load.
//!
//! Flat ground under the wheel's bottom has two mirror planes. Mirrored fore and aft, a shift (x, y) becomes (-x, y), a wheel angle u becomes -u, and a direction
//! at angle a becomes -a; mirrored left and right, it becomes (x, -y), the section angle phi becomes -phi, and a becomes -a. So a field f of a shift (s, s) holds
//! those of all four signs, and the slope over x is
//! (f(u, phi, a) - f(-u, phi, -a) + f(u, -phi, -a) - f(-u, -phi, a)) / 4 s, that over y with the signs + + - -. What is left out is of third order in s.

use fem_client::solver::direction::PerDirection;
use fem_client::solver::{Readout, Response, Ring, RingLine};

use crate::layout::arrangement::FilmKind;
use crate::layout::field::film_field::ShearField;
use crate::layout::solving::layout_fields::{MeshFields, samples};
use crate::layout::solving::layout_scenes::{LayoutScenes, readout};
use crate::run::archive::Outcome;

/// Signs of the field and its images fore and aft, left and right, and both: for the slope over the shift along the wheel, and across it.
const SIGNS: [[f64; 4]; 2] = [[1.0, -1.0, 1.0, -1.0], [1.0, 1.0, -1.0, -1.0]];

/// Adds slopes over the ground's shift to what a mesh answers.
pub(crate) fn add_shear(
    fields: &mut MeshFields,
    scenes: &LayoutScenes,
    kinds: &[FilmKind],
    dragged: Result<Vec<Outcome>, String>,
) {
    match dragged {
        Ok(outcomes) => {
            (fields.fields.sheared, fields.without_shear) = shear_fields(scenes, kinds, &outcomes);
        }
        Err(reason) => fields
            .without_shear
            .push(format!("The ground couldn't be dragged: {reason}")),
    }
}

/// Slopes at each load where the ground could be dragged, and why there are none elsewhere.
fn shear_fields(
    scenes: &LayoutScenes,
    kinds: &[FilmKind],
    outcomes: &[Outcome],
) -> (Vec<ShearField>, Vec<String>) {
    let (mut fields, mut reasons) = (Vec::new(), Vec::new());
    for (load, outcome) in scenes.loads.iter().zip(outcomes) {
        let found = match outcome {
            Ok(response) => shear_field(scenes, kinds, response),
            Err(unsolved) => Err(unsolved.to_string()),
        };
        match found {
            Ok(field) => fields.push(field),
            Err(reason) => reasons.push(format!(
                "Ground pressed by {load} couldn't be dragged: {reason}"
            )),
        }
    }
    (fields, reasons)
}

/// Slopes at one load, from the answer to a scene of [`LayoutScenes::sheared`] read by [`mirrored`].
///
/// # Errors
/// What the answer lacks.
pub fn shear_field(
    scenes: &LayoutScenes,
    kinds: &[FilmKind],
    response: &Response,
) -> Result<ShearField, String> {
    let shift = scenes.shift_mm();
    let depth_mm = response.depth_mm.ok_or("the solver gives no depth")?;
    let [x, y, z] = response.force_n.ok_or("the solver gives no force")?;
    let lines = readout(kinds).rings;
    let read = mirrored(kinds).rings;
    let rings = SIGNS.map(|signs| -> Option<Vec<Ring>> {
        let ring = |line: &RingLine| slopes(line, signs, shift, &read, &response.rings);
        lines.iter().map(ring).collect()
    });
    let [Some(along), Some(across)] = rings else {
        return Err("the solver gives no strains around the wheel".to_owned());
    };
    let of_kind = |kind: &FilmKind| {
        Some([
            samples(&along, kind, kinds)?,
            samples(&across, kind, kinds)?,
        ])
    };
    Ok(ShearField {
        depth_mm,
        force_slopes: [x / shift, y / shift],
        slopes: kinds
            .iter()
            .map(of_kind)
            .collect::<Option<_>>()
            .ok_or("the solver gives no strains around the wheel")?,
        sliding_n: scenes.friction() * z,
    })
}

/// Lines on which films of these kinds are read, with their images left and right.
pub fn mirrored(kinds: &[FilmKind]) -> Readout {
    let own = readout(kinds);
    let mut rings: Vec<RingLine> = Vec::new();
    for (line, side) in own
        .rings
        .iter()
        .flat_map(|line| [(line, 1.0), (line, -1.0)])
    {
        // Without a negative zero.
        let section_deg = side * line.section_deg + 0.0;
        let known = rings
            .iter()
            .position(|ring| ring.section_deg == section_deg);
        let ring = known.unwrap_or_else(|| {
            rings.push(RingLine::at(section_deg));
            rings.len() - 1
        });
        let turned = &mut rings[ring].turned_deg;
        for angle in line.turned_deg.iter().flat_map(|angle| [*angle, -angle]) {
            if !turned.contains(&angle) {
                turned.push(angle);
            }
        }
    }
    Readout { rings, ..own }
}

/// Slopes of all strains on a line, of a field read on this line and its image.
fn slopes(
    line: &RingLine,
    signs: [f64; 4],
    shift_mm: f64,
    read: &[RingLine],
    rings: &[Ring],
) -> Option<Ring> {
    let side = |section_deg: f64| {
        let at = read
            .iter()
            .position(|line| line.section_deg == section_deg)?;
        Some((&read[at], rings.get(at)?))
    };
    let (own, image) = (side(line.section_deg)?, side(0.0 - line.section_deg)?);
    let slope = |[field, aft, left, both]: [&[f64]; 4]| -> Vec<f64> {
        let opposite = |i: usize| (field.len() - i) % field.len();
        (0..field.len())
            .map(|i| {
                let values = [field[i], aft[opposite(i)], left[i], both[opposite(i)]];
                let sum: f64 = signs
                    .iter()
                    .zip(values)
                    .map(|(sign, value)| sign * value)
                    .sum();
                sum / (4.0 * shift_mm)
            })
            .collect()
    };
    let along = |angle_deg: f64| {
        Some(slope([
            strains(own, angle_deg)?,
            strains(own, -angle_deg)?,
            strains(image, -angle_deg)?,
            strains(image, angle_deg)?,
        ]))
    };
    Some(Ring {
        section_deg: line.section_deg,
        theta_deg: own.1.theta_deg.clone(),
        strain: PerDirection {
            x: along(0.0)?,
            y: along(90.0)?,
        },
        turned: line
            .turned_deg
            .iter()
            .map(|angle| along(*angle))
            .collect::<Option<_>>()?,
    })
}

/// Strains on a line along a direction at this angle.
fn strains<'r>((line, ring): (&RingLine, &'r Ring), angle_deg: f64) -> Option<&'r [f64]> {
    let is_asked = |turned: &f64| *turned == angle_deg;
    match angle_deg.abs() {
        0.0 => Some(&ring.strain.x),
        90.0 => Some(&ring.strain.y),
        _ => Some(
            ring.turned
                .get(line.turned_deg.iter().position(is_asked)?)?,
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SHIFT: f64 = 0.02;

    /// Slopes over the shift along the wheel and across it, of a field with both mirror planes.
    fn slopes_of(u: f64, phi: f64, angle: f64) -> [f64; 2] {
        let (u, phi, angle) = (u.to_radians(), phi.to_radians(), angle.to_radians());
        let (straight, turned) = (angle.cos().powi(2), angle.sin() * angle.cos());
        [
            u.sin() * phi.cos() * (1.0 + straight) + u.cos() * phi.sin() * turned,
            u.cos() * phi.sin() * (1.0 + straight) + u.sin() * phi.cos() * turned,
        ]
    }

    /// The field with the ground shifted by [`SHIFT`] both ways, to second order.
    fn field(u: f64, phi: f64, angle: f64) -> f64 {
        let [along, across] = slopes_of(u, phi, angle);
        let (sin_u, cos_u) = u.to_radians().sin_cos();
        let (sin_phi, cos_phi) = phi.to_radians().sin_cos();
        let turned = angle.to_radians().sin() * angle.to_radians().cos();
        let still = cos_u * cos_phi + 3.0 * sin_u * sin_phi * turned;
        let mixed = sin_u * sin_phi + cos_u * cos_phi * turned;
        let squares = 2.0 * still;
        still + SHIFT * (along + across) + SHIFT * SHIFT * (7.0 * mixed + squares)
    }

    fn ring(line: &RingLine) -> Ring {
        let around = |angle: f64| -> Vec<f64> {
            (-180..180)
                .map(|u| field(f64::from(u), line.section_deg, angle))
                .collect()
        };
        Ring {
            section_deg: line.section_deg,
            theta_deg: (-180..180).map(f64::from).collect(),
            strain: PerDirection {
                x: around(0.0),
                y: around(90.0),
            },
            turned: line.turned_deg.iter().map(|angle| around(*angle)).collect(),
        }
    }

    #[test]
    fn one_field_dragged_both_ways_gives_both_slopes() {
        let kinds: Vec<FilmKind> = [
            (0.0, 0.0),
            (0.0, 90.0),
            (30.0, 90.0),
            (-30.0, 40.0),
            (15.0, -90.0),
            (0.0, 45.0),
        ]
        .map(|(phi_deg, angle_deg)| FilmKind::point(phi_deg, angle_deg))
        .to_vec();
        let read = mirrored(&kinds).rings;
        let rings: Vec<Ring> = read.iter().map(ring).collect();
        let lines = readout(&kinds).rings;
        for (axis, signs) in SIGNS.into_iter().enumerate() {
            let found: Vec<Ring> = lines
                .iter()
                .map(|line| slopes(line, signs, SHIFT, &read, &rings).expect("all lines"))
                .collect();
            for kind in &kinds {
                let samples = samples(&found, kind, &kinds).expect("a line");
                for (i, sample) in samples.iter().enumerate() {
                    let expected = slopes_of(i as f64 - 180.0, kind.phi_deg, kind.angle_deg)[axis];
                    // Round-off of values near 4 over the shift.
                    assert!((sample - expected).abs() < 1e-12, "{kind:?} {i}");
                }
            }
        }
    }

    #[test]
    fn a_line_that_was_not_read_gives_no_slopes() {
        let line = RingLine::at(30.0);
        let rings = [ring(&line)];
        assert_eq!(
            slopes(&line, SIGNS[0], SHIFT, std::slice::from_ref(&line), &rings),
            None
        );
    }
}
