//! Layouts of so many films out of many places: exhaustive where that is quick, else greedy with exchange.
//!
//! The criterion is the bound of the contact angle with a flat prior, mean square over contact angles and loads: it is finite for any layout. The
//! information of independent films adds up, so that each place's is computed once for every contact angle and load, and a layout costs a sum.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

use crate::layout::arrangement::{Arrangement, LaidFilm};
use crate::layout::field::film_field::{LoadField, Noise};
use crate::layout::fisher::bounds::{PRIOR_ANGLE_DEG, PRIOR_DEPTH_MM, information};

/// Contact angles over the turn.
const CONTACTS: usize = 90;
/// Layouts up to which all are looked at.
const EXHAUSTIVE: f64 = 1e6;
/// How many of the best are kept.
pub const KEPT: usize = 10;
/// Rounds of exchange at most; each round that goes on makes the layout better.
const MOST_ROUNDS: usize = 50;
/// Starts from films at random, beside the greedy one.
const STARTS: usize = 16;
const SEED: u64 = 1;

/// Information of one film on angle and depth, for every contact angle and load: [angle angle, angle depth, depth depth].
type Contribution = Vec<[f64; 3]>;

/// Places that films may have.
pub struct SearchPlaces {
    films: Vec<LaidFilm>,
    contributions: Vec<Contribution>,
}

/// Films of a layout by their places, in increasing order, with its criterion, degrees.
#[derive(Debug, Clone, PartialEq)]
pub struct FoundLayout {
    /// Numbers of the places.
    pub places: Vec<usize>,
    /// Bound of the contact angle, root mean square over angles and loads, degrees.
    pub bayes_angle_deg: f64,
}

/// What a search found.
#[derive(Debug, Clone, PartialEq)]
pub struct Findings {
    /// Best first, up to [`KEPT`].
    pub best: Vec<FoundLayout>,
    /// Whether all layouts were looked at.
    pub is_exhaustive: bool,
    /// Layouts whose criterion was computed.
    pub looked_at: usize,
}

impl SearchPlaces {
    /// Information of a film at each place under these loads.
    pub fn new(films: Vec<LaidFilm>, loads: &[LoadField], noise: &Noise) -> Self {
        let of_film = |film: &LaidFilm| {
            let alone = Arrangement::free(vec![*film]);
            let at = |load: &LoadField, contact: usize| {
                let angle = contact as f64 * 360.0 / CONTACTS as f64;
                let information = information(load, &alone, noise, angle);
                [
                    information.entry(0, 0),
                    information.entry(0, 1),
                    information.entry(1, 1),
                ]
            };
            loads
                .iter()
                .flat_map(|load| (0..CONTACTS).map(move |contact| at(load, contact)))
                .collect()
        };
        Self {
            contributions: films.iter().map(of_film).collect(),
            films,
        }
    }

    /// How many there are.
    pub fn count(&self) -> usize {
        self.films.len()
    }

    /// The film at a place.
    pub fn film(&self, place: usize) -> LaidFilm {
        self.films[place]
    }

    /// Bound of the contact angle of films at these places, degrees.
    pub fn criterion(&self, places: &[usize]) -> f64 {
        let mut sum = self.nothing();
        places
            .iter()
            .for_each(|&place| add(&mut sum, &self.contributions[place], 1.0));
        angle_deg(&sum)
    }

    /// The best layouts of so many films.
    ///
    /// # Panics
    /// If there are fewer places.
    pub fn search(&self, films: usize) -> Findings {
        assert!(
            films <= self.count(),
            "{films} films for {} places",
            self.count()
        );
        if combinations(self.count(), films) < EXHAUSTIVE {
            self.exhaustive(films)
        } else {
            self.greedy(films)
        }
    }

    fn nothing(&self) -> Contribution {
        vec![[0.0; 3]; self.contributions.first().map_or(0, Vec::len)]
    }

    fn exhaustive(&self, films: usize) -> Findings {
        let mut best = Best::default();
        let mut chosen = Vec::with_capacity(films);
        self.deepen(films, 0, &self.nothing(), &mut chosen, &mut best);
        best.findings(true)
    }

    /// Adds every place from `first` on to those chosen, until there are enough.
    fn deepen(
        &self,
        films: usize,
        first: usize,
        sum: &Contribution,
        chosen: &mut Vec<usize>,
        best: &mut Best,
    ) {
        if chosen.len() == films {
            best.offer(chosen, angle_deg(sum));
            return;
        }
        let missing = films - chosen.len();
        for place in first..=self.count() - missing {
            let mut with = sum.clone();
            add(&mut with, &self.contributions[place], 1.0);
            chosen.push(place);
            self.deepen(films, place + 1, &with, chosen, best);
            chosen.pop();
        }
    }

    /// One film after the other where it helps most, then exchange; the same from films at random, because exchange ends in a layout that no single move makes
    /// better.
    fn greedy(&self, films: usize) -> Findings {
        let mut best = Best::default();
        let (mut chosen, mut sum) = (Vec::new(), self.nothing());
        for _ in 0..films {
            let place = self.best_place(&chosen, &sum, &mut best, films);
            add(&mut sum, &self.contributions[place], 1.0);
            chosen.push(place);
        }
        self.exchange(chosen, &mut best);
        let mut rng = ChaCha8Rng::seed_from_u64(SEED);
        for _ in 0..STARTS {
            let mut places: Vec<usize> = (0..self.count()).collect();
            // The first entries of a shuffled list (Fisher and Yates).
            for film in 0..films {
                let other = film + rng.next_u64() as usize % (places.len() - film);
                places.swap(film, other);
            }
            places.truncate(films);
            self.exchange(places, &mut best);
        }
        best.findings(false)
    }

    /// Takes each film out and puts it back where it helps most, until none moves.
    fn exchange(&self, mut chosen: Vec<usize>, best: &mut Best) {
        let films = chosen.len();
        for _ in 0..MOST_ROUNDS {
            let before = chosen.clone();
            for film in 0..films {
                chosen.remove(film);
                // Afresh, so that round-off doesn't add up.
                let mut sum = self.nothing();
                chosen
                    .iter()
                    .for_each(|&place| add(&mut sum, &self.contributions[place], 1.0));
                let better = self.best_place(&chosen, &sum, best, films);
                chosen.insert(film, better);
            }
            if chosen == before {
                return;
            }
        }
    }

    /// Where one film more helps most; whole layouts are offered as they come.
    fn best_place(
        &self,
        chosen: &[usize],
        sum: &Contribution,
        best: &mut Best,
        films: usize,
    ) -> usize {
        let mut found = (f64::INFINITY, 0);
        for place in (0..self.count()).filter(|place| !chosen.contains(place)) {
            let mut with = sum.clone();
            add(&mut with, &self.contributions[place], 1.0);
            let angle = angle_deg(&with);
            if chosen.len() + 1 == films {
                let mut whole = [chosen, &[place]].concat();
                whole.sort_unstable();
                best.offer(&whole, angle);
            }
            if angle < found.0 {
                found = (angle, place);
            }
        }
        found.1
    }
}

fn add(sum: &mut Contribution, of_film: &Contribution, factor: f64) {
    for (sum, added) in sum.iter_mut().zip(of_film) {
        for k in 0..3 {
            sum[k] += factor * added[k];
        }
    }
}

/// Root mean square of the angle's bound with the prior added.
fn angle_deg(sum: &Contribution) -> f64 {
    let (of_angle, of_depth) = (PRIOR_ANGLE_DEG.powi(-2), PRIOR_DEPTH_MM.powi(-2));
    let variance = |[angle, cross, depth]: &[f64; 3]| {
        let (angle, depth) = (angle + of_angle, depth + of_depth);
        depth / (angle * depth - cross * cross)
    };
    (sum.iter().map(variance).sum::<f64>() / sum.len() as f64).sqrt()
}

/// How many layouts there are; infinite beyond what floats count.
fn combinations(places: usize, films: usize) -> f64 {
    (0..films)
        .map(|k| (places - k) as f64 / (k + 1) as f64)
        .product()
}

/// The best layouts so far, best first; of two equal ones the first in the order of places.
#[derive(Default)]
struct Best {
    kept: Vec<FoundLayout>,
    looked_at: usize,
}

impl Best {
    fn offer(&mut self, places: &[usize], bayes_angle_deg: f64) {
        self.looked_at += 1;
        let is_worse = |last: &FoundLayout| last.bayes_angle_deg <= bayes_angle_deg;
        if self.kept.len() == KEPT && self.kept.last().is_some_and(is_worse) {
            return;
        }
        if self.kept.iter().any(|kept| kept.places == places) {
            return;
        }
        let at = self
            .kept
            .partition_point(|kept| kept.bayes_angle_deg <= bayes_angle_deg);
        self.kept.insert(
            at,
            FoundLayout {
                places: places.to_vec(),
                bayes_angle_deg,
            },
        );
        self.kept.truncate(KEPT);
    }

    fn findings(self, is_exhaustive: bool) -> Findings {
        Findings {
            best: self.kept,
            is_exhaustive,
            looked_at: self.looked_at,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layout::fisher::bounds::bayes_angle_deg;
    use crate::layout::fisher::bounds::tests::{NOISE, gaussian};

    fn places(slots: usize, width_deg: f64) -> SearchPlaces {
        let slot = |slot: usize| {
            (0..2).map(move |kind| LaidFilm {
                theta_deg: slot as f64 * 360.0 / slots as f64,
                kind,
            })
        };
        SearchPlaces::new(
            (0..slots).flat_map(slot).collect(),
            &[gaussian(width_deg).at(1.0)],
            &NOISE,
        )
    }

    #[test]
    fn greedy_with_exchange_finds_the_exhaustive_best() {
        for width in [12.0, 25.0] {
            let places = places(24, width);
            for films in [3, 4] {
                let (all, greedy) = (places.exhaustive(films), places.greedy(films));
                assert!(all.is_exhaustive && all.looked_at as f64 == combinations(48, films));
                let ratio = greedy.best[0].bayes_angle_deg / all.best[0].bayes_angle_deg;
                // Turned or mirrored, a layout is as good: the same to rounding.
                assert!((ratio - 1.0).abs() < 1e-9, "{width} {films}: {ratio}");
                assert!(films == 3 || greedy.looked_at < all.looked_at / 10);
            }
        }
    }

    #[test]
    fn the_criterion_is_the_bound_of_the_layout() {
        let places = places(24, 14.0);
        let chosen = [0, 11, 13, 30, 47];
        let films = chosen.map(|place| places.film(place)).to_vec();
        // The bound goes by whole degrees, the search by every fourth of them.
        let bound = bayes_angle_deg(&gaussian(14.0).at(1.0), &Arrangement::free(films), &NOISE)
            .expect("finite");
        let found = places.criterion(&chosen);
        assert!((found / bound - 1.0).abs() < 0.02, "{found} {bound}");
    }

    #[test]
    fn the_best_are_sorted_and_differ() {
        let found = places(12, 14.0).search(3);
        assert_eq!(found.best.len(), KEPT);
        for pair in found.best.windows(2) {
            assert!(
                pair[0].bayes_angle_deg <= pair[1].bayes_angle_deg
                    && pair[0].places != pair[1].places
            );
        }
    }

    #[test]
    fn all_places_taken_are_one_layout() {
        let found = places(3, 14.0).search(6);
        assert_eq!((found.best.len(), found.looked_at), (1, 1));
        assert_eq!(combinations(48, 4), 194_580.0);
    }
}
