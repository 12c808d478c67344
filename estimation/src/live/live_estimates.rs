//! Estimates row by row, as a robot's controller would have them. A file is nothing but its rows, so both give the same bits.

use crate::align::Clock;
use crate::estimator::{Estimate, Estimator, ForceModel};
use crate::features::FeatureStream;
use crate::relations::relation_watch::RelationWatch;

/// Rows of one run, one after another.
#[derive(Debug)]
pub struct Live<'e> {
    estimator: &'e Estimator,
    clock: Option<Clock>,
    stream: FeatureStream,
    watch: Option<RelationWatch<'e>>,
}

/// Estimates at a time.
#[derive(Debug, Clone, PartialEq)]
pub struct Estimated {
    /// s
    pub time_s: f64,
    /// Forces, one a column.
    pub forces: Vec<Estimate>,
    /// Whether the signals are beyond what was learnt from, by themselves or by what they say of each other.
    pub outside: bool,
    /// Number of the signal that the others make unlikely.
    pub suspect: Option<usize>,
    /// Load that this row's signals, which are taken for the zero, are by the zero of the model.
    pub load: Option<Load>,
}

/// Load under which a run begins.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Load {
    /// Number of the force.
    pub force: usize,
    /// N
    pub load_n: f64,
}

impl Estimated {
    /// Whether all its numbers are.
    pub fn is_finite(&self) -> bool {
        let finite = |estimate: &Estimate| {
            [estimate.force, estimate.low, estimate.high]
                .iter()
                .all(|x| x.is_finite())
        };
        self.time_s.is_finite() && self.forces.iter().all(finite)
    }
}

impl<'e> Live<'e> {
    /// Begins before a run's first row.
    pub fn new(estimator: &'e Estimator) -> Self {
        let signals = estimator.columns.signals.len();
        let stream = &estimator.stream;
        Self {
            estimator,
            clock: stream
                .rate_hz
                .map(|rate_hz| Clock::new(rate_hz, stream.pause_s, signals)),
            stream: FeatureStream::new(stream.settings()),
            watch: estimator.relations.as_ref().map(RelationWatch::new),
        }
    }

    /// Begins anew, as after a pause: nothing is carried over. The zero stays.
    pub fn restart(&mut self) {
        self.stream.restart();
        if let Some(watch) = &mut self.watch {
            watch.restart();
        }
        if let Some(clock) = &mut self.clock {
            clock.restart();
        }
    }

    /// Begins anew with the next row as the zero.
    pub fn zero(&mut self) {
        self.restart();
        self.watch = self.estimator.relations.as_ref().map(RelationWatch::new);
        self.stream.start_at(None, self.estimator.zero.as_ref());
    }

    /// Takes these signals for the zero, one each.
    pub fn start_at(&mut self, zero: Vec<f64>) {
        self.stream
            .start_at(Some(zero), self.estimator.zero.as_ref());
    }

    /// Estimates from a row of signals: once, or with a clock once for each of its ticks that the row completes.
    pub fn push(&mut self, time_s: f64, cycle: Option<usize>, signals: &[f64]) -> Vec<Estimated> {
        match &mut self.clock {
            Some(clock) => {
                let ticks = clock.push(time_s, cycle, signals);
                ticks
                    .into_iter()
                    .map(|tick| self.estimated(tick.time_s, tick.cycle, &tick.signals))
                    .collect()
            }
            None => vec![self.estimated(time_s, cycle, signals)],
        }
    }

    fn estimated(&mut self, time_s: f64, cycle: Option<usize>, signals: &[f64]) -> Estimated {
        let is_zero = self.stream.is_zero_next();
        let load = is_zero.then(|| self.load(time_s, cycle, signals)).flatten();
        let features = self.stream.push(time_s, cycle, signals);
        let forces = self.estimator.forces.iter();
        let suspect = self.watch.as_mut().and_then(|watch| watch.suspect(signals));
        Estimated {
            time_s,
            forces: forces.map(|force| force.estimate(&features)).collect(),
            outside: self.estimator.is_outside(&features) || suspect.is_some(),
            suspect,
            load,
        }
    }

    /// The first force that a reading is beyond what runs at rest are, by the zero of the model; none where that isn't known.
    fn load(&self, time_s: f64, cycle: Option<usize>, signals: &[f64]) -> Option<Load> {
        let zero = self.estimator.zero.as_ref()?;
        let mut stream = FeatureStream::new(self.estimator.stream.settings());
        stream.start_at(Some(zero.clone()), Some(zero));
        let features = stream.push(time_s, cycle, signals);
        let of = |(force, model): (usize, &ForceModel)| {
            let load_n = model.estimate(&features).force;
            (load_n.is_finite() && load_n.abs() > model.loaded_above_n?)
                .then_some(Load { force, load_n })
        };
        self.estimator.forces.iter().enumerate().find_map(of)
    }
}
