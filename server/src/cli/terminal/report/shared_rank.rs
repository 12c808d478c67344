//! Ranks as people read them: `2=` where two share the second.

/// A rank, right-aligned in five columns, with a sign where others of the list share it.
pub(crate) fn rank_cell(rank: usize, all: impl Iterator<Item = usize>) -> String {
    let shared = all.filter(|other| *other == rank).nth(1).is_some();
    let sign = if shared { '=' } else { ' ' };
    format!("{rank:>4}{sign}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shared_ranks_have_a_sign() {
        let cells = [1, 2, 4].map(|rank| rank_cell(rank, [1, 2, 2, 4].into_iter()));
        assert_eq!(cells, ["   1 ", "   2=", "   4 "]);
    }
}
