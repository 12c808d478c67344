//! The solves under way, for whoever looks now: nothing of it is stored.

use std::collections::BTreeMap;

use fem_client::solver::SolveProgress;
use placement::points::Event;
use tokio::sync::watch;

/// The solves of the study that has its turn.
#[derive(Debug, Clone, Default)]
pub struct Solves {
    /// Identifier of the study; empty where none runs.
    pub study: String,
    /// Progress of each solve, by the ordinal of its point.
    pub points: BTreeMap<usize, SolveProgress>,
}

/// A study's turn, at whose end nothing is known of its solves.
#[derive(Debug)]
pub struct Turn<'l>(&'l Live);

impl<'l> Turn<'l> {
    /// The study of this identifier begins.
    pub fn begin(live: &'l Live, study: &str) -> Self {
        live.turn_to(study);
        Self(live)
    }
}

impl Drop for Turn<'_> {
    fn drop(&mut self) {
        self.0.turn_to("");
    }
}

/// Tells of solves.
#[derive(Debug, Default)]
pub struct Live(watch::Sender<Solves>);

impl Live {
    fn turn_to(&self, study: &str) {
        self.0.send_replace(Solves {
            study: study.to_owned(),
            points: BTreeMap::new(),
        });
    }

    /// A solve has come so far, or has ended, which is told by other means.
    pub fn event(&self, event: &Event) {
        self.0.send_if_modified(|solves| match *event {
            Event::Solving { ordinal, progress } => {
                solves.points.insert(ordinal, progress);
                true
            }
            Event::PointSolved { ordinal, .. } | Event::PointFailed { ordinal, .. } => {
                solves.points.remove(&ordinal);
                false
            }
            Event::Started { .. } | Event::Analysing | Event::Revised(_) => false,
        });
    }

    /// Hears of changes from now on.
    pub fn subscribe(&self) -> watch::Receiver<Solves> {
        self.0.subscribe()
    }
}
