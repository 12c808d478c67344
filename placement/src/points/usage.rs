//! Usage of the machine by a run, read from Linux's `/proc`. Elsewhere every figure is 0.

use std::cell::Cell;
use std::fs::read_to_string;
use std::time::Instant;

use results::StudyCost;

thread_local! {
    /// Processor time of ended threads that worked for this one, s.
    static CREDITED: Cell<f64> = const { Cell::new(0.0) };
}

/// Processor time of this thread so far, and of those that [`credit`] counted with it, s; 0 where `/proc` is absent. What runs beside it
/// in the same process isn't counted.
pub fn cpu_s() -> f64 {
    let own = read_to_string("/proc/thread-self/schedstat");
    let own = own.ok().and_then(|text| on_processor_s(&text));
    own.unwrap_or(0.0) + CREDITED.get()
}

/// Counts the processor time of a thread that worked for this one, and has ended, with this one's.
pub fn credit(cpu_s: f64) {
    CREDITED.set(CREDITED.get() + cpu_s);
}

/// The first number is the time on a processor, ns.
fn on_processor_s(schedstat: &str) -> Option<f64> {
    let nanoseconds: f64 = schedstat.split_whitespace().next()?.parse().ok()?;
    Some(1e-9 * nanoseconds)
}

/// Clock and processor time of this thread's work since it was started.
#[derive(Debug, Clone, Copy)]
pub struct Stopwatch {
    begun: Instant,
    cpu_s: f64,
}

impl Stopwatch {
    /// Starts now.
    pub fn start() -> Self {
        Self {
            begun: Instant::now(),
            cpu_s: cpu_s(),
        }
    }

    /// Adds what the work took so far to a cost, whose peak of memory becomes that of now.
    pub fn add_to(&self, cost: &mut StudyCost) {
        cost.wall_s += self.begun.elapsed().as_secs_f64();
        cost.cpu_s += (cpu_s() - self.cpu_s).max(0.0);
        cost.peak_memory_bytes = peak_memory_bytes();
    }
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

fn kib(status: &str, field: &str) -> Option<u64> {
    let line = status.lines().find_map(|line| line.strip_prefix(field))?;
    line.split_whitespace().next()?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn time_on_a_processor_is_in_nanoseconds() {
        assert_eq!(on_processor_s("2500000000 17 3\n"), Some(2.5));
        assert_eq!(on_processor_s(""), None);
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn a_thread_s_time_is_its_own_until_it_is_credited() {
        const BUSY: f64 = 0.2;
        let busy = || {
            while cpu_s() < BUSY {
                std::hint::black_box(0);
            }
            cpu_s()
        };
        let before = cpu_s();
        let theirs = std::thread::spawn(busy).join().unwrap();
        assert!(theirs >= BUSY);
        let waited = cpu_s() - before;
        assert!(waited < BUSY / 2.0, "{waited} s of waiting");
        credit(theirs);
        assert!(cpu_s() - before >= theirs);
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
    }
}
