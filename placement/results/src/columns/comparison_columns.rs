//! Columns of studies side by side: of their locations, and of the designs themselves.
//!
//! What any design sets is a column more, which only a comparison itself knows.

use fem_client::solver::direction::Direction;

use super::answer_table::Table;
use super::figure_column::Column;

/// Columns for rows of a location and its study.
pub fn compared_locations() -> Table {
    let mut columns = vec![
        Column::text("location", "/row/location"),
        Column::integer("rank", "/row/rank"),
        Column::bool("rank_certain", "/row/rank_certain"),
        Column::integer("rank_change", "/row/rank_change"),
        Column::text("rank_verdict", "/row/rank_verdict"),
    ];
    for direction in Direction::ALL {
        let float = |name: &str| {
            Column::float(
                &format!("{name}_{direction}"),
                &format!("/row/{direction}/{name}"),
            )
            .in_unit("%")
        };
        columns.extend(
            [
                "gsi_percent",
                "error_percent",
                "difference_percent",
                "difference_error_percent",
            ]
            .map(float),
        );
        columns.push(Column::text(
            &format!("verdict_{direction}"),
            &format!("/row/{direction}/verdict"),
        ));
    }
    columns.extend(origin());
    Table {
        name: "compared_locations",
        parts: &[
            ("row", "ComparedLocation"),
            ("study", "ComparedStudy"),
            ("comparison", "Comparison"),
        ],
        columns,
    }
}

/// Columns for rows of a study.
pub fn designs() -> Table {
    let mut columns = vec![
        Column::text("state", "/study/state"),
        Column::text("reason", "/study/reason"),
        Column::integer("answer_rank", "/study/answer/rank"),
        Column::text("layout", "/study/answer/words"),
        Column::integer("film_count", "/study/answer/film_count"),
        Column::bool("meets", "/study/answer/meets"),
    ];
    let claims = [
        "/study/answer/angle_deg/error",
        "/study/answer/angle_deg/difference_error",
    ];
    columns.extend(compared_figure("angle", "deg", claims));
    let claims = [
        "/study/answer/force_n/error",
        "/study/answer/force_n/difference_error",
    ];
    columns.extend(compared_figure("force", "n", claims));
    columns.push(
        Column::text("layout_verdict", "/study/answer/verdict")
            .titled("certainty", 0)
            .in_view("answers"),
    );
    columns.extend([
        Column::text("level", "/study/level"),
        Column::float("reaction_n", "/study/reaction_n"),
        Column::float("std_strain_x", "/study/std_strain_x"),
        Column::float("std_strain_y", "/study/std_strain_y"),
        Column::text("best", "/study/best"),
        Column::bool("best_certain", "/study/best_certain"),
        Column::float("layout_spacing_deg", "/study/layout_spacing_deg"),
        Column::text("layout_position", "/study/layout_position"),
        Column::integer("solves", "/study/cost/solves"),
        Column::integer("coarser_solves", "/study/cost/coarser_solves"),
        Column::integer("effect_solves", "/study/cost/effect_solves"),
        Column::integer("reused", "/study/cost/reused"),
        Column::float("wall_s", "/study/cost/wall_s"),
        Column::float("cpu_s", "/study/cost/cpu_s"),
    ]);
    columns.extend(origin());
    Table {
        name: "designs",
        parts: &[("study", "ComparedStudy"), ("comparison", "Comparison")],
        columns,
    }
}

/// Columns of a layout's figure and of its difference from the baseline's, whose claimed errors are there.
fn compared_figure(name: &str, unit: &str, claims: [&'static str; 2]) -> [Column; 5] {
    let at = |field: &str| format!("/study/answer/{name}_{unit}/{field}");
    let float = |part: &str, at: &str| Column::float(&format!("{name}_{part}_{unit}"), at);
    let shown = |part: &str, field: &str, title: &str| {
        float(part, &at(field)).titled(title, 2).in_view("answers")
    };
    let [claim, difference_error] = claims;
    [
        shown("error", "value", name).with_error(claim),
        float("claim", claim),
        shown("difference", "difference", &format!("{name}, difference"))
            .with_error(difference_error),
        float("difference_error", difference_error),
        Column::text(&format!("{name}_verdict"), &at("verdict")),
    ]
}

/// Columns of the document, the program, and the study beside which it stands.
fn origin() -> [Column; 3] {
    [
        Column::text("spec_sha256", "/study/spec_sha256"),
        Column::text("version", "/study/version"),
        Column::text("baseline", "/comparison/baseline"),
    ]
}
