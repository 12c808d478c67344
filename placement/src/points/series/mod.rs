//! Series of points: what each starts from, and how all are solved.
//!
//! - `starts`: which point's equilibrium each of the others begins with
//! - `scene_outcomes`: scenes that are no points of the plan
//! - `series_group`: series that are solved at once; `planned_points` solves one of them, `attempt` a point, `point_keys` names them, `point_readouts` says what is read off, `point_watch` tells how far a solve is
//! - `finite`: refuses what isn't a number

mod attempt;
mod finite;
mod planned_points;
mod point_keys;
mod point_readouts;
mod point_watch;
mod scene_outcomes;
mod series_group;
mod starts;

pub(crate) use self::planned_points::{Answers, Place};
pub(crate) use self::point_keys::keys;
pub(crate) use self::point_readouts::PointReadouts;
pub(crate) use self::scene_outcomes::{outcomes, outcomes_of_all};
pub(crate) use self::series_group::{PointSeries, SceneSeries, answers_of_all};
pub(crate) use self::starts::Starts;
