//! Answers as they were recorded, in `answers/`: `tests/README.md` says how to record them anew.

mod commands;
mod redaction;
mod refused_commands;
mod refused_requests;
mod requests;
mod session;

/// Compares a text with the record of this name.
fn compare(name: &str, text: &str) {
    let mut settings = insta::Settings::new();
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/quick/recorded/answers");
    settings.set_snapshot_path(folder);
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!(name, text));
}
