//! The program from outside: its command line, and the service over HTTP with the closed-form solver behind it.

mod api;
mod app;
mod cli;
mod estimators;
mod forces;
mod interrupted;
mod isolated;
mod long_results;
mod numerics;
mod own_models;
mod program;
mod recorded;
mod rig_recordings;
mod told_answers;
