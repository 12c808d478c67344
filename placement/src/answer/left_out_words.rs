//! Omissions of the model, as sentences with their effects.

use fem_client::scene::Film;
use fem_client::solver::Choice;

use super::figure_words::percent;
use results::{Grade, GradedNote, LeftOut, Topic};

/// Name of the stiffness of films, where solvers leave it out.
pub(super) const FILM_STIFFNESS: &str = "film stiffness";
/// Effects from which on the answer is another one, and a figure.
const CHANGES: f64 = 0.1;
const BEARS: f64 = 0.01;

/// The part of what is left out that changes strains most, of those whose effect is known.
pub(super) fn largest<'a>(left_out: impl Iterator<Item = &'a Choice>) -> Option<LeftOut> {
    let known =
        left_out.filter_map(|choice| Some((choice, choice.effect.filter(|effect| *effect > 0.0)?)));
    let (choice, effect) = known.max_by(|a, b| a.1.total_cmp(&b.1))?;
    Some(LeftOut {
        what: choice.what.clone(),
        why: choice.why.clone(),
        effect,
        sentence: sentence(&choice.what, effect),
    })
}

/// A note for each effect that is known: one of more than a tenth changes the answer.
pub(crate) fn effect_notes(left_out: &[Choice]) -> Vec<GradedNote> {
    let note = |choice: &Choice| {
        let effect = choice.effect.filter(|effect| *effect > 0.0)?;
        let grade = match effect {
            effect if effect > CHANGES => Grade::ChangesAnswer,
            effect if effect > BEARS => Grade::BearsOnFigure,
            _ => Grade::ForTheRecord,
        };
        Some(GradedNote::of(
            grade,
            Topic::Model,
            sentence(&choice.what, effect),
        ))
    };
    left_out.iter().filter_map(note).collect()
}

/// Says what putting it in would do; solvers name what they leave out, and what they put in for it stands in their reasons.
fn sentence(what: &str, effect: f64) -> String {
    let change = percent(effect);
    match what {
        FILM_STIFFNESS => {
            let film = Film::default();
            format!(
                "A glued PVDF film of {} x {} x {} mm would change the strain under it by {change} %: the indices are those of bare rubber.",
                film.length_mm,
                film.width_mm,
                film.thickness_mm()
            )
        }
        _ => format!("The model leaves out {what}, which would change a strain by {change} %."),
    }
}

#[cfg(test)]
mod tests {
    use tire::omission::omissions;

    use super::*;

    fn choice(what: &str, effect: Option<f64>) -> Choice {
        Choice {
            what: what.to_owned(),
            why: "it is small".to_owned(),
            effect,
        }
    }

    #[test]
    fn the_largest_known_effect_is_told() {
        let left_out = [
            choice("y < 0", Some(0.0)),
            choice("friction", Some(0.0626)),
            choice("film stiffness", Some(0.9966)),
            choice("film folding", None),
            choice("compressibility", Some(0.00038)),
        ];
        let found = largest(left_out.iter()).expect("an effect");
        assert_eq!(
            found.sentence,
            "A glued PVDF film of 5 x 5 x 0.05 mm would change the strain under it by 100 %: the indices are those of bare rubber."
        );
        let grades: Vec<(Grade, Topic)> = effect_notes(&left_out)
            .iter()
            .map(|note| (note.grade, note.about))
            .collect();
        assert_eq!(
            grades,
            [
                (Grade::BearsOnFigure, Topic::Model),
                (Grade::ChangesAnswer, Topic::Model),
                (Grade::ForTheRecord, Topic::Model)
            ]
        );
        assert_eq!(largest(left_out[..1].iter()), None);
    }

    #[test]
    fn the_film_that_is_told_is_the_one_that_is_put_in() {
        let all = omissions(&fem_client::scene::Scene::default());
        let film = all
            .iter()
            .find(|omission| omission.what == "film stiffness");
        let film = film.expect("the model has no film");
        let richer = film.richer.as_ref().expect("it fits");
        assert_eq!(richer.film, Some(Film::default()));
    }
}
