//! Groups of points that are left out together.

/// Groups of cross validation.
pub(super) const FOLDS: usize = 8;

/// The groups, with the second of two mirror images in the first one's.
pub(super) fn with_images(groups: &[usize], images: &[usize]) -> Vec<usize> {
    let first = |k: usize| images.get(k).map_or(k, |&image| image.min(k));
    (0..groups.len()).map(|k| groups[first(k)]).collect()
}

/// Returns the group of each point. Groups are equally large and follow the order of the multiples of the golden ratio modulo 1: points of Sobol's
/// sequence at equal strides lie in one slab of each input, to which all others would have to extrapolate.
pub(super) fn groups(count: usize) -> Vec<usize> {
    let place = |k: usize| (k as f64 * std::f64::consts::GOLDEN_RATIO).fract();
    let mut order: Vec<usize> = (0..count).collect();
    order.sort_by(|a, b| place(*a).total_cmp(&place(*b)));
    let mut groups = vec![0; count];
    for (rank, k) in order.into_iter().enumerate() {
        groups[k] = rank * FOLDS.min(count) / count;
    }
    groups
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn groups_are_equal_and_no_slab_of_sobols_points() {
        for count in [5, 8, 20, 101] {
            let groups = groups(count);
            for group in 0..FOLDS.min(count) {
                let size = groups.iter().filter(|g| **g == group).count();
                assert!(size == count / FOLDS || size == count.div_ceil(FOLDS));
            }
        }
        // one remainder by eight would be a slab
        let groups = groups(64);
        for group in 0..FOLDS {
            let members = (0..64usize).filter(|k| groups[*k] == group);
            let remainders: std::collections::HashSet<usize> = members.map(|k| k % 8).collect();
            assert!(remainders.len() > 2, "{remainders:?}");
        }
    }
}
