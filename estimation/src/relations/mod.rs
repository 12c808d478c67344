//! Relations of signals to each other: a sensor that is stuck, halved, swapped or spiked reads what the others make unlikely.
//!
//! - `learnt_relations`: each signal by a line of the others, with limits from left-out runs, as data
//! - `relation_watch`: the rows of one run held against them, one after another
//! - `left_out_residuals`: residuals of runs that weren't learnt from; `still_stretch`: how long signals stand still

pub(crate) mod learnt_relations;
mod left_out_residuals;
pub(crate) mod relation_watch;
mod still_stretch;
