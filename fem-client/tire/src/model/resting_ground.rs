//! The ground of a scene, and how the tread meets it.

use std::f64::consts::TAU;

use fem::load::contact::Penalty;
use fem::load::friction::Friction;
use fem::load::ground_shape::{Profile, Round};
use fem::load::obstacle::{self, GroundAxes, HeightField};
use fem_client::scene::{Ground, GroundProfile, Level, ProfileKind, Scene, StationFunctions};

use super::rough_ground;

/// Contact stiffness in units of shear modulus over wall thickness, when the scene doesn't give one. At the reference
/// tire it is 120 N/mm^3: the reaction is then 0.2 % low and the meridional strain at the centre 0.4 %; three times as
/// stiff leaves a third of that and costs a third more iterations.
const PENALTY_FACTOR: f64 = 1000.0;
/// Penetration over which the contact stiffness grows to its full value, relative to the wall.
const PENALTY_RAMP: f64 = 1e-4;

/// Load steps from the inflated state to the ground's depths under friction, in which contact grows by equal lengths. On the reference tire's coarse mesh 8 leave
/// 0.5 % of the largest strain and of the force at most, 16 half of that, at depths up to 2 mm and a camber of 10 degrees; at 20 degrees 0.9 %. Sixteen equal steps left
/// 0.4 % upright, and 3 % at 20 degrees.
pub fn press_steps(level: Level) -> usize {
    match level {
        Level::Draft | Level::Coarse => 8,
        Level::Standard | Level::Reference => 16,
    }
}

/// Load steps in which ground that presses is dragged, where there is friction: anchors move only at the end of each. Twice as many change a strain by less than
/// the steps of pressing leave.
pub fn drag_steps(level: Level) -> usize {
    press_steps(level) / 2
}

/// Axes of the ground of a scene.
pub(crate) fn ground_axes(ground: &Ground) -> GroundAxes {
    GroundAxes::below(ground.camber_deg.to_radians())
}

/// The ground of a scene at a distance from the axle's middle at which it touches the inflated tire, mm; one that presses with a force begins there.
pub fn ground(ground: &Ground, touching_distance: f64) -> HeightField {
    HeightField {
        axes: ground_axes(ground),
        base: -touching_distance,
        spacing: ground.station_spacing_mm,
        functions: match ground.station_functions {
            StationFunctions::Bspline => obstacle::StationFunctions::BSpline,
            StationFunctions::Hat => obstacle::StationFunctions::Hat,
        },
        depths: match ground.load_n {
            Some(_) => vec![0.0; ground.stations],
            None => ground.depths_mm.clone(),
        },
        shift: ground.shift_mm,
        profile: Profile::Plane,
    }
}

/// The ground with its profile, which stands below the middle of the section, so far from the axle, mm: where the wheel leans, that is aside of it.
pub(crate) fn profiled_ground(
    scenes: &Ground,
    touching_distance: f64,
    centre_radius: f64,
) -> HeightField {
    let plane = ground(scenes, touching_distance);
    let aside = centre_radius * plane.axes.angle.sin();
    let own = scenes.profile.as_ref();
    HeightField {
        profile: own.map_or(Profile::Plane, |own| profile(own, aside)),
        ..plane
    }
}

/// The profile of a scene's ground, whose tire touches it so far aside, mm.
fn profile(own: &GroundProfile, aside: f64) -> Profile {
    let [x, y] = own.place_mm;
    let centre = [x, y + aside];
    let round = Round {
        centre,
        radius: own.radius_mm,
    };
    match own.kind {
        ProfileKind::Sphere => Profile::Sphere(round),
        ProfileKind::Cylinder => Profile::Cylinder(round, own.left()),
        ProfileKind::Edge => Profile::Edge(round, own.left()),
        ProfileKind::Rough => Profile::Waves(rough_ground::waves(&own.roughness(), centre)),
    }
}

/// Depth at which the ground presses with about the scene's load, mm; the solve goes on from there.
pub(crate) fn depth_of_load(scene: &Scene) -> f64 {
    let load = scene.ground.load_n.unwrap_or(0.0);
    (load / load_per_mm(scene)).min(deepest(scene))
}

/// Smallest step of the way to the scene's load, relative to that of a load which the tire may bear: one beyond all bounds is approached in steps as small.
pub(crate) fn load_step(scene: &Scene) -> f64 {
    let bearable = deepest(scene) * load_per_mm(scene);
    let load = scene.ground.load_n.unwrap_or(0.0);
    if load > bearable {
        bearable / load
    } else {
        1.0
    }
}

/// Half of the section, mm.
fn deepest(scene: &Scene) -> f64 {
    0.5 * scene.geometry.section_radius_mm
}

/// Estimates the load that a millimetre of depth adds, N/mm: the patch in which two circles meet a plane grows by 2 pi sqrt(R r) mm^2 per mm, and two
/// fifths of what the pressure and the bending wall bear there reach the ground. On the reference tire it is within a half to twice of the truth from 1 to
/// 30 N.
fn load_per_mm(scene: &Scene) -> f64 {
    let geometry = &scene.geometry;
    let slenderness = geometry.wall_mm / geometry.section_radius_mm;
    let bending = scene.material.law.shear_modulus_mpa() * slenderness * slenderness;
    let bearing = 0.4 * (scene.pressure.internal_mpa + bending);
    TAU * bearing * (geometry.outer_radius_mm * geometry.section_radius_mm).sqrt()
}

/// The penalty that the scene gives, or one to its wall.
pub(super) fn penalty(scene: &Scene) -> Penalty {
    let wall = scene.geometry.wall_mm;
    let scaled = PENALTY_FACTOR * scene.material.law.shear_modulus_mpa() / wall;
    Penalty {
        stiffness: scene.contact.penalty_n_per_mm3.unwrap_or(scaled),
        ramp: PENALTY_RAMP * wall,
    }
}

/// Sticking points give as little as pressed ones.
pub(super) fn friction(scene: &Scene) -> Friction {
    Friction {
        coefficient: scene.contact.friction,
        stiffness: penalty(scene).stiffness,
    }
}
