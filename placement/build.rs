//! Hashes the sources of the analysis, so that a result is never mistaken for one of other statistics.

use std::path::{Path, PathBuf};

use sha2::{Digest, Sha256};

/// Folders whose sources make a result of responses.
const SOURCES: [&str; 2] = ["src", "../gsa/src"];

fn main() -> std::io::Result<()> {
    let root = PathBuf::from(std::env::var_os("CARGO_MANIFEST_DIR").unwrap_or_default());
    let mut files = Vec::new();
    for folder in SOURCES {
        println!("cargo::rerun-if-changed={folder}");
        collect(&root.join(folder), &mut files)?;
    }
    files.sort();
    let mut hash = Sha256::new();
    for file in &files {
        let name = file.strip_prefix(&root).unwrap_or(file);
        hash.update(name.as_os_str().as_encoded_bytes());
        hash.update(std::fs::read(file)?);
    }
    let digits = hash
        .finalize()
        .iter()
        .take(6)
        .fold(String::new(), |text, byte| text + &format!("{byte:02x}"));
    println!("cargo::rustc-env=ANALYSIS_SOURCES={digits}");
    Ok(())
}

fn collect(folder: &Path, files: &mut Vec<PathBuf>) -> std::io::Result<()> {
    for entry in std::fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            collect(&path, files)?;
        } else {
            files.push(path);
        }
    }
    Ok(())
}
