//! Menu of layouts that was tried, in words.

use crate::score::notes::listed;
use results::RankedLayout;

/// Says what was tried: `180 layouts were tried: 3 to 48 films along x, y, or both, at the crown, shoulder or sidewall.`
pub(super) fn menu(layouts: &[&RankedLayout], screened: usize, without_room: usize) -> String {
    let mut told = match layouts.len() {
        1 => "1 layout was tried".to_owned(),
        tried => format!("{tried} layouts were tried"),
    };
    let counts = || layouts.iter().map(|layout| layout.film_count);
    if let (Some(fewest), Some(most)) = (counts().min(), counts().max()) {
        let range = match fewest == most {
            true => format!("{most} films"),
            false => format!("{fewest} to {most} films"),
        };
        told = format!(
            "{told}: {range} along {}, {}",
            ways(layouts),
            places(layouts)
        );
    }
    if screened > 0 {
        told = format!(
            "{told}; {screened} of them weren't simulated, as their bounds are worse than others' errors"
        );
    }
    match without_room {
        0 => format!("{told}."),
        1 => format!("{told}. 1 more has no room for its films."),
        more => format!("{told}. {more} more have no room for their films."),
    }
}

/// `x, y, x and y`: each set of directions once, in their order of size.
fn ways(layouts: &[&RankedLayout]) -> String {
    let mut sets: Vec<Vec<&str>> = layouts
        .iter()
        .map(|layout| layout.films.iter().map(String::as_str).collect())
        .collect();
    sets.sort_by(|a, b| a.len().cmp(&b.len()).then(a.cmp(b)));
    sets.dedup();
    let named: Vec<String> = sets.iter().map(|set| listed(set)).collect();
    match named.as_slice() {
        [one] => one.clone(),
        [first @ .., last] => format!("{}, or {last}", first.join(", ")),
        [] => String::new(),
    }
}

/// Names of the section angles: `at the crown, shoulder or sidewall`.
fn places(layouts: &[&RankedLayout]) -> String {
    let mut names: Vec<&str> = Vec::new();
    for layout in layouts {
        let name = match layout.position.as_str() {
            "mixed" => "several section angles",
            name => name,
        };
        if !names.contains(&name) {
            names.push(name);
        }
    }
    // From the crown down to the bead, as the eye goes.
    names.sort_by_key(|name| {
        ["crown", "shoulder", "sidewall"]
            .iter()
            .position(|known| known == name)
            .unwrap_or(3)
    });
    match names.as_slice() {
        [one] => format!("at {one}"),
        [first @ .., last] => format!("at {} or {last}", first.join(", ")),
        [] => String::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_menu_is_told_by_all_that_was_on_it() {
        let layout = |film_count, position: &str, films: &[&str]| RankedLayout {
            film_count,
            position: position.to_owned(),
            films: films.iter().map(|film| (*film).to_owned()).collect(),
            ..RankedLayout::default()
        };
        let all = [
            layout(3, "sidewall", &["y"]),
            layout(48, "crown", &["x", "y"]),
            layout(12, "crown", &["x"]),
        ];
        let told = |count: usize, screened, without_room| {
            let layouts: Vec<&RankedLayout> = all.iter().take(count).collect();
            menu(&layouts, screened, without_room)
        };
        assert_eq!(
            told(3, 2, 1),
            "3 layouts were tried: 3 to 48 films along x, y, or x and y, at crown or sidewall; 2 of them weren't simulated, as their bounds \
             are worse than others' errors. 1 more has no room for its films."
        );
        assert_eq!(
            told(1, 0, 0),
            "1 layout was tried: 3 films along y, at sidewall."
        );
    }
}
