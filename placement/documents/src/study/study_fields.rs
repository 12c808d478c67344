//! Names of a study's fields.

/// Fields of a study's document.
pub const FIELDS: [&str; 10] = [
    "name",
    "scene",
    "inputs",
    "candidates",
    "layouts",
    "question",
    "method",
    "accuracy",
    "signals",
    "rig",
];
