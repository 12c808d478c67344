//! Layouts in words.

use crate::score::notes::listed;
use results::RankedLayout;

/// `12 films along y at the crown, one every 30 degrees`; of a layout without units `12 films along y at the crown ("mine")`.
pub(super) fn words(layout: &RankedLayout) -> String {
    format!("{} {}", counted(layout.film_count), laid(layout))
}

/// Says how films are laid: `along y at the crown, one every 30 degrees`.
pub(super) fn laid(layout: &RankedLayout) -> String {
    let place = format!("along {} {}", directions(layout), place(layout));
    match (layout.spacing_deg, &layout.name) {
        (Some(spacing), _) => match layout.turn_deg {
            None => format!("{place}, {}", every(layout, spacing)),
            Some(turn) => format!(
                "{place}, {}, the first at {turn:.1} degrees",
                every(layout, spacing)
            ),
        },
        (None, Some(name)) => format!("{place} ({name:?})"),
        (None, None) => place,
    }
}

/// `1 film`, `12 films`.
pub(super) fn counted(films: usize) -> String {
    match films {
        1 => "1 film".to_owned(),
        films => format!("{films} films"),
    }
}

/// Spacing in words: `one every 30 degrees`, `a pair every 60 degrees`; films in turn are apart.
fn every(layout: &RankedLayout, spacing_deg: f64) -> String {
    let together = match layout.staggered {
        true => 1,
        false => layout.films.len(),
    };
    let apart = match layout.staggered {
        true => spacing_deg / layout.films.len() as f64,
        false => spacing_deg,
    };
    let apart = (apart * 10.0).round() / 10.0;
    match together {
        1 => format!("one every {apart} degrees"),
        2 => format!("a pair every {apart} degrees"),
        more => format!("{more} in one place every {apart} degrees"),
    }
}

/// `x and y`, `y`, `x and 45 deg`; `x and y in turn` where they are spread between units.
fn directions(layout: &RankedLayout) -> String {
    let named = |film: &String| match film.as_str() {
        "x" | "y" => film.clone(),
        angle => format!("{angle} deg"),
    };
    let names: Vec<String> = layout.films.iter().map(named).collect();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    match layout.staggered {
        true => format!("{} in turn", listed(&names)),
        false => listed(&names),
    }
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
            film_count: 7 * films.len(),
            ..RankedLayout::default()
        }
    }

    #[test]
    fn layouts_are_told_in_words() {
        let mut crown = layout(Some(360.0 / 7.0), "crown", &["x", "y"]);
        assert_eq!(
            words(&crown),
            "14 films along x and y at the crown, a pair every 51.4 degrees"
        );
        crown.staggered = true;
        assert_eq!(
            laid(&crown),
            "along x and y in turn at the crown, one every 25.7 degrees"
        );
        assert_eq!(
            words(&layout(Some(60.0), "30 deg", &["45"])),
            "7 films along 45 deg at 30 degrees from the crown, one every 60 degrees"
        );
        assert!(
            words(&layout(Some(120.0), "crown", &["x", "y", "45"]))
                .ends_with("at the crown, 3 in one place every 120 degrees")
        );
        let mut free = layout(None, "mixed", &["y"]);
        free.name = Some("mine".to_owned());
        assert_eq!(
            words(&free),
            "7 films along y at several section angles (\"mine\")"
        );
    }
}
