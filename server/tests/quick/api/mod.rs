//! The service from outside: a real listener, a fresh database, the closed-form solver behind it.

mod answers;
mod at_once;
mod crashes;
mod dashboard;
mod edge;
mod events;
mod gone;
mod lists;
mod metrics;
mod openapi;
mod queue;
mod removal;
mod studies;
mod sweeps;
