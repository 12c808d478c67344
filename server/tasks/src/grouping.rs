//! Designs by the points that they share.

use std::collections::{BTreeMap, HashMap};
use std::sync::atomic::AtomicBool;

use fem_client::solver::Solver;
use placement::estimate::Workload;
use placement::points::worker_threads::in_parallel;

use service::study_document::stored_plan;
use store::queue::design_rows::DesignRow;

/// Returns what designs ask of a solver; what can't be planned fails by itself. Nothing when it is stopped meanwhile.
pub fn workloads(
    designs: &[&DesignRow],
    solver: &dyn Solver,
    threads: usize,
    stop: &AtomicBool,
) -> Option<Vec<Option<Workload>>> {
    let workload = |design: &DesignRow| {
        let planned = stored_plan(&design.study).ok()?;
        Some(Workload::of(&planned, solver))
    };
    in_parallel(designs.len(), threads, stop, |i| workload(designs[i]))
}

/// Keys of the points that a design asks for; none where it has no plan.
pub fn keys(work: &Option<Workload>) -> Vec<String> {
    let keys = work.iter().flat_map(Workload::keys);
    keys.map(str::to_owned).collect()
}

/// Designs by their places, those that share a key in one group.
///
/// A forest, in which each design points to an earlier one of its group, and the first of a group to itself.
pub fn grouped(designs: impl Iterator<Item = Vec<String>>) -> Vec<Vec<usize>> {
    let mut earlier: Vec<usize> = Vec::new();
    let mut first_with: HashMap<String, usize> = HashMap::new();
    for (index, keys) in designs.enumerate() {
        earlier.push(index);
        for key in keys {
            let other = *first_with.entry(key).or_insert(index);
            let (one, other) = (root(&mut earlier, index), root(&mut earlier, other));
            earlier[one.max(other)] = one.min(other);
        }
    }
    let mut groups: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for index in 0..earlier.len() {
        groups
            .entry(root(&mut earlier, index))
            .or_default()
            .push(index);
    }
    groups.into_values().collect()
}

/// The first of a design's group; the ways that were long are shorter afterwards.
fn root(earlier: &mut [usize], mut index: usize) -> usize {
    while earlier[index] != index {
        earlier[index] = earlier[earlier[index]];
        index = earlier[index];
    }
    index
}

#[cfg(test)]
mod tests {
    use std::time::{Duration, Instant};

    use super::*;

    #[test]
    fn designs_that_share_a_point_stay_together_in_their_order() {
        let keys = |lists: &[&[&str]]| {
            let owned = |list: &&[&str]| list.iter().map(|key| (*key).to_owned()).collect();
            grouped(lists.iter().map(owned).collect::<Vec<_>>().into_iter())
        };
        assert_eq!(keys(&[&["a"], &["b"], &["a"]]), [vec![0, 2], vec![1]]);
        // The third joins the first two.
        assert_eq!(
            keys(&[&["a"], &["b"], &["b", "a"], &["c"]]),
            [vec![0, 1, 2], vec![3]]
        );
        assert_eq!(
            keys(&[&["a", "x"], &["b"], &["b", "a"], &["x"]]),
            [vec![0, 1, 2, 3]]
        );
        assert_eq!(keys(&[&[], &[]]), [vec![0], vec![1]]);
    }

    #[test]
    fn a_long_chain_of_designs_is_grouped_as_quickly_as_it_is_read() {
        // Each design shares a key with the next: moving a group's keys to the next one's would take an hour.
        const DESIGNS: usize = 100_000;
        let chain = |index: usize| vec![index.to_string(), (index + 1).to_string()];
        let begun = Instant::now();
        let forward = grouped((0..DESIGNS).map(chain));
        let backward = grouped((0..DESIGNS).rev().map(chain));
        // The last one joins all others, which stood alone until then.
        let all = (0..DESIGNS).map(|index| index.to_string()).collect();
        let alone = (0..DESIGNS).map(|index| vec![index.to_string()]);
        let joined = grouped(alone.chain([all]));
        assert_eq!((forward.len(), backward.len(), joined.len()), (1, 1, 1));
        assert_eq!(forward[0].len(), DESIGNS);
        assert!(
            begun.elapsed() < Duration::from_secs(30),
            "{:?}",
            begun.elapsed()
        );
    }
}
