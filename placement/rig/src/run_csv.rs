//! A run as a recording that `strainsite force fit` reads: a CSV file, and the recipe that says what is in it.
//!
//! Rows of both clocks stand in the order of time. What a clock doesn't see at an instant is empty; every row has the number of its stance. The recipe asks for
//! the films' clock, so that forces are interpolated to it.

use std::fmt::Write;

use crate::rig_run::RigRun;

/// Two readings less than this apart are one row, s; a force of 30 N at 5 Hz changes by a millinewton in it.
const SAME_S: f64 = 1e-6;

impl RigRun {
    /// The recording's text. Volts and newtons have 32 bits, seven digits; times have all of theirs.
    pub fn csv(&self) -> String {
        let mut text = header(self.films.volts.ncols());
        let (films, forces) = (&self.films, &self.forces);
        let (mut film, mut force) = (0, 0);
        loop {
            let [by_films, by_force] = match (films.time_s.get(film), forces.time_s.get(force)) {
                (None, None) => break,
                (Some(a), Some(b)) if (a - b).abs() < SAME_S => [true, true],
                (Some(a), Some(b)) => [a < b, a > b],
                (a, b) => [a.is_some(), b.is_some()],
            };
            let (time_s, stance) = if by_films {
                (films.time_s[film], films.stance[film])
            } else {
                (forces.time_s[force], forces.stance[force])
            };
            // Writing to a text can't fail.
            let _ = write!(text, "{time_s}");
            let volts = by_films.then(|| films.volts.row(film));
            cells(&mut text, films.volts.ncols(), volts.iter().flatten());
            let newtons = by_force.then(|| forces.force_n.row(force));
            cells(&mut text, forces.force_n.ncols(), newtons.iter().flatten());
            let _ = writeln!(text, ",{stance}");
            film += usize::from(by_films);
            force += usize::from(by_force);
        }
        text
    }
}

/// `time_s,film_1,...,fx_n,fy_n,fz_n,stance`
fn header(films: usize) -> String {
    let films: String = (1..=films).map(|film| format!(",film_{film}")).collect();
    format!("time_s{films},fx_n,fy_n,fz_n,stance\n")
}

/// Writes so many cells: numbers, or nothing.
fn cells<'n>(text: &mut String, count: usize, numbers: impl Iterator<Item = &'n f64>) {
    let before = text.len();
    for number in numbers {
        let _ = write!(text, ",{}", *number as f32);
    }
    if text.len() == before {
        text.extend(std::iter::repeat_n(',', count));
    }
}

/// The recipe that reads recordings of so many films, whose clock has so many instants a second, Hz.
pub fn recipe_toml(films: usize, film_rate_hz: f64) -> String {
    let names: Vec<String> = (1..=films).map(|film| format!("\"film_{film}\"")).collect();
    format!(
        "[columns]\ntime = \"time_s\"\nsignals = [{}]\nforces = [\"fx_n\", \"fy_n\", \"fz_n\"]\ncycle = \"stance\"\n\n[preprocess]\nrate_hz = {film_rate_hz}\n",
        names.join(", ")
    )
}

#[cfg(test)]
mod tests {
    use document::{Format, parse};
    use estimation::align::aligned;
    use estimation::recipe::{Columns, CycleRule};
    use estimation::recording::csv_recording;
    use estimation::recording::named_columns::NamedColumns;

    use super::*;
    use crate::bump_response::BumpResponse;
    use documents::rig::gait_settings::{Frequency, RunLength};
    use documents::rig::rig_settings::RigSettings;

    fn settings() -> RigSettings {
        let mut settings = RigSettings::default();
        settings.gait.frequency = Frequency::Fixed { hz: 2.0 };
        settings.gait.length = RunLength::Stances(4);
        settings.force_sensor.rate_hz = 160.0;
        settings
    }

    fn recorded(settings: &RigSettings) -> RigRun {
        RigRun::recorded(&BumpResponse::new(3), settings, 0)
    }

    #[test]
    fn rows_of_both_clocks_stand_in_the_order_of_time() {
        let run = recorded(&settings());
        let text = run.csv();
        let mut lines = text.lines();
        let header = "time_s,film_1,film_2,film_3,fx_n,fy_n,fz_n,stance";
        assert_eq!(lines.next(), Some(header));
        let first: Vec<&str> = lines.next().expect("a row").split(',').collect();
        assert_eq!((first[0], &first[4..]), ("0", &["", "", "", "0"][..]));
        let second: Vec<&str> = lines.next().expect("a row").split(',').collect();
        assert_eq!((second[0], &second[1..4]), ("0.0017", &["", "", ""][..]));
        assert_eq!(
            text.lines().count(),
            1 + run.films.time_s.len() + run.forces.time_s.len()
        );
    }

    #[test]
    fn readings_at_one_instant_are_one_row() {
        let mut settings = settings();
        settings.force_sensor.offset_s = 0.0;
        settings.force_sensor.rate_hz = 100.0;
        settings.force_sensor.ppm = 0.0;
        let run = recorded(&settings);
        let text = run.csv();
        assert_eq!(text.lines().count(), 1 + run.films.time_s.len());
        let whole = |line: &&str| !line.contains(",,");
        assert_eq!(text.lines().skip(1).filter(whole).count(), 200);
    }

    /// The estimator's reader makes of it the same numbers to 32 bits, and on the films' clock the films' own rows.
    #[test]
    fn the_estimator_reads_it() {
        let run = recorded(&settings());
        let text = run.csv();
        let columns = Columns {
            time: Some("time_s".to_owned()),
            signals: Some(vec!["film_*".to_owned()]),
            forces: Some(vec!["f?_n".to_owned()]),
            cycles: CycleRule::Column("stance".to_owned()),
            ..Columns::default()
        };
        let header = csv_recording::header("run.csv", &text).expect("a header");
        let names = NamedColumns::find(&columns, [&header]);
        let read = csv_recording::read("run.csv", &text, &columns, &names, true).expect("reads");
        let pause_s = 10.0 * read.interval_s().expect("rows");
        let on_clock = aligned(&read, 200.0, pause_s);
        assert_eq!(on_clock.time_s, run.films.time_s);
        assert_eq!(on_clock.signals, run.films.volts.mapv(as_stored));
        assert_eq!(on_clock.cycle.as_ref(), Some(&run.films.stance));
        let labelled = on_clock.labelled();
        // Before the force sensor's first reading there is no force, and none after its last one.
        assert!((397..400).contains(&labelled), "{labelled}");
    }

    fn as_stored(number: f64) -> f64 {
        let text = format!("{}", number as f32);
        text.parse().expect("a number")
    }

    #[test]
    fn the_recipe_names_what_is_in_the_file() {
        let recipe = parse(&recipe_toml(2, 200.0), Format::Toml).expect("reads");
        let expected = serde_json::json!({
            "columns": {
                "time": "time_s",
                "signals": ["film_1", "film_2"],
                "forces": ["fx_n", "fy_n", "fz_n"],
                "cycle": "stance",
            },
            "preprocess": {"rate_hz": 200},
        });
        assert_eq!(recipe, expected);
    }
}
