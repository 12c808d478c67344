//! Do claimed errors cover the true ones where values have few digits, cut lines are flat, or runs fail? Each method on families of models whose
//! indices are known by quadrature, through the text of a table, as `strainsite gsa analyse` reads it. The table of `docs/proof/hard-runs.md`.
//!
//! `cargo run --release -p lab --example hard_runs`, a minute; with `-- develop` the families that constants were set on.

mod families;

use std::collections::BTreeMap;

use crate::families::model::Model;
use crate::families::{develop, held_out};
use documents::own_model::value_table::ValueTable;
use gsa::campaign::Campaign;
use gsa::method::analysis::Analysis;
use gsa::method::{Kind, Method};
use ndarray::Array2;

/// Draws of each family.
const SEEDS: u64 = 12;
/// Error of the quadrature behind the true indices.
const REFERENCE: f64 = 2e-4;

/// Group of models whose runs would fail where none was made.
const UNMET: &str = "a failing corner that no run met";

/// Claims of one group of families by one method.
#[derive(Debug, Clone, Default)]
struct Tally {
    outputs: usize,
    /// Outputs without indices, or with an error of 1, which says nothing.
    unknown: usize,
    /// Outputs whose largest error is covered.
    covered: usize,
    indices: usize,
    /// Indices that are covered each by its own error.
    covered_indices: usize,
    ratios: Vec<f64>,
    missed: Vec<String>,
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let develop = std::env::args().any(|argument| argument == "develop");
    let sets = match develop {
        true => &develop::SETS[..],
        false => &[held_out::FAMILIES],
    };
    let of_seed = |seed| sets.iter().map(move |set| (seed, set));
    let models: Vec<(u64, Model)> = (0..SEEDS)
        .flat_map(of_seed)
        .flat_map(|(seed, set)| set.all(seed).into_iter().map(move |model| (seed, model)))
        .collect();
    let mut tallies: BTreeMap<(&str, &str), Tally> = BTreeMap::new();
    for kind in Kind::ALL {
        for (seed, model) in &models {
            let (found, failed) = ask(model, method(kind, *seed))?;
            let group = match failed == 0 && model.group.starts_with("failed") {
                true => UNMET,
                false => model.group,
            };
            let met = (group != UNMET).then_some("all that a run met");
            for group in [Some(group), Some("all"), met].into_iter().flatten() {
                let tally = tallies.entry((group, kind.as_str())).or_default();
                tally.add(*seed, model, &found);
            }
        }
    }
    print(&tallies);
    Ok(())
}

fn method(kind: Kind, seed: u64) -> Method {
    Method {
        seed: seed + 1,
        most_runs: 250,
        samples: if kind == Kind::Saltelli { 256 } else { 120 },
        ..Method::of(kind)
    }
}

/// Asks and tells until the method has enough, through the text that a simulator would write; the answer, and how many runs failed.
fn ask(model: &Model, method: Method) -> Result<(Analysis, usize), Box<dyn std::error::Error>> {
    let mut campaign = Campaign::new(&model.inputs, method)?;
    loop {
        let mut text = "id,y\n".to_owned();
        for (id, x) in campaign.points().iter().enumerate() {
            text.push_str(&format!("{id},{}\n", model.written(x)));
        }
        let table = ValueTable::from_csv(&text).map_err(|faults| format!("{faults:?}"))?;
        let values: Array2<f64> = table.leading_rows();
        let found = campaign.tell(&values.view())?.remove(0);
        if campaign.points().len() == values.nrows() {
            let failed = values.iter().filter(|y| !y.is_finite()).count();
            let found = match table.half_units()[0] {
                exact if exact <= 0.0 => found,
                half_unit => found.of_printed(half_unit),
            };
            return Ok((found, failed));
        }
    }
}

impl Tally {
    fn add(&mut self, seed: u64, model: &Model, found: &Analysis) {
        self.outputs += 1;
        let (Some(first_order), Some(claimed)) = (&found.first_order, &found.error.by_input) else {
            self.unknown += 1;
            return;
        };
        let total = found.error.total.unwrap_or(1.0);
        if total >= 1.0 {
            self.unknown += 1;
            return;
        }
        let errors = model.errors(first_order);
        let largest = errors.iter().copied().fold(0.0, f64::max);
        self.indices += errors.len();
        let pairs = errors.iter().zip(claimed);
        self.covered_indices += pairs.filter(|(e, c)| **e <= **c + REFERENCE).count();
        self.ratios.push(total / largest.max(REFERENCE));
        if largest <= total + REFERENCE {
            self.covered += 1;
        } else {
            let name = format!("{} {seed}: {total:.0e} for {largest:.0e}", model.name);
            self.missed.push(name);
        }
    }
}

fn print(tallies: &BTreeMap<(&str, &str), Tally>) {
    println!("| group | method | outputs | no claim | covered | index by index | claimed/true |");
    println!("| --- | --- | --- | --- | --- | --- | --- |");
    for ((group, method), tally) in tallies {
        let mut ratios = tally.ratios.clone();
        ratios.sort_by(f64::total_cmp);
        let claims = tally.outputs - tally.unknown;
        let share = |part: usize, of: usize| match of {
            0 => "-".to_owned(),
            of => format!("{:.0} %", 100.0 * part as f64 / of as f64),
        };
        println!(
            "| {group} | {method} | {} | {} | {} | {} | {} |",
            tally.outputs,
            tally.unknown,
            share(tally.covered, claims),
            share(tally.covered_indices, tally.indices),
            ratios
                .get(ratios.len() / 2)
                .map_or("-".to_owned(), |ratio| format!("{ratio:.1}")),
        );
    }
    for ((group, method), tally) in tallies
        .iter()
        .filter(|((group, _), _)| !group.starts_with("all"))
    {
        for missed in &tally.missed {
            eprintln!("missed by {method}, {group}: {missed}");
        }
    }
}
