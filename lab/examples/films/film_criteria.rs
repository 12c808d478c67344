//! Do other criteria choose the films that know most of the contact? A study's kinds of film by the information of one film on angle and depth, its signal,
//! effective independence, pivoted QR and the variance at the contact's centre, by which the paper ranks; and how far these orders agree. The section "Which
//! film tells most" of `docs/use/layouts.md`.
//!
//! `cargo run --release -p lab --example film_criteria [-- STUDY [LEVEL]]`: a study that ships or the path of one, layouts when left out; standard when left
//! out, two minutes on two cores.

use fem_client::scene::Level;
use lab::film_criteria::criteria::{FilmFigures, agreement, criteria, figures};
use lab::film_criteria::study_films::{StudyFilms, study_films};
use lab::study_runs::{level_argument, study_on};
use results::CandidateFilm;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let study = std::env::args().nth(1);
    let study = study.unwrap_or_else(|| "layouts".to_owned());
    let level = level_argument(2, Level::Standard);
    let StudyFilms {
        films,
        fields,
        depths_mm,
    } = study_films(study_on(&study, level))?;
    let figures = figures(&fields, &depths_mm);
    println!(
        "| section angle, deg | direction | size, mm | angle information, 1/deg | depth information, 1/mm | signal | effective independence | pivot | std at the centre |"
    );
    println!("|---|---|---|---|---|---|---|---|---|");
    let mut rows: Vec<_> = films.iter().zip(&figures).collect();
    rows.sort_by(|(a, _), (b, _)| b.angle_information.total_cmp(&a.angle_information));
    for (film, own) in rows {
        println!("{}", row(film, own));
    }
    let criteria = criteria(&films, &figures);
    let names = criteria.each_ref().map(|(name, _)| *name);
    println!("\n| Kendall's tau | {} |", names.join(" | "));
    println!("|{}", "---|".repeat(1 + names.len()));
    for (name, taus) in names.iter().zip(agreement(&criteria)) {
        let cells = taus.iter().map(|tau| number(*tau, 2));
        println!("| {name} | {} |", cells.collect::<Vec<_>>().join(" | "));
    }
    Ok(())
}

fn row(film: &CandidateFilm, own: &FilmFigures) -> String {
    let size = film.length_mm.zip(film.width_mm);
    format!(
        "| {} | {} | {} | {}{} | {} | {} | {:.3} | {} | {:.2e} |",
        film.section_deg,
        film.direction,
        size.map_or("point".to_owned(), |(length, width)| format!(
            "{length} x {width}"
        )),
        number(Some(film.angle_information), 4),
        film.angle_information_error
            .map_or(String::new(), |error| format!(" +- {error:.4}")),
        number(Some(film.depth_information), 2),
        number(Some(film.signal), 4),
        own.effective_independence,
        own.pivot_rank
            .map_or("-".to_owned(), |rank| rank.to_string()),
        own.centre_std,
    )
}

fn number(value: Option<f64>, digits: usize) -> String {
    value.map_or("-".to_owned(), |value| format!("{value:.digits$}"))
}
