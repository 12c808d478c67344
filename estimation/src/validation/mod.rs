//! Every model with every feature set on every split: what is learnt is never tested.
//!
//! Scale, outliers, hyperparameters and penalties are learnt from a fold's training rows alone. One [`Candidate`] of one force is one piece of work, which depends on
//! nothing but its arguments, so that whoever has cores can share the pieces out.
//!
//! - `candidate`: a model with a set of features; `learnt_model`: the same, learnt
//! - `split_set`: the splits of a force's rows
//! - `tested_rows`: what was said of left-out rows, and its errors; `another_session`: how those of one run are moved
//! - `judged`: a candidate on every split; `blend`: the median of those that are nearly as good as the best
//! - `begun_runs`: left-out runs that begin under a load, or are zeroed after lifting; `begun_run`: one of them
//! - `fit_time`: how long all of it takes

mod another_session;
mod begun_run;
mod begun_runs;
mod blend;
mod candidate;
mod fit_time;
mod judged;
mod learnt_model;
mod split_set;
mod tested_rows;

pub use another_session::ANOTHER_SESSION;
pub use begun_runs::{BegunError, BegunErrors, BegunRuns, Said};
pub use blend::blend;
pub use candidate::{Candidate, candidates};
pub use fit_time::{FitSizes, FitTime, fit_time};
pub use judged::{Judged, Outcome, judge, rolled, rolled_r2};
pub use learnt_model::LearntModel;
pub use split_set::Splits;
pub use tested_rows::{MOST_TESTED, SoundErrors, SplitFigures, Tested};
