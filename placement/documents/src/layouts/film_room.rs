//! Room between films on the inner surface, unrolled: what can't be glued beside what.
//!
//! The inner surface is laid flat where two films meet, with the wheel's radius halfway between them. Films of one unit lie on each other, crosswise, and share their middle: those are no
//! neighbours.

use fem_client::scene::Geometry;

use crate::layouts::film_extent::{FilmExtent, inner_radii_mm, wheel_radius_mm};
use crate::parts::film_place::FilmPlace;

/// Films that are nearer touch, mm: rounding of angles and radii.
const TOUCHING_MM: f64 = 1e-9;

/// Distances of a film's middle on the inner surface, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FilmMarks {
    /// Arc around the wheel from the mark at 0 degrees.
    pub arc_mm: f64,
    /// Arc once around the wheel.
    pub circle_mm: f64,
    /// Arc along the section from the nearer bead.
    pub from_bead_mm: f64,
    /// Arc along the section from the crown, negative on the other side.
    pub from_crown_mm: f64,
}

/// Place where a film's leads leave it, mm: at one end of its length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FilmConnector {
    /// Arc around the wheel from the mark, along the film's own circle.
    pub arc_mm: f64,
    /// Arc along the section from the nearer bead.
    pub from_bead_mm: f64,
    /// Length of a lead straight to that bead, and along it to the mark on the shorter way.
    pub lead_mm: f64,
}

/// Room that films need.
#[derive(Debug, Clone, PartialEq)]
pub struct FilmRoom {
    geometry: Geometry,
    /// Length and width of all films, mm; none: points.
    size_mm: Option<[f64; 2]>,
    /// Least distance between two middles, mm.
    least_distance_mm: f64,
}

impl FilmRoom {
    /// Room on a tire for films of this length and width, mm, whose middles are so far apart, mm.
    pub fn on(geometry: &Geometry, size_mm: Option<[f64; 2]>, least_distance_mm: f64) -> Self {
        Self {
            geometry: geometry.clone(),
            size_mm,
            least_distance_mm,
        }
    }

    /// Whether both can be glued on.
    pub fn has_both(&self, one: &FilmPlace, other: &FilmPlace) -> bool {
        let apart = self.between_mm(one, other);
        let distance = apart[0].hypot(apart[1]);
        if self.is_of_points() {
            return true;
        }
        if distance < TOUCHING_MM {
            let turned = (one.angle_deg - other.angle_deg).rem_euclid(180.0);
            return self.least_distance_mm == 0.0 && turned != 0.0;
        }
        let is_far = distance >= self.least_distance_mm - TOUCHING_MM;
        is_far
            && self
                .size_mm
                .is_none_or(|size| is_clear(size, apart, [one.angle_deg, other.angle_deg]))
    }

    /// Films that need no room: points that may lie anywhere.
    fn is_of_points(&self) -> bool {
        self.size_mm.is_none() && self.least_distance_mm == 0.0
    }

    /// Room in words: `films of 10 x 5 mm, 20 mm from middle to middle,`.
    pub(crate) fn needs(&self) -> String {
        let least = self.least_distance_mm;
        match self.size_mm {
            Some([length, width]) if least == 0.0 => format!("films of {length} x {width} mm"),
            Some([length, width]) => {
                format!("films of {length} x {width} mm, {least} mm from middle to middle,")
            }
            None => format!("films {least} mm from middle to middle"),
        }
    }

    /// Two films that can't both be glued on; `None` where all can.
    pub fn crowded(&self, films: &[FilmPlace]) -> Option<(FilmPlace, FilmPlace)> {
        let mut pairs = films.iter().enumerate().flat_map(|(k, one)| {
            let later = films.iter().skip(k + 1);
            later.map(move |other| (one, other))
        });
        let found = pairs.find(|(one, other)| !self.has_both(one, other));
        found.map(|(one, other)| (*one, *other))
    }

    /// Whether a film keeps out of sectors of the wheel, each from one angle to another in the rolling direction, degrees.
    pub fn keeps_out(&self, film: &FilmPlace, sectors_deg: &[[f64; 2]]) -> bool {
        let extent = |size| FilmExtent::on(&self.geometry, size, film.phi_deg, film.angle_deg);
        let reach_deg = self.size_mm.map_or(0.0, |size| extent(size).reach_deg()[0]);
        sectors_deg.iter().all(|[from, to]| {
            let half = 0.5 * (to - from).rem_euclid(360.0);
            wrapped_deg(film.theta_deg - from - half).abs() > half + reach_deg + TOUCHING_MM
        })
    }

    /// Distances of a film's middle on the inner surface.
    pub fn marks(&self, film: &FilmPlace) -> FilmMarks {
        let radii = inner_radii_mm(&self.geometry);
        let wheel = wheel_radius_mm(radii, film.phi_deg.to_radians());
        let off_bead = self.geometry.bead_angle_deg - film.phi_deg.abs();
        FilmMarks {
            arc_mm: wheel * film.theta_deg.to_radians(),
            circle_mm: wheel * std::f64::consts::TAU,
            from_bead_mm: radii[1] * off_bead.to_radians(),
            from_crown_mm: radii[1] * film.phi_deg.to_radians(),
        }
    }

    /// Place where a film's leads leave it: at the end nearer to a bead; of a film along the wheel at the end ahead. Of a point in its middle.
    pub fn connector(&self, film: &FilmPlace) -> FilmConnector {
        let marks = self.marks(film);
        let radii = inner_radii_mm(&self.geometry);
        let (sin, cos) = film.angle_deg.rem_euclid(180.0).to_radians().sin_cos();
        let is_below = film.phi_deg < 0.0 && sin > TOUCHING_MM;
        let end = if is_below { -1.0 } else { 1.0 };
        let reach_mm = end * self.size_mm.map_or(0.0, |[length, _]| 0.5 * length);
        let from_crown_mm = marks.from_crown_mm + reach_mm * sin;
        let bead = self.geometry.bead_angle_deg.to_radians();
        let arc_mm = marks.arc_mm + reach_mm * cos;
        let turned_deg = 360.0 * arc_mm / marks.circle_mm;
        let along_mm = wheel_radius_mm(radii, bead) * wrapped_deg(turned_deg).to_radians().abs();
        let from_bead_mm = radii[1] * bead - from_crown_mm.abs();
        FilmConnector {
            arc_mm,
            from_bead_mm,
            lead_mm: from_bead_mm + along_mm,
        }
    }

    /// Distances from one film's middle to another's around the wheel and along the section, mm.
    pub(crate) fn between_mm(&self, one: &FilmPlace, other: &FilmPlace) -> [f64; 2] {
        let radii = inner_radii_mm(&self.geometry);
        let halfway = 0.5 * (one.phi_deg + other.phi_deg);
        let wheel = wheel_radius_mm(radii, halfway.to_radians());
        [
            wheel * wrapped_deg(other.theta_deg - one.theta_deg).to_radians(),
            radii[1] * (other.phi_deg - one.phi_deg).to_radians(),
        ]
    }
}

/// An angle from -180 to 180 degrees.
fn wrapped_deg(angle_deg: f64) -> f64 {
    (angle_deg + 180.0).rem_euclid(360.0) - 180.0
}

/// Whether an axis along a side of either of two rectangles separates them: lengths and widths are alike, the middles so far apart, the lengths turned by these angles, degrees.
fn is_clear(size_mm: [f64; 2], apart: [f64; 2], angles_deg: [f64; 2]) -> bool {
    let sides = angles_deg.map(|angle| {
        let (sin, cos) = angle.to_radians().sin_cos();
        [[cos, sin], [-sin, cos]]
    });
    let dot = |a: [f64; 2], b: [f64; 2]| a[0] * b[0] + a[1] * b[1];
    let reach = |[along, across]: [[f64; 2]; 2], axis| {
        0.5 * (size_mm[0] * dot(along, axis).abs() + size_mm[1] * dot(across, axis).abs())
    };
    let separates = |axis: &[f64; 2]| {
        let needed = reach(sides[0], *axis) + reach(sides[1], *axis);
        dot(apart, *axis).abs() >= needed - TOUCHING_MM
    };
    sides.concat().iter().any(separates)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(theta_deg: f64, phi_deg: f64, angle_deg: f64) -> FilmPlace {
        FilmPlace {
            theta_deg,
            phi_deg,
            angle_deg,
        }
    }

    fn room(size_mm: Option<[f64; 2]>, least_distance_mm: f64) -> FilmRoom {
        FilmRoom::on(&Geometry::default(), size_mm, least_distance_mm)
    }

    /// The inner surface's radius at the crown is 47 mm: 25 mm are 30.48 degrees of it.
    #[test]
    fn films_end_to_end_need_their_length() {
        let room = room(Some([25.0, 10.0]), 0.0);
        let degrees = (25.0f64 / 47.0).to_degrees();
        for (apart, angle, has) in [
            (1.001 * degrees, 0.0, true),
            (0.999 * degrees, 0.0, false),
            (0.401 * degrees, 90.0, true),
            (0.399 * degrees, 90.0, false),
        ] {
            for theta in [0.0, 170.0, -300.0] {
                let [one, other] = [at(theta, 0.0, angle), at(theta + apart, 0.0, angle)];
                assert_eq!(room.has_both(&one, &other), has, "{apart} {angle}");
                assert_eq!(room.has_both(&other, &one), has, "{apart} {angle}");
            }
        }
    }

    /// The bead is 120 degrees from the crown, 32.75 mm from the axle.
    #[test]
    fn a_connector_is_at_the_end_nearer_to_a_bead_or_ahead() {
        let room = room(Some([10.0, 5.0]), 0.0);
        let bead = 9.5 * 120f64.to_radians();
        let at_bead_mm = |arc_mm: f64, wheel_mm: f64| 32.75 * arc_mm / wheel_mm;
        let half = 5.0 * 45f64.to_radians().sin();
        let shoulder = 9.5 * 45f64.to_radians();
        let quarter = 90f64.to_radians() * 47.0;
        for (film, arc_mm, from_bead_mm) in [
            (at(90.0, 0.0, 90.0), quarter, bead - 5.0),
            (at(90.0, 0.0, 0.0), quarter + 5.0, bead),
            (at(90.0, 0.0, 45.0), quarter + half, bead - half),
            (at(90.0, 0.0, -45.0), quarter - half, bead - half),
        ] {
            let found = room.connector(&film);
            assert!((found.arc_mm - arc_mm).abs() < 1e-9, "{film:?}: {found:?}");
            assert!(
                (found.from_bead_mm - from_bead_mm).abs() < 1e-9,
                "{film:?}: {found:?}"
            );
            let lead = from_bead_mm + at_bead_mm(arc_mm, 47.0);
            assert!((found.lead_mm - lead).abs() < 1e-9, "{film:?}: {found:?}");
        }
        for phi in [45.0, -45.0] {
            let found = room.connector(&at(350.0, phi, 90.0));
            assert!((found.from_bead_mm - (bead - shoulder - 5.0)).abs() < 1e-9);
            // Ten degrees back to the mark is the shorter way.
            let lead = found.from_bead_mm + 32.75 * 10f64.to_radians();
            assert!((found.lead_mm - lead).abs() < 1e-9, "{found:?}");
        }
    }

    #[test]
    fn corners_that_pass_each_other_are_clear() {
        // Squares of 10 mm turned by 45 degrees reach 7.07 mm to each side: side by side along a diagonal they are 10 mm apart, in a row 14.14 mm.
        let room = room(Some([10.0, 10.0]), 0.0);
        let at_mm = |x: f64, y: f64| at((x / 47.0).to_degrees(), (y / 9.5).to_degrees(), 45.0);
        assert!(!room.has_both(&at_mm(0.0, 0.0), &at_mm(14.1, 0.0)));
        assert!(room.has_both(&at_mm(0.0, 0.0), &at_mm(14.2, 0.0)));
        // Off the crown the wheel is narrower: a little more is asked for.
        assert!(room.has_both(&at_mm(0.0, -3.6), &at_mm(7.2, 3.6)));
        assert!(!room.has_both(&at_mm(0.0, -3.4), &at_mm(6.8, 3.4)));
    }

    #[test]
    fn a_unit_lies_crosswise_and_a_film_on_itself_does_not() {
        let sized = room(Some([25.0, 10.0]), 0.0);
        assert!(sized.has_both(&at(30.0, 0.0, 0.0), &at(30.0, 0.0, 90.0)));
        assert!(!sized.has_both(&at(30.0, 0.0, 0.0), &at(30.0, 0.0, 180.0)));
        let distant = room(None, 20.0);
        assert!(!distant.has_both(&at(30.0, 0.0, 0.0), &at(30.0, 0.0, 90.0)));
        // 24 and 25 degrees of 47 mm are 19.7 and 20.5 mm.
        assert!(!distant.has_both(&at(0.0, 0.0, 0.0), &at(24.0, 0.0, 90.0)));
        assert!(distant.has_both(&at(0.0, 0.0, 0.0), &at(25.0, 0.0, 90.0)));
    }

    #[test]
    fn a_film_keeps_out_of_sectors_with_all_of_its_area() {
        let (points, sized) = (room(None, 0.0), room(Some([25.0, 10.0]), 0.0));
        let valve = [[165.0, 195.0], [350.0, 10.0]];
        for (theta, of_point, of_film) in [
            (165.0, false, false),
            (164.0, true, false),
            (149.0, true, true),
            (-5.0, false, false),
            (10.5, true, false),
            (30.0, true, true),
            (-165.5, false, false),
        ] {
            let film = at(theta, 0.0, 0.0);
            assert_eq!(points.keeps_out(&film, &valve), of_point, "{theta}");
            assert_eq!(sized.keeps_out(&film, &valve), of_film, "{theta}");
        }
    }
}
