//! Changes of every film's signal with a small shift of the ground, along the wheel and across it, of one solve a load.
//!
//! A slope is the part of the field that is odd in one shift alone, over the shift (`mirror_parts`). What is left out is of third order in it.

use fem_client::solver::{Response, Ring};

use crate::layout::solving::layout_fields::{MeshFields, samples};
use crate::layout::solving::layout_scenes::{LayoutScenes, readout};
use crate::layout::solving::mirror_parts::{mirrored, part};
use crate::points::archive::Outcome;
use layouts::arrangement::FilmKind;
use layouts::field::film_field::ShearField;

/// Parts that are odd in the shift along the wheel alone, and in the one across alone.
const SLOPES: [[bool; 2]; 2] = [[true, false], [false, true]];

/// Adds slopes over the ground's shift to what a mesh answers.
pub(crate) fn add_shear(
    fields: &mut MeshFields,
    scenes: &LayoutScenes,
    kinds: &[FilmKind],
    dragged: Result<Vec<Outcome>, String>,
) {
    match dragged {
        Ok(outcomes) => {
            (fields.fields.sheared, fields.reasons) = shear_fields(scenes, kinds, &outcomes);
        }
        Err(reason) => fields
            .reasons
            .push(format!("The ground couldn't be dragged: {reason}")),
    }
}

/// Slopes at each load where the ground could be dragged, and why there are none elsewhere.
fn shear_fields(
    scenes: &LayoutScenes,
    kinds: &[FilmKind],
    outcomes: &[Outcome],
) -> (Vec<ShearField>, Vec<String>) {
    let (mut fields, mut reasons) = (Vec::new(), Vec::new());
    for (load, outcome) in scenes.loads.iter().zip(outcomes) {
        let found = match outcome {
            Ok(response) => shear_field(scenes, kinds, response),
            Err(unsolved) => Err(unsolved.to_string()),
        };
        match found {
            Ok(field) => fields.push(field),
            Err(reason) => reasons.push(format!(
                "Ground pressed by {load} couldn't be dragged: {reason}"
            )),
        }
    }
    (fields, reasons)
}

/// Slopes at one load, from the answer to a scene of [`LayoutScenes::sheared`] read by [`mirrored`].
///
/// # Errors
/// What the answer lacks.
pub fn shear_field(
    scenes: &LayoutScenes,
    kinds: &[FilmKind],
    response: &Response,
) -> Result<ShearField, String> {
    let shift = scenes.shift_mm();
    let depth_mm = response.depth_mm;
    let [x, y, z] = response.force_n.ok_or("the solver gives no force")?;
    let lines = readout(kinds).rings;
    let read = mirrored(kinds).rings;
    let rings = SLOPES.map(|odd| -> Option<Vec<Ring>> {
        let ring = |line| part(line, odd, shift, &read, &response.rings);
        lines.iter().map(ring).collect()
    });
    let [Some(along), Some(across)] = rings else {
        return Err("the solver gives no strains around the wheel".to_owned());
    };
    let of_kind = |kind: &FilmKind| {
        Some([
            samples(&along, kind, kinds)?,
            samples(&across, kind, kinds)?,
        ])
    };
    Ok(ShearField {
        depth_mm,
        force_slopes: [x / shift, y / shift],
        slopes: kinds
            .iter()
            .map(of_kind)
            .collect::<Option<_>>()
            .ok_or("the solver gives no strains around the wheel")?,
        sliding_n: scenes.friction() * z,
    })
}
