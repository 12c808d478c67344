//! Blame for a process's end.

use std::process::ExitStatus;

/// Blame for the end of a process that was to solve.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum Blame {
    /// Blame on nobody: it ended by itself, with or without an answer.
    Nobody,
    /// Blame on what it solved: what ended it.
    Itself(&'static str),
    /// Blame on somebody else, by the signal of this number.
    Outside(i32),
}

/// Counts how often the system has ended a process for lack of memory since it was started; None where it doesn't tell.
pub(super) fn memory_kills() -> Option<u64> {
    let counts = std::fs::read_to_string("/proc/vmstat").ok()?;
    let count = counts
        .lines()
        .find_map(|line| line.strip_prefix("oom_kill "));
    count?.trim().parse().ok()
}

/// Finds who ended a process, and whether the system ended any for lack of memory meanwhile.
pub(super) fn blame(status: ExitStatus, lacked_memory: bool) -> Blame {
    let Some(signal) = signal(status) else {
        return Blame::Nobody;
    };
    match signal {
        4 => Blame::Itself("SIGILL"),
        5 => Blame::Itself("SIGTRAP"),
        6 => Blame::Itself("SIGABRT"),
        7 => Blame::Itself("SIGBUS"),
        8 => Blame::Itself("SIGFPE"),
        // Nobody but the kernel kills so without being seen in its count.
        9 if lacked_memory => Blame::Itself("SIGKILL of the system for lack of memory"),
        11 => Blame::Itself("SIGSEGV"),
        other => Blame::Outside(other),
    }
}

#[cfg(unix)]
fn signal(status: ExitStatus) -> Option<i32> {
    std::os::unix::process::ExitStatusExt::signal(&status)
}

#[cfg(not(unix))]
fn signal(_: ExitStatus) -> Option<i32> {
    None
}

#[cfg(all(test, target_os = "linux"))]
mod tests {
    use std::process::Command;

    use super::*;

    fn ended(script: &str) -> ExitStatus {
        let ended = Command::new("sh").args(["-c", script]).status();
        ended.expect("a shell")
    }

    #[test]
    fn a_fault_of_its_own_is_told_from_a_kill() {
        let cases = [
            ("exit 0", false, Blame::Nobody),
            ("exit 101", true, Blame::Nobody),
            ("kill -ABRT $$", false, Blame::Itself("SIGABRT")),
            ("kill -SEGV $$", false, Blame::Itself("SIGSEGV")),
            ("kill -BUS $$", false, Blame::Itself("SIGBUS")),
            ("kill -ILL $$", false, Blame::Itself("SIGILL")),
            ("kill -FPE $$", false, Blame::Itself("SIGFPE")),
            ("kill -KILL $$", false, Blame::Outside(9)),
            ("kill -TERM $$", true, Blame::Outside(15)),
            // No shell leaves this one ignored.
            ("kill -USR1 $$", false, Blame::Outside(10)),
        ];
        for (script, lacked_memory, expected) in cases {
            assert_eq!(blame(ended(script), lacked_memory), expected, "{script}");
        }
        let lacked = Blame::Itself("SIGKILL of the system for lack of memory");
        assert_eq!(blame(ended("kill -KILL $$"), true), lacked);
    }

    #[test]
    fn the_system_counts_what_it_ends() {
        assert!(memory_kills().is_some());
    }
}
