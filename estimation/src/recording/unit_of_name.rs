//! The unit that a column's name says, and the name without it.

/// A name in small letters and words joined by `_`, and the unit at its end, as in `Force Z [kN]`, `time_ms`, `load (g)`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct NameParts {
    /// Name without its unit.
    pub base: String,
    /// The unit, where it is one of those that are known.
    pub unit: Option<String>,
}

/// Takes a name apart by a test of what a unit is.
pub(super) fn parts(name: &str, is_unit: impl Fn(&str) -> bool) -> NameParts {
    let lower = name.trim().to_lowercase();
    let bare = lower.trim_end_matches([']', ')', '}']);
    let is_break = |letter: char| !letter.is_alphanumeric() && letter != '%';
    let last = bare.rfind(is_break).map(|at| bare.split_at(at));
    let unit_of = |(before, after): (&str, &str)| {
        let unit = after.trim_start_matches(is_break);
        (is_unit(unit) && !before.trim_matches(is_break).is_empty())
            .then(|| (before.to_owned(), unit.to_owned()))
    };
    match last.and_then(unit_of) {
        Some((before, unit)) => NameParts {
            base: joined(&before),
            unit: Some(unit),
        },
        None => NameParts {
            base: joined(&lower),
            unit: None,
        },
    }
}

fn joined(name: &str) -> String {
    let words = name.split(|letter: char| !letter.is_alphanumeric());
    let words: Vec<&str> = words.filter(|word| !word.is_empty()).collect();
    words.join("_")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_unit_stands_at_the_end() {
        for (name, base, unit) in [
            ("Force Z [kN]", "force_z", Some("kn")),
            ("time_ms", "time", Some("ms")),
            ("t (ms)", "t", Some("ms")),
            ("load.kN", "load", Some("kn")),
            ("items", "items", None),
            ("ms", "ms", None),
            ("[ms]", "ms", None),
            ("", "", None),
            ("Kraft z", "kraft_z", None),
        ] {
            let found = parts(name, |unit| ["ms", "kn"].contains(&unit));
            assert_eq!((found.base.as_str(), found.unit.as_deref()), (base, unit));
        }
    }
}
