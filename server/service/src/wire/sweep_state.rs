//! State of a sweep.

use store::queue::study_rows::State;

/// Returns the state of a sweep by whether it has any design in a state: at work while any is or some still wait, cancelled when any was, done when any has a result.
pub(crate) fn state_of(any: impl Fn(State) -> bool) -> State {
    let waits = any(State::Queued);
    let begun = any(State::Running) || any(State::Done) || any(State::Failed);
    match (waits, any(State::Running)) {
        (_, true) => State::Running,
        (true, false) if begun => State::Running,
        (true, false) => State::Queued,
        (false, false) if any(State::Cancelled) => State::Cancelled,
        (false, false) if any(State::Done) => State::Done,
        (false, false) => State::Failed,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sweep_stands_where_its_designs_do() {
        use State::{Cancelled, Done, Failed, Queued, Running};
        for (designs, state) in [
            (&[Queued, Queued][..], Queued),
            (&[Queued, Running], Running),
            (&[Done, Queued], Running),
            (&[Done, Done], Done),
            (&[Done, Failed], Done),
            (&[Failed, Failed], Failed),
            (&[Done, Cancelled], Cancelled),
            (&[Cancelled, Queued], Queued),
        ] {
            assert_eq!(state_of(|any| designs.contains(&any)), state, "{designs:?}");
        }
    }
}
