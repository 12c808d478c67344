//! Processor time of this thread: other work on the machine hardly changes it.

/// Seconds that this thread has run on a processor so far (Linux).
pub fn cpu_seconds() -> f64 {
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").expect("Linux counts it");
    let nanoseconds: f64 = text
        .split_ascii_whitespace()
        .next()
        .and_then(|word| word.parse().ok())
        .expect("the first number is the time on a processor");
    1e-9 * nanoseconds
}
