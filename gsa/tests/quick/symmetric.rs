//! Models that look the same from both ends: their mirror images have the same indices and errors, to the bit.

use gsa::campaign::Campaign;
use gsa::judge::misses::{Claim, error_of_difference};
use gsa::law::distribution::Distribution;
use gsa::method::analysis::Analysis;
use gsa::method::{Kind, Method};
use ndarray::Array2;

const EXCHANGE: [usize; 5] = [4, 3, 2, 1, 0];
/// A place, the centre, the place's mirror image.
const OUTPUTS: [usize; 3] = [2, 1, 0];

fn reversed(x: &[f64]) -> Vec<f64> {
    x.iter().rev().copied().collect()
}

/// Neither a product nor a sum, with a kink; `skew` changes its interactions.
fn place(skew: f64, x: &[f64]) -> f64 {
    let bend = (x[1] + 0.4 * x[0] - 1.3).max(0.0);
    (0.7 * x[1] + 0.3 * x[2]).exp() + skew * x[0] * x[1] * x[3] + bend - (x[4] * x[2]).sin()
}

fn model(skew: f64, x: &[f64]) -> [f64; 3] {
    let back = reversed(x);
    let half = |x: &[f64]| place(skew, x) + 2.0 * x[2] * x[0];
    [place(skew, x), half(x) + half(&back), place(skew, &back)]
}

fn laws() -> Vec<Distribution> {
    vec![Distribution::uniform(0.7, 1.3).expect("a valid law"); 5]
}

fn values(points: &[Vec<f64>], skew: f64) -> Array2<f64> {
    let values: Vec<f64> = points.iter().flat_map(|x| model(skew, x)).collect();
    Array2::from_shape_vec((points.len(), 3), values).expect("three columns")
}

fn campaign(kind: Kind) -> Campaign {
    let method = Method {
        nodes: if kind == Kind::Tensor { 3 } else { 5 },
        samples: 64,
        ..Method::of(kind)
    };
    let mut campaign = Campaign::new(&laws(), method).expect("a valid campaign");
    loop {
        let asked = campaign.points().len();
        campaign
            .tell(&values(campaign.points(), 0.5).view())
            .expect("rules exist");
        if campaign.points().len() == asked {
            return campaign;
        }
    }
}

fn analyses(campaign: &Campaign, skew: f64) -> Vec<Analysis> {
    let symmetric = campaign.symmetric(&EXCHANGE).expect("equal laws");
    let values = values(campaign.points(), skew);
    symmetric
        .analyse(&values.view(), &OUTPUTS)
        .expect("rules exist")
}

/// All that belongs to inputs, and all that doesn't.
fn numbers(found: &Analysis) -> (Vec<Vec<f64>>, Vec<Option<f64>>) {
    let of_inputs = [
        &found.first_order,
        &found.total,
        &found.mdrm_first_order,
        &found.mdrm_total,
        &found.error.by_input,
    ];
    let error = &found.error;
    let parts = [error.quadrature, error.decomposition, error.sampling];
    (
        of_inputs.into_iter().flatten().cloned().collect(),
        [found.mean, found.variance, error.total, Some(error.floor)]
            .into_iter()
            .chain(parts)
            .collect(),
    )
}

#[test]
fn mirror_images_have_the_same_numbers_to_the_bit_by_every_method() {
    for kind in Kind::ALL {
        let found = analyses(&campaign(kind), 0.5);
        for (output, image) in OUTPUTS.into_iter().enumerate() {
            assert_eq!(found[output].method, found[image].method, "{kind:?}");
            let (of_inputs, others) = numbers(&found[output]);
            let (of_image, others_of_image) = numbers(&found[image]);
            assert!(of_inputs.len() >= 3, "{kind:?}: {:?}", found[output]);
            assert_eq!(others, others_of_image, "{kind:?}");
            for (own, of_image) in of_inputs.iter().zip(&of_image) {
                assert_eq!(own, &reversed(of_image), "{kind:?}");
            }
        }
        let pairs = found[1].second_order.as_ref();
        if let Some(pairs) = pairs.filter(|_| kind != Kind::Saltelli) {
            // 12 with 45, 13 with 35, 14 with 25, 23 with 34.
            for (pair, image) in [(0, 9), (1, 8), (2, 6), (4, 7)] {
                assert_eq!(pairs[pair], pairs[image], "{kind:?}");
            }
        }
    }
}

#[test]
fn the_indices_of_lines_stay_and_the_errors_are_those_of_twice_as_many_points() {
    let campaign = campaign(Kind::Mdrm);
    let alone = campaign
        .analyse(&values(campaign.points(), 0.5).view())
        .unwrap();
    let found = analyses(&campaign, 0.5);
    for (own, with_images) in alone.iter().zip(&found) {
        let (own_s, s) = (
            own.first_order.as_ref().unwrap(),
            with_images.first_order.as_ref().unwrap(),
        );
        // Equal but for the order of sums, and values that are known twice.
        assert!(own_s.iter().zip(s).all(|(a, b)| (a - b).abs() < 1e-14));
    }
    let [own, with_images] = [&alone[1], &found[1]].map(|a| a.misses.as_ref().unwrap().errors());
    // The centre's own input learns nothing new from the mirror images; the others learn as much as from their own points.
    assert!(
        (own[2] - with_images[2]).abs() < 1e-14,
        "{own:?} {with_images:?}"
    );
    let worst = |i: usize| own[i].max(own[4 - i]);
    assert!(
        (0..2).all(|i| with_images[i] < worst(i)),
        "{own:?} {with_images:?}"
    );
    assert_eq!(
        found[1].misses.as_ref().unwrap().images,
        [5, 6, 7, 8, 9, 0, 1, 2, 3, 4]
    );
}

#[test]
fn differences_of_mirror_images_have_the_same_error_to_the_bit() {
    let campaign = campaign(Kind::Mdrm);
    let (ours, theirs) = (analyses(&campaign, 0.5), analyses(&campaign, 0.45));
    let claim = |found: &[Analysis], input: usize| found[1].error.by_input.as_ref().unwrap()[input];
    let of_input = |input: usize| {
        let [a, b] = [&ours, &theirs].map(|found| Claim {
            error: claim(found, input),
            misses: found[1].misses.as_ref(),
        });
        (error_of_difference(input, a, b), a.error.hypot(b.error))
    };
    for input in 0..2 {
        let ((error, apart), (of_image, _)) = (of_input(input), of_input(4 - input));
        assert!(
            error == of_image && error < 0.5 * apart,
            "{error} {of_image} {apart}"
        );
    }
}

#[test]
fn a_lost_run_costs_its_mirror_image_too_and_is_named_once() {
    let campaign = campaign(Kind::Mdrm);
    let symmetric = campaign.symmetric(&EXCHANGE).unwrap();
    let mut values = values(campaign.points(), 0.5);
    let last = values.nrows() - 1;
    values.row_mut(last).fill(f64::NAN);
    let found = symmetric.analyse(&values.view(), &OUTPUTS).unwrap();
    assert_eq!(found[1].misses.as_ref().unwrap().residuals.len(), 8);
    let reason = found[1].reason.as_ref().unwrap();
    assert!(
        reason.ends_with(&format!("without a finite value: {last}")),
        "{reason}"
    );
    // A line's run has its mirror image among the runs, which tells its values.
    let node = campaign.design().unwrap().lines()[0].ordinals()[0];
    values.row_mut(node).fill(f64::NAN);
    let without = symmetric.analyse(&values.view(), &OUTPUTS).unwrap();
    assert_eq!(without[1].first_order, found[1].first_order);
}

#[test]
fn what_is_no_exchange_of_equal_inputs_is_no_symmetry() {
    let campaign = campaign(Kind::Mdrm);
    for no_exchange in [&[0, 1, 2][..], &[1, 2, 0, 3, 4], &[9, 1, 2, 3, 4]] {
        assert!(campaign.symmetric(no_exchange).is_none());
    }
    let mut laws = laws();
    laws[4] = Distribution::uniform(0.7, 1.4).unwrap();
    for kind in [Kind::Mdrm, Kind::Pce] {
        let lopsided = Campaign::new(&laws, Method::of(kind)).unwrap();
        assert!(lopsided.symmetric(&EXCHANGE).is_none());
        assert!(lopsided.symmetric(&[0, 3, 2, 1, 4]).is_some());
    }
}

#[test]
fn points_that_are_run_at_both_ends_are_named() {
    let campaign = campaign(Kind::Mdrm);
    let symmetric = campaign.symmetric(&EXCHANGE).unwrap();
    let pairs: Vec<(usize, usize)> = symmetric.pairs().collect();
    let points = campaign.points();
    assert!(
        pairs
            .iter()
            .all(|&(k, l)| points[k] == reversed(&points[l]))
    );
    // The cut point, four nodes of the centre's line, and eight of the others against their images.
    assert_eq!(pairs.iter().filter(|(k, l)| k == l).count(), 5);
    assert_eq!(pairs.len(), 5 + 8);
}
