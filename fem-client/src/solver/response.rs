//! Answer of a solve: strains, forces and diagnostics of one equilibrium.

use serde::{Deserialize, Serialize};

use crate::solver::derivative::Derivative;
use crate::solver::direction::{CrownStretchFields, PerDirection, StrainFields};
use crate::solver::film_state::{FilmSignal, FilmState};
use crate::solver::gauge::GaugeReading;
use crate::solver::value_range::Extremes;

/// Strains, forces and diagnostics of one equilibrium.
///
/// Strains are stretches relative to the inflated state minus one, on the inner surface; x circumferential,
/// y meridional.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct Response {
    /// Force of the ground on the whole tire along the ground's normal, N.
    pub reaction_n: f64,
    /// Force of the ground on the whole tire, N, in the wheel's frame: along the wheel (x), along the axle (y) and in the wheel's plane upwards (z, the reaction of
    /// an upright wheel). Friction pulls the way that the ground is dragged. Absent where the solver doesn't tell.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub force_n: Option<[f64; 3]>,
    /// Moment of the ground's forces about the wheel's centre, N mm, in the wheel's frame: x, y, z as `force_n`. Absent where the solver doesn't tell.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub moment_nmm: Option<[f64; 3]>,
    /// Height of the ground at the contact centre, mm, along its normal from where flat ground touches the inflated tire.
    pub depth_mm: f64,
    /// P1, P2, ... in order.
    pub locations: Vec<LocationStrain>,
    /// Crown, shoulder and sidewall above the contact centre.
    pub section: Section,
    /// The inflated state before contact.
    pub inflated: Inflated,
    /// Estimated discretisation errors of the readout.
    pub error: ResponseError,
    /// Largest |J - 1| of an element's mean.
    pub max_volume_change: f64,
    /// Newton iterations of all load steps of this solve.
    pub newton_iterations: usize,
    /// Residual norms relative to the forces of the problem, one list per load step.
    pub residual_history: Vec<Vec<f64>>,
    /// Model that was solved.
    pub model: ModelSummary,
    /// The dense map, when asked for.
    #[schema(ignore)]
    pub map: Option<StrainMap>,
    /// Rings, one per position asked for, in the order asked.
    #[schema(ignore)]
    pub rings: Vec<Ring>,
    /// Readings, one per gauge asked for, in the order asked.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub gauges: Vec<GaugeReading>,
    /// Signals of the films without stiffness that were asked for, in the order asked.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    #[schema(ignore)]
    pub films: Vec<FilmSignal>,
    /// State of the textile layer; absent without one.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub carcass: Option<CarcassState>,
    /// State of the film; absent without one.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub film: Option<FilmState>,
    /// Derivatives by the numbers asked for, in the order asked.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub derivatives: Vec<Derivative>,
}

/// Strain at a named location.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct LocationStrain {
    /// P1, P2, ...
    pub name: String,
    /// Angle from the contact centre, degrees, positive in the rolling direction.
    pub theta_deg: f64,
    /// Strain.
    #[serde(flatten, with = "StrainFields")]
    pub strain: PerDirection<f64>,
    /// Von Mises stress of the rubber at the inner surface, MPa.
    pub von_mises_mpa: f64,
    /// Estimated discretisation errors; absent when the solver has no estimate.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub error: Option<LocationError>,
}

/// Estimated discretisation errors at a location, absolute: see [`crate::solver::gauge::GaugeError`].
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct LocationError {
    /// Error of the strain.
    #[serde(flatten, with = "StrainFields")]
    pub strain: PerDirection<f64>,
    /// Error of the von Mises stress, MPa.
    pub von_mises_mpa: f64,
}

/// Least and greatest values over the whole textile layer.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct CarcassState {
    /// Stretch of the fibres.
    pub fibre_stretch: Extremes,
    /// Tension along the fibres: force per reference length across a family, N/mm; negative in compression.
    pub tension_n_per_mm: Extremes,
}

/// Strains over the section above the contact centre.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct Section {
    /// 0 degrees from the crown.
    #[serde(with = "StrainFields")]
    #[schema(value_type = StrainFields<f64>)]
    pub crown: PerDirection<f64>,
    /// 45 degrees from the crown.
    #[serde(with = "StrainFields")]
    #[schema(value_type = StrainFields<f64>)]
    pub shoulder: PerDirection<f64>,
    /// 90 degrees from the crown.
    #[serde(with = "StrainFields")]
    #[schema(value_type = StrainFields<f64>)]
    pub sidewall: PerDirection<f64>,
}

/// The inflated tire before contact.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct Inflated {
    /// Outer radius at the crown, mm.
    pub outer_radius_mm: f64,
    /// Stretch at the crown's inner surface.
    #[serde(flatten, with = "CrownStretchFields")]
    #[schema(value_type = CrownStretchFields<f64>)]
    pub crown_stretch: PerDirection<f64>,
}

/// Estimated errors: absolute, of the largest reported value of each kind.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct ResponseError {
    /// Contact penetration's share of the reaction, N.
    pub reaction_n: f64,
    /// Largest error of the strain at P1-P5.
    #[serde(flatten, with = "StrainFields")]
    #[schema(value_type = StrainFields<f64>)]
    pub strain: PerDirection<f64>,
}

/// Summary of a model: what was modelled and what was left out.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, utoipa::ToSchema)]
pub struct ModelSummary {
    /// `3d`, `3d-half` or `3d-quarter`.
    pub dimension: String,
    /// Mesh level.
    pub level: String,
    /// Number of solid elements.
    pub elements: usize,
    /// Free displacement unknowns.
    pub dofs: usize,
    /// Parts of the scene in the model.
    pub modelled: Vec<Choice>,
    /// Parts of the scene left out.
    pub left_out: Vec<Choice>,
}

/// A modelling choice with its reason.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct Choice {
    /// The part.
    pub what: String,
    /// The reason.
    pub why: String,
    /// Effect of leaving it out: the largest change of a strain at P1, P2, ... at the means when it is modelled, over the largest strain of that
    /// direction there.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub effect: Option<f64>,
}

/// Strains on a regular grid, row by row: all circumferential points of the first meridional angle first.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct StrainMap {
    /// Circumferential angles of the columns, degrees.
    pub theta_deg: Vec<f64>,
    /// Meridional angles of the rows from the crown, degrees.
    pub phi_deg: Vec<f64>,
    /// Strain, rows x columns.
    #[serde(flatten, with = "StrainFields")]
    pub strain: PerDirection<Vec<f64>>,
    /// Places of the map's points, when asked for.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub shape: Option<MapShape>,
    /// Places of the map's points in the equilibrium, mm, when asked for: x, y and z of one point after the other, axes as in [`MapShape`].
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub position_mm: Option<Vec<f64>>,
}

/// Places of the points of a map: x in the rolling direction, y along the axle, z upward, from the wheel's centre.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, utoipa::ToSchema)]
pub struct MapShape {
    /// Positions in the inflated state before contact, mm, rows x columns.
    pub inflated_mm: Vec<[f64; 3]>,
    /// Displacements from there to the equilibrium, mm, rows x columns.
    pub displacement_mm: Vec<[f64; 3]>,
}

/// Strains around the whole wheel at one section angle.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Ring {
    /// Section angle from the crown, degrees.
    pub section_deg: f64,
    /// Angles from -180 (included) to 180 (excluded), one degree apart.
    pub theta_deg: Vec<f64>,
    /// Strain.
    #[serde(flatten, with = "StrainFields")]
    pub strain: PerDirection<Vec<f64>>,
    /// Strain in further directions, in the order asked.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub turned: Vec<Vec<f64>>,
}

mod schemas {
    use utoipa::openapi::{RefOr, Schema};
    use utoipa::{PartialSchema, ToSchema};

    use super::{LocationError, LocationStrain};
    use crate::solver::object_schema::{ObjectSchema, Type};

    impl PartialSchema for LocationStrain {
        fn schema() -> RefOr<Schema> {
            ObjectSchema::new("Strain at a named location.")
                .required(Type::String, "name", "P1, P2, ...")
                .required(
                    Type::Number,
                    "theta_deg",
                    "Angle from the contact centre, degrees, positive in the rolling direction.",
                )
                .required(Type::Number, "strain_x", "Circumferential strain.")
                .required(Type::Number, "strain_y", "Meridional strain.")
                .required(
                    Type::Number,
                    "von_mises_mpa",
                    "Von Mises stress of the rubber at the inner surface, MPa.",
                )
                .optional_object(
                    "LocationError",
                    "error",
                    "Estimated discretisation errors; absent when the solver has no estimate.",
                )
                .schema()
        }
    }

    impl ToSchema for LocationStrain {
        fn schemas(schemas: &mut Vec<(String, RefOr<Schema>)>) {
            schemas.push((LocationError::name().into(), LocationError::schema()));
        }
    }

    impl PartialSchema for LocationError {
        fn schema() -> RefOr<Schema> {
            let description = "Estimated discretisation errors at a location, absolute: see [`crate::gauge::GaugeError`].";
            ObjectSchema::new(description)
                .required(
                    Type::Number,
                    "strain_x",
                    "Error of the circumferential strain.",
                )
                .required(Type::Number, "strain_y", "Error of the meridional strain.")
                .required(
                    Type::Number,
                    "von_mises_mpa",
                    "Error of the von Mises stress, MPa.",
                )
                .schema()
        }
    }

    impl ToSchema for LocationError {}
}
