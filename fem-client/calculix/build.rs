//! Hashes the sources of deck, mesh and readout, so that stored results are never mistaken for those of other numerics.

#[path = "../sources.rs"]
mod sources;

/// Folders whose sources determine a response.
const SOURCES: [&str; 3] = ["src", "../tire/src", "../../fem/src"];

fn main() -> std::io::Result<()> {
    println!("cargo::rerun-if-changed=../sources.rs");
    println!(
        "cargo::rustc-env=SOLVER_SOURCES={}",
        sources::hash(&SOURCES)?
    );
    Ok(())
}
