//! Neighbourhood of an equilibrium, shared by the solves that start there: the model, the fitted states and the factorised tangent.
//!
//! The points of a study all start from its cut point, so this is made twice, for the symmetric and the full ground, and
//! every other point is solved without a factorisation of its own. It is a function of scene, mesh and start, never of
//! which solve came first, so that results don't depend on it to the bit.

use std::cmp::Ordering;
use std::collections::VecDeque;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use fem::load::contact::Wrench;
use fem::load::obstacle::HeightField;
use fem::newton::iteration::Newton;
use fem::newton::path::PathReport;
use fem::newton::tangent::Tangent;
use fem::problem::{Loads, State};
use sha2::{Digest, Sha256};

use crate::mesh::tire_grid::{Extent, MeshPlan};
use crate::model::TireModel;
use fem_client::hexadecimal::hexadecimal;
use fem_client::scene::{Film, Ground, Scene};
use fem_client::solver::StartState;

/// Neighbourhoods that are kept; the oldest goes first. Each holds a factor: 60 MB for a standard half model.
const KEPT: usize = 4;
/// Equilibria that a neighbourhood keeps for their mirror images.
const PRESSED: usize = 64;
/// Rise of the ground that the border is ready for, as a share of the start's largest depth, and of the wall.
const REACH: [f64; 2] = [0.5, 0.1];

/// An equilibrium, ready to be left in any direction.
#[derive(Debug)]
pub(crate) struct Neighbourhood {
    pub(crate) inflated_key: String,
    pub(crate) model: TireModel,
    pub(crate) inflated: State,
    pub(crate) equilibrium: State,
    pub(crate) loads: Loads,
    pub(crate) tangent: Arc<Tangent>,
    /// Whether left and right are alike here, so that mirrored depths have mirrored equilibria.
    symmetric: bool,
    pressed: Mutex<VecDeque<(GroundPlace, Arc<Pressed>)>>,
}

/// An equilibrium on the ground, and how it was found.
#[derive(Debug)]
pub(crate) struct Pressed {
    pub(crate) state: State,
    pub(crate) report: PathReport,
    pub(crate) iterations: usize,
    /// Friction's force and moment on the meshed part.
    pub(crate) friction: Wrench,
}

/// Place of the ground of some loads.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct GroundPlace {
    /// Depth of each station, mm.
    pub(crate) depths: Vec<f64>,
    /// Ways by which it is dragged along x and y, mm.
    pub(crate) shift: [f64; 2],
    /// Angle by which the wheel leans to it, rad.
    lean: f64,
}

impl GroundPlace {
    pub(crate) fn of(loads: &Loads) -> Self {
        let ground = loads.ground.as_ref();
        ground.map_or_else(Self::default, |ground| Self {
            depths: ground.depths.clone(),
            shift: ground.shift,
            lean: ground.axes.angle,
        })
    }

    /// Returns the place with left and right exchanged.
    fn mirrored(&self) -> Self {
        let [x, y] = self.shift;
        Self {
            depths: self.depths.iter().rev().copied().collect(),
            // Not minus zero, which would be less than none.
            shift: [0.0 - x, y],
            lean: self.lean,
        }
    }

    /// Orders all places.
    fn cmp(&self, other: &Self) -> Ordering {
        let values = |place: &Self| [place.depths.as_slice(), &place.shift, &[place.lean]].concat();
        let (own, others) = (values(self), values(other));
        let pairs = own.iter().zip(&others);
        pairs.fold(Ordering::Equal, |before, (a, b)| {
            before.then(a.total_cmp(b))
        })
    }
}

impl Neighbourhood {
    /// Makes the neighbourhood; `None` when the state belongs to another mesh or inflation, or its tangent can't be had.
    fn new(scene: &Scene, plan: &MeshPlan, extent: Extent, start: &StartState) -> Option<Self> {
        let model = TireModel::new(scene, plan, extent);
        // Friction presses from the inflated tire: what a start of another part would save there isn't measured.
        let fit = |flat: &[f64]| match scene.ground.is_dragged() {
            true => model.fit(flat),
            false => model.fit_sides(flat),
        };
        let (inflated, equilibrium) = (fit(&start.inflated)?, fit(&start.equilibrium)?);
        let ground = of_start(scene, start);
        let field = model.ground_below(&ground, &inflated);
        let loads = Loads {
            pressure: start.pressure_mpa,
            ground: Some(field.clone()),
            ..Loads::default()
        };
        let film = scene.film.as_ref();
        let film_is_symmetric = film.is_none_or(Film::is_own_mirror_image);
        let deepest = start.depths_mm.iter().copied().fold(0.0, f64::max);
        let reach = REACH[0] * deepest + REACH[1] * scene.geometry.wall_mm;
        let raised = Loads {
            ground: Some(HeightField {
                base: field.base + reach,
                ..field
            }),
            ..loads.clone()
        };
        let mut newton = Newton::for_contact(&model.problem, &equilibrium, &raised).ok()?;
        let tangent = newton.tangent_at(&equilibrium, &loads).ok()?;
        Some(Self {
            inflated_key: start.inflated_key.clone(),
            model,
            inflated,
            equilibrium,
            loads,
            tangent,
            symmetric: extent == Extent::Half && ground.is_symmetric() && film_is_symmetric,
            pressed: Mutex::default(),
        })
    }

    /// The place at which a ground is solved, and whether that exchanges left and right: of two mirrored grounds
    /// only one is ever solved.
    pub(crate) fn canonical(&self, place: GroundPlace) -> (GroundPlace, bool) {
        let mirrored = place.mirrored();
        if self.symmetric && mirrored.cmp(&place) == Ordering::Less {
            (mirrored, true)
        } else {
            (place, false)
        }
    }

    /// The equilibrium on ground at this place if it was found lately.
    pub(crate) fn recall(&self, place: &GroundPlace) -> Option<Arc<Pressed>> {
        let pressed = self.pressed.lock().unwrap_or_else(PoisonError::into_inner);
        let known = pressed.iter().find(|(known, _)| known == place);
        known.map(|(_, pressed)| pressed.clone())
    }

    /// Keeps an equilibrium for its mirror image.
    pub(crate) fn remember(&self, place: GroundPlace, found: Arc<Pressed>) {
        let mut pressed = self.pressed.lock().unwrap_or_else(PoisonError::into_inner);
        if pressed.len() == PRESSED {
            pressed.pop_front();
        }
        pressed.push_back((place, found));
    }
}

type Slot = Arc<OnceLock<Option<Arc<Neighbourhood>>>>;

/// The last few neighbourhoods.
#[derive(Debug, Default)]
pub(crate) struct Neighbourhoods {
    slots: Mutex<Vec<(String, Slot)>>,
}

impl Neighbourhoods {
    /// The neighbourhood of a start state, made at most once however many threads ask.
    pub(crate) fn of(
        &self,
        scene: &Scene,
        plan: &MeshPlan,
        extent: Extent,
        start: &StartState,
    ) -> Option<Arc<Neighbourhood>> {
        let slot = self.slot(key(scene, plan, extent, start));
        slot.get_or_init(|| Neighbourhood::new(scene, plan, extent, start).map(Arc::new))
            .clone()
    }

    fn slot(&self, key: String) -> Slot {
        let mut slots = self.slots.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((_, slot)) = slots.iter().find(|(known, _)| *known == key) {
            return slot.clone();
        }
        if slots.len() == KEPT {
            slots.remove(0);
        }
        let slot = Slot::default();
        slots.push((key, slot.clone()));
        slot
    }
}

/// The ground of a start before it is dragged: wherever a scene's is dragged to, it is pressed first.
pub(crate) fn of_start(scene: &Scene, start: &StartState) -> Ground {
    Ground {
        camber_deg: start.camber_deg,
        ..scene.ground.undragged()
    }
    .at_depths(start.depths_mm.clone())
}

/// Hash of all that a neighbourhood is made of.
fn key(scene: &Scene, plan: &MeshPlan, extent: Extent, start: &StartState) -> String {
    // A model whose ground may push across is prepared for it, wherever it starts.
    let across = scene.ground.may_push_across();
    let scene = Scene {
        ground: of_start(scene, start),
        ..scene.clone()
    };
    let mut hash = Sha256::new();
    hash.update(format!(
        "{scene:?} {across} {plan:?} {extent:?} {}",
        start.inflated_key
    ));
    for value in start.inflated.iter().chain(&start.equilibrium) {
        hash.update(value.to_le_bytes());
    }
    hexadecimal(&hash.finalize())
}
