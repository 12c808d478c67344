//! Layouts in words.

use crate::score::notes::listed;
use results::RankedLayout;

/// `12 units of x and y at the crown, every 30 degrees`; of a layout without units `12 films of x and y at the crown ("mine")`.
pub(super) fn words(layout: &RankedLayout) -> String {
    let films = directions(layout);
    let place = place(layout);
    match (layout.spacing_deg, &layout.name) {
        (Some(spacing), _) => format!(
            "{} units of {films} {place}, {}",
            layout.units,
            every(layout, spacing)
        ),
        (None, Some(name)) => format!("{} films of {films} {place} ({name:?})", layout.units),
        (None, None) => format!("{} films of {films} {place}", layout.units),
    }
}

/// Says what to do: `Glue films of x and y at the crown, 12 units every 30 degrees`.
pub(super) fn instruction(layout: &RankedLayout) -> String {
    match layout.spacing_deg {
        Some(spacing) => format!(
            "Glue films of {} {}, {} units {}",
            directions(layout),
            place(layout),
            layout.units,
            every(layout, spacing)
        ),
        None => format!("Glue {}", words(layout)),
    }
}

/// `every 30 degrees`, and whether the films of a unit are apart.
fn every(layout: &RankedLayout, spacing_deg: f64) -> String {
    let spacing = (spacing_deg * 10.0).round() / 10.0;
    let staggered = if layout.staggered {
        " with their films spread evenly between"
    } else {
        ""
    };
    format!("every {spacing} degrees{staggered}")
}

/// `x and y`, `y`, `x and 45 deg`.
fn directions(layout: &RankedLayout) -> String {
    let named = |film: &String| match film.as_str() {
        "x" | "y" => film.clone(),
        angle => format!("{angle} deg"),
    };
    let names: Vec<String> = layout.films.iter().map(named).collect();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    listed(&names)
}

/// Says where: `at the crown`, `at 30 degrees from the crown`, `at several section angles`.
fn place(layout: &RankedLayout) -> String {
    match layout.position.strip_suffix(" deg") {
        Some(angle) => format!("at {angle} degrees from the crown"),
        None if layout.position == "mixed" => "at several section angles".to_owned(),
        None => format!("at the {}", layout.position),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn layout(spacing_deg: Option<f64>, position: &str, films: &[&str]) -> RankedLayout {
        RankedLayout {
            spacing_deg,
            units: 7,
            position: position.to_owned(),
            films: films.iter().map(|film| (*film).to_owned()).collect(),
            ..RankedLayout::default()
        }
    }

    #[test]
    fn layouts_are_told_in_words() {
        let mut crown = layout(Some(360.0 / 7.0), "crown", &["x", "y"]);
        assert_eq!(
            words(&crown),
            "7 units of x and y at the crown, every 51.4 degrees"
        );
        assert_eq!(
            instruction(&crown),
            "Glue films of x and y at the crown, 7 units every 51.4 degrees"
        );
        crown.staggered = true;
        assert!(instruction(&crown).ends_with("degrees with their films spread evenly between"));
        assert_eq!(
            words(&layout(Some(60.0), "30 deg", &["45"])),
            "7 units of 45 deg at 30 degrees from the crown, every 60 degrees"
        );
        let mut free = layout(None, "mixed", &["y"]);
        free.name = Some("mine".to_owned());
        assert_eq!(
            instruction(&free),
            "Glue 7 films of y at several section angles (\"mine\")"
        );
    }
}
