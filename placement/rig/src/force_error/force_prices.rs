//! Prices of a force's error in films.

use results::{ForcePrice, RankedLayout};

/// Returns for each force the layouts by which it is known better than by any with as many films or fewer, the cheapest first. A force that no film tells has
/// none.
pub fn force_prices(layouts: &[RankedLayout]) -> Vec<ForcePrice> {
    let mut all: Vec<ForcePrice> = layouts.iter().flat_map(of_layout).collect();
    all.sort_by(|a, b| {
        let by_axis = a.axis.cmp(&b.axis).then(a.films.cmp(&b.films));
        by_axis.then(a.rmse_n.total_cmp(&b.rmse_n))
    });
    let mut prices: Vec<ForcePrice> = Vec::new();
    for price in all {
        let last = prices.last().filter(|last| last.axis == price.axis);
        if last.is_none_or(|last| price.rmse_n < last.rmse_n) {
            prices.push(price);
        }
    }
    prices
}

fn of_layout(layout: &RankedLayout) -> Vec<ForcePrice> {
    let films = layout.film_count;
    let of_force = |force: &results::ForceError| {
        let rmse_n = force.fresh.rmse_n.filter(|_| force.useful)?;
        Some(ForcePrice {
            axis: force.axis.clone(),
            films,
            rmse_n,
            layout_rank: layout.rank,
        })
    };
    let known = layout.force_error.iter().flatten();
    known.filter_map(of_force).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bump_response::BumpResponse;
    use crate::force_error::layout_forces::tests::errors_of;

    fn layout(rank: usize, films: usize, rmse_n: f64, useful: bool) -> RankedLayout {
        let mut vertical = errors_of(&BumpResponse::new(2)).swap_remove(2);
        vertical.fresh.rmse_n = Some(rmse_n);
        vertical.useful = useful;
        RankedLayout {
            rank,
            film_count: films,
            force_error: Some(vec![vertical]),
            ..RankedLayout::default()
        }
    }

    #[test]
    fn only_layouts_that_no_cheaper_one_beats_are_named() {
        let layouts = [
            layout(1, 12, 2.0, true),
            layout(2, 6, 3.0, true),
            layout(3, 8, 3.5, true),
            layout(4, 24, 1.0, false),
            layout(5, 12, 2.5, true),
            layout(6, 48, 1.5, true),
        ];
        let found: Vec<(usize, f64, usize)> = force_prices(&layouts)
            .into_iter()
            .map(|price| (price.films, price.rmse_n, price.layout_rank))
            .collect();
        assert_eq!(found, [(6, 3.0, 2), (12, 2.0, 1), (48, 1.5, 6)]);
        assert!(force_prices(&[layout(1, 6, 1.0, false)]).is_empty());
    }
}
