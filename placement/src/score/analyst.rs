//! The analysis of all outputs of a study's points, from the method's campaign and from what is known of strains beside it.

use std::sync::atomic::{AtomicBool, Ordering};

use gsa::campaign::Campaign;
use gsa::method::analysis::{Analysis, Status};
use gsa::symmetric::Symmetric;
use ndarray::{Array2, ArrayView1, Axis};

use crate::points::archive::Outcome;
use crate::score::mirror_images::{Mirror, mirrored_columns};
use crate::score::quantity::tolerance;
use crate::score::readings::{location_columns, range, values};
use documents::parts::directions::Directions;
use documents::study::Study;

/// Analyst of the outcomes at a study's points, on any mesh.
pub(crate) struct Analyst<'s> {
    campaign: &'s Campaign,
    directions: Directions,
    mirror: Option<Mirror>,
}

/// Service to outputs: those that the method serves, or those by the thousand.
#[derive(Clone, Copy)]
enum Service {
    Served,
    Surveyed,
}

impl Service {
    /// Outputs between two looks at whether to stop: the dearest method takes a tenth of a second for one that it serves.
    fn at_once(self) -> usize {
        match self {
            Self::Served => 1,
            Self::Surveyed => 64,
        }
    }
}

/// The analysis was stopped.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Stopped;

impl<'s> Analyst<'s> {
    pub(crate) fn new(study: &Study, campaign: &'s Campaign) -> Self {
        Self {
            campaign,
            directions: study.directions,
            mirror: Mirror::of(study, campaign),
        }
    }

    /// An analysis of each output, locations first, then the map.
    ///
    /// # Errors
    /// When `stop` is set meanwhile.
    ///
    /// # Panics
    /// If there is not one outcome for each point, or the responses differ in their readout.
    pub(crate) fn analyses(
        &self,
        outcomes: &[Outcome],
        stop: &AtomicBool,
    ) -> Result<Vec<Analysis>, Stopped> {
        let points = self.campaign.points().len();
        assert_eq!(outcomes.len(), points, "one outcome for each point");
        let values = values(outcomes);
        let [ranked, others] = location_columns(outcomes, self.directions);
        let mapped: Vec<usize> = (ranked.len() + others.len()..values.ncols()).collect();
        let parts = [
            (Service::Served, ranked),
            (Service::Surveyed, others),
            (Service::Surveyed, mapped),
        ];
        let first = outcomes.iter().flatten().next();
        let images = first.and_then(mirrored_columns).unwrap_or_default();
        let mirror = self.mirror.as_ref();
        let symmetric = mirror.and_then(|mirror| mirror.shown_by(&values, &images));
        let mut found: Vec<(usize, Analysis)> = Vec::with_capacity(values.ncols());
        for (service, columns) in parts {
            for columns in groups(&columns, &images, service.at_once()) {
                if stop.load(Ordering::Relaxed) {
                    return Err(Stopped);
                }
                let mirror = symmetric.zip(Some(&images));
                let analyses = self.of_columns(service, &values, &columns, mirror);
                found.extend(columns.into_iter().zip(analyses));
            }
        }
        found.sort_by_key(|(column, _)| *column);
        let by_column = values.columns().into_iter().zip(found);
        let open = first.map_or(0.0, tolerance);
        let resolved = by_column.map(|(values, (_, analysis))| resolved(analysis, values, open));
        Ok(resolved.collect())
    }

    fn of_columns(
        &self,
        service: Service,
        values: &Array2<f64>,
        columns: &[usize],
        mirror: Option<(&Symmetric, &Vec<usize>)>,
    ) -> Vec<Analysis> {
        let part = values.select(Axis(1), columns);
        let mirror = mirror.and_then(|(symmetric, images)| {
            let place = |&column: &usize| columns.binary_search(&images[column]).ok();
            let images: Option<Vec<usize>> = columns.iter().map(place).collect();
            Some((symmetric, images?))
        });
        let found = match (service, mirror) {
            (Service::Served, None) => self.campaign.analyse(&part.view()),
            (Service::Served, Some((symmetric, images))) => {
                symmetric.analyse(&part.view(), &images)
            }
            (Service::Surveyed, None) => self.campaign.survey(&part.view()),
            (Service::Surveyed, Some((symmetric, images))) => {
                symmetric.survey(&part.view(), &images)
            }
        };
        found.expect("a campaign that asked for points has the rules to analyse them")
    }
}

/// Columns, in order, in groups of so many or one more: each has its columns' mirror images, where the columns have them.
fn groups(columns: &[usize], images: &[usize], at_once: usize) -> Vec<Vec<usize>> {
    let image = |column: usize| {
        let image = images.get(column).filter(|image| **image != column);
        image.filter(|image| columns.binary_search(image).is_ok())
    };
    let mut groups: Vec<Vec<usize>> = Vec::new();
    for &column in columns {
        let image = image(column).copied();
        if image.is_some_and(|image| image < column) {
            continue;
        }
        let together = std::iter::once(column).chain(image);
        match groups.last_mut() {
            Some(group) if group.len() < at_once => group.extend(together),
            _ => groups.push(together.collect()),
        }
    }
    groups.iter_mut().for_each(|group| group.sort_unstable());
    groups
}

/// Takes indices off what a solver can't tell from nothing.
fn resolved(analysis: Analysis, values: ArrayView1<'_, f64>, tolerance: f64) -> Analysis {
    let deviation = analysis.variance.map(f64::sqrt);
    let is_nothing = range(values) <= tolerance || deviation.is_some_and(|d| d <= tolerance);
    if analysis.status == Status::Unusable || tolerance == 0.0 || !is_nothing {
        return analysis;
    }
    analysis.into_constant(&format!(
        "constant within the solver's tolerance: it varies by less than the {tolerance:.0e} that a solve leaves open in a strain"
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_grouped_with_their_mirror_images_and_each_once() {
        let images = [4, 3, 2, 1, 0, 6, 5, 7];
        assert_eq!(
            groups(&[0, 2, 4, 7], &images, 1),
            [vec![0, 4], vec![2], vec![7]]
        );
        // The image of 5 isn't among them.
        assert_eq!(groups(&[1, 2, 3, 5], &images, 2), [vec![1, 3], vec![2, 5]]);
        assert_eq!(groups(&[0, 1, 2], &[], 2), [vec![0, 1], vec![2]]);
        assert!(groups(&[], &[], 2).is_empty());
    }
}
