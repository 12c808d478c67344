//! Hashes sources at build time, so that what they computed is never mistaken for what others did. A part of the build scripts of
//! tire, calculix and placement.

use std::io;
use std::path::{Path, PathBuf};

use sha2::{Digest, Sha256};

/// [`hash_below`] of folders below the package that is built; a change of any of their files has it built again.
pub fn hash(folders: &[&str]) -> io::Result<String> {
    for folder in folders {
        println!("cargo::rerun-if-changed={folder}");
    }
    let package = std::env::var_os("CARGO_MANIFEST_DIR").unwrap_or_default();
    hash_below(Path::new(&package), folders)
}

/// Twelve hexadecimal digits that stand for names and content of all files of these folders, whose paths begin at the root.
pub fn hash_below(root: &Path, folders: &[&str]) -> io::Result<String> {
    let mut files = Vec::new();
    for folder in folders {
        collect(&root.join(folder), &mut files)?;
    }
    files.sort();
    let mut hash = Sha256::new();
    for file in &files {
        let name = file.strip_prefix(root).unwrap_or(file);
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
