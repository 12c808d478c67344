//! The service from outside: a real listener, a fresh database, the closed-form solver behind it.

mod access;
mod crashes;
mod dashboard;
mod events;
mod export;
mod gone;
mod guard;
mod limits;
mod metrics;
mod openapi;
mod queue;
mod removal;
mod results;
mod studies;
mod sweeps;
