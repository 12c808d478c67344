//! Assumptions that the figures of the layout that answers rest on, in words.

use super::layout_figures::three_digits;
use super::layout_words::words;
use results::{AssumptionChange, AssumptionFindings, RestsOn, StudyResult};

/// Changes that are told.
const TOLD: usize = 3;
/// Times that figures must change by to be told.
const MOVED: f64 = 1.1;

/// The assumptions that move its figures most, each with what they are then.
pub(super) fn rests_on(result: &StudyResult) -> Option<RestsOn> {
    let findings = findings(result)?;
    let moved = findings.changes.iter();
    let moved: Vec<&AssumptionChange> = moved
        .filter(|change| change.times >= MOVED)
        .take(TOLD)
        .collect();
    let mut told = match moved.as_slice() {
        [] => steady(&findings.changes),
        moved => {
            let with = |change: &&AssumptionChange| {
                format!(
                    "with {}: {}",
                    change.words,
                    moved_figures(findings, change).join(" and ")
                )
            };
            let moved: Vec<String> = moved.iter().map(with).collect();
            let assumed = [
                degrees(findings.angle_error_deg),
                newtons(findings.force_error_n),
            ];
            format!(
                "As assumed {}; {}.",
                assumed.join(" and "),
                moved.join("; ")
            )
        }
    };
    if !findings.unchanged.is_empty() {
        told += &format!(" Not changed: {}.", findings.unchanged.join(", "));
    }
    let first = moved.first().map(|change| {
        format!(
            "{}: {}",
            change.of,
            moved_figures(findings, change).join(", ")
        )
    });
    let brief = match (first, overturned(result)) {
        (Some(first), Some(overturned)) => format!("{first}.{overturned}"),
        (first, overturned) => first
            .or(overturned)
            .unwrap_or_default()
            .trim_start()
            .to_owned(),
    };
    Some(RestsOn {
        sentence: told.trim_start().to_owned(),
        brief,
    })
}

/// Says that nothing moves the figures.
fn steady(changes: &[AssumptionChange]) -> String {
    let all: Vec<&str> = changes.iter().map(|change| change.words.as_str()).collect();
    match all.as_slice() {
        [] => String::new(),
        all => format!(
            "Neither figure changes by a tenth with {}.",
            alternatives(all)
        ),
    }
}

/// The figures that a change moves.
fn moved_figures(assumed: &AssumptionFindings, change: &AssumptionChange) -> Vec<String> {
    let is_moved = |from: f64, to: f64| (to / from).max(from / to) >= MOVED;
    let angle = is_moved(assumed.angle_error_deg, change.angle_error_deg);
    let force = is_moved(assumed.force_error_n, change.force_error_n);
    let both = [
        angle.then(|| degrees(change.angle_error_deg)),
        force.then(|| newtons(change.force_error_n)),
    ];
    both.into_iter().flatten().collect()
}

fn degrees(angle: f64) -> String {
    format!("{} degrees", three_digits(angle))
}

fn newtons(force: f64) -> String {
    format!("{} N", three_digits(force))
}

/// Says with which changes another layout does better, or limits that are asked aren't kept; begins with a space.
pub(super) fn overturned(result: &StudyResult) -> Option<String> {
    let changes = &findings(result)?.changes;
    let with = |changes: Vec<&AssumptionChange>, then: String| {
        let words: Vec<&str> = changes.iter().map(|change| change.words.as_str()).collect();
        format!(" With {} {then}.", alternatives(&words))
    };
    let of_layout = |rank: usize| {
        let better = changes
            .iter()
            .filter(|change| change.better_rank == Some(rank));
        let layout = result.layout_of_rank(rank)?;
        Some(with(
            better.collect(),
            format!("{} do better", words(layout)),
        ))
    };
    let mut ranks: Vec<usize> = changes
        .iter()
        .filter_map(|change| change.better_rank)
        .collect();
    ranks.sort_unstable();
    ranks.dedup();
    let unkept: Vec<_> = changes
        .iter()
        .filter(|change| change.meets == Some(false))
        .collect();
    let unkept = (!unkept.is_empty()).then(|| with(unkept, "they keep to that no more".to_owned()));
    let told: String = ranks
        .into_iter()
        .filter_map(of_layout)
        .chain(unkept)
        .collect();
    (!told.is_empty()).then_some(told)
}

/// `twice the noise`, `twice the noise or a pressure 10 % lower`.
fn alternatives(words: &[&str]) -> String {
    match words {
        [] => String::new(),
        [one] => (*one).to_owned(),
        [others @ .., last] => format!("{} or {last}", others.join(", ")),
    }
}

fn findings(result: &StudyResult) -> Option<&AssumptionFindings> {
    result.layout_findings.as_ref()?.assumptions.as_ref()
}

#[cfg(test)]
mod tests {
    use results::{LayoutFindings, RankedLayout};

    use super::*;

    fn change(of: &str, angle_error_deg: f64, times: f64) -> AssumptionChange {
        AssumptionChange {
            of: of.to_owned(),
            words: format!("other {of}"),
            angle_error_deg,
            force_error_n: 1.25,
            times,
            better_rank: None,
            meets: None,
        }
    }

    fn result(changes: Vec<AssumptionChange>, unchanged: &[&str]) -> StudyResult {
        let layout = |(k, films): (usize, usize)| RankedLayout {
            rank: k + 1,
            spacing_deg: Some(360.0 / films as f64),
            units: films,
            position: "crown".to_owned(),
            films: vec!["y".to_owned()],
            film_count: films,
            ..RankedLayout::default()
        };
        StudyResult {
            layouts: [12, 9].into_iter().enumerate().map(layout).collect(),
            layout_findings: Some(LayoutFindings {
                assumptions: Some(AssumptionFindings {
                    rank: 1,
                    angle_error_deg: 10.7,
                    force_error_n: 1.25,
                    changes,
                    unchanged: unchanged.iter().map(|&name| name.to_owned()).collect(),
                }),
                ..LayoutFindings::default()
            }),
            ..StudyResult::default()
        }
    }

    #[test]
    fn three_that_move_the_figures_most_are_told() {
        let changes = vec![
            change("noise", 21.4, 2.0),
            change("gain", 16.0, 1.5),
            change("drift", 13.0, 1.2),
            change("place", 12.5, 1.17),
        ];
        let told = rests_on(&result(changes, &["camber"])).expect("told");
        assert_eq!(
            told.sentence,
            "As assumed 10.7 degrees and 1.25 N; with other noise: 21.4 degrees; with other gain: 16.0 degrees; with other drift: 13.0 degrees. \
             Not changed: camber."
        );
        assert_eq!(told.brief, "noise: 21.4 degrees");
        let still = vec![change("noise", 10.8, 1.01), change("gain", 10.7, 1.0)];
        let told = rests_on(&result(still, &[])).expect("told");
        assert_eq!(
            (told.sentence.as_str(), told.brief.as_str()),
            (
                "Neither figure changes by a tenth with other noise or other gain.",
                ""
            )
        );
        assert_eq!(rests_on(&StudyResult::default()), None);
    }

    #[test]
    fn what_overturns_the_answer_is_told() {
        let steady = result(vec![change("noise", 21.4, 2.0)], &[]);
        assert_eq!(overturned(&steady), None);
        let better = |of: &str| AssumptionChange {
            better_rank: Some(2),
            ..change(of, 21.4, 2.0)
        };
        let told = overturned(&result(vec![better("noise"), better("gain")], &[]));
        assert_eq!(
            told.expect("told"),
            " With other noise or other gain 9 films along y at the crown, one every 40 degrees do better."
        );
        let unkept = AssumptionChange {
            meets: Some(false),
            ..change("pressure", 10.7, 1.8)
        };
        assert_eq!(
            overturned(&result(vec![unkept], &[])).expect("told"),
            " With other pressure they keep to that no more."
        );
    }
}
