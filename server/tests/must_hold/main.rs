//! What must hold, whatever happens to the process, the disk, the clock or the network: `tests/README.md` lists it case by case.

#![cfg(target_os = "linux")]

mod clock;
mod crowd;
mod damage;
mod disk;
mod hostile;
mod numbers;
#[path = "../program/mod.rs"]
mod program;
mod slow_clients;
mod small_disk;
mod starts;
#[path = "../api/support.rs"]
#[allow(dead_code)] // made for the tests of the routes, which use more of it
mod support;
mod timing;
