//! Columns of ranked layouts, each at the load where its error is largest, and of kinds of film.

use documents::layouts::layout_settings::{STRAIN_UNIT, VOLT_UNIT};

use super::answer_table::Table;
use super::figure_column::Column;

/// Columns for rows of [`trade`](super::table_rows::trade).
pub fn trade() -> Table {
    let columns = vec![
        Column::integer("film_count", "/trade/film_count").titled("films", 0),
        Column::text("layout", "/trade/words"),
        Column::float("angle_error_deg", "/trade/angle_error_deg")
            .titled("angle, 95 %", 2)
            .in_view("trade")
            .with_error("/trade/angle_claim_deg"),
        Column::float("angle_claim_deg", "/trade/angle_claim_deg"),
        Column::float("force_error_n", "/trade/force_error_n")
            .titled("force, rms", 2)
            .in_view("trade")
            .with_error("/trade/force_claim_n"),
        Column::float("force_claim_n", "/trade/force_claim_n"),
        Column::float("cost", "/trade/cost"),
        Column::bool("meets", "/trade/meets"),
        Column::bool("is_front", "/trade/is_front"),
        Column::integer("rank", "/trade/rank"),
    ];
    Table {
        name: "trade",
        parts: &[("trade", "TradeRow")],
        columns,
    }
}

/// Columns for rows of [`films`](super::table_rows::films).
pub fn films() -> Table {
    let columns = vec![
        Column::integer("film", "/film/number"),
        Column::float("theta_deg", "/film/theta_deg").titled("angle", 1),
        Column::float("arc_mm", "/film/arc_mm").titled("arc from the mark", 1),
        Column::float("phi_deg", "/film/phi_deg").titled("section", 1),
        Column::float("from_bead_mm", "/film/from_bead_mm").titled("from the bead", 1),
        Column::float("from_crown_mm", "/film/from_crown_mm"),
        Column::text("direction", "/film/direction"),
        Column::float("length_mm", "/film/length_mm").titled("length", 1),
        Column::float("width_mm", "/film/width_mm").titled("width", 1),
        Column::float("connector_arc_mm", "/film/connector_arc_mm"),
        Column::float("connector_from_bead_mm", "/film/connector_from_bead_mm"),
        Column::float("lead_mm", "/film/lead_mm").titled("lead", 0),
        Column::float("expected_strain", "/film/expected_strain"),
        Column::float("expected_v", "/film/expected_v"),
        Column::float("expected_depth_mm", "/film/expected_depth_mm"),
    ];
    Table {
        name: "films",
        parts: &[("film", "SheetFilm")],
        columns,
    }
}

/// Columns for rows of [`layouts`](super::table_rows::layouts).
pub fn layouts() -> Table {
    let columns = vec![
        Column::integer("rank", "/layout/rank"),
        Column::float("spacing_deg", "/layout/spacing_deg").titled("spacing", 1),
        Column::integer("units", "/layout/units"),
        Column::text("position", "/layout/position"),
        Column::text("films", "/layout/films"),
        Column::float("weakest_signal_strain", "/layout/score/weakest_signal").of_unit(STRAIN_UNIT),
        Column::float("weakest_signal_v", "/layout/score/weakest_signal").of_unit(VOLT_UNIT),
        Column::float(
            "worst_angle_error_deg",
            "/layout/score/worst_angle_error_deg",
        )
        .titled("angle bound", 2)
        .in_view("bound"),
        Column::float("rms_angle_error_deg", "/layout/score/rms_angle_error_deg"),
        Column::float("worst_depth_error_mm", "/layout/score/worst_depth_error_mm"),
        Column::float("noise_strain", "/layout/score/noise_strain"),
        Column::float("noise_v", "/layout/score/noise_v"),
        Column::text("reason", "/layout/score/reason"),
        Column::bool("rank_certain", "/layout/rank_certain").titled("certain", 0),
        Column::text("name", "/layout/name"),
        Column::bool("staggered", "/layout/staggered"),
        Column::integer("film_count", "/layout/film_count")
            .titled("films", 0)
            .in_view("ranked"),
        Column::float(
            "bayes_angle_error_deg",
            "/layout/score/bayes_angle_error_deg",
        ),
        Column::float(
            "simulated_rms_angle_error_deg",
            "/layout/score/simulated_rms_angle_error_deg",
        ),
        Column::float(
            "simulated_p95_angle_error_deg",
            "/layout/score/simulated_p95_angle_error_deg",
        )
        .titled("angle, 95 %", 2)
        .in_view("ranked")
        .with_error("/layout/score/error/simulated_p95_angle_error_deg"),
        Column::float(
            "simulated_p95_error_deg",
            "/layout/score/error/simulated_p95_angle_error_deg",
        ),
        Column::share("lost_share", "/layout/score/lost_share")
            .titled("lost", 1)
            .in_view("ranked"),
        Column::float(
            "simulated_rms_depth_error_mm",
            "/layout/score/simulated_rms_depth_error_mm",
        ),
        Column::float("force_error_n", "/layout/score/force_error_n"),
        Column::float("alike_sigmas", "/layout/score/alike/sigmas")
            .titled("most alike, sigmas", 1)
            .in_view("alike"),
        Column::float(
            "worst_angle_mesh_error_deg",
            "/layout/score/error/worst_angle_error_deg",
        ),
        Column::text("doubt", "/layout/doubt"),
        Column::float(
            "shear_angle_error_deg",
            "/layout/score/shear/worst_angle_error_deg",
        )
        .titled("angle", 2)
        .in_view("shear")
        .with_error("/layout/score/shear/error/worst_angle_error_deg"),
        Column::float(
            "shear_force_x_error_n",
            "/layout/score/shear/worst_force_error_n/0",
        )
        .titled("force along", 2)
        .in_view("shear")
        .with_error("/layout/score/shear/error/worst_force_error_n/0"),
        Column::float(
            "shear_force_y_error_n",
            "/layout/score/shear/worst_force_error_n/1",
        )
        .titled("force across", 2)
        .in_view("shear")
        .with_error("/layout/score/shear/error/worst_force_error_n/1"),
        Column::float(
            "shear_force_z_error_n",
            "/layout/score/shear/worst_force_error_n/2",
        )
        .titled("force up", 2)
        .in_view("shear")
        .with_error("/layout/score/shear/error/worst_force_error_n/2"),
        Column::text("shear_reason", "/layout/score/shear/reason"),
        Column::float(
            "dead_p95_angle_error_deg",
            "/layout/score/dead/simulated_p95_angle_error_deg",
        )
        .titled("angle, 95 %, one dead", 2)
        .in_view("dead")
        .unexported(),
        Column::float("turn_deg", "/layout/turn_deg"),
        Column::float("worst_load_n", "/layout/worst_load_n")
            .titled("worst load", 1)
            .in_view("bound"),
        Column::float("worst_force_error_n", "/layout/worst_force/error_n")
            .titled("force, rms", 2)
            .in_view("ranked")
            .with_error("/layout/worst_force/claim_n"),
        Column::float("worst_force_load_n", "/layout/worst_force/load_n"),
    ];
    Table {
        name: "layouts",
        parts: &[("layout", "RankedLayout")],
        columns,
    }
}

/// Columns for rows of [`candidates`](super::table_rows::candidates).
pub fn candidates() -> Table {
    let columns = vec![
        Column::float("section_deg", "/film/section_deg").titled("section angle", 1),
        Column::text("direction", "/film/direction"),
        Column::float("length_mm", "/film/length_mm").titled("length", 1),
        Column::float("width_mm", "/film/width_mm").titled("width", 1),
        Column::float("signal", "/film/signal").of_unit(STRAIN_UNIT),
        Column::float("signal_v", "/film/signal").of_unit(VOLT_UNIT),
        Column::float("angle_information", "/film/angle_information").in_unit("1/deg"),
        Column::float("angle_information_error", "/film/angle_information_error").in_unit("1/deg"),
        Column::float("depth_information", "/film/depth_information").in_unit("1/mm"),
    ];
    Table {
        name: "candidates",
        parts: &[("film", "CandidateFilm")],
        columns,
    }
}
