//! A study cut down to what is answered while somebody writes its document.

use fem_client::scene::Level;
use fem_client::solver::Grid;
use gsa::method::Kind;

use crate::ladder::fidelity::Fidelity;
use documents::layouts::assumptions::Assumptions;
use documents::layouts::layout_settings::{LayoutLoads, Layouts};
use documents::study::{Accuracy, Study};

/// Points of the map around the wheel and along the section, at most.
const MOST_MAP: [usize; 2] = [31, 11];

/// Layouts of a preview at most: the default menu with room for some by hand.
const MOST_LAYOUTS: usize = 200;

/// A study on the draft mesh, and what it leaves out of the one that was asked for.
#[derive(Debug, Clone, PartialEq)]
pub struct Preview {
    /// Study to solve: places on a small map, by a plan that isn't extended, and layouts at one load.
    pub study: Study,
    /// Parts that aren't solved, and why; whole sentences.
    pub left_out: Vec<String>,
}

impl Preview {
    /// Cuts a study down.
    pub fn of(study: &Study) -> Self {
        let mut left_out = vec![
            "The error of the mesh: a draft has no coarser mesh to compare with.".to_owned(),
            "What the parts of reality that the model leaves out would change.".to_owned(),
        ];
        let layouts = lighter(study, &mut left_out);
        if study.signals.is_some() {
            left_out.push("Films' signals: they take solves of their own.".to_owned());
        }
        if study.accuracy != Accuracy::Preset {
            left_out
                .push("The accuracy that is asked for: a preview is on the draft mesh.".to_owned());
        }
        let kind = match study.method.kind {
            Kind::Auto => {
                left_out.push(
                    "The points that the adaptive method would add: a preview has its lines alone."
                        .to_owned(),
                );
                Kind::Mdrm
            }
            kind => kind,
        };
        let grid = study.grid.map(|grid| smaller(grid, &mut left_out));
        let draft = Fidelity {
            level: Level::Draft,
            kind,
            nodes: study.method.nodes,
        };
        Self {
            study: Study {
                grid,
                layouts,
                signals: None,
                rig: None,
                accuracy: Accuracy::Preset,
                ..draft.raise(study)
            },
            left_out,
        }
    }
}

/// The layouts at the load in the middle, of bare films, without what takes further solves or hundreds of simulations.
fn lighter(study: &Study, left_out: &mut Vec<String>) -> Layouts {
    let asked = &study.layouts;
    if !asked.is_asked() {
        return Layouts::none();
    }
    let count = asked.rings(study.directions).len() + asked.free.len();
    if count == 0 || count > MOST_LAYOUTS {
        left_out.push(format!(
            "{count} layouts: a preview has {MOST_LAYOUTS} at most, and none of a search."
        ));
        return Layouts::none();
    }
    let loads = match &asked.loads {
        LayoutLoads::Mean => LayoutLoads::Mean,
        LayoutLoads::Depths(depths) => LayoutLoads::Depths(middle(depths)),
        LayoutLoads::Forces(forces) => LayoutLoads::Forces(middle(forces)),
    };
    let light = Layouts {
        loads,
        glued: None,
        dead: false,
        shear: false,
        level: None,
        search: None,
        candidate_sizes_mm: Vec::new(),
        assumptions: Assumptions {
            film: None,
            ..asked.assumptions
        },
        ..asked.clone()
    };
    for (differs, what) in [
        (
            light.loads != asked.loads,
            "Layouts at other loads than the one in the middle.",
        ),
        (
            asked.glued.is_some(),
            "The stiffness of glued films: a preview's are bare.",
        ),
        (asked.dead, "Layouts with a dead film."),
        (asked.shear, "Forces along and across the wheel."),
        (asked.search.is_some(), "The search for the best layouts."),
    ] {
        if differs {
            left_out.push(what.to_owned());
        }
    }
    light
}

fn middle(loads: &[f64]) -> Vec<f64> {
    loads.get(loads.len() / 2).copied().into_iter().collect()
}

/// A map of the same extent with no more points than a preview has.
fn smaller(grid: Grid, left_out: &mut Vec<String>) -> Grid {
    let [circumferential, meridional] = MOST_MAP;
    let small = Grid {
        circumferential: grid.circumferential.min(circumferential),
        meridional: grid.meridional.min(meridional),
        ..grid
    };
    if small != grid {
        left_out.push(format!(
            "A map of {} x {} places: the preview's has {} x {}.",
            grid.circumferential, grid.meridional, small.circumferential, small.meridional
        ));
    }
    small
}

#[cfg(test)]
mod tests {
    use super::*;
    use document::Format;
    use documents::study::plan::Plan;
    use documents::study::presets;

    fn shipped() -> Study {
        Study::from_document(presets()[0].1, Format::Toml, &|path| Err(path.to_owned())).unwrap()
    }

    #[test]
    fn a_preview_has_the_points_of_its_study_on_a_draft_and_says_what_it_has_not() {
        let study = shipped();
        let preview = Preview::of(&study);
        let (own, small) = (
            Plan::new(&study).unwrap(),
            Plan::new(&preview.study).unwrap(),
        );
        assert_eq!(own.values(), small.values());
        assert!(
            small
                .points
                .iter()
                .all(|scene| scene.model.level == Level::Draft)
        );
        assert_eq!(preview.study.layouts.loads, LayoutLoads::Depths(vec![1.0]));
        let grid = preview.study.grid.unwrap();
        assert_eq!((grid.circumferential, grid.meridional), (31, 11));
        let said = preview.left_out.join(" ");
        assert!(
            said.contains("Layouts at other loads")
                && said.contains("61 x 21")
                && !said.contains("signals")
        );
    }

    #[test]
    fn what_is_small_enough_stays_as_it_is() {
        let draft = Preview::of(&shipped()).study;
        let again = Preview::of(&draft);
        assert_eq!(again.study, draft);
        assert_eq!(again.left_out.len(), 2, "{:?}", again.left_out);
    }

    #[test]
    fn what_layouts_take_further_solves_for_is_left_out() {
        let mut study = shipped();
        study.layouts.dead = true;
        study.layouts.shear = true;
        let preview = Preview::of(&study);
        assert!(!preview.study.layouts.dead && !preview.study.layouts.shear);
        let said = preview.left_out.join(" ");
        assert!(
            said.contains("dead film") && said.contains("along and across"),
            "{said}"
        );
        study.layouts.section_deg = (1..9).map(f64::from).collect();
        let many = Preview::of(&study);
        assert!(!many.study.layouts.is_asked());
        assert!(many.left_out.join(" ").contains("200 at most"));
    }

    #[test]
    fn an_adaptive_study_is_shown_by_its_lines() {
        let mut study = shipped();
        study.method.kind = Kind::Auto;
        study.accuracy = Accuracy::Tolerance(0.01);
        let preview = Preview::of(&study);
        assert_eq!(preview.study.method.kind, Kind::Mdrm);
        assert_eq!(preview.study.accuracy, Accuracy::Preset);
        let said = preview.left_out.join(" ");
        assert!(said.contains("adaptive") && said.contains("accuracy"));
    }
}
