//! Why a command failed, for people, for scripts, and as an exit code.

use std::fmt;

use fem_client::fault::Fault;
use serde_json::{Value, json};

/// A command's failure.
#[derive(Debug)]
pub enum Failure {
    /// The input is wrong: every fault.
    Input(Vec<Fault>),
    /// The physics has no answer.
    Physics {
        /// `limit-point`, `self-contact` or `not-converged`.
        status: String,
        /// Which load, how far it got.
        detail: String,
        /// What else is known, as members of the JSON document.
        known: Value,
    },
    /// The physics has no answer to a part of what was asked, and the rest was told already: a sentence.
    Partial(String),
    /// Anything else, a sentence.
    Other(String),
}

impl Failure {
    /// One fault of the command line itself.
    pub fn input(detail: impl Into<String>) -> Self {
        Self::Input(vec![Fault {
            pointer: String::new(),
            detail: detail.into(),
        }])
    }

    /// Anything that has a sentence to say.
    pub fn other(cause: impl fmt::Display) -> Self {
        Self::Other(cause.to_string())
    }

    /// The exit code.
    pub fn code(&self) -> u8 {
        match self {
            Self::Input(_) => 2,
            Self::Physics { .. } | Self::Partial(_) => 3,
            Self::Other(_) => 1,
        }
    }

    /// The failure as a JSON document.
    pub fn document(&self) -> Value {
        match self {
            Self::Input(faults) => {
                json!({"status": "refused", "detail": "the input is wrong", "errors": faults})
            }
            Self::Physics {
                status,
                detail,
                known,
            } => {
                let mut document = json!({"status": status, "detail": detail});
                if let (Value::Object(document), Value::Object(known)) = (&mut document, known) {
                    document.extend(known.clone());
                }
                document
            }
            Self::Partial(detail) | Self::Other(detail) => {
                json!({"status": "failed", "detail": detail})
            }
        }
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Input(faults) => faults.iter().try_for_each(|fault| writeln!(f, "{fault}")),
            Self::Physics { status, detail, .. } => {
                writeln!(f, "no equilibrium ({status}): {detail}")
            }
            Self::Partial(detail) | Self::Other(detail) => writeln!(f, "{detail}"),
        }
    }
}
