//! Error of a table, by solves that it wasn't made of.

use fem_client::solver::Response;

use crate::layout::solving::layout_fields::samples;
use crate::layout::solving::mirror_parts::image;
use crate::response_table::solved_table::{ResponseTable, Weights};
use crate::response_table::table_scenes::Pressing;
use crate::score::scaled_errors::Errors;
use layouts::arrangement::FilmKind;
use layouts::field::hermite::{DEGREES, Turn};
use results::TableError;

/// Readings of a kind of film at both solves of a pair, by the table or by the solves.
type Both = [Vec<f64>; 2];

/// Compares a table with pairs of solves that differ by their load alone. None without pairs.
pub(crate) fn table_error(
    table: &ResponseTable,
    kinds: &[FilmKind],
    pairs: &[[(Pressing, &Response); 2]],
) -> Option<TableError> {
    let (mut signals, mut over_angle, mut over_depth) = Default::default();
    let mut force_worst = 0.0f64;
    for (number, kind) in kinds.iter().enumerate() {
        let compared: Option<Vec<(Both, Both, f64)>> = pairs
            .iter()
            .map(|pair| both(table, number, kind, kinds, pair))
            .collect();
        add(
            &compared?,
            table.largest_of_kind(number),
            [&mut signals, &mut over_angle, &mut over_depth],
        );
    }
    for (pressing, response) in pairs.iter().flatten() {
        let found = table.force_n(&weights(table, pressing));
        for (found, solved) in found.iter().zip(response.force_n?) {
            force_worst = force_worst.max((found - solved).abs() / table.largest_load_n());
        }
    }
    (!pairs.is_empty()).then(|| TableError {
        solves: 2 * pairs.len(),
        signal_rms: signals.rms(),
        signal_worst: signals.worst(),
        angle_slope_rms: over_angle.rms(),
        angle_slope_worst: over_angle.worst(),
        depth_slope_rms: over_depth.rms(),
        depth_slope_worst: over_depth.worst(),
        force_worst,
    })
}

/// Returns what the table and the solves say of a pair, and by how much its depths differ, mm.
fn both(
    table: &ResponseTable,
    number: usize,
    kind: &FilmKind,
    kinds: &[FilmKind],
    pair: &[(Pressing, &Response); 2],
) -> Option<(Both, Both, f64)> {
    let found = pair.map(|(pressing, _)| table.samples(number, &weights(table, &pressing)));
    let [first, second] =
        pair.map(|(_, response)| samples(&image(kinds, [false; 2], &response.rings)?, kind, kinds));
    let [low, high] = pair.map(|(pressing, _)| table.depth_of_load_mm(pressing.load_n));
    Some((found, [first?, second?], high - low))
}

/// Adds the errors of one kind of film: of its signals, and of their slopes over angle and depth.
fn add(
    compared: &[(Both, Both, f64)],
    largest: f64,
    [signals, over_angle, over_depth]: [&mut Errors; 3],
) {
    let angle_slopes = |samples: &Vec<f64>| -> Vec<f64> {
        let turn = Turn::new(samples.clone());
        (0..DEGREES)
            .map(|degree| turn.slope(degree as f64 - 180.0))
            .collect()
    };
    let depth_slopes = |[low, high]: &Both, apart: f64| -> Vec<f64> {
        low.iter()
            .zip(high)
            .map(|(low, high)| (high - low) / apart)
            .collect()
    };
    let of_solves = |slopes: &dyn Fn(&Both, f64) -> Vec<f64>| {
        let all = compared
            .iter()
            .flat_map(|(_, solved, apart)| slopes(solved, *apart));
        all.fold(f64::MIN_POSITIVE, |largest: f64, slope| {
            largest.max(slope.abs())
        })
    };
    let both_angles =
        |both: &Both, _: f64| both.iter().flat_map(angle_slopes).collect::<Vec<f64>>();
    let (steepest, fastest) = (of_solves(&both_angles), of_solves(&depth_slopes));
    for (found, solved, apart) in compared {
        signals.compare(&found.concat(), &solved.concat(), largest);
        over_angle.compare(
            &both_angles(found, *apart),
            &both_angles(solved, *apart),
            steepest,
        );
        over_depth.compare(
            &depth_slopes(found, *apart),
            &depth_slopes(solved, *apart),
            fastest,
        );
    }
}

fn weights(table: &ResponseTable, pressing: &Pressing) -> Weights {
    let depth_mm = table.depth_of_load_mm(pressing.load_n);
    let largest = table.largest_shift_mm(depth_mm);
    table.weights(depth_mm, pressing.shares.map(|share| share * largest))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::response_table::solved_table::tests::{answers_to, table_of};
    use crate::response_table::table_scenes::TableScenes;
    use fem_client::scene::Scene;

    fn compared(spoil: impl Fn(&mut Response)) -> TableError {
        let kinds = [FilmKind::point(0.0, 90.0), FilmKind::point(30.0, 40.0)];
        let (table, settings) = table_of(&kinds, 0.5);
        let scenes = TableScenes::new(&Scene::default(), settings);
        let tested = scenes.tested();
        let answers: Vec<[(Pressing, Response); 2]> = tested
            .iter()
            .map(|pair| {
                pair.map(|pressing| {
                    let mut response = answers_to(&kinds, &pressing);
                    spoil(&mut response);
                    (pressing, response)
                })
            })
            .collect();
        let pairs: Vec<_> = answers
            .iter()
            .map(|pair| {
                pair.each_ref()
                    .map(|(pressing, response)| (*pressing, response))
            })
            .collect();
        table_error(&table, &kinds, &pairs).expect("pairs")
    }

    #[test]
    fn a_table_that_is_right_has_no_error() {
        let error = compared(|_| ());
        assert_eq!(error.solves, 20);
        for value in [
            error.signal_worst,
            error.angle_slope_worst,
            error.depth_slope_worst,
            error.force_worst,
        ] {
            assert!(value < 1e-9, "{error:?}");
        }
    }

    /// The largest signal of the kind along y at the crown is 1.5, by the depth.
    #[test]
    fn what_the_solves_say_otherwise_is_told() {
        let error = compared(|response| {
            response.rings[0].strain.y[100] += 0.15;
            response.reaction_n += 1.0;
            response.force_n = response.force_n.map(|[x, y, z]| [x, y - 0.3, z]);
        });
        assert!((error.signal_worst - 0.1).abs() < 1e-9, "{error:?}");
        // One sample of 360 of one of two kinds.
        assert!((error.signal_rms - 0.1 / 720f64.sqrt()).abs() < 1e-9);
        assert!((error.force_worst - 0.01).abs() < 1e-9);
        // Both solves of a pair are off by the same: a slope over the depth isn't.
        assert!(error.depth_slope_worst < 1e-9 && error.angle_slope_worst > 0.01);
    }
}
