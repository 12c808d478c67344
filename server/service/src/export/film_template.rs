//! Template to glue by: the answer's films on the unrolled inner surface, an SVG that prints at 1:1.
//!
//! The circle around the wheel is cut into strips that fit on paper, one below the other. A film's x is its arc from the mark along its own circle, its y the arc from the crown.

use std::fmt::Write;

use results::{SheetFilm, StudyResult};

use crate::export::export_choice::ExportError;

/// Width of the drawing, mm: that of A4 between a printer's margins.
const WIDTH_MM: f64 = 190.0;
/// Arc of the wheel on a strip, mm.
const STRIP_MM: f64 = 180.0;
/// Space on the left of strips, mm.
const LEFT_MM: f64 = 5.0;
/// Space for the title and the scale, mm.
const HEAD_MM: f64 = 22.0;
/// Space between strips, mm.
const GAP_MM: f64 = 12.0;
/// Length of the scale, mm.
const SCALE_MM: f64 = 100.0;
/// Half of a point's cross, mm.
const CROSS_MM: f64 = 2.0;
/// Radius of the dot at a connector, mm.
const DOT_MM: f64 = 0.7;
/// Height of a line of numbers, mm.
const LINE_MM: f64 = 3.2;

/// Draws the films of the answer.
///
/// # Errors
/// [`ExportError::NoFilms`] where the answer has none.
pub fn svg(result: &StudyResult) -> Result<String, ExportError> {
    let answer = result
        .answer
        .as_ref()
        .filter(|answer| !answer.films.is_empty());
    let answer = answer.ok_or(ExportError::NoFilms)?;
    let title = format!("{}: {} films", result.study.name, answer.films.len());
    Ok(drawn(&title, &answer.films))
}

fn drawn(title: &str, films: &[SheetFilm]) -> String {
    let longest = |length: fn(&SheetFilm) -> f64| films.iter().map(length).fold(0.0, f64::max);
    let circle = longest(|film| film.circle_mm);
    // From the crown to the bead, and as far on the other side.
    let half = longest(|film| film.from_bead_mm + film.from_crown_mm.abs());
    let strips = (circle / STRIP_MM).ceil().max(1.0) as usize;
    let pitch = 2.0 * half + GAP_MM;
    let height = HEAD_MM + pitch * strips as f64;
    let dots = match films.iter().any(|film| !connector(film).is_empty()) {
        true => " Dots are connectors.",
        false => "",
    };
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{WIDTH_MM}mm\" height=\"{height:.3}mm\" viewBox=\"0 0 {WIDTH_MM} {height:.3}\" \
         font-family=\"sans-serif\" font-size=\"3\" fill=\"none\" stroke=\"black\" stroke-width=\"0.2\">\n\
         <title>{title}</title>\n\
         <g fill=\"black\" stroke=\"none\"><text x=\"{LEFT_MM}\" y=\"6\" font-size=\"4\">{title}</text>\n\
         <text x=\"{LEFT_MM}\" y=\"11\">Inner surface, seen from the axle. Print at 100 %: the bar is {SCALE_MM} mm. Glue strips end to end.{dots}</text></g>\n\
         <path id=\"scale\" d=\"M {LEFT_MM} 14 v 3 M {LEFT_MM} 15.5 h {SCALE_MM} m 0 -1.5 v 3\"/>\n",
        title = escaped(title)
    );
    for strip in 0..strips {
        let from = strip as f64 * STRIP_MM;
        let long = (circle - from).min(STRIP_MM);
        let top = HEAD_MM + pitch * strip as f64;
        draw_strip(&mut svg, (strip, long, half, top));
        for film in films {
            let reach = film
                .length_mm
                .unwrap_or(CROSS_MM)
                .hypot(film.width_mm.unwrap_or(0.0));
            if film.arc_mm > from - reach && film.arc_mm < from + long + reach {
                draw_film(&mut svg, film, from, top + half);
            }
        }
        svg.push_str("</g>\n<g fill=\"black\" stroke=\"none\">\n");
        // A film's number stands on the strip where its middle is, and isn't cut off there.
        let has_middle = |film: &&SheetFilm| (from..from + long).contains(&film.arc_mm);
        for (k, film) in films
            .iter()
            .enumerate()
            .filter(|(_, film)| has_middle(film))
        {
            write_number(&mut svg, film, beside(films, k), from, top + half);
        }
        svg.push_str("</g>\n");
    }
    svg.push_str("</svg>\n");
    svg
}

/// Draws a strip's outline, its crown and its marks, and opens the group of its films, cut off at its ends.
fn draw_strip(svg: &mut String, (strip, long, half, top): (usize, f64, f64, f64)) {
    let whole = 2.0 * half;
    let (right, crown) = (LEFT_MM + long, top + half);
    let note = match strip {
        0 => "mark, 0 degrees; the wheel rolls to the right".to_owned(),
        _ => format!("{} mm from the mark", strip as f64 * STRIP_MM),
    };
    // Writing to a text can't fail.
    let _ = write!(
        svg,
        "<clipPath id=\"strip{strip}\"><rect x=\"{LEFT_MM}\" y=\"{top:.3}\" width=\"{long:.3}\" height=\"{whole:.3}\"/></clipPath>\n\
         <rect x=\"{LEFT_MM}\" y=\"{top:.3}\" width=\"{long:.3}\" height=\"{whole:.3}\"/>\n\
         <path d=\"M {LEFT_MM} {crown:.3} H {right:.3}\" stroke-dasharray=\"3 1\"/>\n\
         <text x=\"{LEFT_MM}\" y=\"{:.3}\" fill=\"black\" stroke=\"none\">{note}; bead above and below, crown dashed</text>\n\
         <g clip-path=\"url(#strip{strip})\">\n",
        top - 1.5
    );
}

/// Draws a film: a rectangle, or a cross where it has no size.
fn draw_film(svg: &mut String, film: &SheetFilm, from: f64, crown: f64) {
    let (x, y) = (LEFT_MM + film.arc_mm - from, crown - film.from_crown_mm);
    // The picture's y points down.
    let turn = match film.direction.as_str() {
        "x" => 0.0,
        "y" => -90.0,
        angle => -angle.parse::<f64>().unwrap_or(0.0),
    };
    let shape = match (film.length_mm, film.width_mm) {
        (Some(length), Some(width)) => format!(
            "<rect x=\"{:.3}\" y=\"{:.3}\" width=\"{length}\" height=\"{width}\"/>",
            -0.5 * length,
            -0.5 * width
        ),
        _ => format!("<path d=\"M -{CROSS_MM} 0 H {CROSS_MM} M 0 -1 V 1\"/>"),
    };
    let _ = writeln!(
        svg,
        "<g transform=\"translate({x:.3} {y:.3})\"><g class=\"film\" transform=\"rotate({turn})\">{shape}</g>{}</g>",
        connector(film)
    );
}

/// Dot where a film's leads leave it, from the film's middle; nothing where that isn't known, or is the middle.
fn connector(film: &SheetFilm) -> String {
    let known = (
        film.length_mm,
        film.connector_arc_mm,
        film.connector_from_bead_mm,
    );
    let (Some(_), Some(arc), Some(from_bead)) = known else {
        return String::new();
    };
    let outwards = film.from_bead_mm - from_bead;
    // The picture's y points down.
    let (x, y) = match film.from_crown_mm < 0.0 {
        true => (arc - film.arc_mm, outwards),
        false => (arc - film.arc_mm, -outwards),
    };
    format!(
        "<circle class=\"connector\" cx=\"{x:.3}\" cy=\"{y:.3}\" r=\"{DOT_MM}\" fill=\"black\"/>"
    )
}

/// Films before this one that lie in its place.
fn beside(films: &[SheetFilm], film: usize) -> usize {
    let own = &films[film];
    let is_here = |other: &&SheetFilm| {
        (other.arc_mm - own.arc_mm).hypot(other.from_crown_mm - own.from_crown_mm) < CROSS_MM
    };
    films[..film].iter().filter(is_here).count()
}

/// Writes a film's number in its middle, or beside its cross; below those of others in its place.
fn write_number(svg: &mut String, film: &SheetFilm, below: usize, from: f64, crown: f64) {
    let y = crown - film.from_crown_mm + 1.0 + LINE_MM * below as f64;
    let (x, anchor) = match film.length_mm {
        Some(_) => (LEFT_MM + film.arc_mm - from, "middle"),
        None => (LEFT_MM + film.arc_mm - from + 1.3 * CROSS_MM, "start"),
    };
    let number = film.number;
    let _ = writeln!(
        svg,
        "<text x=\"{x:.3}\" y=\"{y:.3}\" text-anchor=\"{anchor}\">{number}</text>"
    );
}

/// Text that XML can hold.
fn escaped(text: &str) -> String {
    let plain: String = text.chars().filter(|c| !c.is_control()).collect();
    plain
        .replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn film(number: usize, theta_deg: f64) -> SheetFilm {
        SheetFilm {
            number,
            theta_deg,
            arc_mm: theta_deg.to_radians() * 47.0,
            circle_mm: 360f64.to_radians() * 47.0,
            phi_deg: 0.0,
            from_bead_mm: 9.5 * 120f64.to_radians(),
            from_crown_mm: 0.0,
            direction: "y".to_owned(),
            length_mm: Some(10.0),
            width_mm: Some(5.0),
            connector_arc_mm: Some(theta_deg.to_radians() * 47.0),
            connector_from_bead_mm: Some(9.5 * 120f64.to_radians() - 5.0),
            lead_mm: None,
            expected_strain: None,
            expected_v: None,
            expected_depth_mm: None,
        }
    }

    /// 295.3 mm of the crown are two strips, of 180 and 115.3 mm; a film at the cut is on both, in two halves.
    #[test]
    fn films_lie_at_their_arcs_in_millimetres() {
        let cut_deg = (180.0f64 / 47.0).to_degrees();
        let svg = drawn("a < b", &[film(1, 30.0), film(2, cut_deg), film(3, 300.0)]);
        assert!(svg.contains("width=\"190mm\" height=\"125.587mm\" viewBox=\"0 0 190 125.587\""));
        assert!(svg.contains("<title>a &lt; b</title>") && svg.contains("h 100 m"));
        let count = |text: &str| svg.matches(text).count();
        assert_eq!((count("class=\"film\""), count("<clipPath")), (4, 2));
        let half = 9.5 * 120f64.to_radians();
        let crowns = [22.0 + half, 22.0 + 2.0 * half + 12.0 + half];
        for (x, crown) in [
            (5.0 + 24.609, crowns[0]),
            (185.0, crowns[0]),
            (5.0, crowns[1]),
            (5.0 + 246.091 - 180.0, crowns[1]),
        ] {
            let place = format!("translate({x:.3} {crown:.3})");
            assert!(svg.contains(&place), "{place}: {svg}");
        }
        assert!(svg.contains("width=\"115.310\""));
        // A film along y has its connector where its length ends, turned to the bead above.
        assert_eq!(
            count("<circle class=\"connector\" cx=\"0.000\" cy=\"-5.000\" r=\"0.7\""),
            4
        );
        // Each number once, that of the film at the cut where the second strip begins.
        assert_eq!(count("text-anchor"), 3);
        assert!(svg.contains("<text x=\"5.000\""));
    }

    #[test]
    fn numbers_of_points_in_one_place_stand_below_each_other() {
        let point = |number| SheetFilm {
            length_mm: None,
            width_mm: None,
            ..film(number, 0.0)
        };
        let svg = drawn("two", &[point(1), point(2)]);
        let half = 9.5 * 120f64.to_radians();
        for (number, y) in [(1, 23.0 + half), (2, 26.2 + half)] {
            let written = format!("<text x=\"7.600\" y=\"{y:.3}\" text-anchor=\"start\">{number}<");
            assert!(svg.contains(&written), "{written}: {svg}");
        }
    }
}
