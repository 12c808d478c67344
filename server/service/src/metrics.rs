//! Metrics of the service: what it has done and how it is, in the text format that Prometheus reads.
//!
//! Every label has a bounded number of values: states, outcomes, methods, statuses, and routes as they are written in the router, never
//! the addresses that clients ask for.

use std::sync::Arc;

use placement::points::Event;
use prometheus_client::encoding::EncodeLabelSet;
use prometheus_client::encoding::text::encode;
use prometheus_client::metrics::counter::Counter;
use prometheus_client::metrics::family::Family;
use prometheus_client::metrics::gauge::Gauge;
use prometheus_client::metrics::histogram::{Histogram, exponential_buckets};
use prometheus_client::registry::{Registry, Unit};

use store::queue::study_rows::State;

/// The media type of [`Metrics::text`].
pub const MEDIA_TYPE: &str = "application/openmetrics-text; version=1.0.0; charset=utf-8";

/// Buckets of solves, s: 4 ms, a solve of the draft mesh from a start, to two hours.
const SOLVE_BUCKETS: (f64, u16) = (0.004, 11);
/// Buckets of requests, s: half a millisecond to half a minute, the longest that a body may take.
const REQUEST_BUCKETS: (f64, u16) = (0.0005, 9);
/// Fine enough to tell a slow service from a quick one, coarse enough for few lines.
const BUCKET_FACTOR: f64 = 4.0;

/// Counts what happens. All parts of a service share one.
#[derive(Debug)]
pub struct Metrics {
    registry: Registry,
    points: Family<Point, Counter>,
    solve_s: Histogram,
    requests: Family<Request, Counter>,
    request_s: Family<Route, Histogram>,
    now: Now,
}

/// Gauges of the present state, asked for when somebody reads.
#[derive(Debug, Default)]
struct Now {
    studies: Family<OfState, Gauge>,
    estimators: Family<OfState, Gauge>,
    engine_tasks: Family<OfEngine, Gauge>,
    database_bytes: Gauge,
    event_streams: Gauge,
    memory_bytes: Gauge,
}

/// Outcome of a point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PointOutcome {
    /// A solved point.
    Solved,
    /// A point without an equilibrium, or whose solve broke.
    Failed,
    /// Another study had solved it.
    Reused,
}

impl PointOutcome {
    fn as_str(self) -> &'static str {
        match self {
            Self::Solved => "solved",
            Self::Failed => "failed",
            Self::Reused => "reused",
        }
    }
}

/// Snapshot of the present state.
#[derive(Debug)]
pub struct Snapshot {
    /// Studies of each state.
    pub studies: Vec<(State, i64)>,
    /// Estimators of each state.
    pub estimators: Vec<(State, i64)>,
    /// Tasks that other machines have, by engine and state.
    pub engine_tasks: Vec<(&'static str, &'static str, usize)>,
    /// Size of the database with its write-ahead log.
    pub database_bytes: u64,
    /// Open event streams.
    pub event_streams: usize,
    /// Resident memory of the process.
    pub memory_bytes: u64,
}

#[derive(Debug, Clone, PartialEq, Eq, Hash, EncodeLabelSet)]
struct Point {
    outcome: &'static str,
}

#[derive(Debug, Clone, PartialEq, Eq, Hash, EncodeLabelSet)]
struct OfState {
    state: &'static str,
}

#[derive(Debug, Clone, PartialEq, Eq, Hash, EncodeLabelSet)]
struct OfEngine {
    engine: &'static str,
    state: &'static str,
}

#[derive(Debug, Clone, PartialEq, Eq, Hash, EncodeLabelSet)]
struct Route {
    route: String,
}

#[derive(Debug, Clone, PartialEq, Eq, Hash, EncodeLabelSet)]
struct Request {
    method: &'static str,
    route: String,
    status: u16,
}

fn histogram((least, count): (f64, u16)) -> Histogram {
    Histogram::new(exponential_buckets(least, BUCKET_FACTOR, count))
}

impl Metrics {
    /// Begins before anything has happened.
    pub fn new() -> Arc<Self> {
        let mut metrics = Self {
            registry: Registry::default(),
            points: Family::default(),
            solve_s: histogram(SOLVE_BUCKETS),
            requests: Family::default(),
            request_s: Family::new_with_constructor(|| histogram(REQUEST_BUCKETS)),
            now: Now::default(),
        };
        // A series that begins at zero shows its first rise.
        for outcome in [
            PointOutcome::Solved,
            PointOutcome::Failed,
            PointOutcome::Reused,
        ] {
            metrics.points_of(outcome);
        }
        metrics.register();
        Arc::new(metrics)
    }

    fn register(&mut self) {
        let own = self.registry.sub_registry_with_prefix("strainsite");
        own.register("points", "Points by what came of them", self.points.clone());
        own.register_with_unit(
            "solve",
            "Wall-clock time of solves",
            Unit::Seconds,
            self.solve_s.clone(),
        );
        own.register(
            "requests",
            "Requests by method, route and status",
            self.requests.clone(),
        );
        let latency = self.request_s.clone();
        own.register_with_unit(
            "request",
            "Time to the head of the answer",
            Unit::Seconds,
            latency,
        );
        let now = &self.now;
        own.register("studies", "Studies by state", now.studies.clone());
        own.register("estimators", "Estimators by state", now.estimators.clone());
        own.register(
            "engine_tasks",
            "Tasks of sweeps that other machines solve, by engine and state",
            now.engine_tasks.clone(),
        );
        let size = now.database_bytes.clone();
        own.register_with_unit(
            "database",
            "Size of the database with its log",
            Unit::Bytes,
            size,
        );
        own.register(
            "event_streams",
            "Open event streams",
            now.event_streams.clone(),
        );
        let memory = now.memory_bytes.clone();
        self.registry.register_with_unit(
            "process_resident_memory",
            "Resident memory",
            Unit::Bytes,
            memory,
        );
    }

    fn points_of(&self, outcome: PointOutcome) -> Counter {
        let outcome = outcome.as_str();
        self.points.get_or_create_owned(&Point { outcome })
    }

    /// Counts points that ended in this way.
    pub fn points(&self, outcome: PointOutcome, count: u64) {
        self.points_of(outcome).inc_by(count);
    }

    /// Counts an event of a run.
    pub fn event(&self, event: &Event) {
        match event {
            Event::PointSolved { .. } => self.points(PointOutcome::Solved, 1),
            Event::PointFailed { .. } => self.points(PointOutcome::Failed, 1),
            Event::Started { .. }
            | Event::Solving { .. }
            | Event::Analysing
            | Event::Revised(_) => {}
        }
    }

    /// A solve took this long, s.
    pub fn solve(&self, wall_s: f64) {
        self.solve_s.observe(wall_s);
    }

    /// A request was answered after so many seconds. The route is the router's.
    pub fn request(&self, method: &'static str, route: &str, status: u16, wall_s: f64) {
        let route = route.to_owned();
        self.request_s
            .get_or_create_owned(&Route {
                route: route.clone(),
            })
            .observe(wall_s);
        self.requests
            .get_or_create_owned(&Request {
                method,
                route,
                status,
            })
            .inc();
    }

    /// Writes all of it as text.
    pub fn text(&self, now: &Snapshot) -> String {
        let of_states = [
            (&self.now.studies, &now.studies),
            (&self.now.estimators, &now.estimators),
        ];
        for (family, counts) in of_states {
            for (state, count) in counts {
                let state = state.as_str();
                family.get_or_create_owned(&OfState { state }).set(*count);
            }
        }
        for &(engine, state, count) in &now.engine_tasks {
            let count = i64::try_from(count).unwrap_or(i64::MAX);
            let gauge = &self.now.engine_tasks;
            gauge
                .get_or_create_owned(&OfEngine { engine, state })
                .set(count);
        }
        let whole = |bytes: u64| i64::try_from(bytes).unwrap_or(i64::MAX);
        self.now.database_bytes.set(whole(now.database_bytes));
        self.now.memory_bytes.set(whole(now.memory_bytes));
        self.now
            .event_streams
            .set(i64::try_from(now.event_streams).unwrap_or(i64::MAX));
        let mut text = String::new();
        // Writing to a String can't fail.
        let _ = encode(&mut text, &self.registry);
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_counted_stands_in_the_text() {
        let metrics = Metrics::new();
        metrics.points(PointOutcome::Solved, 2);
        metrics.solve(0.01);
        metrics.request("GET", "/v1/studies/{id}", 404, 0.001);
        let text = metrics.text(&Snapshot {
            studies: vec![(State::Queued, 7), (State::Done, 2)],
            estimators: vec![(State::Running, 1)],
            engine_tasks: vec![("slurm", "waiting", 5)],
            database_bytes: 4096,
            event_streams: 3,
            memory_bytes: 1 << 20,
        });
        for line in [
            "strainsite_points_total{outcome=\"solved\"} 2",
            "strainsite_points_total{outcome=\"reused\"} 0",
            "strainsite_solve_seconds_bucket{le=\"0.004\"} 0",
            "strainsite_solve_seconds_bucket{le=\"0.016\"} 1",
            "strainsite_solve_seconds_count 1",
            "strainsite_requests_total{method=\"GET\",route=\"/v1/studies/{id}\",status=\"404\"} 1",
            "strainsite_request_seconds_count{route=\"/v1/studies/{id}\"} 1",
            "strainsite_studies{state=\"queued\"} 7",
            "strainsite_estimators{state=\"running\"} 1",
            "strainsite_engine_tasks{engine=\"slurm\",state=\"waiting\"} 5",
            "strainsite_database_bytes 4096",
            "strainsite_event_streams 3",
            "process_resident_memory_bytes 1048576",
            "# EOF",
        ] {
            assert!(
                text.lines().any(|known| known == line),
                "{line} is not in {text}"
            );
        }
    }
}
