//! Forces in other units than newtons, told by the names of their columns, and the names that answers give them.

use super::unit_of_name::parts;

/// Newtons of each unit that a name may end with.
const UNITS: [(&[&str], f64); 5] = [
    (&["n", "newton", "newtons"], 1.0),
    (&["kn"], 1e3),
    (&["mn"], 1e-3),
    // Standard gravity; the pound is 0.45359237 kg.
    (&["g", "gf", "gram", "grams", "gramm"], 9.80665e-3),
    (&["kg", "kgf", "kp"], 9.80665),
];
const POUNDS: (&[&str], f64) = (&["lb", "lbs", "lbf"], 0.453_592_37 * 9.80665);

fn newtons(unit: &str) -> Option<f64> {
    let mut units = UNITS.iter().chain([&POUNDS]);
    let found = units.find(|(words, _)| words.contains(&unit))?;
    Some(found.1)
}

/// A column that may hold a force, by its name.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct ForceColumn {
    /// Name in small letters, without its unit.
    pub base: String,
    /// Newtons of one of its unit; 1 where the name says none.
    pub newtons: f64,
    /// Whether the name says a unit.
    pub has_unit: bool,
}

impl ForceColumn {
    pub(super) fn of(name: &str) -> Self {
        let found = parts(name, |unit| newtons(unit).is_some());
        Self {
            newtons: found.unit.as_deref().and_then(newtons).unwrap_or(1.0),
            has_unit: found.unit.is_some(),
            base: found.base,
        }
    }

    /// Whether its numbers are newtons as they stand.
    pub(super) fn is_newtons(&self) -> bool {
        self.newtons == 1.0
    }

    /// Newtons of one of the column's unit, where a force was found in it: 1 where the force has the column's own name, as a model has that learnt from it as newtons.
    fn newtons_as(&self, force: &str, column: &str) -> f64 {
        if force == column { 1.0 } else { self.newtons }
    }
}

/// The name of a column's force in newtons: its own, or with `_n` in place of another unit.
pub(super) fn force_of(column: &str) -> String {
    let found = ForceColumn::of(column);
    if found.is_newtons() {
        column.to_owned()
    } else {
        format!("{}_n", found.base)
    }
}

/// The column of a force in a header: the one of its name, or else the first whose force in newtons has it.
pub(super) fn column_of<'h>(force: &str, header: &'h [String]) -> Option<&'h String> {
    let mut by_name = header.iter().filter(|column| *column == force);
    let by_unit = || header.iter().find(|column| force_of(column) == force);
    by_name.next().or_else(by_unit)
}

/// The column of a force in a header, and newtons of one of its unit.
pub(super) fn measured_in<'h>(force: &str, header: &'h [String]) -> Option<(&'h String, f64)> {
    let column = column_of(force, header)?;
    Some((column, ForceColumn::of(column).newtons_as(force, column)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn other_units_become_newtons() {
        for (column, force, newtons) in [
            ("Force Z (kN)", "force_z_n", 1e3),
            ("fz_kN", "fz_n", 1e3),
            ("force_g", "force_n", 9.80665e-3),
            ("load [kg]", "load_n", 9.80665),
            ("fz_lbf", "fz_n", 4.448_221_615_260_5),
            ("Force Z [N]", "Force Z [N]", 1.0),
            ("fz_n", "fz_n", 1.0),
            ("fz", "fz", 1.0),
        ] {
            assert_eq!(force_of(column), force);
            let found = ForceColumn::of(column).newtons;
            assert!(
                (found - newtons).abs() < 1e-12 * newtons,
                "{column} {found}"
            );
        }
        let header = ["force_g", "fz_n"].map(str::to_owned);
        assert_eq!(column_of("force_n", &header), Some(&header[0]));
        assert_eq!(column_of("fz_n", &header), Some(&header[1]));
        assert_eq!(column_of("fy_n", &header), None);
    }
}
