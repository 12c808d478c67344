//! The film that gives most, of those whose signals a study reads: in volts, at the largest load.

use documents::parts::film_model::FilmModel;
use fem_client::solver::FilmCondition;

use super::figure_words::with_error;
use super::first_rank::{Standing, judge};
use results::{Certainty, SignalAxis, SignalRow, Signals, SignalsAnswer};

/// Name of the study's own tire.
const OWN: &str = "own";

/// The film that gives most, by the most detailed of the models that are read; `None` where no film has a voltage.
pub(super) fn strongest_film(signals: &Signals) -> Option<SignalsAnswer> {
    let read = |row: &&SignalRow| {
        row.tire == OWN && row.over == SignalAxis::Load && row.open_circuit_v.is_some()
    };
    let rows = || signals.rows.iter().filter(read);
    let film = rows()
        .map(|row| row.film)
        .max_by_key(|film| detail(*film))?;
    let of_film = || rows().filter(|row| row.film == film);
    let load_n = of_film().map(|row| row.load_n).fold(0.0, f64::max);
    let at_load = || of_film().filter(|row| row.load_n == load_n);
    let beyond = at_load().filter(|row| !bears(row)).count();
    let mut films: Vec<&SignalRow> = at_load().filter(|row| bears(row)).collect();
    if films.is_empty() {
        films = at_load().collect();
    }
    films.sort_by(|a, b| volts(b).total_cmp(&volts(a)));
    let (first, others) = films.split_first()?;
    let standings: Vec<Standing> = others.iter().map(|row| standing(row)).collect();
    let judged = judge(&standing(first), &standings);
    let next = judged.closest.or((!others.is_empty()).then_some(0));
    let (verdict, reason) = match next.map(|next| others[next]) {
        None => (
            Certainty::Unknown,
            "One film is read, and one is no ranking.".to_owned(),
        ),
        Some(next) => {
            let figures = format!(
                "{} gives {}, and {} {}",
                named(first),
                figure(first),
                named(next),
                figure(next)
            );
            (judged.verdict, judged.reason(&named(next), &figures))
        }
    };
    Some(SignalsAnswer {
        sentence: sentence(first, others.first().copied(), film, beyond),
        verdict,
        reason,
        film,
        position: first.position.as_str().to_owned(),
        direction: first.direction.as_str().to_owned(),
        load_n,
        open_circuit_v: first.open_circuit_v?,
        error_v: error(first),
    })
}

/// Whether the film bears it.
fn bears(row: &SignalRow) -> bool {
    row.state == Some(FilmCondition::Ok)
}

fn detail(film: FilmModel) -> u8 {
    match film {
        FilmModel::Bare => 0,
        FilmModel::Transfer => 1,
        FilmModel::Coupled => 2,
    }
}

fn volts(row: &SignalRow) -> f64 {
    row.open_circuit_v.map_or(0.0, f64::abs)
}

fn error(row: &SignalRow) -> Option<f64> {
    row.error.map(|error| error.open_circuit_v)
}

fn standing(row: &SignalRow) -> Standing {
    Standing {
        value: volts(row),
        off: error(row).map(|error| [error; 2]),
    }
}

fn figure(row: &SignalRow) -> String {
    let volts = row.open_circuit_v.unwrap_or(0.0);
    format!("{} V", with_error(volts, error(row)))
}

/// `y at the crown`.
fn named(row: &SignalRow) -> String {
    format!("{} at the {}", row.direction, row.position.as_str())
}

fn sentence(first: &SignalRow, next: Option<&SignalRow>, film: FilmModel, beyond: usize) -> String {
    let kind = match film {
        FilmModel::Bare => "bare films",
        FilmModel::Transfer => "films, by their transfer,",
        FilmModel::Coupled => "glued films",
    };
    let next = next.map_or_else(String::new, |next| {
        format!("; {} gives {}", named(next), figure(next))
    });
    let torn = match beyond {
        0 => String::new(),
        1 => " One film more is beyond what it bears.".to_owned(),
        count => format!(" {count} films more are beyond what they bear."),
    };
    let torn = if bears(first) {
        torn
    } else {
        " All are beyond what they bear.".to_owned()
    };
    format!(
        "Of the {kind} {} gives most: {} in the open circuit at {} N{next}.{torn}",
        named(first),
        figure(first),
        first.load_n
    )
}

#[cfg(test)]
mod tests {
    use fem_client::solver::Position;
    use fem_client::solver::direction::Direction;
    use results::SignalError;

    use super::*;

    /// A film at the crown that reads this at 20 N.
    fn row(film: FilmModel, direction: Direction, volts: f64, state: FilmCondition) -> SignalRow {
        SignalRow {
            tire: OWN.to_owned(),
            film,
            position: Position::Crown,
            direction,
            over: SignalAxis::Load,
            load_n: 20.0,
            pressure_mpa: 0.2,
            contact_deg: 0.0,
            depth_mm: Some(1.0),
            strain: None,
            tension_1_n_per_mm: None,
            charge_nc: None,
            open_circuit_v: Some(volts),
            output_v: None,
            output_std_v: None,
            state: Some(state),
            error: Some(SignalError {
                strain: 0.0,
                charge_nc: 0.0,
                open_circuit_v: 2.0,
                output_v: 0.0,
            }),
            reason: None,
        }
    }

    fn answered(rows: Vec<SignalRow>) -> SignalsAnswer {
        let signals = Signals {
            rows,
            ..Signals::default()
        };
        strongest_film(&signals).expect("a film with a voltage")
    }

    #[test]
    fn the_most_detailed_model_decides_and_what_tears_is_told() {
        let (bare, glued) = (FilmModel::Bare, FilmModel::Coupled);
        let answer = answered(vec![
            row(bare, Direction::Y, 1600.0, FilmCondition::BeyondYield),
            row(glued, Direction::X, -14.8, FilmCondition::Ok),
            row(glued, Direction::Y, 35.8, FilmCondition::Ok),
        ]);
        assert_eq!(
            answer.sentence,
            "Of the glued films y at the crown gives most: 35.8 +- 2.0 V in the open circuit at 20 N; x at the crown gives -14.8 +- 2.0 V."
        );
        assert_eq!(answer.verdict, Certainty::Certain);
        let torn = answered(vec![
            row(glued, Direction::X, 14.8, FilmCondition::Ok),
            row(glued, Direction::Y, 35.8, FilmCondition::BeyondYield),
        ]);
        assert_eq!(
            (torn.direction.as_str(), torn.verdict),
            ("x", Certainty::Unknown)
        );
        assert!(
            torn.sentence
                .ends_with(" One film more is beyond what it bears."),
            "{}",
            torn.sentence
        );
    }
}
