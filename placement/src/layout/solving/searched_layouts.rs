//! Layouts that a study has searched for.

use crate::layout::solving::study_layouts::Asked;
use crate::points::RunContext;
use crate::points::worker_threads::in_parallel;
use documents::layouts::layout_settings::Layouts;
use layouts::arrangement::LaidFilm;
use layouts::field::film_field::{DepthFields, LoadField, Noise};
use layouts::ranking::asked_layouts::{AskedLayout, listed};
use layouts::search::best_layouts::{Findings, joined};
use layouts::search::layout_search::SearchPlaces;
use layouts::search::search_criterion::{SearchCriterion, SearchFields};
use results::LayoutSearch;

/// Depths of the study that a contact may be taken for.
const OTHER_DEPTHS: usize = 8;

/// Searches for the best layouts of each number of films by each criterion, and adds them to those that are scored; `None` when the study is stopped.
pub(crate) fn search(
    settings: &Layouts,
    asked: &mut Asked,
    fields: &DepthFields,
    depths_mm: &[f64],
    noise: &Noise,
    context: RunContext<'_>,
) -> Option<Vec<LayoutSearch>> {
    let Some(search) = &settings.search else {
        return Some(Vec::new());
    };
    let loads: Vec<LoadField> = depths_mm.iter().map(|depth| fields.at(*depth)).collect();
    let fields = SearchFields {
        loads: &loads,
        others: &fields.evenly(OTHER_DEPTHS),
    };
    let searched = |criterion| {
        let films = asked.places.clone();
        let places = SearchPlaces::new(films, criterion, &fields, noise, context.stop)?;
        Some((criterion, places))
    };
    let searches: Option<Vec<_>> = SearchCriterion::ALL.into_iter().map(searched).collect();
    let searches = searches?;
    let numbers = search.films.iter();
    let tasks: Vec<(usize, &(SearchCriterion, SearchPlaces))> = numbers
        .flat_map(|&films| searches.iter().map(move |search| (films, search)))
        .collect();
    let starts = |task: usize| tasks[task].1.1.starts(tasks[task].0);
    let pieces: Vec<(usize, usize)> = (0..tasks.len())
        .flat_map(|task| (0..starts(task)).map(move |start| (task, start)))
        .collect();
    let found = in_parallel(pieces.len(), context.threads, context.stop, |piece| {
        let (task, start) = pieces[piece];
        let (films, (_, places)) = tasks[task];
        places.search(films, start, context.stop)
    })?;
    let found: Option<Vec<Findings>> = found.into_iter().collect();
    let mut found = found?.into_iter();
    let reports = tasks.iter().enumerate().map(|(task, (films, search))| {
        let found = joined(found.by_ref().take(starts(task)))?;
        Some(report(*films, search, &found, asked))
    });
    reports.collect()
}

/// Reports what one search found, whose layouts are added to those that are scored, each once.
fn report(
    films: usize,
    (criterion, places): &(SearchCriterion, SearchPlaces),
    found: &Findings,
    asked: &mut Asked,
) -> LayoutSearch {
    let laid = |found: &[usize]| -> Vec<LaidFilm> {
        found.iter().map(|&place| places.film(place)).collect()
    };
    for (k, layout) in found.best.iter().take(criterion.simulated()).enumerate() {
        let by = match criterion {
            SearchCriterion::Bound => "",
            SearchCriterion::IntervalErrors => " by interval errors",
        };
        let name = format!("best {films} films{by}, {}", k + 1);
        let layout = listed(name, laid(&layout.places), &asked.kinds);
        let is_known = |known: &AskedLayout| known.arrangement == layout.arrangement;
        if !asked.layouts.iter().any(is_known) {
            asked.layouts.push(layout);
        }
    }
    let best = found.best.first();
    LayoutSearch {
        films,
        places: places.count(),
        method: match found.is_exhaustive {
            true => "exhaustive",
            false => "greedy and exchange",
        }
        .to_owned(),
        criterion: criterion.as_str().to_owned(),
        looked_at: found.looked_at,
        bayes_angle_error_deg: best.map(|best| places.bound_deg(&best.places)),
        best: best
            .map_or_else(Vec::new, |best| laid(&best.places))
            .iter()
            .map(|film| asked.kinds.place(film))
            .collect(),
    }
}
