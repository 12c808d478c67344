//! The inputs that matter, of all there are: shares of the variance of the strain at the contact centre.

use fem_client::solver::direction::Direction;

use super::figure_words::with_error;
use super::first_rank::{Standing, judge};
use crate::score::quantity::QUANTITY;
use results::{Certainty, InputReport, InputShare, InputsAnswer, Output, StudyResult};

/// Inputs that a sentence names.
const NAMED: usize = 3;

/// Returns how much each input tells of the strain at the contact centre, in the direction that varies more of those asked for; `None` without indices there.
pub(super) fn inputs_that_matter(
    result: &StudyResult,
    asked: &[Direction],
) -> Option<InputsAnswer> {
    let centre = &result
        .cut_point
        .locations
        .get(result.cut_point.locations.len() / 2)?
        .name;
    let at_centre = |output: &&Output| {
        output.location == *centre
            && asked.contains(&output.direction)
            && output.first_order.is_some()
    };
    let output = result
        .outputs
        .iter()
        .filter(at_centre)
        // The first of equals: x before y.
        .reduce(|best, next| if next.std > best.std { next } else { best })?;
    let shares = shares(result, output)?;
    let across = result
        .outputs
        .iter()
        .filter(at_centre)
        .find(|other| other.direction != output.direction);
    let across = across.and_then(|output| Some((output, self::shares(result, output)?)));
    let (verdict, reason) = judged(&shares);
    Some(InputsAnswer {
        sentence: sentence(&shares, output) + &other_direction(&shares, across.as_ref()),
        verdict,
        reason,
        location: output.location.clone(),
        direction: output.direction.as_str().to_owned(),
        shares,
        beside: Vec::new(),
    })
}

/// The inputs in the order of their indices.
fn shares(result: &StudyResult, output: &Output) -> Option<Vec<InputShare>> {
    let indices = output.first_order.as_ref()?;
    let share = |(input, index): (&InputReport, &f64)| InputShare {
        input: input.name.clone(),
        index: *index,
        error: output.error.total,
    };
    let inputs = result.inputs.iter().zip(indices);
    let mut shares: Vec<InputShare> = inputs.map(share).collect();
    shares.sort_by(|a, b| b.index.total_cmp(&a.index));
    Some(shares)
}

/// Says which input matters most in the other direction, where that is another one.
fn other_direction(shares: &[InputShare], across: Option<&(&Output, Vec<InputShare>)>) -> String {
    let both =
        across.and_then(|(output, others)| Some((*output, shares.first()?, others.first()?)));
    match both {
        Some((output, first, other)) if first.input != other.input => format!(
            " Of the {} {QUANTITY} there {} makes {} %.",
            output.direction,
            other.input,
            figure(other)
        ),
        _ => String::new(),
    }
}

/// Judges that the first matters most, by the others' shares.
fn judged(shares: &[InputShare]) -> (Certainty, String) {
    let standing = |share: &InputShare| Standing {
        value: share.index,
        off: share.error.map(|error| [error; 2]),
    };
    let Some((first, others)) = shares
        .split_first()
        .filter(|(_, others)| !others.is_empty())
    else {
        return (
            Certainty::Unknown,
            "One input varies, and one is no ranking.".to_owned(),
        );
    };
    let standings: Vec<Standing> = others.iter().map(standing).collect();
    let judged = judge(&standing(first), &standings);
    let next = &others[judged.closest.unwrap_or(0)];
    let figures = format!(
        "{} makes {} %, and {} {} %",
        first.input,
        figure(first),
        next.input,
        figure(next)
    );
    let reason = judged.reason(&next.input, &figures);
    (judged.verdict, reason)
}

/// The share, percent, with its error.
fn figure(share: &InputShare) -> String {
    with_error(100.0 * share.index, share.error.map(|error| 100.0 * error))
}

fn sentence(shares: &[InputShare], output: &Output) -> String {
    let what = format!(
        "the variance of the {} {QUANTITY} at {}",
        output.direction, output.location
    );
    let (first, rest) = match shares {
        [] => return String::new(),
        [only] => {
            return format!("One input varies: {} makes all of {what}.", only.input);
        }
        [first, rest @ ..] => (first, rest),
    };
    let named: Vec<String> = rest
        .iter()
        .take(NAMED - 1)
        .map(|share| format!("{} {} %", share.input, figure(share)))
        .collect();
    let more = match rest.get(NAMED - 1) {
        None => String::new(),
        Some(next) => {
            let count = rest.len() + 1 - NAMED;
            let others = if count == 1 {
                "the other one"
            } else {
                "each of the others"
            };
            format!("; {others} {:.1} % at most", 100.0 * next.index)
        }
    };
    format!(
        "Of {} inputs {} matters most: it makes {} % of {what}, {}{more}.",
        shares.len(),
        first.input,
        figure(first),
        named.join(", ")
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn output() -> Output {
        serde_json::from_value(serde_json::json!({"location": "P3", "direction": "y", "mean": 0.1, "std": 0.01, "first_order": null, "total": null,
            "method": "mdrm", "status": "ok", "error": {}}))
        .expect("an output")
    }

    fn share(input: &str, index: f64) -> InputShare {
        InputShare {
            input: input.to_owned(),
            index,
            error: Some(0.01),
        }
    }

    #[test]
    fn the_first_is_judged_by_the_others_and_one_is_no_ranking() {
        let [cords, near, far] = [share("cords", 0.5), share("P3", 0.495), share("P2", 0.1)];
        let verdict = |all: &[&InputShare]| {
            let all: Vec<InputShare> = all.iter().copied().cloned().collect();
            judged(&all)
        };
        assert_eq!(
            verdict(&[&cords, &far]),
            (
                Certainty::Certain,
                "No other does as much: cords makes 50.0 +- 1.0 %, and P2 10.0 +- 1.0 %."
                    .to_owned()
            )
        );
        let (tied, why) = verdict(&[&cords, &near, &far]);
        assert_eq!(tied, Certainty::Tied);
        assert!(why.starts_with("The errors can't tell P3 from it"), "{why}");
        assert_eq!(verdict(&[&cords]).0, Certainty::Unknown);
        let unknown = InputShare {
            error: None,
            ..cords.clone()
        };
        assert_eq!(verdict(&[&unknown, &far]).0, Certainty::Unknown);
    }

    #[test]
    fn another_first_in_the_other_direction_is_named() {
        let (y, x) = ([share("pressure", 0.97)], vec![share("P1", 0.96)]);
        let across = Output {
            direction: Direction::X,
            ..output()
        };
        assert_eq!(
            other_direction(&y, Some(&(&across, x))),
            " Of the x strain there P1 makes 96.0 +- 1.0 %."
        );
        assert_eq!(other_direction(&y, Some(&(&across, y.to_vec()))), "");
        assert_eq!(other_direction(&y, None), "");
    }

    #[test]
    fn the_first_are_named_and_the_rest_is_bounded() {
        let all = [
            share("cords", 0.39),
            share("P3", 0.3),
            share("P2", 0.1),
            share("wall", 0.08),
            share("pressure", 0.01),
        ];
        assert_eq!(
            sentence(&all, &output()),
            "Of 5 inputs cords matters most: it makes 39.0 +- 1.0 % of the variance of the y strain at P3, P3 30.0 +- 1.0 %, P2 10.0 +- 1.0 %; each of the others 8.0 % at most."
        );
        assert!(sentence(&all[..4], &output()).ends_with("; the other one 8.0 % at most."));
        assert!(sentence(&all[..3], &output()).ends_with("P2 10.0 +- 1.0 %."));
        assert_eq!(
            sentence(&all[..1], &output()),
            "One input varies: cords makes all of the variance of the y strain at P3."
        );
    }
}
