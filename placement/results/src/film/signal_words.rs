//! The words in which signals are told: enums that stand in documents as their names.

use document::Choice;

/// Quantity that changes along a curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Choice)]
pub enum SignalAxis {
    /// The load, N.
    Load,
    /// The internal pressure, MPa.
    Pressure,
    /// The wheel angle from the film to the contact, degrees.
    Contact,
}

/// Trend of a curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Choice)]
pub enum Trend {
    /// Every value is larger than the one before.
    Up,
    /// Every value is smaller than the one before.
    Down,
    /// Neither.
    No,
}

/// Claim about films' voltages.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Choice)]
pub enum Claim {
    /// Claim over the loads.
    #[choice("voltage rises with load")]
    RisesWithLoad,
    /// Claim over the pressures.
    #[choice("voltage falls with pressure")]
    FallsWithPressure,
    /// Claim over the contact angles.
    #[choice("linear over the contact angle")]
    Linear,
}

/// Whether a claim holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Choice)]
pub enum Holds {
    /// A claim that holds, and no error could change that.
    Yes,
    /// A claim that doesn't hold, and no error could change that.
    No,
    /// The errors, or what wasn't solved, leave it open.
    Uncertain,
}
