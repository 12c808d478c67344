//! Solved loads as fields of every kind of film.

use fem_client::solver::{Response, Ring};

use crate::layout::arrangement::FilmKind;
use crate::layout::field::film_field::DepthFields;
use crate::layout::field::hermite::Nodes;
use crate::layout::solving::layout_scenes::{LayoutScenes, readout};
use crate::run::archive::Outcome;
use crate::score::quantity::around;

/// Depths nearer than this are one, mm.
const SAME_DEPTH_MM: f64 = 1e-6;

/// What one mesh answers about the loads of a study.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshFields {
    /// Signals of all kinds of film.
    pub fields: DepthFields,
    /// For each load asked for: its depth (mm), or why it wasn't reached.
    pub loads: Vec<Result<f64, String>>,
    /// The crown's largest strain at the load in the middle.
    pub crown: f64,
}

/// Fields of the kinds of film from what was solved, in the order of the scenes; the first two kinds are those of the crown.
///
/// # Errors
/// Why there are none.
pub fn mesh_fields(
    scenes: &LayoutScenes,
    kinds: &[FilmKind],
    outcomes: &[Outcome],
) -> Result<MeshFields, String> {
    let solved = |index: usize| -> Result<(f64, &Response), String> {
        let response = outcomes[index]
            .as_ref()
            .map_err(|unsolved| unsolved.to_string())?;
        let depth = response.depth_mm.ok_or("the solver gives no depth")?;
        Ok((depth, response))
    };
    let of_load = |load| {
        let index = scenes.solved.iter().position(|other| *other == load);
        let (depth, _) = solved(index.ok_or("it wasn't solved")?)?;
        Ok(depth)
    };
    let loads: Vec<Result<f64, String>> = scenes.loads.iter().map(|load| of_load(*load)).collect();
    let mut nodes: Vec<(f64, &Response)> = (0..outcomes.len())
        .filter_map(|index| solved(index).ok())
        .collect();
    nodes.sort_by(|a, b| a.0.total_cmp(&b.0));
    nodes.dedup_by(|b, a| b.0 - a.0 < SAME_DEPTH_MM);
    if nodes.len() < 2 {
        return Err(
            "Fewer than two loads have an equilibrium, so that layouts have no scores.".to_owned(),
        );
    }
    let signals = kinds.iter().map(|kind| {
        nodes
            .iter()
            .map(|(_, response)| samples(response, kind, kinds))
            .collect()
    });
    let fields = DepthFields {
        depths: Nodes::new(nodes.iter().map(|node| node.0).collect()),
        forces_n: nodes.iter().map(|node| node.1.reaction_n).collect(),
        signals: signals
            .collect::<Option<_>>()
            .ok_or("The solver gives no strains around the wheel.")?,
    };
    let (middle, _) = solved(scenes.middle())
        .map_err(|reason| format!("The load in the middle has no equilibrium: {reason}"))?;
    let at_middle = fields.at(middle);
    let crown = at_middle.kinds[..2]
        .iter()
        .flat_map(|kind| kind.signal.samples());
    let crown = crown.fold(0.0, |largest: f64, strain| largest.max(strain.abs()));
    Ok(MeshFields {
        fields,
        loads,
        crown,
    })
}

/// Strains of one kind of film around the wheel.
fn samples(response: &Response, kind: &FilmKind, kinds: &[FilmKind]) -> Option<Vec<f64>> {
    let readout = readout(kinds);
    let lines = readout.rings.iter().zip(&response.rings);
    let (line, ring): (_, &Ring) = lines
        .into_iter()
        .find(|(line, _)| line.section_deg == kind.phi_deg)?;
    match kind.angle_deg {
        0.0 => Some(around(ring).x.clone()),
        90.0 => Some(around(ring).y.clone()),
        angle => {
            let turned = line.turned_deg.iter().position(|turned| *turned == angle)?;
            ring.turned.get(turned).cloned()
        }
    }
}
