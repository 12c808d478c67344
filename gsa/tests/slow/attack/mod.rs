//! An attack on the claimed errors: every method on models chosen to mislead, and on a held-out set.

mod draw;
mod exact;
mod held_out;
mod misleading;
mod shapes;

use std::collections::BTreeMap;

use gsa::campaign::Campaign;
use gsa::method::analysis::Analysis;
use gsa::method::{Kind, Method};

use crate::asking::until_enough;
use crate::known::{Known, quantile};

/// An analysis: claimed and true error of the first-order indices (the latter no less than the rounding floor), runs.
struct Outcome {
    seed: u64,
    claimed: f64,
    truth: f64,
    runs: usize,
}

impl Outcome {
    fn covered(&self) -> bool {
        self.truth <= self.claimed
    }
}

/// Most points of a full grid that are worth the time here.
const MOST_OF_GRID: usize = 1000;

/// Asks and tells until the method has what it needs; `None` if it would need too much of a model of so many inputs.
fn campaign(known: &Known, method: Method) -> Option<(Analysis, usize)> {
    let grid = method.nodes.saturating_pow(known.inputs.len() as u32);
    if method.kind == Kind::Tensor && grid > MOST_OF_GRID {
        return None;
    }
    let campaign = Campaign::new(&known.inputs, method).ok()?;
    Some(until_enough(campaign, &known.model))
}

fn coverage<'a>(outcomes: impl Iterator<Item = &'a Outcome>) -> f64 {
    let (mut covered, mut all) = (0, 0);
    for outcome in outcomes {
        all += 1;
        covered += usize::from(outcome.covered());
    }
    100.0 * f64::from(covered as u32) / f64::from(all)
}

/// The method's outcomes, with a table of them.
fn attack(title: &str, method: Method, models: &[(u64, Known)]) -> Vec<Outcome> {
    let mut table: BTreeMap<&str, Vec<Outcome>> = BTreeMap::new();
    let mut silent: BTreeMap<&str, usize> = BTreeMap::new();
    for (seed, known) in models {
        let seed = *seed;
        let Some((found, runs)) = campaign(known, Method { seed, ..method }) else {
            continue;
        };
        let (Some(first_order), Some(claimed)) = (&found.first_order, found.error.total) else {
            *silent.entry(known.family).or_default() += 1;
            continue;
        };
        assert!(
            first_order.iter().all(|s| (0.0..=1.0 + 1e-12).contains(s)) && claimed.is_finite(),
            "{} {seed}: {found:?}",
            known.family
        );
        let truth = known.error_of(first_order).max(found.error.floor);
        table.entry(known.family).or_default().push(Outcome {
            seed,
            claimed,
            truth,
            runs,
        });
    }
    print(title, &table, &silent);
    table.into_values().flatten().collect()
}

/// Coverage in per cent and the median of claimed over true error.
fn summary(outcomes: &[Outcome]) -> (f64, f64) {
    let ratio = quantile(outcomes.iter().map(|o| o.claimed / o.truth).collect(), 0.5);
    let covered = coverage(outcomes.iter());
    let count = outcomes.len();
    println!("all {count} outputs: {covered:.1} % covered, median claimed/true {ratio:.1}");
    (covered, ratio)
}

fn print(title: &str, table: &BTreeMap<&str, Vec<Outcome>>, silent: &BTreeMap<&str, usize>) {
    println!(
        "\n{title}\n{:26} covered  claimed/true  median true     claimed   runs  missed seeds",
        "family"
    );
    for (family, outcomes) in table {
        let of = |value: fn(&Outcome) -> f64| quantile(outcomes.iter().map(value).collect(), 0.5);
        let missed = outcomes.iter().filter(|o| !o.covered());
        let missed: Vec<String> = missed
            .map(|o| format!("{}: {:.0e} for {:.0e}", o.seed, o.claimed, o.truth))
            .collect();
        println!(
            "{family:26} {:5.0} %       {:8.2}      {:.1e}     {:.1e}  {:5.0}  {}",
            coverage(outcomes.iter()),
            of(|o| o.claimed / o.truth),
            of(|o| o.truth),
            of(|o| o.claimed),
            of(|o| o.runs as f64),
            missed.join(", ")
        );
    }
    for (family, count) in silent {
        println!("{family:26} no indices in {count}");
    }
}

/// Every family by seed.
fn models(seeds: std::ops::Range<u64>, all: fn(u64) -> Vec<Known>) -> Vec<(u64, Known)> {
    let of_seed = |seed| all(seed).into_iter().map(move |known| (seed, known));
    seeds.flat_map(of_seed).collect()
}

fn method(kind: Kind, nodes: usize) -> Method {
    Method {
        nodes,
        most_runs: 250,
        samples: if kind == Kind::Saltelli { 256 } else { 120 },
        ..Method::of(kind)
    }
}

/// Method, nodes and seeds, with the least coverage and the largest median ratio allowed.
type Row = (Kind, usize, std::ops::Range<u64>, f64, f64);

/// Runs the rows on their models, and returns what misses its limits; pools them all at the end.
fn judge(rows: &[Row], all: fn(u64) -> Vec<Known>) -> Vec<String> {
    let most = rows.iter().map(|(_, _, seeds, ..)| seeds.end).max();
    let models = models(0..most.unwrap_or(0), all);
    let (mut pooled, mut beyond) = (Vec::new(), Vec::new());
    for (kind, nodes, seeds, least_coverage, largest_ratio) in rows {
        let title = format!("{}, {nodes} nodes", kind.as_str());
        let count = models
            .iter()
            .filter(|(seed, _)| seeds.contains(seed))
            .count();
        let outcomes = attack(&title, method(*kind, *nodes), &models[..count]);
        let (covered, ratio) = summary(&outcomes);
        pooled.extend(outcomes);
        if covered < *least_coverage || ratio > *largest_ratio {
            beyond.push(title);
        }
    }
    println!("\nall methods");
    let (covered, ratio) = summary(&pooled);
    if covered < 95.0 || ratio > 10.0 {
        beyond.push("all methods".to_owned());
    }
    beyond
}

/// The aim is 95 % at a median of ten. One family is out of reach, "rare corner": an effect in 1/600 of the volume meets no point, and
/// everything else is reproduced to rounding. It is 3 % of the outputs, and 5 % of those that a full grid is affordable for, of which
/// its nodes see the corner and claim too little.
#[test]
fn claimed_errors_hold_on_misleading_models() {
    let rows = [
        (Kind::Mdrm, 3, 0..20, 95.0, 10.0),
        (Kind::Mdrm, 5, 0..20, 95.0, 10.0),
        (Kind::Mdrm, 7, 0..20, 95.0, 10.0),
        (Kind::Mdrm, 9, 0..20, 95.0, 10.0),
        (Kind::Bivariate, 5, 0..20, 95.0, 10.0),
        (Kind::Tensor, 5, 0..20, 94.0, 10.0),
        (Kind::Pce, 5, 0..4, 95.0, 10.0),
        (Kind::Saltelli, 5, 0..4, 95.0, 10.0),
        (Kind::Auto, 5, 0..8, 95.0, 10.0),
    ];
    let beyond = judge(&rows, misleading::all);
    assert!(beyond.is_empty(), "{beyond:?}");
}

/// Samples of 4096 know the indices to a few thousandths: formulas and references of the held-out models belong together. 95 % intervals
/// of the largest of several indices are exceeded now and then, hardly ever twofold.
#[test]
fn held_out_references_agree_with_samples() {
    let sampled = Method {
        samples: 4096,
        ..Method::of(Kind::Saltelli)
    };
    for known in held_out::all(0) {
        let (found, _) = campaign(&known, sampled).expect("a campaign");
        let (Some(first_order), Some(claimed)) = (&found.first_order, found.error.total) else {
            panic!("{}: {found:?}", known.family);
        };
        let error = known.error_of(first_order);
        assert!(
            error <= 2.0 * claimed,
            "{}: {error} {claimed}",
            known.family
        );
    }
}

/// Shares and medians seen when the models were new, after all constants had been set, rounded to the safe side: they say what to
/// expect of claims on models that nothing was set on. All methods together cover 98 % at a median of 9.5. Smooth models are the many
/// here, and five nodes claim a kink's error for them.
#[test]
fn claimed_errors_hold_on_held_out_models() {
    let rows = [
        (Kind::Mdrm, 3, 0..4, 95.0, 10.0),
        (Kind::Mdrm, 5, 0..4, 95.0, 11.0),
        (Kind::Mdrm, 7, 0..4, 95.0, 14.0),
        (Kind::Mdrm, 9, 0..4, 95.0, 11.0),
        (Kind::Bivariate, 5, 0..4, 95.0, 21.0),
        (Kind::Tensor, 5, 0..4, 94.0, 26.0),
        (Kind::Pce, 5, 0..4, 95.0, 10.0),
        (Kind::Saltelli, 5, 0..4, 94.0, 10.0),
        (Kind::Auto, 5, 0..4, 95.0, 12.0),
    ];
    let beyond = judge(&rows, held_out::all);
    assert!(beyond.is_empty(), "{beyond:?}");
}
