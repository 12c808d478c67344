//! What is wrong with a document.

use serde::Serialize;

/// One fault of a document: where it is, and what would be right.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Fault {
    /// JSON pointer (RFC 6901) to the faulty value; empty for the document itself.
    pub pointer: String,
    /// What is wrong and what would be right, one sentence.
    pub detail: String,
}
