//! Solved loads as fields of every kind of film.

use fem_client::solver::{Readout, Response, Ring};

use crate::layout::solving::layout_scenes::{LayoutScenes, readout};
use crate::points::archive::Outcome;
use crate::score::quantity::around;
use layouts::arrangement::FilmKind;
use layouts::field::film_field::{DepthFields, SurfaceError};
use layouts::field::hermite::{DEGREES, Nodes, Turn};
use results::ContactFindings;

/// Depths nearer than this are one, mm.
const SAME_DEPTH_MM: f64 = 1e-6;

/// Standard deviations of a bell that hold 95 % of it.
const NORMAL_95: f64 = 1.959_964;

/// The sample of a film at the contact's centre.
pub const CONTACT: usize = DEGREES / 2;

/// Fields of one mesh at the loads of a study.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshFields {
    /// Signals of all kinds of film.
    pub fields: DepthFields,
    /// Depth of each load asked for, mm, or why it wasn't reached.
    pub loads: Vec<Result<f64, String>>,
    /// Depth of the load in the middle, mm.
    middle_mm: f64,
    /// The crown's largest signal at the load in the middle.
    pub crown: f64,
    /// Reasons why something is missing that was asked for.
    pub reasons: Vec<String>,
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
        let depth = response.depth_mm;
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
            .map(|(_, response)| samples(&response.rings, kind, kinds))
            .collect()
    });
    let fields = DepthFields {
        depths: Nodes::new(nodes.iter().map(|node| node.0).collect()),
        forces_n: nodes.iter().map(|node| node.1.reaction_n).collect(),
        signals: signals
            .collect::<Option<_>>()
            .ok_or("The solver gives no strains around the wheel.")?,
        sheared: Vec::new(),
        contacts: None,
        spread: None,
        together: None,
        surface_error: None,
    };
    let (middle_mm, _) = solved(scenes.middle())
        .map_err(|reason| format!("The load in the middle has no equilibrium: {reason}"))?;
    let mut mesh = MeshFields {
        fields,
        loads,
        middle_mm,
        crown: 0.0,
        reasons: Vec::new(),
    };
    mesh.crown = mesh.crown_signal()?;
    Ok(mesh)
}

impl MeshFields {
    /// Depths of the loads that were reached, mm.
    pub(crate) fn depths(&self) -> Vec<f64> {
        self.loads.iter().flatten().copied().collect()
    }

    /// The crown's largest signal at the load in the middle.
    ///
    /// # Errors
    /// The crown feels nothing.
    pub(crate) fn crown_signal(&self) -> Result<f64, String> {
        let crown = self.crown_at(self.middle_mm);
        match crown > 0.0 {
            true => Ok(crown),
            false => Err("The crown feels nothing, so that layouts have no scores.".to_owned()),
        }
    }

    /// The crown's largest signal at a depth, mm.
    fn crown_at(&self, depth_mm: f64) -> f64 {
        let field = self.fields.at(depth_mm);
        let crown = field.kinds[..2].iter();
        let signals = crown.flat_map(|kind| kind.signal.samples());
        signals.fold(0.0, |largest: f64, signal| largest.max(signal.abs()))
    }

    /// Deviation of a surface over contacts beside this field, of which shares are claimed.
    pub(crate) fn surface_error(&self, found: &ContactFindings) -> SurfaceError {
        let deepest = self.depths().into_iter().fold(0.0, f64::max);
        let deviation = |claim: Option<f64>, rms: f64| claim.map_or(rms, |claim| claim / NORMAL_95);
        SurfaceError {
            signal: deviation(found.signal_claim, found.signal_error_rms) * self.crown_at(deepest),
            force_n: deviation(found.force_claim_n, found.force_error_n),
        }
    }
}

/// Signal of one kind of film around the wheel: the mean over its points, a linear function of what the lines read.
pub fn samples(rings: &[Ring], kind: &FilmKind, kinds: &[FilmKind]) -> Option<Vec<f64>> {
    let readout = readout(kinds);
    let mut mean = vec![0.0; DEGREES];
    for point in kind.points() {
        for (angle_deg, weight) in kind.reads.directions(kind.angle_deg) {
            let along = along(rings, &readout, point.section_deg, angle_deg)?;
            let along = Turn::new(along.clone());
            for (sum, degree) in mean.iter_mut().zip(-180..180) {
                *sum += weight * point.share * along.at(f64::from(degree) + point.wheel_deg);
            }
        }
    }
    Some(mean)
}

/// Strains at a section angle along a direction, degrees.
fn along<'r>(
    rings: &'r [Ring],
    readout: &Readout,
    section_deg: f64,
    angle_deg: f64,
) -> Option<&'r Vec<f64>> {
    let mut lines = readout.rings.iter().zip(rings);
    let (line, ring) = lines.find(|(line, _)| line.section_deg == section_deg)?;
    match angle_deg {
        0.0 => Some(&around(ring).x),
        90.0 => Some(&around(ring).y),
        angle => {
            let turned = line.turned_deg.iter().position(|turned| *turned == angle)?;
            ring.turned.get(turned)
        }
    }
}

#[cfg(test)]
mod tests {
    use fem_client::scene::Geometry;
    use fem_client::solver::direction::PerDirection;

    use super::*;

    /// Lines for a kind of film, with strains by the wheel angle, degrees.
    fn rings(kind: FilmKind, x: impl Fn(f64) -> f64) -> Vec<Ring> {
        let theta_deg: Vec<f64> = (-180..180).map(f64::from).collect();
        let ring = |section_deg| Ring {
            section_deg,
            strain: PerDirection {
                x: theta_deg.iter().map(|theta| x(*theta)).collect(),
                y: vec![0.0; DEGREES],
            },
            turned: Vec::new(),
            theta_deg: theta_deg.clone(),
        };
        let lines = readout(&[kind]).rings.into_iter();
        lines.map(|line| ring(line.section_deg)).collect()
    }

    #[test]
    fn a_long_film_reads_a_wider_peak() {
        // 10 mm are 12.2 degrees at the crown.
        let (width, length_mm) = (8.0, 10.0);
        let long = FilmKind::sized(&Geometry::default(), Some([length_mm, 1.0]), 0.0, 0.0);
        let peak = |theta: f64| (-0.5 * (theta / width) * (theta / width)).exp();
        let found = samples(&rings(long, peak), &long, &[long]).expect("lines");
        let moment = |power: i32| -> f64 {
            let terms = found.iter().zip(-180..180);
            terms.map(|(f, u)| f * f64::from(u).powi(power)).sum()
        };
        let squared = moment(2) / moment(0);
        let covered = (length_mm / 47.0f64).to_degrees();
        let expected = width * width + covered * covered / 12.0;
        // The mean of a film adds its own second moment; the interpolation's fourth order leaves 1e-5.
        assert!(
            (squared / expected - 1.0).abs() < 1e-4,
            "{squared} {expected}"
        );
        assert!((moment(0) / (width * std::f64::consts::TAU.sqrt()) - 1.0).abs() < 1e-4);
    }

    #[test]
    fn a_tiny_film_reads_what_a_point_reads() {
        let of = |kind: FilmKind| {
            let rings = rings(kind, |theta| (-0.01 * theta * theta).exp());
            samples(&rings, &kind, &[kind]).expect("lines")
        };
        let point = of(FilmKind::point(0.0, 0.0));
        assert_eq!(point[180], 1.0);
        let tiny = FilmKind::sized(&Geometry::default(), Some([1e-6, 1e-6]), 0.0, 0.0);
        for (a, b) in of(tiny).iter().zip(&point) {
            assert!((a - b).abs() < 1e-9);
        }
    }

    #[test]
    fn without_its_lines_a_film_reads_nothing() {
        let kind = FilmKind::sized(&Geometry::default(), Some([10.0, 5.0]), 0.0, 0.0);
        assert_eq!(samples(&[], &kind, &[kind]), None);
        let rings = rings(FilmKind::point(0.0, 0.0), |_| 1.0);
        assert_eq!(samples(&rings, &kind, &[kind]), None);
    }
}
