//! The tables of a study's answer, column by column.
//!
//! Every row ends with the study, the hash of its document and the version of the program, so that rows of several studies can
//! be put under each other. Strains have no unit, as in all data; other columns carry theirs in their names.

use fem_client::solver::FilmCondition;
use fem_client::solver::direction::Direction;
use placement::result::{
    CandidateFilm, InputReport, Output, RankedLayout, RankedLocation, SignalError, SignalRow,
    StudyResult,
};
use placement::score::location_scores::{Figure, SCORES, Score};
use placement::study::position_name;

use super::export_choice::Table;
use super::force_tables::{forces, published};
use super::table::{Rows, TypedTable};
use super::unit::{PURE, unit_of};
use crate::views::point_views::EvaluationView;

/// A table of a result; `points` are read for [`Table::Points`] alone.
pub fn table(table: Table, result: &StudyResult, points: &[EvaluationView]) -> TypedTable {
    match table {
        Table::Indices => signed(indices(result), result),
        Table::Locations => signed(locations(&result.locations), result),
        Table::Layouts => signed(layouts(&result.layouts), result),
        Table::Candidates => {
            let films = result
                .layout_findings
                .as_ref()
                .map(|found| &found.candidates[..]);
            signed(candidates(films.unwrap_or_default()), result)
        }
        Table::Points => signed(solved(&result.inputs, points), result),
        Table::Signals => signed(signals(result), result),
        Table::Forces => signed(forces(result), result),
        Table::Published => signed(published(result), result),
    }
}

/// With the columns that say where the rows are from.
fn signed<T>(rows: Rows<T>, result: &StudyResult) -> TypedTable {
    let study = &result.study;
    rows.constant("study", &study.id)
        .constant("spec_sha256", &study.spec_sha256)
        .constant("version", &study.version)
        .table()
}

/// One strain and one input.
type Index<'r> = (&'r Output, usize, &'r InputReport);

fn indices(result: &StudyResult) -> Rows<Index<'_>> {
    let of_output = |output| {
        let inputs = result.inputs.iter().enumerate();
        inputs.map(move |(k, input)| (output, k, input))
    };
    let at = |list: &Option<Vec<f64>>, k: usize| list.as_ref().and_then(|l| l.get(k)).copied();
    Rows::of(result.outputs.iter().flat_map(of_output))
        .text("location", |(output, ..)| Some(&output.location))
        .text("direction", |(output, ..)| Some(output.direction.as_str()))
        .text("input", |(.., input)| Some(&input.name))
        .float("first_order", PURE, |(o, k, _)| at(&o.first_order, *k))
        .float("total", PURE, |(o, k, _)| at(&o.total, *k))
        .float("error_mesh", PURE, |(output, ..)| output.error.mesh)
        .float("error_quadrature", PURE, |(o, ..)| o.error.quadrature)
        .float("error_decomposition", PURE, |(o, ..)| o.error.decomposition)
        .float("error_total", PURE, |(output, ..)| output.error.total)
        .float("mean_strain", PURE, |(output, ..)| output.mean)
        .float("std_strain", PURE, |(output, ..)| output.std)
        .text("method", |(output, ..)| Some(output.method.as_str()))
        .text("status", |(output, ..)| Some(output.status.as_str()))
        .float("mdrm_first_order", PURE, |(o, k, _)| {
            at(&o.mdrm_first_order, *k)
        })
}

fn locations(locations: &[RankedLocation]) -> Rows<&RankedLocation> {
    let rows = Rows::of(locations)
        .integer("rank", |l| Some(l.rank))
        .text("name", |l| Some(&l.name))
        .text("input", |l| l.input.as_deref());
    let mut rows = figures(rows, |score, d| Some(score.field(d)), |figure| figure.value);
    for direction in Direction::ALL {
        rows = rows.integer(&format!("rank_{direction}"), |l| l.ranks[direction]);
    }
    let rows = rows.bool("rank_certain", |l| Some(l.rank_certain));
    figures(rows, Score::error_field, |figure| figure.error)
}

/// A column for each score and direction that has this part.
fn figures(
    mut rows: Rows<&RankedLocation>,
    name: fn(&Score, Direction) -> Option<String>,
    part: fn(Figure) -> Option<f64>,
) -> Rows<&RankedLocation> {
    for score in SCORES {
        for direction in Direction::ALL {
            if let Some(name) = name(score, direction) {
                let unit = unit_of(&name);
                rows = rows.float(name, unit, |l| part(l.scores.of_score(score)[direction]));
            }
        }
    }
    rows
}

/// A layout with its films in one text.
type Layout<'r> = (&'r RankedLayout, String);

/// Each layout at the load where its error is largest.
fn layouts(layouts: &[RankedLayout]) -> Rows<Layout<'_>> {
    let rows = Rows::of(
        layouts
            .iter()
            .map(|layout| (layout, layout.films.join("+"))),
    )
    .integer("rank", |(layout, _)| Some(layout.rank))
    .float("spacing_deg", "deg", |(layout, _)| layout.spacing_deg)
    .integer("units", |(layout, _)| Some(layout.units))
    .text("position", |(layout, _)| Some(&layout.position))
    .text("films", |(_, films)| Some(films))
    .float("weakest_signal_strain", PURE, |(l, _)| {
        l.score.weakest_signal
    })
    .float("worst_angle_error_deg", "deg", |(l, _)| {
        l.score.worst_angle_error_deg
    })
    .float("rms_angle_error_deg", "deg", |(l, _)| {
        l.score.rms_angle_error_deg
    })
    .float("worst_depth_error_mm", "mm", |(l, _)| {
        l.score.worst_depth_error_mm
    })
    .float("noise_strain", PURE, |(l, _)| Some(l.score.noise_strain))
    .text("reason", |(layout, _)| layout.score.reason.as_deref());
    simulated(rows)
}

/// What estimates of simulated contacts are worth, and how sure that is.
fn simulated(rows: Rows<Layout<'_>>) -> Rows<Layout<'_>> {
    rows.bool("rank_certain", |(layout, _)| layout.rank_certain)
        .text("name", |(layout, _)| layout.name.as_deref())
        .bool("staggered", |(layout, _)| Some(layout.staggered))
        .integer("film_count", |(layout, _)| layout.film_count)
        .float("bayes_angle_error_deg", "deg", |(l, _)| {
            l.score.bayes_angle_error_deg
        })
        .float("simulated_rms_angle_error_deg", "deg", |(l, _)| {
            l.score.simulated_rms_angle_error_deg
        })
        .float("simulated_p95_angle_error_deg", "deg", |(l, _)| {
            l.score.simulated_p95_angle_error_deg
        })
        .float("simulated_p95_error_deg", "deg", |(l, _)| {
            l.score.error.as_ref()?.simulated_p95_angle_error_deg
        })
        .float("lost_share", PURE, |(l, _)| l.score.lost_share)
        .float("simulated_rms_depth_error_mm", "mm", |(l, _)| {
            l.score.simulated_rms_depth_error_mm
        })
        .float("force_error_n", "N", |(l, _)| l.score.force_error_n)
        .float("alike_sigmas", PURE, |(l, _)| {
            Some(l.score.alike.as_ref()?.sigmas)
        })
        .float("worst_angle_mesh_error_deg", "deg", |(l, _)| {
            l.score.error.as_ref()?.worst_angle_error_deg
        })
        .text("doubt", |(layout, _)| layout.doubt.as_deref())
        .float("shear_angle_error_deg", "deg", |(l, _)| {
            l.score.shear.as_ref()?.worst_angle_error_deg
        })
        .float("shear_force_x_error_n", "N", |(l, _)| sheared(l, 0))
        .float("shear_force_y_error_n", "N", |(l, _)| sheared(l, 1))
        .float("shear_force_z_error_n", "N", |(l, _)| sheared(l, 2))
        .text("shear_reason", |(layout, _)| {
            layout.score.shear.as_ref()?.reason.as_deref()
        })
}

/// Bound of a force with shear unknown, N.
fn sheared(layout: &RankedLayout, axis: usize) -> Option<f64> {
    layout.score.shear.as_ref()?.worst_force_error_n?[axis]
}

/// Kinds of film by several criteria.
fn candidates(films: &[CandidateFilm]) -> Rows<&CandidateFilm> {
    Rows::of(films.iter())
        .float("section_deg", "deg", |film| Some(film.section_deg))
        .text("direction", |film| Some(&film.direction))
        .float("length_mm", "mm", |film| film.length_mm)
        .float("width_mm", "mm", |film| film.width_mm)
        .float("signal", PURE, |film| Some(film.signal))
        .float("angle_information", "1/deg", |film| {
            Some(film.angle_information)
        })
        .float("angle_information_error", "1/deg", |film| {
            film.angle_information_error
        })
        .float("depth_information", "1/mm", |film| {
            Some(film.depth_information)
        })
        .float("effective_independence", PURE, |film| {
            Some(film.effective_independence)
        })
        .integer("pivot_rank", |film| film.pivot_rank)
        .float("centre_std", PURE, |film| Some(film.centre_std))
}

/// One column per input and two per location; locations are those of the first point that has any.
fn solved<'r>(inputs: &[InputReport], points: &'r [EvaluationView]) -> Rows<&'r EvaluationView> {
    let seen = points.iter().find_map(|point| point.locations.as_ref());
    let names = seen
        .into_iter()
        .flatten()
        .map(|location| location.name.as_str());
    let mut rows = Rows::of(points)
        .integer("ordinal", |point| Some(point.ordinal))
        .text("level", |point| point.level.as_deref());
    for (k, input) in inputs.iter().enumerate() {
        rows = rows.float(&input.name, unit_of(&input.vary), |point| {
            point
                .values
                .as_ref()
                .and_then(|values| values.get(k))
                .copied()
        });
    }
    rows = rows.float("reaction_n", "N", |point| point.reaction_n);
    for name in names {
        let at = |point: &EvaluationView| {
            let mut all = point.locations.iter().flatten();
            all.find(|location| location.name == name).cloned()
        };
        for direction in Direction::ALL {
            rows = rows.float(format!("{name}_strain_{direction}"), PURE, |point| {
                Some(at(point)?.strain[direction])
            });
        }
    }
    rows.integer("newton_iterations", |point| point.newton_iterations)
        .float("wall_s", "s", |point| Some(point.wall_s))
        .text("reason", |point| point.reason.as_deref())
        .text("key", |point| Some(&point.key))
}

/// What each film reads of each pressing; no row where the study asks for no signals.
fn signals(result: &StudyResult) -> Rows<&SignalRow> {
    let rows = result.signals.iter().flat_map(|signals| &signals.rows);
    let error =
        |part: fn(&SignalError) -> f64| move |row: &&SignalRow| row.error.as_ref().map(part);
    Rows::of(rows)
        .text("tire", |row| Some(&row.tire))
        .text("film", |row| Some(row.film.as_str()))
        .text("position", |row| Some(position_name(row.position)))
        .text("direction", |row| Some(row.direction.as_str()))
        .text("over", |row| Some(row.over.as_str()))
        .float("load_n", "N", |row| Some(row.load_n))
        .float("pressure_mpa", "MPa", |row| Some(row.pressure_mpa))
        .float("contact_deg", "deg", |row| Some(row.contact_deg))
        .float("depth_mm", "mm", |row| row.depth_mm)
        .float("strain", PURE, |row| row.strain)
        .float("tension_1_n_per_mm", "N/mm", |row| row.tension_1_n_per_mm)
        .float("charge_nc", "nC", |row| row.charge_nc)
        .float("open_circuit_v", "V", |row| row.open_circuit_v)
        .float("output_v", "V", |row| row.output_v)
        .float("output_std_v", "V", |row| row.output_std_v)
        .text("state", |row| row.state.map(FilmCondition::as_str))
        .float("strain_error", PURE, error(|error| error.strain))
        .float("charge_error_nc", "nC", error(|error| error.charge_nc))
        .float(
            "open_circuit_error_v",
            "V",
            error(|error| error.open_circuit_v),
        )
        .float("output_error_v", "V", error(|error| error.output_v))
        .text("reason", |row| row.reason.as_deref())
}
