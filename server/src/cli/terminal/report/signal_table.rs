//! Table of films' voltages, and what holds of them, for people: a block for each tire, a line for each film's place.

use std::fmt::Write;

use documents::parts::film_model::FilmModel;
use results::Claim;
use results::ClaimRow;
use results::Holds;
use results::SignalAxis;
use results::SignalCurve;
use results::Signals;
use results::StudyResult;

use crate::cli::terminal::paint::{BAD, FAINT, GOOD, HEADER, header, left};
use crate::cli::terminal::wrapping::labelled;

/// Lines at most, the last of which says how many tires are left out.
const MOST_LINES: usize = 25;
/// Columns of a model of a film, and of its first two claims.
const WIDTH: usize = 28;
const CLAIMS: [usize; 2] = [8, 9];

/// The signals of a result; nothing where it has none.
pub fn signals(result: &StudyResult) -> String {
    let Some(signals) = &result.signals else {
        return String::new();
    };
    let question = "does the voltage rise with the load, fall with the pressure, and is it linear over the contact angle (R2)?";
    let mut text = format!("\n{}", labelled(HEADER, "signals", question));
    let blocks: Vec<String> = signals
        .claims
        .chunk_by(|a, b| a.tire == b.tire)
        .map(|claims| block(signals, claims))
        .collect();
    let mut lines = text.lines().count();
    for (shown, block) in blocks.iter().enumerate() {
        lines += block.lines().count();
        if lines >= MOST_LINES {
            let rest = blocks.len() - shown;
            let _ = writeln!(text, "{rest} more tires are in the result: --json -");
            return text;
        }
        text.push_str(block);
    }
    text
}

/// A tire: a column for each model of a film, a line for each place.
fn block(signals: &Signals, claims: &[ClaimRow]) -> String {
    let Some(first) = claims.first() else {
        return String::new();
    };
    let has = |film: &FilmModel| claims.iter().any(|row| row.film == *film);
    let films: Vec<FilmModel> = FilmModel::ALL.into_iter().filter(has).collect();
    let (mut above, mut below) = (format!("{:<14}", first.tire), "film".to_owned());
    let _ = write!(below, "{:10}", "");
    for film in &films {
        let _ = write!(above, "{:<WIDTH$}", film.as_str());
        let _ = write!(below, "{:<WIDTH$}", "load    pressure contact");
    }
    let mut text = header(&format!("{}\n{}\n", above.trim_end(), below.trim_end()));
    let mut places = Vec::new();
    for row in claims {
        if !places.contains(&(row.position, row.direction)) {
            places.push((row.position, row.direction));
        }
    }
    for (position, direction) in places {
        let of_place = |row: &&ClaimRow| (row.position, row.direction) == (position, direction);
        let _ = write!(text, "{:<11}{:<3}", position.as_str(), direction.as_str());
        for film in &films {
            let of_film = claims
                .iter()
                .filter(of_place)
                .filter(|row| row.film == *film);
            text.push_str(&cells(signals, of_film));
        }
        text.truncate(text.trim_end().len());
        text.push('\n');
    }
    text
}

/// The three claims of one film.
fn cells<'r>(signals: &Signals, claims: impl Iterator<Item = &'r ClaimRow>) -> String {
    let mut text = String::new();
    for row in claims {
        let (style, holds) = match row.holds {
            Holds::Yes => (GOOD, "yes"),
            Holds::No => (BAD, "no"),
            Holds::Uncertain => (FAINT, "unsure"),
        };
        match row.claim {
            Claim::Linear => {
                let r2 = contact_curve(signals, row).and_then(|curve| curve.linear_r2);
                let r2 = r2.map_or(String::new(), |r2| format!(" {r2:.2}"));
                let whole = format!("{holds}{r2}");
                text.push_str(&left(style, &whole, WIDTH - CLAIMS[0] - CLAIMS[1]));
            }
            Claim::RisesWithLoad => text.push_str(&left(style, holds, CLAIMS[0])),
            Claim::FallsWithPressure => text.push_str(&left(style, holds, CLAIMS[1])),
        }
    }
    text
}

fn contact_curve<'s>(signals: &'s Signals, row: &ClaimRow) -> Option<&'s SignalCurve> {
    let mut curves = signals.curves.iter();
    curves.find(|curve| {
        curve.over == SignalAxis::Contact
            && curve.tire == row.tire
            && (curve.film, curve.position, curve.direction)
                == (row.film, row.position, row.direction)
    })
}
