//! The reference tire against an independent code on that code's meshes: equilibria, its finest mesh in detail, and sensitivity
//! studies; prints Markdown.
//!
//! `cargo run --release -p lab --example independent`, two minutes and 2 GB.

#[path = "../../fem-client/tire/tests/slow/independent/mod.rs"]
mod independent;

use independent::finest::{self, SCALARS, finest};
use independent::five_depths::{Answer, OUTPUTS, Study, studies};

fn main() {
    println!("### Equilibria\n");
    equilibria();
    println!("\n### Its finest mesh, Q2-L3n4\n");
    finest_mesh();
    println!("\n### Its studies\n");
    println!(
        "| study | solves | reaction N, relative | strains | von Mises MPa | product-form indices | additive shares | strains that change sign |"
    );
    println!("| ---{} |", " | ---".repeat(7));
    for study in studies() {
        line(&study, &study.solve());
    }
}

fn equilibria() {
    println!(
        "| case | displacements | depth mm | inflated radius mm, theirs | ours, difference | inflated stretch, largest difference | reaction N, theirs | ours, relative difference | x at P3, theirs | ours, difference | y at P3, theirs | ours, difference | least cord stretch |"
    );
    println!("| ---{} |", " | ---".repeat(12));
    let figures = independent::figures();
    for case in figures.chunk_by(|a, b| a.case == b.case) {
        for (theirs, ours) in case.iter().zip(independent::solve(case)) {
            let (a, b) = (&theirs.solution, &ours.solution);
            let stretch = theirs.inflated_stretch.map_or(String::new(), |stretch| {
                let pairs = stretch.iter().zip(ours.inflated_stretch);
                let differences = pairs.map(|(a, b)| (a - b).abs());
                format!("{:.0e}", differences.fold(0.0, f64::max))
            });
            println!(
                "| {} | {} | {} | {:.5} | {:+.0e} | {} | {:.5} | {:+.0e} | {:.6} | {:+.0e} | {:.6} | {:+.0e} | {:.4} |",
                theirs.case,
                theirs.displacements(),
                theirs.depth_mm,
                a.inflated_radius_mm,
                b.inflated_radius_mm - a.inflated_radius_mm,
                stretch,
                a.reaction_n,
                b.reaction_n / a.reaction_n - 1.0,
                a.x[0],
                b.x[0] - a.x[0],
                a.y[0],
                b.y[0] - a.y[0],
                ours.least_cord_stretch,
            );
        }
    }
}

fn finest_mesh() {
    println!("| quantity | depth mm | theirs | ours, difference |");
    println!("| ---{} |", " | ---".repeat(3));
    let asked = finest();
    for (theirs, ours) in asked.iter().zip(finest::solve(&asked)) {
        let depth = theirs.figures.depth_mm;
        for (k, name) in ["x", "y", "von Mises MPa"].into_iter().enumerate() {
            let pairs = theirs.crown_line.iter().zip(&ours.crown_line);
            let largest = largest(pairs.map(|(a, b)| (a[k + 1], b[k + 1])));
            let points = theirs.crown_line.len();
            println!("| {name} at {points} points of the crown line | {depth} | | {largest:.0e} |");
        }
        for (k, name) in SCALARS.into_iter().enumerate() {
            let (a, b) = (theirs.scalars[k], ours.scalars[k]);
            println!("| {name} | {depth} | {a:.7} | {:+.0e} |", b - a);
        }
    }
}

/// Largest differences of a study.
fn line(study: &Study, answer: &Answer) {
    let rows = |kind: &'static str| study.rows.iter().filter(move |row| row.kind == kind);
    let cut = |output: &str, ours: &[f64]| {
        let row = rows("cut").find(|row| row.output == output);
        let theirs = &row.expect("the table has the cut point").values;
        largest(theirs.iter().copied().zip(ours.iter().copied()))
    };
    let indices = |kind, ours: &[Vec<f64>]| {
        let all = rows(kind).flat_map(|row| {
            let output = OUTPUTS.iter().position(|name| *name == row.output);
            let ours = &ours[output.expect("an output with indices")];
            row.values.iter().copied().zip(ours.iter().copied())
        });
        largest(all)
    };
    let (x, y) = (cut("x", &answer.cut.x), cut("y", &answer.cut.y));
    let reaction = answer.cut.reaction;
    let changing = OUTPUTS.iter().zip(&answer.changes_sign);
    let changing = changing.filter(|(_, changes)| **changes);
    let names: Vec<&str> = changing.map(|(name, _)| *name).collect();
    println!(
        "| {} | {} | {:.0e} | {:.0e} | {:.0e} | {:.0e} | {:.0e} | {} |",
        study.name,
        answer.solves,
        cut("reaction", &[reaction]) / reaction,
        x.max(y),
        cut("von_mises", &answer.cut.von_mises),
        indices("mdrm", &answer.mdrm),
        indices("additive", &answer.additive),
        names.join(", "),
    );
}

fn largest(pairs: impl Iterator<Item = (f64, f64)>) -> f64 {
    pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}
