//! Hashes the sources of the analysis, so that a result is never mistaken for one of other statistics.

#[path = "../fem-client/sources.rs"]
mod sources;

/// Folders whose sources make a result of responses.
const SOURCES: [&str; 7] = [
    "src",
    "documents/src",
    "layouts/src",
    "results/src",
    "rig/src",
    "../gsa/src",
    "../estimation/src",
];

fn main() -> std::io::Result<()> {
    println!("cargo::rerun-if-changed=../fem-client/sources.rs");
    println!(
        "cargo::rustc-env=ANALYSIS_SOURCES={}",
        sources::hash(&SOURCES)?
    );
    Ok(())
}
