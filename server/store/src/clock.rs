//! The time, as rows have it.

use std::time::Duration;

use jiff::Timestamp;

/// The time now, RFC 3339, UTC, to the millisecond.
pub fn now() -> String {
    written(Timestamp::now())
}

/// The time so long ago, as [`now`] writes it; the earliest time there is for what was before that.
pub fn before(age: Duration) -> String {
    written(
        Timestamp::now()
            .saturating_sub(age)
            .unwrap_or(Timestamp::MIN),
    )
}

fn written(time: Timestamp) -> String {
    format!("{time:.3}")
}
