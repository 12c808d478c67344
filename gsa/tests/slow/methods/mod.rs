//! Contract of the methods: on random models, and at the extremes.

mod contract;
mod extremes;
mod invariance;
mod shares;
