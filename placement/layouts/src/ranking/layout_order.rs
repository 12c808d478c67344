//! Scored layouts in their order, and those that no other beats.

use fem_client::solver::Coarser;
use gsa::judge::certainty::{Estimate, places_certain};

use crate::ranking::kendall::tau;
use crate::simulate::simulation::LOST_DEG;
use results::{
    FrontLayout, LayoutError, LayoutLoad, LayoutScore, LoadScore, RankedLayout, ShearError,
    ShearScore, ToldQuantity,
};

/// Claimed errors in standard errors of the simulation.
const DEVIATIONS: f64 = 2.0;
/// Most films that a layout may have.
const MOST_FILMS: f64 = 240.0;
/// Share of a bound from which its error is said.
const DOUBTFUL: f64 = 0.2;
/// Scores nearer than this are equal, relative: mirror images differ by rounding, and by what a simulation of other contacts makes of it.
const EQUAL: f64 = 1e-9;

/// A figure of a layout at a load.
type Figure = fn(&LayoutScore) -> Option<f64>;
/// Figures whose differences between two meshes are judged together.
const BOUNDS: [Figure; 3] = [
    |score| score.worst_angle_error_deg,
    |score| score.rms_angle_error_deg,
    |score| score.worst_depth_error_mm,
];
const SIMULATED: [Figure; 3] = [
    |score| score.simulated_rms_angle_error_deg,
    |score| score.simulated_p95_angle_error_deg,
    |score| score.force_error_n,
];

/// A layout's scores at all loads: those of its mesh, with the errors that a coarser one shows, and those that they have by the surface over contacts.
pub fn with_scores(
    mut label: RankedLayout,
    loads: &[LayoutLoad],
    fine: Vec<LayoutScore>,
    coarse: Option<&(Vec<LayoutScore>, Coarser)>,
) -> RankedLayout {
    let claims = coarse.map(|(coarse, coarser)| {
        let of = |change: f64| coarser.of_largest * change;
        let of_figures = |figures| of(largest_change(&fine, coarse, figures));
        let bounds_and_simulated = [of_figures(&BOUNDS), of_figures(&SIMULATED)];
        (bounds_and_simulated, of(largest_told_change(&fine, coarse)))
    });
    let scored = loads.iter().filter(|load| load.reason.is_none());
    label.loads = scored
        .zip(fine)
        .enumerate()
        .map(|(k, (load, mut score))| {
            let both = coarse.zip(claims);
            score.error = both.map(|((coarse, _), (claims, _))| error(&score, &coarse[k], claims));
            for own in &mut score.told {
                own.claim = claims.zip(own.error_se).map(|((_, of_mesh), error_se)| {
                    (of_mesh * own.error).hypot(DEVIATIONS * error_se)
                });
            }
            if let (Some(shear), Some((coarse, coarser))) = (&mut score.shear, coarse) {
                shear.error = coarse[k]
                    .shear
                    .as_ref()
                    .map(|coarse| shear_error(shear, coarse, coarser.factor));
            }
            LoadScore {
                depth_mm: load.depth_mm,
                load_n: load.load_n,
                score,
            }
        })
        .collect();
    let worst = label
        .loads
        .iter()
        .max_by(|a, b| p95(&a.score).total_cmp(&p95(&b.score)));
    label.score = worst.map_or_else(LayoutScore::default, |load| load.score.clone());
    label.worst_load_n = worst.and_then(|load| load.load_n);
    label.worst_force = label.largest_force_error();
    label.contacts = label.largest_contact_errors();
    label.told = label.largest_told_errors();
    label.doubt = doubt(&label.score);
    label
}

fn p95(score: &LayoutScore) -> f64 {
    score.simulated_p95_angle_error_deg.unwrap_or(f64::INFINITY)
}

/// The largest change of some figures from one mesh to another, at any load, over the larger value: a single one may agree on two meshes by chance.
fn largest_change(fine: &[LayoutScore], coarse: &[LayoutScore], figures: &[Figure]) -> f64 {
    let change = |(fine, coarse): (&LayoutScore, &LayoutScore)| {
        let of_figure = |of: &Figure| relative_change(of(fine)?, of(coarse)?);
        figures.iter().filter_map(of_figure).fold(0.0, f64::max)
    };
    fine.iter().zip(coarse).map(change).fold(0.0, f64::max)
}

/// The largest change from one mesh to another of what is told, at any load, over the larger value.
fn largest_told_change(fine: &[LayoutScore], coarse: &[LayoutScore]) -> f64 {
    let change = |fine: &ToldQuantity, coarse: &LayoutScore| {
        let same = coarse.told.iter().find(|own| own.of == fine.of)?;
        relative_change(fine.error, same.error)
    };
    let pairs = fine.iter().zip(coarse);
    let changes = pairs.flat_map(|(fine, coarse)| {
        let told = fine.told.iter();
        told.filter_map(move |own| change(own, coarse))
    });
    changes.fold(0.0, f64::max)
}

/// Difference of two figures over the larger one; none where that is 0.
fn relative_change(a: f64, b: f64) -> Option<f64> {
    let larger = a.max(b);
    (larger > 0.0).then(|| (a - b).abs() / larger)
}

/// Errors of figures that both meshes have, by what is claimed of bounds and of simulated figures, relative.
fn error(
    fine: &LayoutScore,
    coarse: &LayoutScore,
    [of_bounds, of_simulated]: [f64; 2],
) -> LayoutError {
    let of_mesh = |of: Figure, claim: f64| of(coarse).and_then(|_| Some(claim * of(fine)?));
    let bounds = BOUNDS.map(|of| of_mesh(of, of_bounds));
    let standard_errors = [
        fine.simulated_rms_angle_error_deg_se,
        fine.simulated_p95_angle_error_deg_se,
        fine.force_error_n_se,
    ];
    let surface = fine.error.unwrap_or_default();
    let of_surface = [
        surface.simulated_rms_angle_error_deg,
        surface.simulated_p95_angle_error_deg,
        surface.force_error_n,
    ];
    let simulated: [Option<f64>; 3] = std::array::from_fn(|k| {
        let of_mesh = of_mesh(SIMULATED[k], of_simulated)?;
        let of_chance = DEVIATIONS * standard_errors[k]?;
        Some(of_mesh.hypot(of_chance).hypot(of_surface[k].unwrap_or(0.0)))
    });
    LayoutError {
        worst_angle_error_deg: bounds[0],
        rms_angle_error_deg: bounds[1],
        worst_depth_error_mm: bounds[2],
        simulated_rms_angle_error_deg: simulated[0],
        simulated_p95_angle_error_deg: simulated[1],
        force_error_n: simulated[2],
    }
}

fn shear_error(fine: &ShearScore, coarse: &ShearScore, factor: f64) -> ShearError {
    let of_mesh = |fine: f64, coarse: f64| factor * (fine - coarse).abs();
    let angles = fine.worst_angle_error_deg.zip(coarse.worst_angle_error_deg);
    let forces = fine.worst_force_error_n.zip(coarse.worst_force_error_n);
    ShearError {
        worst_angle_error_deg: angles.map(|(fine, coarse)| of_mesh(fine, coarse)),
        worst_force_error_n: forces
            .map(|(fine, coarse)| std::array::from_fn(|k| Some(of_mesh(fine[k]?, coarse[k]?)))),
    }
}

/// Says which figures have an error beyond a fifth of themselves.
fn doubt(score: &LayoutScore) -> Option<String> {
    let error = score.error.as_ref()?;
    let figures = [
        (
            "the worst bound of the angle",
            score.worst_angle_error_deg,
            error.worst_angle_error_deg,
        ),
        (
            "the bound of the depth",
            score.worst_depth_error_mm,
            error.worst_depth_error_mm,
        ),
        (
            "the simulated 95th percentile",
            score.simulated_p95_angle_error_deg,
            error.simulated_p95_angle_error_deg,
        ),
    ];
    let shares = figures
        .into_iter()
        .filter_map(|(name, value, error)| Some((name, error? / value?)));
    let doubtful = shares.filter(|(_, share)| *share > DOUBTFUL);
    let texts: Vec<String> = doubtful
        .map(|(name, share)| format!("{name} by {:.0} %", 100.0 * share))
        .collect();
    (!texts.is_empty()).then(|| format!("may be off: {}", texts.join(", ")))
}

/// Returns what the order goes by: the simulated 95th percentile at the worst load times the root of the number of films, degrees. The variance falls as
/// one over that number, so that this compares what a film contributes. Where one contact in twenty is lost, another film doesn't count: such layouts come
/// last, by the percentile alone.
fn key(layout: &RankedLayout) -> f64 {
    weighted(layout, p95(&layout.score))
}

/// Returns what an error of so many degrees counts in a layout.
fn weighted(layout: &RankedLayout, error_deg: f64) -> f64 {
    let films = if error_deg <= LOST_DEG {
        films(layout)
    } else {
        MOST_FILMS
    };
    error_deg * films.sqrt()
}

/// Key of the order, with its range.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct OrderKey {
    /// The error times the root of the number of films, degrees; infinite where there is no error.
    pub value: f64,
    /// Distances down and up by which it may be off by the claimed error; `None` where that isn't known. An error that may be beyond the loss of the contact
    /// weighs as such.
    pub off: Option<[f64; 2]>,
}

/// Returns what the order goes by in a layout.
pub(crate) fn order_key(layout: &RankedLayout) -> OrderKey {
    let (value, middle) = (key(layout), p95(&layout.score));
    let error = layout.score.error.as_ref();
    let error = error.and_then(|error| error.simulated_p95_angle_error_deg);
    let off = error.filter(|_| value.is_finite()).map(|error| {
        let [low, high] = [(middle - error).max(0.0), middle + error];
        [
            value - weighted(layout, low),
            weighted(layout, high) - value,
        ]
    });
    OrderKey { value, off }
}

fn films(layout: &RankedLayout) -> f64 {
    layout.film_count as f64
}

/// Puts layouts in order, best first: equal ones share the rank of the first of them and stand in the order in which they came.
pub fn rank(layouts: &mut [RankedLayout]) {
    layouts.sort_by(|a, b| key(a).total_cmp(&key(b)));
    let estimate = |layout: &RankedLayout| {
        let OrderKey { value, off } = order_key(layout);
        Estimate {
            // What is best is greatest.
            value: -value,
            error: off.map_or(f64::INFINITY, |[down, up]| down.max(up)),
        }
    };
    let estimates: Vec<Estimate> = layouts.iter().map(estimate).collect();
    let known: Vec<Estimate> = estimates
        .iter()
        .copied()
        .filter(|estimate| estimate.value.is_finite())
        .collect();
    let mut certain = places_certain(&known, 0.0).into_iter();
    let mut before: Option<(f64, usize)> = None;
    for (row, layout) in layouts.iter_mut().enumerate() {
        let value = key(layout);
        let rank = match before {
            Some((last, rank)) if value - last <= EQUAL * last => rank,
            _ => row + 1,
        };
        (layout.rank, before) = (rank, Some((value, rank)));
        layout.rank_certain = Some(value.is_finite() && certain.next().unwrap_or(false));
    }
}

/// Layouts that no other beats with as few films or fewer, least films first.
pub fn front(layouts: &[RankedLayout]) -> Vec<FrontLayout> {
    let mut order: Vec<usize> = (0..layouts.len()).collect();
    order.sort_by(|&i, &j| {
        films(&layouts[i])
            .total_cmp(&films(&layouts[j]))
            .then(p95(&layouts[i].score).total_cmp(&p95(&layouts[j].score)))
    });
    let mut front: Vec<FrontLayout> = Vec::new();
    for index in order {
        let (error, film_count) = (p95(&layouts[index].score), layouts[index].film_count);
        let best = front
            .last()
            .map_or(f64::INFINITY, |last| last.simulated_p95_angle_error_deg);
        if error < best {
            front.push(FrontLayout {
                film_count,
                simulated_p95_angle_error_deg: error,
                index,
            });
        }
    }
    front
}

/// Kendall's tau between the order by simulation and that by the worst bound, both times the root of the number of films; layouts without a bound come last.
pub fn tau_of_bound(layouts: &[RankedLayout]) -> Option<f64> {
    let simulated: Vec<f64> = layouts.iter().map(key).collect();
    let bound = |layout: &RankedLayout| {
        layout
            .score
            .worst_angle_error_deg
            .map_or(f64::MAX, |worst| worst * films(layout).sqrt())
    };
    let bounds: Vec<f64> = layouts.iter().map(bound).collect();
    tau(&simulated, &bounds)
}

#[cfg(test)]
mod tests {
    use fem_client::scene::Level;

    use super::*;
    use results::ContactError;

    fn layout(film_count: usize, p95: f64, error: f64) -> RankedLayout {
        RankedLayout {
            film_count,
            score: LayoutScore {
                simulated_p95_angle_error_deg: Some(p95),
                worst_angle_error_deg: Some(2.0 * p95),
                error: Some(LayoutError {
                    simulated_p95_angle_error_deg: Some(error),
                    ..LayoutError::default()
                }),
                ..LayoutScore::default()
            },
            ..RankedLayout::default()
        }
    }

    /// The angle is worst at the small load, the force at the large one, and so is what contacts do to each.
    #[test]
    fn each_error_is_told_at_its_own_worst_load() {
        let load = |load_n: f64| LayoutLoad {
            load_n: Some(load_n),
            depth_mm: None,
            force_slope_n_per_mm: None,
            shear: None,
            knees: Vec::new(),
            reason: None,
        };
        let score = |angle: f64, force: f64| LayoutScore {
            simulated_p95_angle_error_deg: Some(angle),
            force_error_n: Some(force),
            contacts: vec![ContactError {
                of: "camber_deg".to_owned(),
                words: "camber".to_owned(),
                p95_angle_error_deg: angle / 2.0,
                force_error_n: force / 2.0,
            }],
            ..LayoutScore::default()
        };
        let label = RankedLayout::default();
        let scores = vec![score(9.0, 0.5), score(1.0, 3.0)];
        let found = with_scores(label, &[load(5.0), load(33.0)], scores, None);
        assert_eq!(found.worst_load_n, Some(5.0));
        assert_eq!(found.score.force_error_n, Some(0.5));
        let force = found.worst_force.expect("a force");
        assert_eq!(
            (force.error_n, force.claim_n, force.load_n),
            (3.0, None, Some(33.0))
        );
        let camber = &found.contacts[0];
        assert_eq!(
            (camber.p95_angle_error_deg, camber.force_error_n),
            (4.5, 1.5)
        );
    }

    #[test]
    fn films_count_and_errors_decide_what_is_certain() {
        let mut layouts = [
            layout(4, 10.0, 0.1),
            layout(16, 4.0, 0.5),
            layout(16, 4.2, 0.5),
            layout(1, 16.0, f64::INFINITY),
        ];
        rank(&mut layouts);
        let shown: Vec<(usize, usize, Option<bool>)> = layouts
            .iter()
            .map(|l| (l.rank, l.film_count, l.rank_certain))
            .collect();
        // 16, 16, 16.8 and 20; those of equal value share their rank.
        assert_eq!(
            shown,
            [
                (1, 16, Some(false)),
                (1, 1, Some(false)),
                (3, 16, Some(false)),
                (4, 4, Some(false))
            ]
        );
        let mut clear = [layout(4, 10.0, 0.1), layout(4, 5.0, 0.1)];
        rank(&mut clear);
        assert_eq!(
            clear.map(|l| (l.rank, l.rank_certain)),
            [(1, Some(true)), (2, Some(true))]
        );
    }

    #[test]
    fn the_front_has_less_error_with_every_film_more() {
        let layouts = [
            layout(12, 2.0, 0.1),
            layout(6, 5.0, 0.1),
            layout(8, 6.0, 0.1),
            layout(12, 3.0, 0.1),
            layout(24, 2.0, 0.1),
        ];
        let found: Vec<(usize, usize)> = front(&layouts)
            .iter()
            .map(|layout| (layout.film_count, layout.index))
            .collect();
        assert_eq!(found, [(6, 1), (12, 0)]);
        assert_eq!(tau_of_bound(&layouts), Some(1.0));
    }

    #[test]
    fn the_worst_load_gives_the_score_and_its_doubt() {
        let load = |depth_mm: f64| LayoutLoad {
            depth_mm: Some(depth_mm),
            load_n: None,
            force_slope_n_per_mm: None,
            shear: None,
            knees: Vec::new(),
            reason: None,
        };
        let of = |p95: f64, se: f64| LayoutScore {
            simulated_p95_angle_error_deg: Some(p95),
            simulated_p95_angle_error_deg_se: Some(se),
            ..LayoutScore::default()
        };
        let mut fine = vec![of(5.0, 0.1), of(9.0, 0.3)];
        fine[0].error = Some(LayoutError {
            simulated_p95_angle_error_deg: Some(0.7),
            ..LayoutError::default()
        });
        let coarse = vec![of(5.5, 0.1), of(10.0, 0.3)];
        let coarser = Coarser {
            level: Level::Coarse,
            factor: 3.0,
            of_largest: 2.0,
        };
        let found = with_scores(
            RankedLayout::default(),
            &[load(2.0), load(1.0)],
            fine,
            Some(&(coarse, coarser)),
        );
        assert_eq!(found.score.simulated_p95_angle_error_deg, Some(9.0));
        let error = found
            .score
            .error
            .and_then(|error| error.simulated_p95_angle_error_deg)
            .expect("an error");
        // A tenth at the worst load, where the other one changed by an eleventh.
        assert!((error - (2.0 * 0.1 * 9.0f64).hypot(0.6)).abs() < 1e-12);
        let at_other = found.loads[0].score.error.as_ref();
        let error = at_other
            .and_then(|error| error.simulated_p95_angle_error_deg)
            .expect("an error");
        // The surface's error comes on top.
        let expected = (2.0 * 0.1 * 5.0f64).hypot(0.2).hypot(0.7);
        assert!((error - expected).abs() < 1e-12);
        assert_eq!(
            found.doubt.as_deref(),
            Some("may be off: the simulated 95th percentile by 21 %")
        );
    }
}
