//! Reads what a film is wired to: a table's `kind` and the fields of that kind.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use serde_json::Value;

use crate::document::fault::Fault;
use crate::document::fields::{Fields, Range};
use crate::film::amplifier::Circuit;

const RESISTANCE: Range = Range::new(1e-6, 1e9, "megohm");
const CABLE: Range = Range::new(0.0, 1e6, "pF");
const CAPACITANCE: Range = Range::new(1e-6, 1e6, "nF");
const KINDS: [(&str, Circuit); 3] = [
    ("open-circuit", Circuit::OpenCircuit),
    ("voltage", Circuit::VOLTAGE),
    ("charge", Circuit::CHARGE),
];

/// The circuit that a table's kind names, with the usual values; `usual` where it names none. An unknown kind is taken as one without fields of its own, so
/// that the kind is at fault.
pub fn named_circuit(value: &Value, usual: Circuit) -> Circuit {
    let Some(kind) = value.get("kind") else {
        return usual;
    };
    let named = KINDS.iter().find(|(name, _)| Some(*name) == kind.as_str());
    named.map_or(Circuit::OpenCircuit, |(_, circuit)| *circuit)
}

/// The fields that a table of this circuit may have.
pub fn circuit_fields(circuit: Circuit) -> &'static [&'static str] {
    match circuit {
        Circuit::OpenCircuit => &["kind"],
        Circuit::Voltage { .. } => &["kind", "input_mohm", "cable_pf"],
        Circuit::Charge { .. } => &["kind", "feedback_nf", "feedback_mohm"],
    }
}

/// Reads the fields of a circuit that [`named_circuit`] found; absent ones keep what they hold. None after a fault.
pub fn read_circuit(
    fields: &Fields<'_>,
    mut circuit: Circuit,
    faults: &mut Vec<Fault>,
) -> Option<Circuit> {
    let kind = fields.choice("kind", &KINDS, circuit, faults);
    let numbers = match &mut circuit {
        Circuit::OpenCircuit => Some(()),
        Circuit::Voltage {
            input_mohm,
            cable_pf,
        } => fields.numbers(
            [
                ("input_mohm", RESISTANCE, input_mohm),
                ("cable_pf", CABLE, cable_pf),
            ],
            faults,
        ),
        Circuit::Charge {
            feedback_nf,
            feedback_mohm,
        } => fields.numbers(
            [
                ("feedback_nf", CAPACITANCE, feedback_nf),
                ("feedback_mohm", RESISTANCE, feedback_mohm),
            ],
            faults,
        ),
    };
    kind.and(numbers)?;
    Some(circuit)
}
