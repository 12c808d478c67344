//! Designs by the points that they share.

use std::collections::{BTreeMap, HashMap};
use std::sync::atomic::AtomicBool;

use fem_client::solver::Solver;
use placement::estimate::Workload;
use placement::points::worker_threads::in_parallel;

use service::forecast::many_designs::key_number;
use service::study_document::stored_plan;
use store::queue::design_rows::DesignRow;

/// Returns what designs ask of a solver; none of one that can't be planned, which fails by itself. Nothing when it is stopped meanwhile.
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

/// Designs by their places, those that share a point in one group.
///
/// A forest, in which each design points to an earlier one of its group, and the first of a group to itself.
#[derive(Debug, Default)]
pub struct Groups {
    earlier: Vec<usize>,
    /// First design with each key, which a number stands for: two keys of one number put two designs into a group, nothing else.
    first_with: HashMap<u64, u32>,
}

impl Groups {
    /// Adds the next design, by the keys of the points that it asks for.
    ///
    /// # Panics
    /// Beyond 2^32 designs.
    pub fn add<'k>(&mut self, keys: impl Iterator<Item = &'k str>) {
        let index = self.earlier.len();
        self.earlier.push(index);
        let own = u32::try_from(index).expect("designs are counted in 32 bits");
        for key in keys {
            let other = *self.first_with.entry(key_number(key)).or_insert(own);
            let (one, other) = (self.root(index), self.root(other as usize));
            self.earlier[one.max(other)] = one.min(other);
        }
    }

    /// The groups, each in the order of its designs.
    pub fn into_groups(mut self) -> Vec<Vec<usize>> {
        let mut groups: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        for index in 0..self.earlier.len() {
            groups.entry(self.root(index)).or_default().push(index);
        }
        groups.into_values().collect()
    }

    /// The first of a design's group; the ways that were long are shorter afterwards.
    fn root(&mut self, mut index: usize) -> usize {
        while self.earlier[index] != index {
            self.earlier[index] = self.earlier[self.earlier[index]];
            index = self.earlier[index];
        }
        index
    }
}

#[cfg(test)]
mod tests {
    use std::time::{Duration, Instant};

    use super::*;

    #[test]
    fn designs_that_share_a_point_stay_together_in_their_order() {
        let keys = |lists: &[&[&str]]| {
            let mut groups = Groups::default();
            for list in lists {
                groups.add(list.iter().copied());
            }
            groups.into_groups()
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
        let keys: Vec<String> = (0..=DESIGNS).map(|index| index.to_string()).collect();
        let grouped = |lists: &mut dyn Iterator<Item = &[String]>| {
            let mut groups = Groups::default();
            lists.for_each(|list| groups.add(list.iter().map(String::as_str)));
            groups.into_groups()
        };
        let begun = Instant::now();
        let forward = grouped(&mut keys.windows(2));
        let backward = grouped(&mut keys.windows(2).rev());
        // The last one joins all others, which stood alone until then.
        let all = &keys[..DESIGNS];
        let joined = grouped(&mut all.chunks(1).chain([all]));
        assert_eq!((forward.len(), backward.len(), joined.len()), (1, 1, 1));
        assert_eq!(forward[0].len(), DESIGNS);
        assert!(
            begun.elapsed() < Duration::from_secs(30),
            "{:?}",
            begun.elapsed()
        );
    }
}
