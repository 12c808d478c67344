//! The trade against its whole menu, on the foot tire's own mesh.

use std::collections::BTreeMap;
use std::sync::atomic::AtomicBool;

use document::Format;
use documents::study::Study;
use documents::study::plan::Plan;
use placement::ladder::climb;
use placement::points::RunContext;
use placement::points::memory::MemoryArchive;
use results::{RankedLayout, StudyResult};
use tire::embedded::EmbeddedSolver;

/// The shipped study of one depth on the coarse mesh, with these layouts.
fn answered(layouts: &str) -> StudyResult {
    let text = format!(
        "name = \"menu\"
scene = {{ preset = \"foot-tire\" }}
inputs = [{{ name = \"P3\", vary = \"ground.depths_mm[2]\", distribution = {{ kind = \"uniform\", min = 0.7, max = 1.3 }} }}]
method = {{ kind = \"mdrm\", nodes = 2, check_points = 0, seed = 1 }}
accuracy = {{ preset = \"coarse\" }}
[layouts]
depths_mm = [1]
{layouts}"
    );
    solved(&text)
}

/// Returns what a study's document says.
pub(crate) fn solved(text: &str) -> StudyResult {
    let refuse = |path: &str| Err(path.to_owned());
    let study = Study::from_document(text, Format::Toml, &refuse).expect("a document");
    let plan = Plan::new(&study).expect("a plan");
    let context = RunContext {
        solver: &EmbeddedSolver::default(),
        archive: &MemoryArchive::default(),
        threads: 2,
        stop: &AtomicBool::new(false),
        pause: None,
        observer: &|_| (),
    };
    climb::answer(&study, &plan, context).expect("an answer")
}

/// The angle's error and its claim, degrees.
fn figure(layout: &RankedLayout) -> (f64, f64) {
    let error = layout.score.error.as_ref();
    let claim = error.and_then(|error| error.simulated_p95_angle_error_deg);
    let value = layout.score.simulated_p95_angle_error_deg;
    (value.expect("simulated"), claim.expect("a coarser mesh"))
}

/// Every layout of the default menu is simulated by itself: what screening left out is no better than the trade says, beyond the errors of both.
#[test]
fn no_layout_of_the_menu_betters_the_trade() {
    let offered = answered("");
    let trade = offered.answer.expect("an answer").trade.expect("a trade");
    // The same rings asked for one by one; the most films are the menu's, so that all are simulated with the same draws.
    let places = "spacings_deg = []\npositions = [\"crown\", \"shoulder\", \"sidewall\"]";
    let alone = answered(&format!(
        "{places}\nunits = [3, 4, 6, 8, 9, 10, 12, 15, 18, 20, 24, 30, 36, 48]\ndirections = [[0], [90]]"
    ));
    let pairs = answered(&format!(
        "{places}\nunits = [2, 3, 4, 5, 6, 9, 10, 12, 15, 18, 24]\ndirections = [[0, 90]]\nstaggered = true"
    ));
    let mut all: BTreeMap<usize, Vec<(f64, f64)>> = BTreeMap::new();
    for layout in alone.layouts.iter().chain(&pairs.layouts) {
        all.entry(layout.film_count)
            .or_default()
            .push(figure(layout));
    }
    assert_eq!(all.values().map(Vec::len).sum::<usize>(), trade.tried);
    assert!(trade.screened > trade.tried / 2, "{}", trade.menu);
    assert_eq!(
        all.keys().copied().collect::<Vec<_>>(),
        trade
            .rows
            .iter()
            .map(|row| row.film_count)
            .collect::<Vec<_>>()
    );
    let mut exact = 0;
    for row in &trade.rows {
        let own = row.angle_claim_deg.expect("a coarser mesh");
        let tried = &all[&row.film_count];
        let same = |figure: &&(f64, f64)| (figure.0 - row.angle_error_deg).abs() < 1e-9;
        assert!(tried.iter().any(|figure| same(&figure)), "{row:?}");
        for (value, claim) in tried {
            assert!(
                value + claim + own >= row.angle_error_deg,
                "{value} +- {claim} betters {row:?}"
            );
        }
        exact += usize::from(
            tried
                .iter()
                .all(|(value, _)| *value >= row.angle_error_deg - 1e-9),
        );
    }
    // Where most layouts lose the contact the best of them is guessed from few draws.
    assert!(
        exact + 3 >= trade.rows.len(),
        "{exact} of {}",
        trade.rows.len()
    );
}
