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
    read_as(path, most_bytes, |bytes| {
        let text = String::from_utf8(bytes);
        text.map_err(|_| io::Error::new(io::ErrorKind::InvalidData, "it is not UTF-8 text"))
    })
}

/// Reads a text as [`read_text`] does, which may be UTF-16 with its mark, too, or Latin-1: what spreadsheets and old loggers write.
///
/// # Errors
/// As of [`read_text`], but for the bytes, which are always some text.
pub fn read_any_text(path: &Path, most_bytes: usize) -> Result<String, String> {
    read_as(path, most_bytes, |bytes| Ok(decoded(bytes)))
}

fn decoded(bytes: Vec<u8>) -> String {
    let utf16 = |pair: fn([u8; 2]) -> u16| {
        let (pairs, _) = bytes.get(2..).unwrap_or_default().as_chunks::<2>();
        let units = pairs.iter().map(|bytes| pair(*bytes));
        char::decode_utf16(units)
            .map(|letter| letter.unwrap_or(char::REPLACEMENT_CHARACTER))
            .collect()
    };
    match bytes.as_slice() {
        [0xff, 0xfe, ..] => return utf16(u16::from_le_bytes),
        [0xfe, 0xff, ..] => return utf16(u16::from_be_bytes),
        _ => {}
    }
    String::from_utf8(bytes).unwrap_or_else(|error| {
        // Bytes of Latin-1 are the first characters of Unicode.
        error.into_bytes().into_iter().map(char::from).collect()
    })
}

fn read_as(
    path: &Path,
    most_bytes: usize,
    text_of: impl Fn(Vec<u8>) -> io::Result<String>,
) -> Result<String, String> {
    let read = File::open(path).and_then(|file| bounded(file, most_bytes));
    let read = read.and_then(|bytes| bytes.map(text_of).transpose());
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

/// The bytes, or none when there are more. A pipe doesn't say how long it is.
fn bounded(file: File, most_bytes: usize) -> io::Result<Option<Vec<u8>>> {
    let limit = u64::try_from(most_bytes).unwrap_or(u64::MAX);
    let length = file.metadata()?.len();
    if length > limit {
        return Ok(None);
    }
    let mut bytes = Vec::with_capacity(usize::try_from(length).unwrap_or(0).saturating_add(1));
    file.take(limit.saturating_add(1)).read_to_end(&mut bytes)?;
    Ok((bytes.len() <= most_bytes).then_some(bytes))
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
    fn bytes_of_other_encodings_become_text() {
        let utf16 = |order: fn(u16) -> [u8; 2]| -> Vec<u8> {
            "\u{feff}a,µ\n".encode_utf16().flat_map(order).collect()
        };
        assert_eq!(decoded(utf16(u16::to_le_bytes)), "a,µ\n");
        assert_eq!(decoded(utf16(u16::to_be_bytes)), "a,µ\n");
        assert_eq!(decoded(b"a,\xb5\n".to_vec()), "a,µ\n");
        assert_eq!(decoded("a,µ\n".into()), "a,µ\n");
    }

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
