//! Faults of documents.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use serde::{Deserialize, Serialize};

use crate::visible::visible;

/// Faults listed for one document; a document with more is told so in a last fault.
pub const MAX_FAULTS: usize = 100;

/// A fault of a document: where it is, and what would be right.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct Fault {
    /// JSON pointer (RFC 6901) to the faulty value; empty for the document itself.
    pub pointer: String,
    /// Sentence that says what is wrong and what would be right.
    pub detail: String,
}

impl Fault {
    /// Appends a fault to the list, which never grows beyond [`MAX_FAULTS`] and one closing entry.
    pub fn add(faults: &mut Vec<Self>, pointer: &str, detail: impl Into<String>) {
        match faults.len().cmp(&MAX_FAULTS) {
            std::cmp::Ordering::Less => {
                faults.push(Self {
                    pointer: pointer.to_owned(),
                    detail: detail.into(),
                });
            }
            std::cmp::Ordering::Equal => faults.push(Self {
                pointer: String::new(),
                detail: format!("there are more than {MAX_FAULTS} faults; the rest isn't listed"),
            }),
            std::cmp::Ordering::Greater => {}
        }
    }

    /// Whether the list is full: what else is wrong isn't told.
    pub fn are_enough(faults: &[Self]) -> bool {
        faults.len() > MAX_FAULTS
    }
}

impl std::fmt::Display for Fault {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        if self.pointer.is_empty() {
            f.write_str(&self.detail)
        } else {
            write!(f, "{}: {}", visible(&self.pointer), self.detail)
        }
    }
}

/// The pointer of a member: `pointer` followed by `name`, escaped as RFC 6901 asks.
pub fn member(pointer: &str, name: &str) -> String {
    format!("{pointer}/{}", name.replace('~', "~0").replace('/', "~1"))
}

/// The pointer of an array's entry.
pub fn entry(pointer: &str, index: usize) -> String {
    format!("{pointer}/{index}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_list_of_faults_is_bounded() {
        let mut faults = Vec::new();
        for i in 0..10 * MAX_FAULTS {
            Fault::add(&mut faults, &entry("", i), "bad");
        }
        assert_eq!(faults.len(), MAX_FAULTS + 1);
        assert!(faults[MAX_FAULTS].detail.contains("more than 100"));
    }

    #[test]
    fn names_are_escaped_in_pointers() {
        assert_eq!(member("/a", "b/c~d"), "/a/b~1c~0d");
    }
}
