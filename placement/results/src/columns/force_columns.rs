//! Columns of how well each layout tells each force, learnt from a virtual rig, and of the models that a fit judges.

use super::answer_table::Table;
use super::figure_column::Column;

/// Columns for rows of [`forces`](super::table_rows::forces).
pub fn forces() -> Table {
    let mut columns = vec![
        Column::integer("layout_rank", "/layout/rank").titled("rank", 0),
        Column::integer("films", "/layout/film_count"),
        Column::text("force", "/force/axis").in_view("known"),
        Column::text("chosen", "/force/chosen"),
        Column::text("features", "/force/features"),
        Column::bool("useful", "/force/useful"),
        Column::float("leak", "/force/leak").in_view("leak"),
        Column::float("bound_n", "/force/floor_n").titled("bound", 2),
    ];
    for (name, title, at) in [
        ("fresh", "", "/force/fresh"),
        ("contact", "in contact", "/force/in_contact"),
        ("dead", "one dead", "/force/dead/error"),
        ("askew", "films off", "/force/askew/error"),
    ] {
        columns.extend(trial(name, title, at));
    }
    columns.extend([
        Column::float("left_out_rmse_n", "/left_out/rmse_n"),
        Column::float("left_out_nrmse_percent", "/left_out/nrmse_percent"),
        Column::float("mean_nrmse_percent", "/left_out/mean_nrmse_percent"),
        Column::float("worst_contact_deg", "/force/worst_contact/deg")
            .titled("worst contact", 1)
            .in_view("where"),
        Column::float("worst_contact_rmse_n", "/force/worst_contact/rmse_n")
            .titled("off by there", 2)
            .in_view("where"),
        Column::text("reason", "/force/reason"),
    ]);
    Table {
        name: "forces",
        parts: &[
            ("layout", "RankedLayout"),
            ("force", "ForceError"),
            ("left_out", "SplitError"),
        ],
        columns,
    }
}

/// Columns for rows of [`force_on`](super::table_rows::force_on), for people alone.
pub fn elsewhere() -> Table {
    let shown = |column: Column, title: &str, digits: usize| {
        let column = column.titled(title, digits).in_view("other tires");
        column.unexported()
    };
    let columns = vec![
        shown(Column::float("rmse_n", "/other/error/rmse_n"), "off by", 2),
        shown(
            Column::float("own_rmse_n", "/force/fresh/rmse_n"),
            "on its own tire",
            2,
        ),
        shown(
            Column::share("coverage", "/other/error/coverage"),
            "covered",
            0,
        ),
        shown(
            Column::share("outside", "/other/error/outside"),
            "flagged",
            0,
        ),
    ];
    Table {
        name: "elsewhere",
        parts: &[("force", "ForceError"), ("other", "ElsewhereError")],
        columns,
    }
}

/// Columns for rows of [`force_with`](super::table_rows::force_with), for people alone.
pub fn drifts() -> Table {
    let shown = |name: &str, at: &str, title: &str, digits: usize| {
        let column = Column::float(name, at).titled(title, digits);
        column.in_view("drift").unexported()
    };
    let columns = vec![
        shown("rmse_n", "/drift/error/rmse_n", "off by", 2),
        shown("nrmse_percent", "/drift/error/nrmse_percent", "NRMSE", 1),
        shown("in_contact", "/drift/in_contact/rmse_n", "in contact", 2),
    ];
    Table {
        name: "drifts",
        parts: &[("force", "ForceError"), ("drift", "DriftError")],
        columns,
    }
}

/// Columns for rows of a force and one of its models, as reports of fits have them.
pub fn models() -> Table {
    let judged = |name: &str, title: &str, digits: usize| {
        let column = Column::float(name, &format!("/model/validation/{name}"));
        column.titled(title, digits).in_view("judged")
    };
    let mut columns = vec![
        Column::text("force", "/force/force"),
        Column::text("model", "/model/model"),
        Column::text("features", "/model/features"),
        Column::bool("chosen", "/chosen").described("Whether it estimates the force."),
        Column::text("by", "/model/validation/by"),
        judged("rmse_n", "RMSE", 3),
        judged("nrmse_percent", "NRMSE", 2),
        judged("mean_nrmse_percent", "mean's NRMSE", 2),
        judged("r2", "R2", 3),
        judged("coverage", "covered", 2),
        judged("width_n", "width", 3),
        Column::float("rmse_low_n", "/model/validation/rmse_interval_n/0"),
        Column::float("rmse_high_n", "/model/validation/rmse_interval_n/1"),
    ];
    for (split, title) in [
        ("random", "random rows"),
        ("cycle", "cycles"),
        ("run", "runs"),
        ("time", "later rows"),
        ("frequency", "frequencies"),
    ] {
        let at = format!("/model/splits/{split}/rmse_n");
        let column = Column::float(&format!("{split}_rmse_n"), &at);
        columns.push(column.titled(title, 3).in_view("splits"));
    }
    columns.extend([
        Column::float("leak_factor", "/model/leak_factor")
            .titled("leak", 2)
            .in_view("leak"),
        Column::bool("better_than_mean", "/model/better_than_mean"),
    ]);
    Table {
        name: "models",
        parts: &[("force", "ForceReport"), ("model", "ModelReport")],
        columns,
    }
}

/// Figures of estimates against true forces; with what is changed in their title, the error alone is in the view.
fn trial(name: &str, changed: &str, at: &str) -> [Column; 4] {
    let float = |figure: &str, title: &str, digits: usize| {
        let title = format!("{changed} {title}");
        let column = Column::float(&format!("{name}_{figure}"), &format!("{at}/{figure}"));
        column.titled(title.trim(), digits)
    };
    let figures = [
        float(
            "rmse_n",
            if changed.is_empty() {
                "learnt, off by"
            } else {
                ""
            },
            2,
        ),
        float("nrmse_percent", "NRMSE", 1),
        float("r2", "R2", 2),
        float("coverage", "covered", 2),
    ];
    let mut shown = if changed.is_empty() { figures.len() } else { 1 };
    figures.map(|column| {
        if shown == 0 {
            return column;
        }
        shown -= 1;
        column.in_view("known")
    })
}
