//! Layouts of so many films out of many places: exhaustive where that is quick, else greedy with exchange.

use std::sync::atomic::{AtomicBool, Ordering};

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

use crate::arrangement::LaidFilm;
use crate::field::film_field::Noise;
use crate::search::best_layouts::{Best, Findings};
use crate::search::search_criterion::{SearchCriterion, SearchFields, Share};
use crate::search::search_films::SearchFilms;

/// Layouts up to which all are looked at.
const EXHAUSTIVE: f64 = 1e6;
/// Rounds of exchange at most; each round that goes on makes the layout better.
const MOST_ROUNDS: usize = 50;
/// Starts from films at random, beside the greedy one.
const STARTS: usize = 16;
const SEED: u64 = 1;

/// Places that films may have.
pub struct SearchPlaces {
    of: SearchFilms,
    shares: Vec<Share>,
}

impl SearchPlaces {
    /// Shares of a film at each place in the criterion; `None` when it is stopped meanwhile.
    pub fn new(
        of: SearchFilms,
        criterion: SearchCriterion,
        fields: &SearchFields<'_>,
        noise: &Noise,
        stop: &AtomicBool,
    ) -> Option<Self> {
        let share = |film: &LaidFilm| {
            go_on(stop)?;
            Some(criterion.share(film, fields, noise))
        };
        let shares: Option<Vec<Share>> = of.films.iter().map(share).collect();
        Some(Self {
            shares: shares?,
            of,
        })
    }

    /// Counts the places.
    pub fn count(&self) -> usize {
        self.of.films.len()
    }

    /// The film at a place.
    pub fn film(&self, place: usize) -> LaidFilm {
        self.of.films[place]
    }

    /// Returns how many searches for so many films there are, each from a start of its own: pieces of work that whoever has cores can share out.
    pub fn starts(&self, films: usize) -> usize {
        starts(self.count(), self.of.fixed, films)
    }

    /// The best layouts of so many films, fixed ones among them, that the search from one start finds, where they have room; `None` when it is stopped meanwhile.
    pub fn search(&self, films: usize, start: usize, stop: &AtomicBool) -> Option<Findings> {
        if films > self.count() || films < self.of.fixed {
            return Some(Best::default().findings(true));
        }
        match self.starts(films) {
            1 => self.exhaustive(films, stop),
            _ => self.greedy(films, start, stop),
        }
    }

    /// Bound of the contact angle of films at these places, whatever the search goes by, degrees.
    pub fn bound_deg(&self, places: &[usize]) -> f64 {
        self.sum(places).bound_deg()
    }

    fn nothing(&self) -> Share {
        self.shares
            .first()
            .map_or_else(Share::default, Share::nothing)
    }

    fn sum(&self, places: &[usize]) -> Share {
        let mut sum = self.nothing();
        places
            .iter()
            .for_each(|&place| sum.add(&self.shares[place]));
        sum
    }

    fn exhaustive(&self, films: usize, stop: &AtomicBool) -> Option<Findings> {
        let mut seen = Seen::new(films, stop);
        let mut chosen = self.fixed();
        if chosen.len() == films {
            seen.best
                .offer(&chosen, self.sum(&chosen).error_of_sum_deg(&self.nothing()));
        } else {
            let sum = self.sum(&chosen);
            self.deepen(self.of.fixed, &sum, &mut chosen, &mut seen)?;
        }
        Some(seen.best.findings(true))
    }

    /// Adds every place from `first` on to those chosen, until there are enough.
    fn deepen(
        &self,
        first: usize,
        sum: &Share,
        chosen: &mut Vec<usize>,
        seen: &mut Seen<'_>,
    ) -> Option<()> {
        go_on(seen.stop)?;
        let missing = seen.films - chosen.len();
        let conflicts = &self.of.conflicts;
        if missing == 1 {
            for place in first..self.count() {
                if !conflicts.leaves_room(place, chosen) {
                    continue;
                }
                chosen.push(place);
                let error = sum.error_of_sum_deg(&self.shares[place]);
                seen.best.offer(chosen, error);
                chosen.pop();
            }
            return Some(());
        }
        let mut with = sum.nothing();
        for place in first..=self.count() - missing {
            if !conflicts.leaves_room(place, chosen) {
                continue;
            }
            with.set_to_sum(sum, &self.shares[place]);
            chosen.push(place);
            self.deepen(place + 1, &with, chosen, seen)?;
            chosen.pop();
        }
        Some(())
    }

    /// Exchanges from films that were added one after the other where each helps most; from the second start on from films at random, because exchange ends in a
    /// layout that no single move makes better.
    fn greedy(&self, films: usize, start: usize, stop: &AtomicBool) -> Option<Findings> {
        let mut seen = Seen::new(films, stop);
        let chosen = match start {
            0 => self.added(&mut seen)?,
            // Neighbour after neighbour, which has room for the most films.
            1 if !self.of.conflicts.is_empty() => self.in_order(self.of.fixed..self.count(), films),
            _ => self.at_random(films, start),
        };
        // A start that has no room for the last films tells nothing.
        if chosen.len() == films {
            self.exchange(chosen, &mut seen)?;
        }
        Some(seen.best.findings(false))
    }

    fn fixed(&self) -> Vec<usize> {
        (0..self.of.fixed).collect()
    }

    /// Places added one after the other where each helps most, as many as are asked for and have room.
    fn added(&self, seen: &mut Seen<'_>) -> Option<Vec<usize>> {
        let mut chosen = self.fixed();
        let mut sum = self.sum(&chosen);
        while chosen.len() < seen.films {
            let Some(place) = self.best_place(&chosen, &sum, seen)? else {
                break;
            };
            sum.add(&self.shares[place]);
            chosen.push(place);
        }
        Some(chosen)
    }

    /// The first of these places that leave each other room, as many as are asked for or there are.
    fn in_order(&self, places: impl Iterator<Item = usize>, films: usize) -> Vec<usize> {
        let mut chosen = self.fixed();
        for place in places {
            if chosen.len() < films && self.of.conflicts.leaves_room(place, &chosen) {
                chosen.push(place);
            }
        }
        chosen
    }

    fn at_random(&self, films: usize, start: usize) -> Vec<usize> {
        let mut rng = ChaCha8Rng::seed_from_u64(SEED);
        let mut places: Vec<usize> = Vec::new();
        let shuffled = match self.of.conflicts.is_empty() {
            true => films - self.of.fixed,
            // Some of them have no room.
            false => self.count() - self.of.fixed,
        };
        // Starts go on in one stream.
        for _ in 0..start {
            places = (self.of.fixed..self.count()).collect();
            // The first entries of a shuffled list (Fisher and Yates).
            for film in 0..shuffled {
                let other = film + rng.next_u64() as usize % (places.len() - film);
                places.swap(film, other);
            }
        }
        self.in_order(places.into_iter(), films)
    }

    /// Takes each film out and puts it back where it helps most, until none moves.
    fn exchange(&self, mut chosen: Vec<usize>, seen: &mut Seen<'_>) -> Option<()> {
        for _ in 0..MOST_ROUNDS {
            let before = chosen.clone();
            for film in self.of.fixed..seen.films {
                let here = chosen.remove(film);
                // Afresh, so that round-off doesn't add up.
                let sum = self.sum(&chosen);
                let better = self.best_place(&chosen, &sum, seen)?;
                chosen.insert(film, better.unwrap_or(here));
            }
            if chosen == before {
                break;
            }
        }
        Some(())
    }

    /// Returns the place where one film more helps most, if there is room for one; whole layouts are offered as they come.
    fn best_place(
        &self,
        chosen: &[usize],
        sum: &Share,
        seen: &mut Seen<'_>,
    ) -> Option<Option<usize>> {
        let mut found = (f64::INFINITY, None);
        let is_free = |place: &usize| {
            !chosen.contains(place) && self.of.conflicts.leaves_room(*place, chosen)
        };
        for place in (self.of.fixed..self.count()).filter(is_free) {
            go_on(seen.stop)?;
            let error = sum.error_of_sum_deg(&self.shares[place]);
            if chosen.len() + 1 == seen.films {
                let mut whole = [chosen, &[place]].concat();
                whole.sort_unstable();
                seen.best.offer(&whole, error);
            }
            if found.1.is_none() || error < found.0 {
                found = (error, Some(place));
            }
        }
        Some(found.1)
    }
}

/// State of a search for so many films: what it has seen so far, and whether it is to stop.
struct Seen<'a> {
    films: usize,
    best: Best,
    stop: &'a AtomicBool,
}

impl<'a> Seen<'a> {
    fn new(films: usize, stop: &'a AtomicBool) -> Self {
        Self {
            films,
            best: Best::default(),
            stop,
        }
    }
}

fn go_on(stop: &AtomicBool) -> Option<()> {
    (!stop.load(Ordering::Relaxed)).then_some(())
}

/// Returns how many layouts a search for so many films out of so many places is expected to look at: all, or three and a half rounds of exchange from each start, as
/// counted for 12 to 48 films of 1680 places.
pub fn expected_looks(places: usize, fixed: usize, films: usize) -> f64 {
    const ROUNDS: f64 = 3.5;
    match starts(places, fixed, films) {
        1 => combinations(places, fixed, films),
        starts => (1.0 + ROUNDS * starts as f64) * (films * places) as f64,
    }
}

/// Returns how many searches there are for so many films out of so many places, the fixed ones among them.
fn starts(places: usize, fixed: usize, films: usize) -> usize {
    match combinations(places, fixed, films) < EXHAUSTIVE {
        true => 1,
        false => 1 + STARTS,
    }
}

/// Counts the layouts; infinite beyond what floats count.
fn combinations(places: usize, fixed: usize, films: usize) -> f64 {
    let free = places.saturating_sub(fixed);
    (0..films.saturating_sub(fixed))
        .map(|k| free.saturating_sub(k) as f64 / (k + 1) as f64)
        .product()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fisher::bounds::tests::{NOISE, gaussian};
    use crate::search::best_layouts::{KEPT, joined};
    use crate::search::search_films::Conflicts;

    static GO_ON: AtomicBool = AtomicBool::new(false);

    fn places(criterion: SearchCriterion, slots: usize, width_deg: f64) -> SearchPlaces {
        let slot = |slot: usize| {
            (0..2).map(move |kind| LaidFilm {
                theta_deg: slot as f64 * 360.0 / slots as f64,
                kind,
            })
        };
        let fields = gaussian(width_deg);
        let films = SearchFilms {
            films: (0..slots).flat_map(slot).collect(),
            fixed: 0,
            conflicts: Conflicts::default(),
        };
        SearchPlaces::new(
            films,
            criterion,
            &SearchFields {
                loads: &[fields.at(1.0)],
                others: &[0.5, 0.75, 1.0, 1.25, 1.5].map(|depth| fields.at(depth)),
            },
            &NOISE,
            &GO_ON,
        )
        .expect("nobody stops it")
    }

    /// Films of y in 24 slots, the first one glued already, three slots forbidden, and neighbours apart by more than so many slots.
    fn constrained(apart: usize) -> SearchPlaces {
        let slots: Vec<usize> = (0..24).filter(|slot| !(11..=13).contains(slot)).collect();
        let near = |one: usize, other: usize| {
            let distance = slots[one].abs_diff(slots[other]);
            distance.min(24 - distance) <= apart
        };
        let film = |slot: &usize| LaidFilm {
            theta_deg: 15.0 * *slot as f64,
            kind: 1,
        };
        let films = SearchFilms {
            films: slots.iter().map(film).collect(),
            fixed: 1,
            conflicts: Conflicts::of(slots.len(), near),
        };
        let fields = gaussian(14.0);
        let fields = SearchFields {
            loads: &[fields.at(1.0)],
            others: &[0.5, 1.0, 1.5].map(|depth| fields.at(depth)),
        };
        SearchPlaces::new(films, SearchCriterion::Bound, &fields, &NOISE, &GO_ON)
            .expect("nobody stops it")
    }

    #[test]
    fn greedy_under_constraints_finds_the_best_of_all_that_have_room() {
        for (films, apart) in [(3, 0), (3, 2), (4, 0), (4, 2)] {
            let places = constrained(apart);
            let all = places.exhaustive(films, &GO_ON).expect("ends");
            // By counting, without the search's own loops.
            let room = |chosen: &[usize]| {
                (0..films).all(|k| places.of.conflicts.leaves_room(chosen[k], &chosen[..k]))
            };
            let mut best = f64::INFINITY;
            let mut count = 0;
            for mask in 0..1u32 << 20 {
                if mask.count_ones() as usize != films - 1 {
                    continue;
                }
                let free = (0..20)
                    .filter(|bit| mask & (1 << bit) != 0)
                    .map(|bit| bit + 1);
                let chosen: Vec<usize> = std::iter::once(0).chain(free).collect();
                if room(&chosen) {
                    count += 1;
                    best = best.min(places.bound_deg(&chosen));
                }
            }
            assert_eq!(all.looked_at, count, "{films} {apart}");
            assert!(apart > 0 || count == if films == 3 { 190 } else { 1140 });
            let starts = (0..=STARTS).map(|start| places.greedy(films, start, &GO_ON));
            let greedy = joined(starts.map(|found| found.expect("ends"))).expect("one");
            for found in [&all, &greedy] {
                let ratio = places.bound_deg(&found.best[0].places) / best;
                assert!((ratio - 1.0).abs() < 1e-6, "{films} {apart}: {ratio}");
                assert!(
                    found
                        .best
                        .iter()
                        .all(|layout| layout.places[0] == 0 && room(&layout.places))
                );
            }
        }
    }

    #[test]
    fn a_ring_is_filled_up_to_the_last_film_that_has_room() {
        // Of 24 slots without three, with two empty ones between neighbours: 0, 3, 6, 9 or 10, then 14 or 15 to 21.
        let places = constrained(2);
        for (films, has) in [(7, true), (8, false)] {
            let all = places.exhaustive(films, &GO_ON).expect("ends");
            assert_eq!(!all.best.is_empty(), has, "{films}");
            let starts = (0..=STARTS).map(|start| places.greedy(films, start, &GO_ON));
            let greedy = joined(starts.map(|found| found.expect("ends"))).expect("one");
            assert_eq!(!greedy.best.is_empty(), has, "{films}");
        }
    }

    #[test]
    fn a_search_heeds_its_stop_flag() {
        let stop = AtomicBool::new(true);
        let places = places(SearchCriterion::Bound, 24, 12.0);
        assert_eq!(places.exhaustive(3, &stop), None);
        assert_eq!(places.greedy(3, 1, &stop), None);
    }

    #[test]
    fn greedy_with_exchange_finds_the_exhaustive_best() {
        for (criterion, width, counts) in [
            (SearchCriterion::Bound, 12.0, &[3, 4][..]),
            (SearchCriterion::Bound, 25.0, &[3, 4]),
            // Twenty times as dear.
            (SearchCriterion::IntervalErrors, 12.0, &[3]),
        ] {
            let places = places(criterion, 24, width);
            for &films in counts {
                let all = places.exhaustive(films, &GO_ON).expect("ends");
                let starts = (0..=STARTS).map(|start| places.greedy(films, start, &GO_ON));
                let greedy = joined(starts.map(|found| found.expect("ends"))).expect("one");
                assert!(all.is_exhaustive && all.looked_at as f64 == combinations(48, 0, films));
                let ratio = greedy.best[0].error_deg / all.best[0].error_deg;
                // Turned or mirrored, a layout is as good: the same to rounding, of distances to single precision.
                assert!((ratio - 1.0).abs() < 1e-6, "{width} {films}: {ratio}");
                assert!(films == 3 || greedy.looked_at < all.looked_at / 10);
            }
        }
    }

    #[test]
    fn the_best_are_sorted_and_differ() {
        let found = places(SearchCriterion::Bound, 12, 14.0)
            .search(3, 0, &GO_ON)
            .expect("ends");
        assert_eq!(found.best.len(), KEPT);
        for pair in found.best.windows(2) {
            assert!(pair[0].error_deg <= pair[1].error_deg && pair[0].places != pair[1].places);
        }
    }

    #[test]
    fn all_places_taken_are_one_layout() {
        let found = places(SearchCriterion::Bound, 3, 14.0)
            .search(6, 0, &GO_ON)
            .expect("ends");
        assert_eq!((found.best.len(), found.looked_at), (1, 1));
        assert_eq!(combinations(48, 0, 4), 194_580.0);
    }
}
