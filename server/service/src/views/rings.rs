//! Signals around the wheel that a study's layouts are scored by.

use fem_client::solver::direction::Direction;
use results::{LayoutFindings, LayoutLoad, StrainRing};
use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

/// Unit of what the wall itself shows.
const STRAIN: &str = "strain";

/// Rings around the whole wheel.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct Rings {
    /// Unit of the lists named `strain` and, by the depth, `slope`: `strain`, or `V` where layouts are of glued films.
    pub unit: String,
    /// A ring for each section angle that layouts have; none where the study asks for no layouts.
    pub rings: Vec<WheelRing>,
}

/// Both directions around the wheel at one section angle.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct WheelRing {
    /// Section angle from the crown, degrees.
    pub section_deg: f64,
    /// The load at which it is read.
    pub load: Option<RingLoad>,
    /// Angles from the contact, degrees: from -180 on.
    pub theta_deg: Vec<f64>,
    /// Circumferential strain; null where no layout has such a film.
    pub strain_x: Option<Vec<f64>>,
    /// Meridional strain; null where no layout has such a film.
    pub strain_y: Option<Vec<f64>>,
    /// Derivative of the circumferential strain by the depth, 1/mm.
    pub slope_x_per_mm: Option<Vec<f64>>,
    /// Derivative of the meridional strain by the depth, 1/mm.
    pub slope_y_per_mm: Option<Vec<f64>>,
}

/// A load of layouts.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct RingLoad {
    /// Height of the ground above the inflated outer radius, mm.
    pub depth_mm: f64,
    /// Vertical force, N; null where it isn't known.
    pub load_n: Option<f64>,
}

impl Rings {
    /// The rings of layouts, in the order of their section angles in the document. Films at other angles to the wheel aren't shown.
    pub fn of(findings: Option<&LayoutFindings>) -> Self {
        let Some(findings) = findings else {
            return Self {
                unit: STRAIN.to_owned(),
                rings: Vec::new(),
            };
        };
        let mut rings: Vec<WheelRing> = Vec::new();
        for ring in &findings.rings {
            let place = rings
                .iter()
                .position(|known| known.section_deg == ring.section_deg);
            let place = place.unwrap_or_else(|| {
                rings.push(empty(ring, &findings.loads));
                rings.len() - 1
            });
            let Some(known) = rings.get_mut(place) else {
                continue;
            };
            let (strain, slope) = match Direction::named(&ring.direction) {
                Some(Direction::X) => (&mut known.strain_x, &mut known.slope_x_per_mm),
                Some(Direction::Y) => (&mut known.strain_y, &mut known.slope_y_per_mm),
                None => continue,
            };
            *strain = Some(ring.strain.clone());
            *slope = Some(ring.by_depth.clone());
        }
        rings.retain(|ring| ring.strain_x.is_some() || ring.strain_y.is_some());
        Self {
            unit: findings.unit.clone(),
            rings,
        }
    }
}

fn empty(ring: &StrainRing, loads: &[LayoutLoad]) -> WheelRing {
    let at_depth = |load: &&LayoutLoad| load.depth_mm == Some(ring.depth_mm);
    let around = ring.strain.len();
    let step = 360.0 / around.max(1) as f64;
    WheelRing {
        section_deg: ring.section_deg,
        load: Some(RingLoad {
            depth_mm: ring.depth_mm,
            load_n: loads.iter().find(at_depth).and_then(|load| load.load_n),
        }),
        theta_deg: (0..around).map(|k| step * k as f64 - 180.0).collect(),
        strain_x: None,
        strain_y: None,
        slope_x_per_mm: None,
        slope_y_per_mm: None,
    }
}
