//! Commands, a file or folder each.

pub(crate) mod compare;
pub(crate) mod db;
pub(crate) mod documents;
pub(crate) mod export;
pub(crate) mod force;
pub(crate) mod gsa;
pub(crate) mod library;
pub(crate) mod run;
pub(crate) mod serve;
pub(crate) mod shell;
pub(crate) mod solve;
pub(crate) mod sweep;
pub(crate) mod trade;
pub(crate) mod verify;
