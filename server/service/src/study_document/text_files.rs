//! Text files of users, read up to a limit.

// What users name is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use document::fields::nearest;

/// Reads a text that has at most so many bytes; of a longer one no more than that is read.
///
/// # Errors
/// A sentence that names the file, and a name like it where there is none.
pub fn read_text(path: &Path, most_bytes: usize) -> Result<String, String> {
    let read = File::open(path).and_then(|file| bounded(file, most_bytes));
    match read {
        Ok(Some(text)) => Ok(text),
        Ok(None) => Err(format!(
            "{} can't be read: it has more than {most_bytes} bytes",
            path.display()
        )),
        Err(error) => {
            let hint = match error.kind() {
                io::ErrorKind::NotFound => like(path),
                _ => String::new(),
            };
            Err(format!("{} can't be read: {error}{hint}", path.display()))
        }
    }
}

/// The text, or none when there is more of it. A pipe doesn't say how long it is.
fn bounded(file: File, most_bytes: usize) -> io::Result<Option<String>> {
    let limit = u64::try_from(most_bytes).unwrap_or(u64::MAX);
    let length = file.metadata()?.len();
    if length > limit {
        return Ok(None);
    }
    let mut bytes = Vec::with_capacity(usize::try_from(length).unwrap_or(0).saturating_add(1));
    file.take(limit.saturating_add(1)).read_to_end(&mut bytes)?;
    if bytes.len() > most_bytes {
        return Ok(None);
    }
    let text = String::from_utf8(bytes);
    text.map(Some)
        .map_err(|_| io::Error::new(io::ErrorKind::InvalidData, "it is not UTF-8 text"))
}

/// Files of a folder that are looked at for a name like the one that isn't there.
const MOST_LOOKED_AT: usize = 1000;

fn like(path: &Path) -> String {
    let folder = match path.parent() {
        Some(folder) if folder != Path::new("") => folder,
        _ => Path::new("."),
    };
    let Some(name) = path.file_name().and_then(|name| name.to_str()) else {
        return String::new();
    };
    let files = folder.read_dir().into_iter().flatten().flatten();
    let names: Vec<String> = files
        .take(MOST_LOOKED_AT)
        .filter(|file| file.path().is_file())
        .filter_map(|file| file.file_name().into_string().ok())
        .collect();
    match nearest(name, names.iter().map(String::as_str)) {
        Some(near) => format!(". Did you mean {}?", path.with_file_name(near).display()),
        None => String::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_more_than_the_limit_is_read() {
        let folder = tempfile::tempdir().expect("temp dir");
        let path = folder.path().join("a.toml");
        std::fs::write(&path, "12345").expect("writes");
        assert_eq!(read_text(&path, 5).as_deref(), Ok("12345"));
        let refused = read_text(&path, 4).expect_err("too long");
        assert!(refused.ends_with("it has more than 4 bytes"), "{refused}");
        // Longer than memory, and not there: what isn't written takes no disk.
        let sparse = File::options().write(true).open(&path).expect("opens");
        sparse.set_len(1 << 40).expect("grows");
        assert!(read_text(&path, 1 << 20).is_err());
        std::fs::write(&path, [0xff]).expect("writes");
        let refused = read_text(&path, 4).expect_err("no text");
        assert!(refused.ends_with("it is not UTF-8 text"), "{refused}");
        assert!(read_text(folder.path(), 4).is_err(), "a folder");
    }

    #[cfg(unix)]
    #[test]
    fn what_does_not_end_is_cut_off() {
        let refused = read_text(Path::new("/dev/zero"), 1000).expect_err("no end");
        assert!(refused.ends_with("more than 1000 bytes"), "{refused}");
    }

    #[test]
    fn a_file_that_is_not_there_has_one_of_its_kind_named() {
        let folder = tempfile::tempdir().expect("temp dir");
        std::fs::write(folder.path().join("foot-tire.toml"), "").expect("writes");
        let near = read_text(&folder.path().join("foot-tyre.toml"), 4).expect_err("isn't there");
        assert!(near.ends_with("foot-tire.toml?"), "{near}");
        let far = read_text(&folder.path().join("quite-another"), 4).expect_err("isn't there");
        assert!(!far.contains("Did you mean"), "{far}");
    }
}
