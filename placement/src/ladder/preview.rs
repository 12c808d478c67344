//! A study cut down to what is answered while somebody writes its document.

use fem_client::scene::Level;
use fem_client::solver::Grid;
use gsa::method::Kind;

use crate::ladder::fidelity::Fidelity;
use documents::layouts::layout_settings::Layouts;
use documents::study::{Accuracy, Study};

/// Points of the map around the wheel and along the section, at most.
const MOST_MAP: [usize; 2] = [31, 11];

/// A study on the draft mesh, and what it leaves out of the one that was asked for.
#[derive(Debug, Clone, PartialEq)]
pub struct Preview {
    /// Study to solve: places alone, on a small map, by a plan that isn't extended.
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
        if study.layouts.is_asked() {
            left_out.push("Layouts: they take solves of their own.".to_owned());
        }
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
                layouts: Layouts::none(),
                signals: None,
                rig: None,
                accuracy: Accuracy::Preset,
                ..draft.raise(study)
            },
            left_out,
        }
    }
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
        assert!(!preview.study.layouts.is_asked());
        let grid = preview.study.grid.unwrap();
        assert_eq!((grid.circumferential, grid.meridional), (31, 11));
        let said = preview.left_out.join(" ");
        assert!(said.contains("Layouts") && said.contains("61 x 21") && !said.contains("signals"));
    }

    #[test]
    fn what_is_small_enough_stays_as_it_is() {
        let draft = Preview::of(&shipped()).study;
        let again = Preview::of(&draft);
        assert_eq!(again.study, draft);
        assert_eq!(again.left_out.len(), 2, "{:?}", again.left_out);
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
