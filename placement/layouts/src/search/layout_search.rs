//! Layouts of so many films out of many places: exhaustive where that is quick, else greedy with exchange.

use std::sync::atomic::{AtomicBool, Ordering};

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

use crate::arrangement::LaidFilm;
use crate::field::film_field::Noise;
use crate::search::best_layouts::{Best, Findings};
use crate::search::search_criterion::{SearchCriterion, SearchFields, Share};

/// Layouts up to which all are looked at.
const EXHAUSTIVE: f64 = 1e6;
/// Rounds of exchange at most; each round that goes on makes the layout better.
const MOST_ROUNDS: usize = 50;
/// Starts from films at random, beside the greedy one.
const STARTS: usize = 16;
const SEED: u64 = 1;

/// Places that films may have.
pub struct SearchPlaces {
    films: Vec<LaidFilm>,
    shares: Vec<Share>,
}

impl SearchPlaces {
    /// Shares of a film at each place in the criterion; `None` when it is stopped meanwhile.
    pub fn new(
        films: Vec<LaidFilm>,
        criterion: SearchCriterion,
        fields: &SearchFields<'_>,
        noise: &Noise,
        stop: &AtomicBool,
    ) -> Option<Self> {
        let share = |film: &LaidFilm| {
            go_on(stop)?;
            Some(criterion.share(film, fields, noise))
        };
        let shares: Option<Vec<Share>> = films.iter().map(share).collect();
        Some(Self {
            shares: shares?,
            films,
        })
    }

    /// Counts the places.
    pub fn count(&self) -> usize {
        self.films.len()
    }

    /// The film at a place.
    pub fn film(&self, place: usize) -> LaidFilm {
        self.films[place]
    }

    /// Returns how many searches for so many films there are, each from a start of its own: pieces of work that whoever has cores can share out.
    pub fn starts(&self, films: usize) -> usize {
        starts(self.count(), films)
    }

    /// The best layouts of so many films that the search from one start finds; `None` when it is stopped meanwhile.
    ///
    /// # Panics
    /// If there are fewer places.
    pub fn search(&self, films: usize, start: usize, stop: &AtomicBool) -> Option<Findings> {
        assert!(
            films <= self.count(),
            "{films} films for {} places",
            self.count()
        );
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
        let mut chosen = Vec::with_capacity(films);
        self.deepen(0, &self.nothing(), &mut chosen, &mut seen)?;
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
        if missing == 1 {
            for place in first..self.count() {
                chosen.push(place);
                let error = sum.error_of_sum_deg(&self.shares[place]);
                seen.best.offer(chosen, error);
                chosen.pop();
            }
            return Some(());
        }
        let mut with = sum.nothing();
        for place in first..=self.count() - missing {
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
            _ => self.at_random(films, start),
        };
        self.exchange(chosen, &mut seen)?;
        Some(seen.best.findings(false))
    }

    fn added(&self, seen: &mut Seen<'_>) -> Option<Vec<usize>> {
        let (mut chosen, mut sum) = (Vec::new(), self.nothing());
        for _ in 0..seen.films {
            let place = self.best_place(&chosen, &sum, seen)?;
            sum.add(&self.shares[place]);
            chosen.push(place);
        }
        Some(chosen)
    }

    fn at_random(&self, films: usize, start: usize) -> Vec<usize> {
        let mut rng = ChaCha8Rng::seed_from_u64(SEED);
        let mut places = Vec::new();
        // Starts go on in one stream.
        for _ in 0..start {
            places = (0..self.count()).collect();
            // The first entries of a shuffled list (Fisher and Yates).
            for film in 0..films {
                let other = film + rng.next_u64() as usize % (places.len() - film);
                places.swap(film, other);
            }
        }
        places.truncate(films);
        places
    }

    /// Takes each film out and puts it back where it helps most, until none moves.
    fn exchange(&self, mut chosen: Vec<usize>, seen: &mut Seen<'_>) -> Option<()> {
        for _ in 0..MOST_ROUNDS {
            let before = chosen.clone();
            for film in 0..seen.films {
                chosen.remove(film);
                // Afresh, so that round-off doesn't add up.
                let sum = self.sum(&chosen);
                let better = self.best_place(&chosen, &sum, seen)?;
                chosen.insert(film, better);
            }
            if chosen == before {
                break;
            }
        }
        Some(())
    }

    /// Returns the place where one film more helps most; whole layouts are offered as they come.
    fn best_place(&self, chosen: &[usize], sum: &Share, seen: &mut Seen<'_>) -> Option<usize> {
        let mut found = (f64::INFINITY, 0);
        for place in (0..self.count()).filter(|place| !chosen.contains(place)) {
            go_on(seen.stop)?;
            let error = sum.error_of_sum_deg(&self.shares[place]);
            if chosen.len() + 1 == seen.films {
                let mut whole = [chosen, &[place]].concat();
                whole.sort_unstable();
                seen.best.offer(&whole, error);
            }
            if error < found.0 {
                found = (error, place);
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
pub fn expected_looks(places: usize, films: usize) -> f64 {
    const ROUNDS: f64 = 3.5;
    match starts(places, films) {
        1 => combinations(places, films),
        starts => (1.0 + ROUNDS * starts as f64) * (films * places) as f64,
    }
}

/// Returns how many searches there are for so many films out of so many places.
fn starts(places: usize, films: usize) -> usize {
    match combinations(places, films) < EXHAUSTIVE {
        true => 1,
        false => 1 + STARTS,
    }
}

/// Counts the layouts; infinite beyond what floats count.
fn combinations(places: usize, films: usize) -> f64 {
    (0..films)
        .map(|k| (places - k) as f64 / (k + 1) as f64)
        .product()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fisher::bounds::tests::{NOISE, gaussian};
    use crate::search::best_layouts::{KEPT, joined};

    static GO_ON: AtomicBool = AtomicBool::new(false);

    fn places(criterion: SearchCriterion, slots: usize, width_deg: f64) -> SearchPlaces {
        let slot = |slot: usize| {
            (0..2).map(move |kind| LaidFilm {
                theta_deg: slot as f64 * 360.0 / slots as f64,
                kind,
            })
        };
        let fields = gaussian(width_deg);
        SearchPlaces::new(
            (0..slots).flat_map(slot).collect(),
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
                assert!(all.is_exhaustive && all.looked_at as f64 == combinations(48, films));
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
        assert_eq!(combinations(48, 4), 194_580.0);
    }
}
