//! Films' signals over load, pressure and contact angle, and what they show.

use fem_client::solver::direction::Direction;
use fem_client::solver::{FilmCondition, Position};
use serde::{Deserialize, Serialize};

use super::signal_words::{Claim, Holds, SignalAxis, Trend};
use documents::parts::film_model::FilmModel;

/// Films' signals over load, pressure and contact angle.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, utoipa::ToSchema)]
pub struct Signals {
    /// Readings of each film at each pressing.
    pub rows: Vec<SignalRow>,
    /// The rows as curves of the open circuit's voltage.
    pub curves: Vec<SignalCurve>,
    /// Two films around the wheel, read against each other.
    pub pairs: Vec<FilmPair>,
    /// Widths around the wheel over which the contact is felt.
    pub widths: Vec<StressWidth>,
    /// Claims about such films, and what holds of them.
    pub claims: Vec<ClaimRow>,
}

/// Reading of one film at one pressing.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct SignalRow {
    /// Name of the tire; the study's own is `own`.
    pub tire: String,
    /// Model of the film.
    pub film: FilmModel,
    /// Position of the film in the section.
    #[schema(value_type = String)]
    pub position: Position,
    /// Direction of its length: x circumferential, y meridional.
    #[schema(value_type = String)]
    pub direction: Direction,
    /// Curve that it is a point of.
    pub over: SignalAxis,
    /// Vertical force of the ground, N.
    pub load_n: f64,
    /// Internal pressure, MPa.
    pub pressure_mpa: f64,
    /// Wheel angle from the film to the contact, degrees.
    pub contact_deg: f64,
    /// Height of the ground above the inflated outer radius, mm.
    pub depth_mm: Option<f64>,
    /// Mean strain along the film since inflation.
    pub strain: Option<f64>,
    /// Mean tension along the film since inflation, N/mm.
    pub tension_1_n_per_mm: Option<f64>,
    /// Charge, nC.
    pub charge_nc: Option<f64>,
    /// Voltage where nothing draws charge, V.
    pub open_circuit_v: Option<f64>,
    /// Amplitude at the amplifier, V.
    pub output_v: Option<f64>,
    /// Standard deviation of that by noise, gain and temperature, V.
    pub output_std_v: Option<f64>,
    /// Whether the film bears that, and the amplifier shows it: `ok`, `beyond-yield`, `saturated` or `wrinkled`; null where that isn't known.
    #[schema(value_type = Option<String>)]
    pub state: Option<FilmCondition>,
    /// Errors by the mesh; null without a coarser mesh.
    pub error: Option<SignalError>,
    /// Reason why numbers are null.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub reason: Option<String>,
}

impl SignalRow {
    /// Value of what changes along its curve: N, MPa or degrees.
    pub fn along(&self) -> f64 {
        match self.over {
            SignalAxis::Load => self.load_n,
            SignalAxis::Pressure => self.pressure_mpa,
            SignalAxis::Contact => self.contact_deg,
        }
    }
}

/// Errors of a film's reading by the mesh, absolute: the change from the next coarser mesh, times Richardson's factor.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct SignalError {
    /// Error of the strain.
    pub strain: f64,
    /// Error of the charge, nC.
    pub charge_nc: f64,
    /// Error of the open circuit's voltage, V.
    pub open_circuit_v: f64,
    /// Error of the amplifier's voltage, V.
    pub output_v: f64,
}

/// The open circuit's voltage of one film over loads, pressures or contact angles.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct SignalCurve {
    /// Name of the tire.
    pub tire: String,
    /// Model of the film.
    pub film: FilmModel,
    /// Position of the film in the section.
    #[schema(value_type = String)]
    pub position: Position,
    /// Direction of its length.
    #[schema(value_type = String)]
    pub direction: Direction,
    /// Quantity that changes along it.
    pub over: SignalAxis,
    /// Slope of the line of least squares, V per N, per MPa or per degree; null of fewer than two points.
    pub slope: Option<f64>,
    /// Trend of the curve; null of fewer than two points.
    pub monotone: Option<Trend>,
    /// Whether every step is larger than the errors of its two ends together.
    pub monotone_certain: bool,
    /// Share of the variance that the line explains; null of fewer than three points, and where nothing varies.
    pub linear_r2: Option<f64>,
}

/// The difference of two films at the crown, 30 degrees before and behind a point of the wheel, as the contact moves away from that point.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct FilmPair {
    /// Name of the tire.
    pub tire: String,
    /// Model of the films.
    pub film: FilmModel,
    /// Direction of their length.
    #[schema(value_type = String)]
    pub direction: Direction,
    /// Wheel angles from that point to the contact, degrees.
    pub contact_deg: Vec<f64>,
    /// Open circuit's voltage of the film that the contact comes to minus that of the other one, V; null where it isn't solved.
    pub values: Vec<Option<f64>>,
    /// Trend of the difference.
    pub monotone: Option<Trend>,
    /// Share of the variance that a line explains.
    pub linear_r2: Option<f64>,
}

/// A Gaussian in the von Mises stress of the inner surface around the wheel at the crown: offset + amplitude exp(-angle^2 / (2 width^2)).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct StressWidth {
    /// Name of the tire.
    pub tire: String,
    /// Vertical force of the ground, N.
    pub load_n: f64,
    /// Height of the ground above the inflated outer radius, mm.
    pub depth_mm: Option<f64>,
    /// Amplitude, MPa.
    pub amplitude_mpa: Option<f64>,
    /// Standard deviation, degrees around the wheel.
    pub width_deg: Option<f64>,
    /// Stress far from the contact, MPa.
    pub offset_mpa: Option<f64>,
    /// Share of the variance within 60 degrees of the contact that the Gaussian explains.
    pub r2: Option<f64>,
    /// Reason why numbers are null.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub reason: Option<String>,
}

/// Whether a claim holds of one film.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct ClaimRow {
    /// Name of the tire.
    pub tire: String,
    /// Model of the film.
    pub film: FilmModel,
    /// Position of the film in the section.
    #[schema(value_type = String)]
    pub position: Position,
    /// Direction of its length.
    #[schema(value_type = String)]
    pub direction: Direction,
    /// Claim about the curve.
    pub claim: Claim,
    /// Whether it holds.
    pub holds: Holds,
    /// Course of the curve, in words.
    pub detail: String,
}
