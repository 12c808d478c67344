//! Columns of a file that are meant: by name, by pattern, or by what is usual.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use std::collections::HashSet;

use serde::{Deserialize, Serialize};

use crate::recipe::column_names::is_pattern;
use crate::recipe::time_unit::TimeUnit;
use crate::recipe::{Columns, CycleRule};
use crate::recording::csv_line::quoted;
use crate::recording::force_unit::{ForceColumn, column_of, force_of};
use crate::recording::recording_fault::FaultList;
use crate::recording::time_column::{is_time, nanoseconds_beside, unit_of};

/// The columns' names, the same for all runs.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct NamedColumns {
    /// Seconds.
    pub time: String,
    /// Signals, in the order of the first file.
    pub signals: Vec<String>,
    /// Forces, N.
    pub forces: Vec<String>,
    /// Column that tells cycles apart.
    pub cycle: Option<String>,
    /// Unit of the time, where it isn't seconds.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub time_unit: Option<TimeUnit>,
    /// Columns of the forces that are in other units than newtons, in the order of the forces; the forces have names in newtons.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub converted: Vec<String>,
}

/// Name of the column of time where a recipe names none; a file without it has time first.
const TIME: &str = "time_s";
/// Forces where a recipe names none, as [`plain`] makes their names; the first patterns that fit a column decide.
const FORCES: [&[&str]; 7] = [
    &["f?_n"],
    &["force_n"],
    &["f_n"],
    &["f?"],
    &["force_x_n", "force_y_n", "force_z_n"],
    &["force_x", "force_y", "force_z"],
    &["force"],
];

/// Names of forces without their units, as `[N]` and `_kn` are.
const BASES: [&str; 4] = ["f?", "f", "force_?", "force"];

impl NamedColumns {
    /// Finds the columns in the headers of all runs. A signal by pattern is meant when one file has it; whether a file has all of them, [`Self::check`] tells.
    pub fn find<'h>(columns: &Columns, headers: impl IntoIterator<Item = &'h Vec<String>>) -> Self {
        let all = union(headers.into_iter().flatten());
        let time = match &columns.time {
            Some(name) => name.clone(),
            None if all.iter().any(|name| name == TIME) => TIME.to_owned(),
            None => {
                let usual = all.iter().find(|name| is_time(name));
                usual.or(all.first()).cloned().unwrap_or_default()
            }
        };
        let cycle = match &columns.cycles {
            CycleRule::Column(name) => Some(name.clone()),
            _ => None,
        };
        let beside = nanoseconds_beside(&time, &all);
        let of_time = |name: &String| *name == time || Some(name) == beside;
        let rest: Vec<&String> = all
            .iter()
            .filter(|name| !of_time(name) && Some(*name) != cycle.as_ref())
            .collect();
        let measured = match &columns.forces {
            Some(patterns) => matching(patterns, &rest),
            None => usual_forces(&rest),
        };
        let taken: HashSet<&String> = measured.iter().collect();
        let signals: Vec<&String> = rest
            .iter()
            .copied()
            .filter(|name| !taken.contains(name))
            .collect();
        let signals = match &columns.signals {
            Some(patterns) => matching(patterns, &signals),
            None => signals.into_iter().cloned().collect(),
        };
        let not = columns.not_signals.iter().flatten();
        let is_left = |name: &String| !not.clone().any(|pattern| matches(pattern, name));
        let signals = signals.into_iter().filter(is_left).collect();
        let unit = columns.time_unit.or_else(|| unit_of(&time));
        Self {
            time_unit: unit.filter(|unit| *unit != TimeUnit::S),
            converted: other_units(&measured),
            forces: in_newtons(&measured),
            time,
            signals,
            cycle,
        }
    }

    /// A sentence on each column of forces that is converted.
    pub fn conversions(&self) -> impl Iterator<Item = String> {
        self.converted.iter().map(|column| {
            format!(
                "force {} is column {} times {}, in newtons",
                force_of(column).escape_debug(),
                column.escape_debug(),
                ForceColumn::of(column).newtons
            )
        })
    }

    /// A fault for each column that a header lacks, and where no column is meant at all.
    pub fn check(&self, columns: &Columns, header: &[String], faults: &mut FaultList) {
        self.check_any_signal(columns, header, faults);
        if self.forces.is_empty() {
            faults.add(Some(1), None, nothing("forces", &columns.forces, header));
        }
        self.check_header(header, faults);
    }

    /// A fault for each column but forces that a header lacks, and where no signal is meant at all.
    pub(super) fn check_without_forces(
        &self,
        columns: &Columns,
        header: &[String],
        faults: &mut FaultList,
    ) {
        self.check_any_signal(columns, header, faults);
        self.check_unlabelled(header, faults);
    }

    fn check_any_signal(&self, columns: &Columns, header: &[String], faults: &mut FaultList) {
        if self.signals.is_empty() {
            faults.add(Some(1), None, nothing("signals", &columns.signals, header));
        }
    }

    fn check_header(&self, header: &[String], faults: &mut FaultList) {
        let cycle = self.cycle.iter();
        let there: HashSet<&String> = header.iter().collect();
        for name in std::iter::once(&self.time)
            .chain(&self.signals)
            .chain(&self.forces)
            .chain(cycle)
        {
            if faults.is_full() {
                return;
            }
            let is_there = there.contains(name)
                || self.forces.contains(name) && column_of(name, header).is_some();
            if !is_there {
                let detail = format!("is missing; the file has {}", listed(header));
                faults.add(Some(1), Some(name), detail);
            }
        }
    }

    /// Returns those of the columns that a header has, the time apart.
    pub fn among(&self, header: &[String]) -> Self {
        let known: HashSet<&String> = header.iter().collect();
        let signals = self.signals.iter().filter(|name| known.contains(name));
        let forces = self.forces.iter();
        let forces = forces.filter(|name| column_of(name, header).is_some());
        let converted = self.converted.iter().filter(|name| known.contains(name));
        Self {
            time: self.time.clone(),
            time_unit: self.time_unit,
            converted: converted.cloned().collect(),
            signals: signals.cloned().collect(),
            forces: forces.cloned().collect(),
            cycle: self.cycle.clone().filter(|name| header.contains(name)),
        }
    }

    /// The columns that a model reads: those of estimates have no forces, and may lack the cycles.
    pub fn unlabelled(&self, header: &[String]) -> Self {
        Self {
            forces: Vec::new(),
            cycle: self.cycle.clone().filter(|name| header.contains(name)),
            ..self.clone()
        }
    }

    /// A fault for each signal, or time, that a header lacks.
    pub fn check_unlabelled(&self, header: &[String], faults: &mut FaultList) {
        self.unlabelled(header).check_header(header, faults);
    }
}

/// Names of the forces of these columns, in newtons.
fn in_newtons(columns: &[String]) -> Vec<String> {
    let forces: Vec<String> = columns.iter().map(|name| force_of(name)).collect();
    union(forces.iter())
}

/// Columns that are in other units.
fn other_units(columns: &[String]) -> Vec<String> {
    let others = columns.iter().filter(|name| force_of(name) != **name);
    others.cloned().collect()
}

fn nothing(what: &str, asked: &Option<Vec<String>>, header: &[String]) -> String {
    let asked = match asked {
        Some(patterns) => format!("by {}", listed(patterns)),
        None => "by the usual names".to_owned(),
    };
    format!(
        "no column is among the {what} {asked}: name them by {what} = [...] under [columns]; the file has {}",
        listed(header)
    )
}

/// Most names that stand in one sentence.
const MOST_NAMED: usize = 20;

fn listed(names: &[String]) -> String {
    let shown = |name: &String| {
        let short: String = name.chars().take(40).collect();
        quoted(&short).escape_debug().to_string()
    };
    let shown: Vec<String> = names.iter().take(MOST_NAMED).map(shown).collect();
    let more = match names.len().saturating_sub(MOST_NAMED) {
        0 => String::new(),
        more => format!(" and {more} more"),
    };
    shown.join(", ") + &more
}

fn union<'a>(names: impl Iterator<Item = &'a String>) -> Vec<String> {
    let mut seen = HashSet::new();
    names.filter(|name| seen.insert(*name)).cloned().collect()
}

/// Names in the order of the patterns, then of the file. A pattern without a match stays as a name, which its file then lacks.
fn matching(patterns: &[String], names: &[&String]) -> Vec<String> {
    let mut found: Vec<String> = Vec::new();
    let mut seen: HashSet<&String> = HashSet::new();
    for pattern in patterns {
        if !is_pattern(pattern) {
            // The column of this name, or one that its file lacks.
            if seen.insert(pattern) {
                found.push(pattern.clone());
            }
            continue;
        }
        for name in names.iter().filter(|name| matches(pattern, name)) {
            if seen.insert(name) {
                found.push((*name).clone());
            }
        }
    }
    found
}

/// The first of the usual patterns that fit a column decide.
fn usual_forces(names: &[&String]) -> Vec<String> {
    let of_pattern = |patterns: &&[&str]| -> Vec<String> {
        let is_meant = |name: &str| patterns.iter().any(|pattern| matches(pattern, name));
        let fits = names.iter().filter(|name| is_meant(&plain(name)));
        fits.map(|name| (*name).clone()).collect()
    };
    let mut found = FORCES.iter().map(of_pattern);
    let in_newtons = found.find(|names| !names.is_empty());
    in_newtons.unwrap_or_else(|| usual_forces_in_other_units(names))
}

/// Columns with the usual names of forces, in other units than newtons.
fn usual_forces_in_other_units(names: &[&String]) -> Vec<String> {
    let others: Vec<(ForceColumn, &String)> = names
        .iter()
        .map(|name| (ForceColumn::of(name), *name))
        .filter(|(column, _)| column.has_unit && !column.is_newtons())
        .collect();
    let of_pattern = |pattern: &&str| -> Vec<String> {
        let fits = others
            .iter()
            .filter(|(column, _)| matches(pattern, &column.base));
        fits.map(|(_, name)| (*name).clone()).collect()
    };
    let mut found = BASES.iter().map(of_pattern);
    found.find(|names| !names.is_empty()).unwrap_or_default()
}

/// A name in small letters, with `_` for spaces, without `[s]` or `[N]` behind it: units as they are read. Others stay, so that such a column isn't taken for what it isn't.
fn plain(name: &str) -> String {
    let lower = name.to_lowercase();
    let units = ["[s]", "(s)", "[n]", "(n)"];
    let without = units.iter().find_map(|unit| lower.strip_suffix(unit));
    without.unwrap_or(&lower).trim().replace(' ', "_")
}

/// Whether a name fits a pattern, in which `*` stands for any characters and `?` for one. What lies between two stars is looked for once, from left to right, so that
/// the time doesn't grow with their number.
pub fn matches(pattern: &str, name: &str) -> bool {
    let mut parts = pattern.split('*');
    let (first, last) = (parts.next().unwrap_or_default(), parts.next_back());
    let Some(rest) = after(first, name) else {
        return false;
    };
    let Some(last) = last else {
        return rest.is_empty();
    };
    let found = parts.try_fold(rest, |rest, part| {
        let begins = rest.char_indices().map(|(at, _)| at).chain([rest.len()]);
        let mut ends = begins.filter_map(|at| after(part, rest.get(at..)?));
        ends.next()
    });
    let characters = last.chars().count();
    let end = found.and_then(|rest| {
        let skipped = rest.chars().count().checked_sub(characters)?;
        let at = rest
            .char_indices()
            .nth(skipped)
            .map_or(rest.len(), |(at, _)| at);
        after(last, rest.get(at..)?)
    });
    end.is_some_and(str::is_empty)
}

/// Rest of a name that begins with a part of a pattern, in which `?` stands for any character.
fn after<'n>(part: &str, name: &'n str) -> Option<&'n str> {
    let mut rest = name.chars();
    let begins = part.chars().all(|c| {
        let next = rest.next();
        next.is_some_and(|next| c == '?' || c == next)
    });
    begins.then_some(rest.as_str())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn named(names: &[&str]) -> Vec<String> {
        names.iter().map(|name| (*name).to_owned()).collect()
    }

    #[test]
    fn patterns_fit_as_in_a_shell() {
        for (pattern, name, fits) in [
            ("s*", "s12", true),
            ("*_n", "fz_n", true),
            ("f?_n", "fz_n", true),
            ("f?_n", "f_n", false),
            ("a*b*c", "aXbYbc", true),
            ("a*b*c", "aXbYb", false),
            ("a*bc*bc", "abcbc", true),
            ("a*bc*bc", "abc", false),
            ("a*a", "a", false),
            ("**", "x", true),
            ("?*?", "é", false),
            ("?*?", "éü", true),
            ("*", "", true),
            ("", "a", false),
        ] {
            assert_eq!(matches(pattern, name), fits, "{pattern} {name}");
        }
    }

    #[test]
    fn usual_names_need_no_recipe() {
        let header = named(&["time_s", "s1", "fx_n", "fz_n", "s2"]);
        let found = NamedColumns::find(&Columns::default(), [&header]);
        assert_eq!(found.time, "time_s");
        assert_eq!(found.signals, ["s1", "s2"]);
        assert_eq!(found.forces, ["fx_n", "fz_n"]);
        let without = Columns {
            not_signals: Some(named(&["s?"])),
            ..Columns::default()
        };
        let header = named(&["time_s", "s1", "a", "f_n"]);
        let found = NamedColumns::find(&without, [&header]);
        assert_eq!(
            (found.signals, found.forces),
            (named(&["a"]), named(&["f_n"]))
        );
        for (time, force) in [
            ("Time", "Fz"),
            ("Time [s]", "Force Z [N]"),
            ("timestamp", "FZ"),
            ("t", "force_z"),
        ] {
            let header = named(&["sample", "S1", time, force]);
            let found = NamedColumns::find(&Columns::default(), [&header]);
            assert_eq!((found.time.as_str(), found.forces), (time, named(&[force])));
        }
        // Other units are converted, and the force is called so; what may be none isn't taken.
        for (column, forces) in [
            ("Force Z (kN)", named(&["force_z_n"])),
            ("force_g", named(&["force_n"])),
            ("load_cell_N", Vec::new()),
        ] {
            let header = named(&["time_s", "s1", column]);
            let found = NamedColumns::find(&Columns::default(), [&header]);
            assert_eq!(
                (found.signals.len(), found.forces),
                (2 - forces.len(), forces)
            );
        }
        let header = named(&["sec", "nanosec", "s1", "fz_n"]);
        let found = NamedColumns::find(&Columns::default(), [&header]);
        assert_eq!(
            (found.time.as_str(), found.signals),
            ("sec", named(&["s1"]))
        );
        let header = named(&["s1", "time_ms", "fz_n"]);
        let found = NamedColumns::find(&Columns::default(), [&header]);
        assert_eq!(
            (found.time.as_str(), found.time_unit),
            ("time_ms", Some(TimeUnit::Ms))
        );
        let header = named(&["t", "s1", "force"]);
        let found = NamedColumns::find(&Columns::default(), [&header]);
        assert_eq!(
            (found.time.as_str(), found.forces),
            ("t", named(&["force"]))
        );
    }

    #[test]
    fn every_missing_column_is_named_with_its_file() {
        let columns = Columns {
            signals: Some(named(&["s*", "extra"])),
            ..Columns::default()
        };
        let headers = [
            named(&["time_s", "s1", "s2", "fz_n"]),
            named(&["time_s", "s1", "fz_n", "fx_n"]),
        ];
        let found = NamedColumns::find(&columns, &headers);
        let mut faults = Vec::new();
        for (file, header) in ["a.csv", "b.csv"].iter().zip(&headers) {
            let mut here = FaultList::of(file);
            found.check(&columns, header, &mut here);
            faults.extend(here.into_faults());
        }
        let told: Vec<String> = faults.iter().map(ToString::to_string).collect();
        for part in [
            "a.csv, line 1, column extra",
            "a.csv, line 1, column fx_n",
            "b.csv, line 1, column s2",
        ] {
            assert!(
                told.iter().any(|fault| fault.starts_with(part)),
                "{part}: {told:?}"
            );
        }
    }
}
