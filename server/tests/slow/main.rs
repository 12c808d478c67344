//! Tests of what must hold, whatever happens to the process, the disk, the clock or the network: `tests/README.md` lists it case by case. And what an
//! estimate is worth, beside nothing else but these.

#![cfg(target_os = "linux")]

#[path = "../quick/app.rs"]
#[allow(dead_code)] // made for the tests of the routes, which use more of it
mod app;
mod clock;
mod crowd;
mod damage;
mod disk;
mod estimates;
mod hostile;
mod kill;
mod numbers;
#[path = "../quick/program/mod.rs"]
mod program;
mod slow_clients;
mod small_disk;
mod starts;
mod timing;
mod upkeep;
