//! Failures of commands, for people, for scripts, and as exit codes.

use std::fmt;

use document::fault::Fault;
use document::visible::visible;
use serde_json::{Value, json};
use tasks::task_error::TaskError;

use crate::cli::terminal::paint::{BAD, painted};

/// A command's failure.
#[derive(Debug)]
pub enum Failure {
    /// The input is wrong: every fault.
    Input(Vec<Fault>),
    /// The input is wrong in part: every fault. The JSON document says them already, with the rest.
    Told(Vec<Fault>),
    /// The physics has no answer.
    Physics {
        /// `limit-point`, `self-contact` or `not-converged`.
        status: String,
        /// Load, and how far it got, in words.
        detail: String,
        /// Further facts, as members of the JSON document.
        known: Value,
    },
    /// The physics has no answer to a part of what was asked, and the rest was told already: a sentence.
    Partial(String),
    /// Another failure, a sentence.
    Other(String),
}

impl Failure {
    /// Makes a fault of the command line itself.
    pub fn input(detail: impl Into<String>) -> Self {
        Self::Input(vec![Fault {
            pointer: String::new(),
            detail: detail.into(),
        }])
    }

    /// Makes a failure of a sentence.
    pub fn other(cause: impl fmt::Display) -> Self {
        Self::Other(cause.to_string())
    }

    /// The exit code.
    pub fn code(&self) -> u8 {
        match self {
            Self::Input(_) | Self::Told(_) => 2,
            Self::Physics { .. } | Self::Partial(_) => 3,
            Self::Other(_) => 1,
        }
    }

    /// Returns what [`Display`](fmt::Display) says, painted for a terminal: what failed, or where, stands out.
    pub fn painted(&self) -> String {
        let line = |text: &dyn fmt::Display| painted(BAD, text) + "\n";
        match self {
            Self::Input(faults) | Self::Told(faults) => faults
                .iter()
                .map(|fault| match visible(&fault.pointer) {
                    pointer if pointer.is_empty() => line(fault),
                    pointer => format!("{}: {}\n", painted(BAD, pointer), fault.detail),
                })
                .collect(),
            Self::Physics { status, detail, .. } => {
                let what = format!("no equilibrium ({status})");
                format!("{}: {detail}\n", painted(BAD, what))
            }
            Self::Partial(detail) | Self::Other(detail) => line(detail),
        }
    }

    /// The failure as a JSON document.
    pub fn document(&self) -> Value {
        match self {
            Self::Input(faults) | Self::Told(faults) => {
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

impl From<TaskError> for Failure {
    fn from(error: TaskError) -> Self {
        match error {
            TaskError::Asked(detail) => Self::input(detail),
            error => Self::other(error),
        }
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Input(faults) | Self::Told(faults) => {
                faults.iter().try_for_each(|fault| writeln!(f, "{fault}"))
            }
            Self::Physics { status, detail, .. } => {
                writeln!(f, "no equilibrium ({status}): {detail}")
            }
            Self::Partial(detail) | Self::Other(detail) => writeln!(f, "{detail}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::terminal::shown::{plain, shown};

    #[test]
    fn paint_changes_nothing_that_is_said() {
        let fault = |pointer: &str, detail: &str| Fault {
            pointer: pointer.to_owned(),
            detail: detail.to_owned(),
        };
        let failures = [
            Failure::Input(vec![
                fault("", "there is no such study"),
                fault("/a\u{7f}b", "must be 0"),
            ]),
            Failure::Physics {
                status: "limit-point".to_owned(),
                detail: "at 0.12 MPa".to_owned(),
                known: Value::Null,
            },
            Failure::Partial("1 of 2 designs have no result".to_owned()),
            Failure::Other("stopped on request".to_owned()),
        ];
        for failure in failures {
            let painted = failure.painted();
            assert!(shown(&painted).contains("\u{1b}[31m"), "{painted:?}");
            assert_eq!(plain(&painted), failure.to_string());
        }
    }
}
