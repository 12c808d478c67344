//! Cost of judging layouts on one core: bounds of many, and simulations of the shipped ones. The strains are a bell's, as wide as the foot tire's.

use std::sync::atomic::AtomicBool;
use std::time::Instant;

use layouts::arrangement::{Arrangement, LaidFilm};
use layouts::field::film_field::{DepthFields, LoadField, Noise};
use layouts::field::hermite::Nodes;
use layouts::ranking::layout_scores::Scorer;
use layouts::search::best_layouts::joined;
use layouts::search::layout_search::SearchPlaces;
use layouts::search::search_criterion::{SearchCriterion, SearchFields};
use layouts::search::search_films::SearchFilms;
use layouts::simulate::draws::Draws;
use layouts::simulate::simulation::SAMPLES;

const WIDTH_DEG: f64 = 7.6;
const NOISE: Noise = Noise {
    floor: 0.0017,
    in_volts: false,
    gain_std: 0.0,
    place_std_deg: 0.0,
};

static GO_ON: AtomicBool = AtomicBool::new(false);

fn main() {
    let fields = fields();
    let slot = |slot: usize| {
        (0..2).map(move |kind| LaidFilm {
            theta_deg: 15.0 * slot as f64,
            kind,
        })
    };
    let at = |depths: &[f64]| -> Vec<LoadField> {
        depths.iter().map(|depth| fields.at(*depth)).collect()
    };
    let others = fields.evenly(8);
    let places = |criterion| {
        let fields = SearchFields {
            loads: &at(&[1.0]),
            others: &others,
        };
        let films = SearchFilms {
            films: (0..24).flat_map(slot).collect(),
            ..SearchFilms::none()
        };
        SearchPlaces::new(films, criterion, &fields, &NOISE, &GO_ON).expect("nobody stops it")
    };
    let [by_bound, by_errors] = SearchCriterion::ALL.map(places);
    println!("| what | number | s |\n|---|---|---|");
    for count in [20_000, 40_000] {
        let begun = Instant::now();
        // Six films each, spread by a stride that visits all places.
        let sum: f64 = (0..count)
            .map(|k| {
                let chosen = [0, 7, 13, 22, 31, 40].map(|first| (first + k * (first % 5 + 1)) % 48);
                by_bound.bound_deg(&chosen)
            })
            .sum();
        assert!(sum.is_finite());
        println!(
            "| bound of six films | {count} | {:.2} |",
            begun.elapsed().as_secs_f64()
        );
    }
    for (name, places) in [("bound", &by_bound), ("interval errors", &by_errors)] {
        let begun = Instant::now();
        let starts = (0..places.starts(12)).map(|start| places.search(12, start, &GO_ON));
        let found = joined(starts.flatten()).expect("nobody stops it");
        println!(
            "| search for twelve films, by {name} | {} | {:.2} |",
            found.looked_at,
            begun.elapsed().as_secs_f64()
        );
    }
    let layouts: Vec<Arrangement> = [12, 8, 6, 5, 4, 3, 2]
        .map(|units| Arrangement::regular(units, &[0, 1], false))
        .to_vec();
    let scorer = Scorer::new(
        &fields,
        NOISE,
        vec![0.5, 1.0, 2.0],
        layouts.iter(),
        Draws::new(1, SAMPLES, 24),
        false,
    );
    let begun = Instant::now();
    for _ in 0..3 {
        assert!(
            layouts
                .iter()
                .all(|layout| scorer.figures(layout).len() == 3)
        );
    }
    println!(
        "| simulation of a layout at three loads | 21 | {:.2} |",
        begun.elapsed().as_secs_f64()
    );
}

/// Returns the fields of a bell that grows with the depth, and of its slope.
fn fields() -> DepthFields {
    let depths = [0.25, 0.45, 0.5, 0.55, 0.9, 1.0, 1.1, 1.8, 2.0, 2.2, 2.5];
    let bell = |u: f64| (-0.5 * (u / WIDTH_DEG).powi(2)).exp();
    let over = |profile: &dyn Fn(f64) -> f64| -> Vec<Vec<f64>> {
        let around = |depth: &f64| {
            (-180..180)
                .map(|u| 0.087 * depth.powf(0.8) * profile(f64::from(u)))
                .collect()
        };
        depths.iter().map(around).collect()
    };
    DepthFields {
        depths: Nodes::new(depths.to_vec()),
        forces_n: depths.iter().map(|depth| 13.1 * depth.powf(1.3)).collect(),
        signals: vec![over(&bell), over(&|u| -u / WIDTH_DEG * bell(u))],
        sheared: Vec::new(),
        contacts: None,
        spread: None,
        together: None,
        surface_error: None,
    }
}
