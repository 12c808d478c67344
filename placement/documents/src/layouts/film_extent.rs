//! A film's rectangle on the inner surface, and the points that stand for it.
//!
//! As in a scene, the rectangle is laid in lengths along the circumference and along the section, with the wheel's radius where its middle lies. Its signal is the
//! mean over the area that it covers of the undeformed tire.

use fem_client::scene::{Film, Geometry};
use gsa::law::distribution::Distribution;

/// Points along a side that covers no angle at all.
const FEWEST_POINTS: f64 = 3.0;
/// A further point for so many degrees of a side, along the section. Of a film of 25 x 10 mm on the foot tire the mean is then within 0.7 % of that by many points
/// (`tests/slow/film_points.rs`); 7 x 5 points leave 57 %, as the wall is bent one way below the film's middle and the other way below its ends.
const DEGREES_A_POINT: f64 = 5.0;
/// A further point for so many degrees of a side that runs around the wheel: strains there are a peak of some ten degrees, and points cost nothing.
const DEGREES_A_POINT_AROUND: f64 = 3.0;
/// Section angles nearer than this are one, degrees.
const SAME_DEG: f64 = 1e-9;
/// Most points along a side.
const MOST_POINTS: f64 = 64.0;

/// Extent of a film on the inner surface of a tire.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FilmExtent {
    /// Length along its direction, mm.
    pub length_mm: f64,
    /// Width across, mm.
    pub width_mm: f64,
    /// Section angle of its middle, rad.
    phi: f64,
    /// Angle of its length to the circumferential direction, degrees.
    angle_deg: f64,
    /// Radii of the inner surface: from the axle to the middle of the section, and of the section, mm.
    radii_mm: [f64; 2],
}

/// A point that stands for a part of a film.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FilmPoint {
    /// Share of the film's area.
    pub share: f64,
    /// Wheel angle from the film's middle, degrees.
    pub wheel_deg: f64,
    /// Section angle from the crown, degrees.
    pub section_deg: f64,
}

impl FilmExtent {
    /// Places a film of this length and width, mm, at a section angle, its length at an angle to the circumference, degrees.
    pub fn on(
        geometry: &Geometry,
        [length_mm, width_mm]: [f64; 2],
        phi_deg: f64,
        angle_deg: f64,
    ) -> Self {
        Self {
            length_mm,
            width_mm,
            phi: phi_deg.to_radians(),
            angle_deg,
            radii_mm: inner_radii_mm(geometry),
        }
    }

    /// Length and width, mm.
    pub fn size_mm(&self) -> [f64; 2] {
        [self.length_mm, self.width_mm]
    }

    /// Half of the angles that it covers around the wheel and along the section, degrees.
    pub(crate) fn reach_deg(&self) -> [f64; 2] {
        let film = Film {
            length_mm: self.length_mm,
            width_mm: self.width_mm,
            angle_deg: self.angle_deg,
            ..Film::default()
        };
        let [around, across] = film.half_extent_mm();
        let [of_wheel, of_section] = self.angle_of_mm();
        [around * of_wheel, across * of_section]
    }

    /// The section angle, degrees from the crown, to which it reaches.
    pub fn farthest_deg(&self) -> f64 {
        self.phi.to_degrees().abs() + self.reach_deg()[1]
    }

    /// Whether it reaches no farther than a section angle, degrees, and not around the whole wheel.
    pub fn fits(&self, farthest_deg: f64) -> bool {
        self.farthest_deg() <= farthest_deg && self.reach_deg()[0] < 180.0
    }

    /// Points whose mean is the mean over its area: Gauss points along both sides, as many as the angles ask for that they cover.
    pub fn points(&self) -> Vec<FilmPoint> {
        let [of_wheel, of_section] = self.angle_of_mm();
        let (sin, cos) = self.angle_deg.to_radians().sin_cos();
        let points = |side_mm: f64, along_wheel: f64, along_section: f64| {
            let around = side_mm * along_wheel.abs() * of_wheel / DEGREES_A_POINT_AROUND;
            let section = side_mm * along_section.abs() * of_section / DEGREES_A_POINT;
            (FEWEST_POINTS + around.max(section).ceil()).min(MOST_POINTS) as usize
        };
        self.points_by([
            points(self.length_mm, cos, sin),
            points(self.width_mm, sin, cos),
        ])
    }

    /// Returns so many Gauss points along its length and its width.
    pub fn points_by(&self, counts: [usize; 2]) -> Vec<FilmPoint> {
        let [of_wheel, of_section] = self.angle_of_mm();
        let (sin, cos) = self.angle_deg.to_radians().sin_cos();
        let [along, across] = counts.map(gauss);
        let mut points = Vec::with_capacity(along.len() * across.len());
        for &(s, of_length) in &along {
            for &(t, of_width) in &across {
                let [s, t] = [s * self.length_mm, t * self.width_mm];
                let section_deg = self.phi.to_degrees() + (s * sin + t * cos) * of_section;
                // Points on a common line differ by rounding.
                let section_deg = (section_deg / SAME_DEG).round() * SAME_DEG + 0.0;
                points.push(FilmPoint {
                    share: of_length * of_width * self.wheel_radius_mm(section_deg.to_radians()),
                    wheel_deg: (s * cos - t * sin) * of_wheel,
                    section_deg,
                });
            }
        }
        let area: f64 = points.iter().map(|point| point.share).sum();
        points.iter_mut().for_each(|point| point.share /= area);
        points
    }

    /// Degrees around the wheel and along the section that a millimetre is at its middle.
    fn angle_of_mm(&self) -> [f64; 2] {
        [self.wheel_radius_mm(self.phi), self.radii_mm[1]].map(|radius| (1.0 / radius).to_degrees())
    }

    /// Returns the radius of the inner surface at a section angle, rad.
    fn wheel_radius_mm(&self, phi: f64) -> f64 {
        wheel_radius_mm(self.radii_mm, phi)
    }
}

/// Radii of the inner surface, mm: from the axle to the middle of the section, and of the section.
pub(crate) fn inner_radii_mm(geometry: &Geometry) -> [f64; 2] {
    [
        geometry.outer_radius_mm - geometry.section_radius_mm,
        geometry.section_radius_mm - geometry.wall_mm,
    ]
}

/// Distance of the inner surface from the axle at a section angle, rad, by its radii; mm.
pub(crate) fn wheel_radius_mm([middle, section]: [f64; 2], phi: f64) -> f64 {
    middle + section * phi.cos()
}

/// Gauss points of the interval from -1/2 to 1/2 with their weights; its middle where there are no others.
fn gauss(count: usize) -> Vec<(f64, f64)> {
    let rule = Distribution::uniform(-0.5, 0.5)
        .ok()
        .and_then(|even| even.gauss_rule(count).ok());
    rule.map_or_else(
        || vec![(0.0, 1.0)],
        |rule| rule.nodes.into_iter().zip(rule.weights).collect(),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The mean of a function of wheel and section angle, degrees.
    fn mean(extent: &FilmExtent, of: impl Fn(f64, f64) -> f64) -> f64 {
        let points = extent.points().into_iter();
        points
            .map(|point| point.share * of(point.wheel_deg, point.section_deg))
            .sum()
    }

    fn on(size_mm: [f64; 2], phi_deg: f64, angle_deg: f64) -> FilmExtent {
        FilmExtent::on(&Geometry::default(), size_mm, phi_deg, angle_deg)
    }

    #[test]
    fn a_wave_around_the_wheel_is_averaged_to_its_sinc() {
        // The inner surface's radius is 37.5 + 9.5 mm at the crown, and 37.5 mm at the sidewall.
        for (phi, radius) in [(0.0, 47.0), (90.0, 37.5)] {
            for waves in [3.0, 12.0, 30.0] {
                let found = mean(&on([25.0, 10.0], phi, 0.0), |wheel, _| {
                    (waves * (wheel + 7.0).to_radians()).cos()
                });
                let half: f64 = 0.5 * waves * 25.0 / radius;
                let expected = half.sin() / half * (waves * 7f64.to_radians()).cos();
                // Eleven Gauss points and more of half a dozen radians: their rest is below 1e-10.
                assert!((found - expected).abs() < 1e-10, "{waves}: {found}");
            }
        }
        // Across the film it is averaged over the width.
        let across = mean(&on([25.0, 10.0], 0.0, 90.0), |wheel, _| {
            (30.0 * wheel.to_radians()).cos()
        });
        let half: f64 = 0.5 * 30.0 * 10.0 / 47.0;
        // Eight points of 3.2 rad: h^16 (8!)^4 2^16 / (17 (16!)^3) = 1.3e-10.
        assert!((across - half.sin() / half).abs() < 2e-10);
    }

    #[test]
    fn a_linear_field_has_its_middle_s_value_as_its_mean() {
        for angle in [0.0, 30.0, 90.0, 180.0] {
            let mean = mean(&on([25.0, 10.0], 0.0, angle), |wheel, section| {
                2.0 + 0.3 * wheel - 0.1 * section
            });
            assert!((mean - 2.0).abs() < 1e-9, "{angle}: {mean}");
        }
        // Off the crown there is more area on the crown's side: the mean of phi over (a + b cos phi) dphi.
        let (a, b, half) = (37.5, 9.5, 5.0 / 9.5);
        let (low, high) = (45f64.to_radians() - half, 45f64.to_radians() + half);
        let area = a * (high - low) + b * (high.sin() - low.sin());
        let moment = |x: f64| 0.5 * a * x * x + b * (x * x.sin() + x.cos());
        let expected = (moment(high) - moment(low)) / area;
        let found = mean(&on([10.0, 5.0], 45.0, 90.0), |_, section| {
            section.to_radians()
        });
        assert!((found - expected).abs() < 1e-9, "{found} {expected}");
        assert!((expected.to_degrees() - 45.0).abs() < 1.0);
    }

    #[test]
    fn a_tiny_film_is_its_middle() {
        for angle in [0.0, 45.0, 90.0] {
            let tiny = on([1e-6, 1e-6], 30.0, angle);
            for point in tiny.points() {
                // 1e-6 mm on 9.5 mm.
                assert!((point.section_deg - 30.0).abs() < 1e-5 && point.wheel_deg.abs() < 1e-5);
            }
            let shares: f64 = tiny.points().iter().map(|point| point.share).sum();
            assert!((shares - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn a_film_covers_the_angles_that_its_sides_are() {
        let [around, across] = on([25.0, 10.0], 0.0, 90.0).reach_deg();
        assert!((around - (5.0f64 / 47.0).to_degrees()).abs() < 1e-12);
        assert!((across - (12.5f64 / 9.5).to_degrees()).abs() < 1e-12);
        let film = on([25.0, 10.0], -30.0, 90.0);
        assert!((film.farthest_deg() - 30.0 - across).abs() < 1e-12);
        assert!(!film.fits(100.0) && film.fits(106.0));
        // The inner circumference at the crown is 295 mm.
        assert!(on([295.0, 1.0], 0.0, 0.0).fits(100.0) && !on([296.0, 1.0], 0.0, 0.0).fits(100.0));
        for point in film.points() {
            assert!(
                point.wheel_deg.abs() < around && (point.section_deg + 30.0).abs() < across,
                "{point:?}"
            );
        }
    }

    #[test]
    fn films_along_a_line_share_their_section_angles() {
        let lines = |extent: &FilmExtent| {
            let mut angles: Vec<f64> = extent.points().iter().map(|p| p.section_deg).collect();
            angles.sort_by(f64::total_cmp);
            angles.dedup();
            angles.len()
        };
        // 60.3 and 150.8 degrees along the section: three points, and one more for each five degrees begun.
        for (angle, expected) in [(0.0, 16), (90.0, 34), (180.0, 16), (-90.0, 34)] {
            assert_eq!(lines(&on([25.0, 10.0], 0.0, angle)), expected);
        }
    }
}
