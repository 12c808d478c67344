//! Screening of the menu: which of its layouts are simulated in full.
//!
//! Layouts of as many films compete. In the order of their bounds each is simulated shortly, at the load where its bound is worst, until the bounds of the rest
//! are beyond what the best one reaches; those that come near it are kept.

use std::collections::BTreeMap;

use crate::ranking::asked_layouts::AskedLayout;
use crate::ranking::layout_scores::Scorer;
use crate::simulate::draws::Draws;
use crate::simulate::simulation::LOST_DEG;

/// Least ratio of the 95th percentile to the bound: 1.96 of a normal error that is the same at all contacts, 1.9 to 23 on tires.
const LEAST_RATIO: f64 = 1.5;
/// Largest ratio of a kept layout's short percentile to the best one's: of 96 samples it is known to some 18 %.
const NEAR: f64 = 1.6;
/// Most layouts of a number of films that are looked at, and kept, where all lose the contact: which loses least says little.
const OF_LOST: [usize; 2] = [6, 2];

/// Limits of errors that layouts are compared by; none of both: the angle's error alone.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Limits {
    /// Largest error of the angle, degrees.
    pub angle_deg: Option<f64>,
    /// Largest error of the force, N.
    pub force_n: Option<f64>,
}

/// Layouts of the menu by their numbers of films: each group is screened alone.
pub fn competitors(layouts: &[AskedLayout]) -> Vec<Vec<usize>> {
    let mut groups: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for (index, layout) in layouts
        .iter()
        .enumerate()
        .filter(|(_, layout)| layout.of_menu)
    {
        let films = layout.arrangement.films.len();
        groups.entry(films).or_default().push(index);
    }
    groups.into_values().collect()
}

/// Layouts of a group of competitors that may be its best, in their order.
pub fn kept(
    group: &[usize],
    layouts: &[AskedLayout],
    scorer: &Scorer,
    draws: &Draws,
    limits: Limits,
) -> Vec<usize> {
    let mut bounded: Vec<(f64, f64, usize)> = group
        .iter()
        .map(|&index| {
            let (depth_mm, bound_deg) = scorer.worst_bound(&layouts[index].arrangement);
            (bound_deg, depth_mm, index)
        })
        .collect();
    bounded.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut found: Vec<(f64, usize)> = Vec::new();
    let mut best = f64::INFINITY;
    for (bound_deg, depth_mm, index) in bounded {
        let is_lost = limits.force_n.is_none() && best > LOST_DEG;
        if is_lost && found.len() >= OF_LOST[0] {
            break;
        }
        // A bound of the angle says nothing of the force.
        if limits.force_n.is_none() && LEAST_RATIO * bound_deg > best * NEAR {
            break;
        }
        let [angle_deg, force_n] = scorer.glimpse(&layouts[index].arrangement, depth_mm, draws);
        let figure = match (limits.angle_deg, limits.force_n) {
            (angle, Some(force)) => angle
                .map_or(0.0, |angle| angle_deg / angle)
                .max(force_n / force),
            (_, None) => angle_deg,
        };
        best = best.min(figure);
        found.push((figure, index));
    }
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    let is_lost = limits.force_n.is_none() && best > LOST_DEG;
    let most = if is_lost { OF_LOST[1] } else { found.len() };
    let near = found
        .iter()
        .take(most)
        .filter(|(figure, _)| *figure <= NEAR * best);
    let mut kept: Vec<usize> = near.map(|(_, index)| *index).collect();
    kept.sort_unstable();
    kept
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arrangement::FilmReads;
    use crate::fisher::bounds::tests::{NOISE, gaussian};
    use crate::ranking::asked_layouts::{Kinds, asked_layouts};
    use crate::simulate::simulation::SAMPLES;
    use documents::layouts::layout_settings::Layouts;
    use documents::parts::directions::Directions;
    use fem_client::scene::Geometry;
    use fem_client::solver::Position;

    /// The menu at the crown on bells of 14 degrees: whatever is left out is no better than what is kept, beyond the errors of both.
    #[test]
    fn nothing_that_is_left_out_is_better_than_the_best_that_is_kept() {
        let settings = Layouts {
            positions: vec![Position::Crown],
            ..Layouts::default()
        };
        let mut kinds = Kinds::of_crown(&Geometry::default(), None, FilmReads::Strain);
        let (layouts, _) = asked_layouts(&settings, Directions::Both, &mut kinds);
        let arrangements = || layouts.iter().map(|layout| &layout.arrangement);
        let depths = vec![0.6, 1.0];
        let scorer = Scorer::new(
            &gaussian(14.0),
            NOISE,
            depths,
            arrangements(),
            Draws::new(1, SAMPLES, 48),
            false,
        );
        let draws = Draws::new(1, SAMPLES / 5, 48);
        let worst = |index: usize| {
            let scores = scorer.figures(&layouts[index].arrangement);
            let of = |score: &results::LayoutScore| {
                let value = score.simulated_p95_angle_error_deg.expect("simulated");
                (
                    value,
                    score.simulated_p95_angle_error_deg_se.expect("simulated"),
                )
            };
            scores.iter().map(of).fold(
                (0.0, 0.0),
                |worst, own| if own.0 > worst.0 { own } else { worst },
            )
        };
        let mut screened = 0;
        for group in competitors(&layouts) {
            let kept = kept(&group, &layouts, &scorer, &draws, Limits::default());
            assert!(!kept.is_empty());
            let best =
                kept.iter()
                    .map(|&index| worst(index))
                    .fold((f64::INFINITY, 0.0), |best, own| {
                        if own.0 < best.0 { own } else { best }
                    });
            for &index in group.iter().filter(|index| !kept.contains(index)) {
                screened += 1;
                let (value, se) = worst(index);
                // Three standard errors of the difference.
                assert!(
                    value > best.0 - 3.0 * se.hypot(best.1),
                    "{:?} {value} {best:?}",
                    layouts[index].label
                );
            }
        }
        assert!(screened > 10, "{screened} of {}", layouts.len());
    }
}
