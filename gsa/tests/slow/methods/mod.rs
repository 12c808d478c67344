//! What every method keeps to, asked and told through one contract: on random models, and at the extremes.

mod contract;
mod extremes;
mod invariance;
mod shares;
