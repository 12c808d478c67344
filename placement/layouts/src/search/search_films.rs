//! Films that a search chooses from, and which of them can't both be glued on.

use crate::arrangement::LaidFilm;

/// Films that a search chooses from.
#[derive(Debug, Clone)]
pub struct SearchFilms {
    /// Films by their place's number, those that are in every layout first.
    pub films: Vec<LaidFilm>,
    /// Count of those.
    pub fixed: usize,
    /// Pairs that leave each other no room.
    pub conflicts: Conflicts,
}

impl SearchFilms {
    /// No films to choose from.
    pub fn none() -> Self {
        Self {
            films: Vec::new(),
            fixed: 0,
            conflicts: Conflicts::default(),
        }
    }
}

/// Pairs of places that can't both have a film, a bit each.
#[derive(Debug, Clone, Default)]
pub struct Conflicts {
    /// Words of a row; none where there is no conflict.
    stride: usize,
    bits: Vec<u64>,
}

impl Conflicts {
    /// Asks of every pair of so many places, the smaller number first.
    pub fn of(places: usize, conflict: impl Fn(usize, usize) -> bool) -> Self {
        let stride = places.div_ceil(64);
        let mut bits = vec![0; places * stride];
        let mut is_any = false;
        for one in 0..places {
            for other in one + 1..places {
                if conflict(one, other) {
                    is_any = true;
                    bits[one * stride + other / 64] |= 1 << (other % 64);
                    bits[other * stride + one / 64] |= 1 << (one % 64);
                }
            }
        }
        match is_any {
            true => Self { stride, bits },
            false => Self::default(),
        }
    }

    /// Whether a place leaves room to each of these.
    pub(crate) fn leaves_room(&self, place: usize, chosen: &[usize]) -> bool {
        let row = || &self.bits[place * self.stride..(place + 1) * self.stride];
        self.stride == 0
            || chosen
                .iter()
                .all(|other| row()[other / 64] & (1 << (other % 64)) == 0)
    }

    /// Whether there is none.
    pub(crate) fn is_empty(&self) -> bool {
        self.stride == 0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_pair_is_found_from_both_sides() {
        let are_near = |one: usize, other: usize| other - one == 3;
        let conflicts = Conflicts::of(200, are_near);
        for place in 0..200 {
            for other in (0..200).filter(|other| *other != place) {
                let room = conflicts.leaves_room(place, &[other]);
                assert_eq!(room, place.abs_diff(other) != 3, "{place} {other}");
            }
        }
        assert!(!conflicts.leaves_room(70, &[1, 2, 67]) && conflicts.leaves_room(70, &[]));
        assert!(Conflicts::of(5, |_, _| false).is_empty());
    }
}
