//! Hashes the solver's sources, so that stored results are never mistaken for those of other numerics.

#[path = "../sources.rs"]
mod sources;

/// Folders whose sources determine a response.
const SOURCES: [&str; 2] = ["src", "../../fem/src"];

fn main() -> std::io::Result<()> {
    println!("cargo::rerun-if-changed=../sources.rs");
    println!(
        "cargo::rustc-env=SOLVER_SOURCES={}",
        sources::hash(&SOURCES)?
    );
    Ok(())
}
