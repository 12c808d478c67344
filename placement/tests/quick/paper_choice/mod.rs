//! M-DRM at 26 solves against the full grid of 3125: the figures of `docs/proof/paper-choice/README.md`.

mod grid;

use self::grid::{Grid, difference, mdrm, tensor};

/// P3 x and P3 y among the outputs.
const CENTRE: [usize; 2] = [4, 5];

#[test]
fn the_sum_of_the_lines_holds_and_their_product_does_not() {
    let grid = Grid::new();
    let (truth, runs) = grid.analysed(tensor());
    assert_eq!(runs, 3125);
    let (found, runs) = grid.analysed(mdrm(5, 1));
    assert_eq!(runs, 26);
    for (output, (truth, found)) in truth.iter().zip(&found).enumerate() {
        let exact = truth.first_order.as_ref().expect("indices");
        let total = truth.total.as_ref().expect("indices");
        // Interactions have less than a hundredth of the variance everywhere.
        assert!(exact.iter().sum::<f64>() > 0.99, "{output}: {exact:?}");
        assert!(difference(exact, total) < 0.01);
        // What 26 solves say is within a hundredth, and within what they claim.
        let own = found.first_order.as_ref().expect("indices");
        let error = difference(own, exact);
        assert!(error < 0.01, "{output}: {error}");
        assert!(found.error.total.is_some_and(|claimed| claimed > error));
    }
    // The product is off by 6 points at the centre and by a third where the strain's sign changes.
    let product = |output: usize| {
        let exact = truth[output].first_order.as_ref().expect("indices");
        difference(
            found[output].mdrm_first_order.as_ref().expect("indices"),
            exact,
        )
    };
    assert!((product(CENTRE[0]) - 0.064).abs() < 0.001, "{}", product(4));
    assert!((product(2) - 0.342).abs() < 0.001, "{}", product(2));
    let misfit = |output: usize| {
        let deviation = truth[output].variance.expect("a variance").sqrt();
        grid.misfit_of_product(output, deviation)
    };
    // Where the sign changes, the product misses more than there is; the meridional strain at the centre keeps its sign.
    assert!(misfit(2) > 1.0 && misfit(CENTRE[1]) < 0.1);
}

#[test]
fn the_ranking_survives() {
    let grid = Grid::new();
    let (truth, _) = grid.analysed(tensor());
    let (found, _) = grid.analysed(mdrm(5, 1));
    for output in CENTRE {
        let exact = truth[output].first_order.as_ref().expect("indices");
        let own = found[output].first_order.as_ref().expect("indices");
        let product = found[output].mdrm_first_order.as_ref().expect("indices");
        for indices in [exact, own, product] {
            assert!(indices[2] > indices[1] && indices[1] > indices[0]);
            assert!(indices[2] > indices[3] && indices[3] > indices[4]);
        }
    }
}

#[test]
fn claims_cover_the_truth_for_nearly_all_draws_of_the_check_points() {
    let grid = Grid::new();
    let (truth, _) = grid.analysed(tensor());
    let (mut covered, mut all) = (0, 0);
    for seed in 0..100 {
        let (found, _) = grid.analysed(mdrm(5, seed));
        for (truth, found) in truth.iter().zip(&found) {
            let exact = truth.first_order.as_ref().expect("indices");
            let error = difference(found.first_order.as_ref().expect("indices"), exact);
            all += 1;
            covered += usize::from(found.error.total.is_some_and(|claimed| claimed >= error));
        }
    }
    assert!(covered * 100 >= 95 * all, "{covered} of {all}");
}
