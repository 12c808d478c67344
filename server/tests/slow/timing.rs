//! Times of requests.

use std::time::Duration;

/// The duration that 99 % of all stay below.
pub fn p99(mut durations: Vec<Duration>) -> Duration {
    durations.sort();
    let at = (durations.len() * 99).div_ceil(100);
    durations[at.clamp(1, durations.len()) - 1]
}

#[test]
fn the_ninety_ninth_of_a_hundred() {
    let durations = (1..=100).rev().map(Duration::from_millis).collect();
    assert_eq!(p99(durations), Duration::from_millis(99));
    assert_eq!(p99(vec![Duration::from_secs(3)]), Duration::from_secs(3));
}
