//! Parts of a recording that a header's columns become.

use std::collections::HashMap;

use crate::recording::force_unit::measured_in;
use crate::recording::named_columns::NamedColumns;
use crate::recording::time_column::nanoseconds_beside;

/// Part of a recording that a column becomes.
#[derive(Debug, Clone, PartialEq)]
pub enum Part {
    /// The time.
    Time,
    /// Nanoseconds beside the time's whole seconds.
    Nanoseconds,
    /// The signal of this number.
    Signal(usize),
    /// The force of this number.
    Force {
        /// Number of the force.
        number: usize,
        /// Newtons of one of its unit.
        newtons: f64,
    },
    /// Entries that tell cycles apart.
    Cycle,
    /// No part: the column is left out.
    None,
}

/// The part that each column of a header becomes, with names that were found among it.
pub fn taken_columns(names: &NamedColumns, header: &[String]) -> Vec<Part> {
    let beside = nanoseconds_beside(&names.time, header);
    let signals: HashMap<&String, usize> = names.signals.iter().zip(0..).collect();
    let forces = names
        .forces
        .iter()
        .enumerate()
        .filter_map(|(number, force)| {
            let (column, newtons) = measured_in(force, header)?;
            Some((column, Part::Force { number, newtons }))
        });
    let forces: HashMap<&String, Part> = forces.collect();
    let part = |column: &String| {
        if *column == names.time {
            Part::Time
        } else if Some(column) == beside {
            Part::Nanoseconds
        } else if Some(column) == names.cycle.as_ref() {
            Part::Cycle
        } else if let Some(force) = forces.get(column) {
            force.clone()
        } else {
            let signal = signals.get(column);
            signal.map_or(Part::None, |number| Part::Signal(*number))
        }
    };
    header.iter().map(part).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::recipe::{Columns, CycleRule};

    #[test]
    fn every_column_is_taken_for_one_part() {
        let header = ["sec", "nanosec", "press", "b", "force_g", "note", "a"].map(str::to_owned);
        let columns = Columns {
            not_signals: Some(vec!["note".to_owned()]),
            cycles: CycleRule::Column("press".to_owned()),
            ..Columns::default()
        };
        let names = NamedColumns::find(&columns, [&header.to_vec()]);
        let force = Part::Force {
            number: 0,
            newtons: 9.80665e-3,
        };
        let expected = [
            Part::Time,
            Part::Nanoseconds,
            Part::Cycle,
            Part::Signal(0),
            force,
            Part::None,
            Part::Signal(1),
        ];
        assert_eq!(taken_columns(&names, &header), expected);
    }
}
