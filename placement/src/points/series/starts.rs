//! Starts of a series' points: from nothing, or from another point's equilibrium.

/// Starts of the points of a series: another point each, but of the first, which starts from nothing.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Starts {
    /// The start of each; of the first, which has none, itself.
    of: Vec<usize>,
    /// Whether another one starts from each.
    is_left: Vec<bool>,
}

impl Starts {
    /// Makes so many points start from the first one.
    pub(crate) fn from_first(count: usize) -> Self {
        Self::of_each(vec![0; count])
    }

    /// Points that start from these ones of the series; what is said of the first one is ignored.
    ///
    /// # Panics
    /// If a point starts from itself or from one behind it.
    pub(crate) fn of_each(of: Vec<usize>) -> Self {
        let are_before = (1..of.len()).all(|point| of[point] < point);
        assert!(are_before, "a point starts from one before it");
        let mut is_left = vec![false; of.len()];
        of.iter().skip(1).for_each(|start| is_left[*start] = true);
        Self { of, is_left }
    }

    /// The point from which one starts; none of the first.
    pub(crate) fn of(&self, point: usize) -> Option<usize> {
        (point > 0).then(|| self.of[point])
    }

    /// Whether another one starts from a point.
    pub(crate) fn is_left(&self, point: usize) -> bool {
        self.is_left[point]
    }

    /// All but the first, in groups that start from points of the groups before alone, in their order within each.
    pub(crate) fn generations(&self) -> Vec<Vec<usize>> {
        let mut ages = vec![0; self.of.len()];
        let mut generations: Vec<Vec<usize>> = Vec::new();
        for point in 1..self.of.len() {
            let age = ages[self.of[point]];
            ages[point] = age + 1;
            if generations.len() == age {
                generations.push(Vec::new());
            }
            generations[age].push(point);
        }
        generations
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn generations_follow_their_starts() {
        let starts = Starts::of_each(vec![0, 0, 1, 0, 2, 3]);
        assert_eq!(starts.generations(), [vec![1, 3], vec![2, 5], vec![4]]);
        assert_eq!((starts.of(0), starts.of(4)), (None, Some(2)));
        let left: Vec<bool> = (0..6).map(|point| starts.is_left(point)).collect();
        assert_eq!(left, [true, true, true, true, false, false]);
        assert_eq!(Starts::from_first(4).generations(), [vec![1, 2, 3]]);
        assert!(Starts::from_first(1).generations().is_empty());
    }

    #[test]
    #[should_panic(expected = "before it")]
    fn no_point_starts_from_one_behind_it() {
        Starts::of_each(vec![0, 2, 1]);
    }
}
