#![no_main]

#[path = "../recorded_checks.rs"]
#[allow(dead_code)] // each target has a check of its own
mod checks;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    if let Ok(text) = std::str::from_utf8(bytes) {
        checks::recording(text);
    }
});
