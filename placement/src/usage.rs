//! What a run takes of the machine, read from Linux's `/proc/self`. Elsewhere every figure is 0.

use std::fs::read_to_string;

/// Ticks per second of the times in `/proc`: fixed at 100 for user space on every Linux architecture that Rust's
/// standard library supports.
const TICKS_PER_S: f64 = 100.0;

/// Processor time of this process with all its threads so far, s; 0 where `/proc` is absent.
pub fn cpu_s() -> f64 {
    read_to_string("/proc/self/stat")
        .ok()
        .and_then(|text| cpu_ticks(&text))
        .map_or(0.0, |ticks| ticks / TICKS_PER_S)
}

/// User and system time from the line of `/proc/self/stat`: fields 14 and 15.
fn cpu_ticks(stat: &str) -> Option<f64> {
    // The second field is the program's name in brackets and may hold anything, so count from its closing one.
    let mut fields = stat.rsplit_once(')')?.1.split_whitespace().skip(11);
    let mut ticks = || fields.next()?.parse::<f64>().ok();
    Some(ticks()? + ticks()?)
}

/// Largest resident memory of this process so far, bytes; 0 where `/proc` is absent.
pub fn peak_memory_bytes() -> u64 {
    read_to_string("/proc/self/status")
        .ok()
        .and_then(|text| kib(&text, "VmHWM:"))
        .map_or(0, |kib| kib * 1024)
}

/// Resident memory of this process now, bytes; 0 where `/proc` is absent.
pub fn memory_bytes() -> u64 {
    read_to_string("/proc/self/status")
        .ok()
        .and_then(|text| kib(&text, "VmRSS:"))
        .map_or(0, |kib| kib * 1024)
}

/// Memory of the machine, bytes; without bound where `/proc` is absent.
pub fn machine_memory_bytes() -> u64 {
    read_to_string("/proc/meminfo")
        .ok()
        .and_then(|text| kib(&text, "MemTotal:"))
        .map_or(u64::MAX, |kib| kib * 1024)
}

fn kib(status: &str, field: &str) -> Option<u64> {
    let line = status.lines().find_map(|line| line.strip_prefix(field))?;
    line.split_whitespace().next()?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_are_found_behind_any_program_name() {
        let stat = "7 (a) b (c) R 1 2 3 4 5 6 7 8 9 10 250 50 0 0 20 0 2 0 100 0 0";
        assert_eq!(cpu_ticks(stat), Some(300.0));
        assert_eq!(cpu_ticks("7 (a"), None);
    }

    #[test]
    fn peak_memory_is_in_kib() {
        assert_eq!(
            kib("VmPeak:\t 9 kB\nVmHWM:\t    1234 kB\n", "VmHWM:"),
            Some(1234)
        );
        assert_eq!(kib("", "VmHWM:"), None);
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn this_process_takes_memory() {
        // A test binary maps more than a megabyte of itself.
        assert!(memory_bytes() > 1 << 20);
        assert!(peak_memory_bytes() >= memory_bytes());
        assert!(machine_memory_bytes() > memory_bytes());
        assert!(cpu_s() >= 0.0);
    }
}
