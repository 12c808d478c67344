//! Content hashes, and JSON that reads back as what was written.

use fem_client::hexadecimal::hexadecimal;
use serde::Serialize;
use serde::de::DeserializeOwned;
use sha2::{Digest, Sha256};

use crate::store_error::StoreError;

/// SHA-256 of the parts in order, each with its length so that no two lists of parts hash alike; lower-case hex.
pub fn sha256(parts: &[&[u8]]) -> String {
    let mut digest = Digested::default();
    for part in parts {
        digest.begin(part.len());
        digest.update(part);
    }
    digest.end()
}

/// Hash of parts that come in pieces, the same as of whole ones.
#[derive(Debug, Clone, Default)]
pub(crate) struct Digested(Sha256);

impl Digested {
    /// A part of so many bytes follows.
    pub(crate) fn begin(&mut self, bytes: usize) {
        self.0.update((bytes as u64).to_le_bytes());
    }

    /// A piece of it.
    pub(crate) fn update(&mut self, piece: &[u8]) {
        self.0.update(piece);
    }

    /// The hash of all parts.
    pub(crate) fn end(self) -> String {
        hexadecimal(&self.0.finalize())
    }
}

/// SHA-256 of a document as it stands in documents, lower-case hex.
pub(crate) fn document_sha256(text: &str) -> String {
    hexadecimal(&Sha256::digest(text))
}

/// A row's document, which has this hash.
///
/// # Errors
/// [`StoreError::Damaged`] when it hasn't.
pub(crate) fn intact<'d>(
    (table, row): (&'static str, &str),
    document: &'d str,
    sha256: &str,
) -> Result<&'d str, StoreError> {
    if document_sha256(document) == sha256 {
        return Ok(document);
    }
    Err(StoreError::Damaged {
        table,
        row: row.to_owned(),
    })
}

/// JSON text of a value, refused unless it reads back as the same value.
///
/// `serde_json` writes NaN and infinities as null without a word; reading back finds both, and any other loss.
///
/// # Errors
/// [`StoreError::NotFinite`] naming `what`.
pub fn encode<T>(what: &'static str, value: &T) -> Result<String, StoreError>
where
    T: Serialize + DeserializeOwned + PartialEq,
{
    let text = serde_json::to_string(value).map_err(|_| StoreError::NotFinite { what })?;
    match serde_json::from_str::<T>(&text) {
        Ok(read) if read == *value => Ok(text),
        _ => Err(StoreError::NotFinite { what }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_nan_is_refused_even_where_null_is_allowed() {
        assert!(encode("a number", &1.5).is_ok());
        assert!(matches!(
            encode("a number", &f64::NAN),
            Err(StoreError::NotFinite { what: "a number" })
        ));
        assert!(encode("an option", &Some(f64::INFINITY)).is_err());
        assert_eq!(
            encode("an option", &None::<f64>).expect("null is a value of its own"),
            "null"
        );
    }

    #[test]
    fn moving_a_byte_between_parts_changes_the_hash() {
        assert_ne!(sha256(&[b"ab", b"c"]), sha256(&[b"a", b"bc"]));
        // SHA-256 of eight zero bytes, the length of one empty part, computed with coreutils.
        assert_eq!(
            sha256(&[b""]),
            "af5570f5a1810b7af78caf4bc70a660f0df51e42baf91d4de5b2328de0e83dfc"
        );
    }
}
