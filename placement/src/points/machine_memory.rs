//! Memory that this process may take: the machine's, or less where a control group bounds it, as containers and systemd do.

use std::fs::read_to_string;
use std::path::Path;

/// Memory of the machine or of the control group that this process is in, bytes; without bound where the system doesn't tell.
pub fn machine_memory_bytes() -> u64 {
    let read = |path: &str| read_to_string(path).ok();
    let machine = read("/proc/meminfo").and_then(|text| total_bytes(&text));
    let groups = read("/proc/self/cgroup").unwrap_or_default();
    let group = group_bytes(&groups, read);
    machine.into_iter().chain(group).min().unwrap_or(u64::MAX)
}

fn total_bytes(meminfo: &str) -> Option<u64> {
    let line = meminfo
        .lines()
        .find_map(|line| line.strip_prefix("MemTotal:"))?;
    let kib: u64 = line.split_whitespace().next()?.parse().ok()?;
    Some(kib * 1024)
}

/// The least limit of the groups that a process is in and of those above them; of both versions of control groups (`man 7 cgroups`).
fn group_bytes(groups: &str, read: impl Fn(&str) -> Option<String>) -> Option<u64> {
    let limits = groups.lines().flat_map(|line| {
        let mut fields = line.splitn(3, ':').skip(1);
        let (controllers, group) = (fields.next().unwrap_or(""), fields.next().unwrap_or("/"));
        let (mount, file) = match controllers {
            "" => ("/sys/fs/cgroup", "memory.max"),
            _ => ("/sys/fs/cgroup/memory", "memory.limit_in_bytes"),
        };
        let counts = controllers.is_empty() || controllers.split(',').any(|one| one == "memory");
        let above = Path::new(group).ancestors().filter(move |_| counts);
        above
            .map(|group| {
                let group = group.to_string_lossy();
                format!("{mount}{}/{file}", group.trim_end_matches('/'))
            })
            .collect::<Vec<_>>()
    });
    // "max" stands for no limit.
    let bytes = limits.filter_map(|path| read(&path)?.trim().parse().ok());
    bytes.min()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_least_limit_above_a_process_counts_in_both_versions() {
        let files = [
            ("/sys/fs/cgroup/memory.max", "max\n"),
            ("/sys/fs/cgroup/system.slice/memory.max", "500000000\n"),
            ("/sys/fs/cgroup/system.slice/a.service/memory.max", "max\n"),
            (
                "/sys/fs/cgroup/memory/memory.limit_in_bytes",
                "9223372036854771712\n",
            ),
            (
                "/sys/fs/cgroup/memory/docker/c1/memory.limit_in_bytes",
                "700000000\n",
            ),
            ("/sys/fs/cgroup/cpu/memory.limit_in_bytes", "1\n"),
        ];
        let read = |path: &str| {
            let found = files.iter().find(|(file, _)| *file == path);
            found.map(|(_, text)| (*text).to_owned())
        };
        let second = "0::/system.slice/a.service\n";
        assert_eq!(group_bytes(second, read), Some(500_000_000));
        let first = "5:cpu:/\n4:cpuset,memory:/docker/c1\n0::/\n";
        assert_eq!(group_bytes(first, read), Some(700_000_000));
        // A container sees its own group as the root, whatever the path says.
        let other = "4:memory:/elsewhere/c2\n";
        assert_eq!(group_bytes(other, read), Some(9_223_372_036_854_771_712));
        assert_eq!(group_bytes("", read), None);
    }

    #[test]
    fn the_machine_s_is_in_kib() {
        assert_eq!(
            total_bytes("MemTotal:       16 kB\nMemFree: 1 kB\n"),
            Some(16_384)
        );
        assert_eq!(total_bytes(""), None);
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn this_machine_has_some() {
        let bytes = machine_memory_bytes();
        assert!((1 << 20..1 << 50).contains(&bytes), "{bytes}");
    }
}
