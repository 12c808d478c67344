//! Parts of a field by the two mirror planes of a flat ground: those that are even or odd in the ground's shift.
//!
//! Mirrored fore and aft, a shift (x, y) becomes (-x, y), a wheel angle u becomes -u, and a direction at angle a becomes -a; mirrored left and right, it becomes
//! (x, -y), the section angle phi becomes -phi, and a becomes -a. So a field f of the shift (x, y) holds those of all four signs, and its part that is odd in x
//! alone is (f(u, phi, a) - f(-u, phi, -a) + f(u, -phi, -a) - f(-u, -phi, a)) / 4.

use fem_client::solver::direction::PerDirection;
use fem_client::solver::{Readout, Ring, RingLine};

use crate::layout::solving::layout_scenes::readout;
use layouts::arrangement::FilmKind;

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

/// Images of a field before and behind, left and right, and both: whether it is mirrored so.
const IMAGES: [[bool; 2]; 4] = [[false, false], [true, false], [false, true], [true, true]];

/// The part of all strains on a line that is odd, or even, in the shift along the wheel and in the one across, divided by `over`; of a field read on this line and
/// its image.
pub(crate) fn part(
    line: &RingLine,
    odd: [bool; 2],
    over: f64,
    read: &[RingLine],
    rings: &[Ring],
) -> Option<Ring> {
    let [aft, left] = odd.map(|odd| if odd { -1.0 } else { 1.0 });
    let signs = [1.0, aft, left, aft * left];
    ring(line, read, rings, |angle_deg| {
        let [own, aft, left, both] =
            IMAGES.map(|mirrors| image_along(line, angle_deg, mirrors, read, rings));
        let images = [own?, aft?, left?, both?];
        let at = |i: usize| {
            let values = images.iter().zip(signs);
            let sum: f64 = values.map(|(image, sign)| sign * image[i]).sum();
            sum / (4.0 * over)
        };
        Some((0..images[0].len()).map(at).collect())
    })
}

/// The lines of [`readout`] from those of [`mirrored`], of the field's image before and behind, and left and right.
pub(crate) fn image(kinds: &[FilmKind], mirrors: [bool; 2], rings: &[Ring]) -> Option<Vec<Ring>> {
    let read = mirrored(kinds).rings;
    let own = |line: &RingLine| {
        ring(line, &read, rings, |angle_deg| {
            image_along(line, angle_deg, mirrors, &read, rings)
        })
    };
    readout(kinds).rings.iter().map(own).collect()
}

/// A line with the strains in all its directions.
fn ring(
    line: &RingLine,
    read: &[RingLine],
    rings: &[Ring],
    along: impl Fn(f64) -> Option<Vec<f64>>,
) -> Option<Ring> {
    let (_, own) = on_line(line.section_deg, read, rings)?;
    let turned = line.turned_deg.iter();
    Some(Ring {
        section_deg: line.section_deg,
        theta_deg: own.theta_deg.clone(),
        strain: PerDirection {
            x: along(0.0)?,
            y: along(90.0)?,
        },
        turned: turned.map(|angle| along(*angle)).collect::<Option<_>>()?,
    })
}

/// Strains on a line along a direction at this angle, of the field's image before and behind, and left and right.
fn image_along(
    line: &RingLine,
    angle_deg: f64,
    [aft, left]: [bool; 2],
    read: &[RingLine],
    rings: &[Ring],
) -> Option<Vec<f64>> {
    // Either image of a direction at angle a is at -a: twice mirrored it is itself.
    let turn = if aft == left { 1.0 } else { -1.0 };
    let section_deg = match left {
        true => 0.0 - line.section_deg,
        false => line.section_deg,
    };
    let field = strains(on_line(section_deg, read, rings)?, turn * angle_deg)?;
    Some(match aft {
        true => {
            let opposite = |i: usize| field[(field.len() - i) % field.len()];
            (0..field.len()).map(opposite).collect()
        }
        false => field.to_vec(),
    })
}

/// Line at a section angle, and strains there.
fn on_line<'r>(
    section_deg: f64,
    read: &'r [RingLine],
    rings: &'r [Ring],
) -> Option<(&'r RingLine, &'r Ring)> {
    let at = read
        .iter()
        .position(|line| line.section_deg == section_deg)?;
    Some((&read[at], rings.get(at)?))
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
    use crate::layout::solving::layout_fields::samples;

    /// Odd in the shift along, and in the one across.
    const SLOPES: [[bool; 2]; 2] = [[true, false], [false, true]];
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
        shifted(u, phi, angle, [1.0, 1.0])
    }

    /// The field with the ground shifted by [`SHIFT`] these ways.
    fn shifted(u: f64, phi: f64, angle: f64, [x, y]: [f64; 2]) -> f64 {
        let [along, across] = slopes_of(u, phi, angle);
        let (sin_u, cos_u) = u.to_radians().sin_cos();
        let (sin_phi, cos_phi) = phi.to_radians().sin_cos();
        let turned = angle.to_radians().sin() * angle.to_radians().cos();
        let still = cos_u * cos_phi + 3.0 * sin_u * sin_phi * turned;
        let mixed = sin_u * sin_phi + cos_u * cos_phi * turned;
        let squares = 2.0 * still;
        still + SHIFT * (x * along + y * across) + SHIFT * SHIFT * (7.0 * x * y * mixed + squares)
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
        for (axis, odd) in SLOPES.into_iter().enumerate() {
            let found: Vec<Ring> = lines
                .iter()
                .map(|line| part(line, odd, SHIFT, &read, &rings).expect("all lines"))
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
    fn images_are_the_fields_of_opposite_shifts() {
        let kinds = [(0.0, 0.0), (30.0, 90.0), (-30.0, 40.0), (0.0, 45.0)]
            .map(|(phi_deg, angle_deg)| FilmKind::point(phi_deg, angle_deg));
        let read = mirrored(&kinds).rings;
        let rings: Vec<Ring> = read.iter().map(ring).collect();
        for mirrors in [[false, false], [true, false], [false, true], [true, true]] {
            let found = image(&kinds, mirrors, &rings).expect("all lines");
            let signs = mirrors.map(|is_mirrored| if is_mirrored { -1.0 } else { 1.0 });
            for kind in &kinds {
                let samples = samples(&found, kind, &kinds).expect("a line");
                for (u, sample) in (-180..180).zip(samples) {
                    let expected = shifted(f64::from(u), kind.phi_deg, kind.angle_deg, signs);
                    assert!(
                        (sample - expected).abs() < 1e-12,
                        "{mirrors:?} {kind:?} {u}"
                    );
                }
            }
        }
    }

    #[test]
    fn a_line_that_was_not_read_has_no_part() {
        let line = RingLine::at(30.0);
        let rings = [ring(&line)];
        assert_eq!(
            part(&line, SLOPES[0], SHIFT, std::slice::from_ref(&line), &rings),
            None
        );
    }
}
