//! Recordings from their files.

use std::path::PathBuf;

use document::fault::Fault;
use service::forces::recorded_texts::{MOST_RECORDING_BYTES, NamedText};
use service::study_document::text_files::read_any_text;

/// The recordings that can be read, and why others can't.
pub(crate) fn recordings(paths: &[PathBuf]) -> (Vec<NamedText>, Vec<Fault>) {
    let mut files = Vec::new();
    let mut unread = Vec::new();
    for path in paths {
        match read_any_text(path, MOST_RECORDING_BYTES) {
            Ok(text) => files.push(NamedText {
                name: path.display().to_string(),
                text,
            }),
            Err(detail) => unread.push(Fault {
                pointer: String::new(),
                detail,
            }),
        }
    }
    (files, unread)
}
