//! The service from outside: a real listener, a fresh database, the closed-form solver behind it.

mod crashes;
mod dashboard;
mod edge;
mod events;
mod export;
mod films;
mod gone;
mod metrics;
mod openapi;
mod queue;
mod removal;
mod results;
mod studies;
mod sweeps;
