//! Layouts in their order.

use serde::{Deserialize, Serialize};

use super::film::force_error::ForceError;
use documents::parts::film_place::FilmPlace;

/// A layout in the ranking.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, utoipa::ToSchema)]
pub struct RankedLayout {
    /// 1 is best. Layouts of equal score share the rank of the first of them.
    pub rank: usize,
    /// Whether the errors leave no doubt about its place; absent of one that wasn't ranked.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub rank_certain: Option<bool>,
    /// Name of a layout that was listed film by film, or found by the search; absent of a regular one.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub name: Option<String>,
    /// Angle between neighbouring units, degrees; null of a layout without units.
    pub spacing_deg: Option<f64>,
    /// Angle of the first unit from the mark, degrees, where no film may lie there; absent of 0.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub turn_deg: Option<f64>,
    /// Number of units; of a layout without units its number of films.
    pub units: usize,
    /// Meridional position: a name, an angle such as `30 deg`, or `mixed`.
    pub position: String,
    /// Directions of the films of each unit: `x`, `y`, or an angle such as `45`.
    pub films: Vec<String>,
    /// Whether the films of a unit are spread evenly between two units.
    #[serde(skip_serializing_if = "std::ops::Not::not", default)]
    pub staggered: bool,
    /// All films of the wheel.
    pub film_count: usize,
    /// The films of a layout without units, one by one.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub places: Vec<FilmPlace>,
    /// Figures that may be off by more than a fifth, in words.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub doubt: Option<String>,
    /// Scores at the load where the angle's error is largest.
    pub score: LayoutScore,
    /// Load of these scores, N.
    #[serde(default)]
    pub worst_load_n: Option<f64>,
    /// Error of the vertical force at the load where that is largest; absent of a layout without scores.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub worst_force: Option<WorstForce>,
    /// Errors of contacts that differ in nothing and in each quantity of `layouts.contacts` alone, each at the load where it is largest; absent where contacts don't
    /// differ.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub contacts: Vec<ContactError>,
    /// Errors of what films tell of a contact beside angle and force, each at the load where it is largest; absent where contacts don't differ, or an estimate
    /// averages over them.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub told: Vec<ToldQuantity>,
    /// Scores at every load.
    pub loads: Vec<LoadScore>,
    /// Noise and inputs as sources of the angle's error; absent where the study has no map, and of films that the map doesn't show.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub error_sources: Option<ErrorSources>,
    /// Errors of the forces along, across and vertical on a virtual rig; absent where the study has none, and of layouts that a search found.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub force_error: Option<Vec<ForceError>>,
}

/// Error of the vertical force at the load where it is largest.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct WorstForce {
    /// The error, root mean square over contacts, N.
    pub error_n: f64,
    /// Claimed error of that, N; null where there is no coarser mesh.
    pub claim_n: Option<f64>,
    /// The load, N.
    pub load_n: Option<f64>,
}

impl RankedLayout {
    /// Errors of contacts by quantity, each at the load where it is largest, of its scores.
    pub fn largest_contact_errors(&self) -> Vec<ContactError> {
        let mut largest: Vec<ContactError> = Vec::new();
        for own in self.loads.iter().flat_map(|load| &load.score.contacts) {
            match largest.iter_mut().find(|known| known.of == own.of) {
                None => largest.push(own.clone()),
                Some(known) => {
                    known.p95_angle_error_deg =
                        known.p95_angle_error_deg.max(own.p95_angle_error_deg);
                    known.force_error_n = known.force_error_n.max(own.force_error_n);
                }
            }
        }
        largest
    }

    /// Errors of told quantities, each at the load where it is largest, of its scores.
    pub fn largest_told_errors(&self) -> Vec<ToldQuantity> {
        let mut largest: Vec<ToldQuantity> = Vec::new();
        let at_loads = self.loads.iter().flat_map(|load| {
            let told = load.score.told.iter();
            told.map(|own| ToldQuantity {
                load_n: load.load_n,
                ..own.clone()
            })
        });
        for own in at_loads {
            match largest.iter_mut().find(|known| known.of == own.of) {
                None => largest.push(own),
                Some(known) if own.error > known.error => *known = own,
                Some(_) => {}
            }
        }
        largest
    }

    /// Error of the vertical force at the load where it is largest, of its scores.
    pub fn largest_force_error(&self) -> Option<WorstForce> {
        let at_loads = self.loads.iter().filter_map(|load| {
            Some(WorstForce {
                error_n: load.score.force_error_n?,
                claim_n: load.score.error.and_then(|error| error.force_error_n),
                load_n: load.load_n,
            })
        });
        at_loads.max_by(|a, b| a.error_n.total_cmp(&b.error_n))
    }

    /// Whether both are names of one layout, whatever is known of it.
    pub fn is_same(&self, other: &Self) -> bool {
        let label = |layout: &Self| {
            let name = (layout.name.clone(), layout.position.clone(), layout.units);
            (
                name,
                layout.films.clone(),
                layout.staggered,
                layout.places.clone(),
            )
        };
        label(self) == label(other)
    }
}

/// Sources of a layout's error of the contact angle at the study's own load: root mean squares over all contact angles, to first order, degrees.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, utoipa::ToSchema)]
pub struct ErrorSources {
    /// Error by the noise of the readings.
    pub noise_deg: f64,
    /// Error by each input of the study, which the estimate takes at its mean.
    pub inputs_deg: Vec<f64>,
}

/// A layout's scores at one load.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct LoadScore {
    /// Height of the ground above the inflated outer radius, mm.
    pub depth_mm: Option<f64>,
    /// Vertical force, N.
    pub load_n: Option<f64>,
    /// The scores.
    pub score: LayoutScore,
}

/// Scores of a layout: how well it sees the contact, over all angles at which it can touch down.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, utoipa::ToSchema)]
pub struct LayoutScore {
    /// Signal of the film that sees most, strain or volts of a glued one, at the contact angle where that is least.
    pub weakest_signal: Option<f64>,
    /// Cramer-Rao bound of the contact angle, worst angle, degrees.
    pub worst_angle_error_deg: Option<f64>,
    /// Cramer-Rao bound of the contact angle, root mean square over the angles, degrees.
    pub rms_angle_error_deg: Option<f64>,
    /// Cramer-Rao bound of a uniform depth, worst angle, mm.
    pub worst_depth_error_mm: Option<f64>,
    /// Bound of the contact angle's error with a flat prior, root mean square over the angles, degrees: finite where the others aren't.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub bayes_angle_error_deg: Option<f64>,
    /// Error of the contact angle as estimated from noisy readings, root mean square, degrees.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub simulated_rms_angle_error_deg: Option<f64>,
    /// Standard error of the root mean square by the number of simulated contacts, degrees.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub simulated_rms_angle_error_deg_se: Option<f64>,
    /// 95 % of simulated contacts are estimated better than this, degrees.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub simulated_p95_angle_error_deg: Option<f64>,
    /// Standard error of the 95th percentile by the number of simulated contacts, degrees.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub simulated_p95_angle_error_deg_se: Option<f64>,
    /// Share of simulated contacts that are off by more than 20 degrees.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub lost_share: Option<f64>,
    /// Error of the depth as estimated, root mean square, mm.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub simulated_rms_depth_error_mm: Option<f64>,
    /// Error of the depth as a vertical force, N: by the slope of force over depth.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub force_error_n: Option<f64>,
    /// Standard error of the force's error by the number of simulated contacts, N.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub force_error_n_se: Option<f64>,
    /// The two contacts, more than 20 degrees apart, that look most alike.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub alike: Option<AlikeContacts>,
    /// Score with the one film dead whose loss costs most, where that was asked for.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub dead: Option<DeadFilm>,
    /// Errors of contacts that differ in nothing (`noise`) and in each quantity of `layouts.contacts` alone; absent where contacts don't differ.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub contacts: Vec<ContactError>,
    /// Errors of what films tell of a contact beside angle and force; absent where contacts don't differ, or an estimate averages over them.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub told: Vec<ToldQuantity>,
    /// Score with forces along and across the wheel unknown, too, where that was asked for.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub shear: Option<ShearScore>,
    /// Noise of each film assumed for the bounds, strain; null of glued films.
    pub noise_strain: Option<f64>,
    /// Noise of each glued film assumed for the bounds, V; absent of bare ones.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub noise_v: Option<f64>,
    /// Errors by the mesh and the number of simulated contacts; absent where there is no coarser mesh.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub error: Option<LayoutError>,
    /// Reason why numbers are null.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub reason: Option<String>,
}

/// Simulated errors of contacts that differ from the usual one in a single quantity.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct ContactError {
    /// The quantity, as `layouts.contacts` names it; `noise`: none differs.
    pub of: String,
    /// Name for people.
    pub words: String,
    /// 95 % of contact angles are estimated better than this, degrees.
    pub p95_angle_error_deg: f64,
    /// Error of the vertical force, root mean square, N.
    pub force_error_n: f64,
}

/// Error of what films tell of a quantity that contacts differ in.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct ToldQuantity {
    /// The quantity, as `layouts.contacts` names it, or a load in the wheel's frame: `fx_n`, `fy_n`, `mx_nmm`, `my_nmm`, `mz_nmm`.
    pub of: String,
    /// Name for people.
    pub words: String,
    /// Error of its estimate, root mean square over contacts, in its own unit.
    pub error: f64,
    /// Standard error of it by the number of simulated contacts; none of a study before it was told, nor are the next two.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub error_se: Option<f64>,
    /// Claimed error of it, by that and the coarser mesh.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub claim: Option<f64>,
    /// Load at which it is this large, N: the worst one.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub load_n: Option<f64>,
    /// Standard deviation over contacts: the error where films tell nothing.
    pub deviation: f64,
    /// Whether films tell something of it: the error is at least a tenth less than the deviation.
    pub known: bool,
}

/// Claimed errors of a layout's scores, each in the unit of its score.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, utoipa::ToSchema)]
pub struct LayoutError {
    /// Error of the bound of the angle, worst angle, degrees.
    pub worst_angle_error_deg: Option<f64>,
    /// Error of the bound of the angle, root mean square, degrees.
    pub rms_angle_error_deg: Option<f64>,
    /// Error of the bound of the depth, mm.
    pub worst_depth_error_mm: Option<f64>,
    /// Error of the simulated root mean square, degrees.
    pub simulated_rms_angle_error_deg: Option<f64>,
    /// Error of the simulated 95th percentile, degrees.
    pub simulated_p95_angle_error_deg: Option<f64>,
    /// Error of the force's error, N.
    #[serde(default)]
    pub force_error_n: Option<f64>,
}

/// Cramer-Rao bounds with four unknowns: contact angle, depth, and the ground's shifts along the wheel and across it, about a contact that isn't dragged. A
/// shift across that no film feels doesn't enter.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, utoipa::ToSchema)]
pub struct ShearScore {
    /// Bound of the contact angle, worst angle, degrees.
    pub worst_angle_error_deg: Option<f64>,
    /// Bounds of the ground's forces on the tire along the wheel, across it (null where no film feels it) and up, worst angle, N.
    pub worst_force_error_n: Option<[Option<f64>; 3]>,
    /// Errors by the mesh; absent where there is no coarser one.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub error: Option<ShearError>,
    /// Quantity that can't be told, in words.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub reason: Option<String>,
}

/// Claimed errors of bounds with four unknowns, each in the unit of its bound.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, utoipa::ToSchema)]
pub struct ShearError {
    /// Error of the bound of the angle, degrees.
    pub worst_angle_error_deg: Option<f64>,
    /// Errors of the bounds of the forces, N.
    pub worst_force_error_n: Option<[Option<f64>; 3]>,
}

/// Two contacts that readings can hardly tell apart.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct AlikeContacts {
    /// Angle of the first, degrees; its depth is that of the load.
    pub angle_deg: f64,
    /// Angle of the second, degrees.
    pub other_angle_deg: f64,
    /// Depth of the second, mm.
    pub other_depth_mm: f64,
    /// Distance of their readings in standard deviations of the noise.
    pub sigmas: f64,
}

/// Score that is left when a film dies.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct DeadFilm {
    /// The film, counted from 0.
    pub film: usize,
    /// Simulated 95th percentile of the angle's error without it, degrees.
    pub simulated_p95_angle_error_deg: Option<f64>,
    /// Bound of the angle with a flat prior without it, root mean square, degrees.
    pub bayes_angle_error_deg: Option<f64>,
}
