//! One file per command; `designs` runs those of a sweep.

pub(crate) mod compare;
pub(crate) mod db;
mod designs;
pub(crate) mod export;
pub(crate) mod gsa;
pub(crate) mod library;
pub(crate) mod run;
pub(crate) mod serve;
pub(crate) mod shell;
pub(crate) mod solve;
pub(crate) mod sweep;
pub(crate) mod trade;
pub(crate) mod validate;
pub(crate) mod verify;
