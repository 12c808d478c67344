//! Bounds of what a rig's runs may hold, by the study's layouts.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use document::fault::Fault;
use document::fields::plain;

use crate::study::Study;

/// Readings of all films in a run: 400 MB.
const MOST_READINGS: f64 = 5e7;
/// Readings of all runs and layouts: some minutes of a core.
const MOST_OF_ALL: f64 = 2e9;

/// Whether what the films of a study's layouts read can be kept in memory, and be learnt from in reasonable time.
pub(crate) fn check_readings(study: &Study, faults: &mut Vec<Fault>) {
    let Some(rig) = &study.rig else {
        return;
    };
    let layouts = &study.layouts;
    let films = layouts.film_counts(study.directions);
    let of_film = rig.gait.longest_s() * rig.film_rate_hz;
    let most = films.iter().max().copied().unwrap_or(0) as f64;
    let all = films.iter().sum::<usize>() as f64;
    let limits = [
        (
            "a run of the largest layout has",
            most * of_film,
            MOST_READINGS,
        ),
        (
            "all runs of all layouts have",
            all * of_film * rig.runs as f64,
            MOST_OF_ALL,
        ),
    ];
    for (what, readings, limit) in limits {
        if readings > limit {
            let detail = format!(
                "{what} up to {} readings of films; at most {} are recorded",
                plain(readings.round()),
                plain(limit)
            );
            Fault::add(faults, "/rig", detail);
        }
    }
}

#[cfg(test)]
mod tests {
    use document::Format;

    use super::*;
    use crate::study::presets;

    fn preset(name: &str) -> &'static str {
        let found = presets().into_iter().find(|(other, _)| *other == name);
        found.expect("it ships").1
    }

    #[test]
    fn more_readings_than_can_be_kept_are_refused() {
        let told = |rig: &str| {
            let text = preset("forces").replace("[rig] ", &format!("[rig]\n{rig}\n#"));
            let no_files = |path: &str| Err(path.to_owned());
            Study::from_document(&text, Format::Toml, &no_files)
                .err()
                .unwrap_or_default()
        };
        assert_eq!(told("runs = 8"), []);
        // 48 films of 24 units at 20 kHz for 60 s; with 100 films in all, four times and a thousand times.
        let details = |rig| -> Vec<String> {
            let faults = told(rig).into_iter();
            faults.map(|fault| fault.to_string()).collect()
        };
        let fast = details("film_rate_hz = 20000");
        assert!(
            fast.len() == 1 && fast[0].contains("largest layout has up to 5.76e7"),
            "{fast:?}"
        );
        let many = details("film_rate_hz = 2000\nruns = 1000");
        assert!(many.len() == 1 && many[0].contains("1.2e10"), "{many:?}");
    }
}
