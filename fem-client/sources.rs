//! Hashes sources at build time, so that what they computed is never mistaken for what others did. A part of the build scripts of this package and of placement.

use std::io;
use std::path::{Path, PathBuf};

use sha2::{Digest, Sha256};

/// Twelve hexadecimal digits that stand for all files of these folders, whose paths begin at the package's; a change of any of them has
/// the package built again.
pub fn hash(folders: &[&str]) -> io::Result<String> {
    let root = PathBuf::from(std::env::var_os("CARGO_MANIFEST_DIR").unwrap_or_default());
    let mut files = Vec::new();
    for folder in folders {
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
    let digest = hash.finalize();
    let digits = digest.iter().take(6);
    Ok(digits.fold(String::new(), |text, byte| text + &format!("{byte:02x}")))
}

fn collect(folder: &Path, files: &mut Vec<PathBuf>) -> io::Result<()> {
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
