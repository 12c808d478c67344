//! Scores of layouts on one mesh, at every load.

use std::collections::BTreeMap;

use crate::arrangement::{Arrangement, LaidFilm};
use crate::field::film_field::{DepthFields, LoadField, Noise, SurfaceError};
use crate::field::response_surface::Drawn;
use crate::fisher::bounds::{bayes_angle_deg, bounds, weakest_signal};
use crate::ranking::contact_scores::{of_surface, told};
use crate::ranking::shear_score::shear;
use crate::simulate::alike::alike;
use crate::simulate::drawn_contacts::TrueContact;
use crate::simulate::draws::Draws;
use crate::simulate::reading_likelihood::Likelihood;
use crate::simulate::simulation::{Simulated, simulate, simulate_unknown};
use results::{ContactError, DeadFilm, LayoutScore};

/// Largest simulated errors of a layout over the loads, with their standard errors by the number of samples.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct LargestErrors {
    /// 95th percentile of the angle's error, degrees.
    pub angle_deg: f64,
    /// Standard error of it, degrees.
    pub angle_se_deg: f64,
    /// Root mean square error of the vertical force, N.
    pub force_n: f64,
    /// Standard error of it, N.
    pub force_se_n: f64,
}

/// Scores layouts on the fields of one mesh.
pub struct Scorer {
    noise: Noise,
    /// Likelihoods by the kinds of film that a layout has.
    likelihoods: BTreeMap<Vec<usize>, Likelihood>,
    /// Likelihoods with the error of the surface over contacts as further noise; none where it isn't known.
    off_surface: BTreeMap<Vec<usize>, Likelihood>,
    surface_error: Option<SurfaceError>,
    depths_mm: Vec<f64>,
    draws: Draws,
    dead: bool,
}

impl Scorer {
    /// Prepares for these layouts at these depths, with this noise of simulated readings. `dead`: also without the film whose loss costs most.
    pub fn new<'a>(
        fields: &DepthFields,
        noise: Noise,
        depths_mm: Vec<f64>,
        layouts: impl Iterator<Item = &'a Arrangement>,
        draws: Draws,
        dead: bool,
    ) -> Self {
        let with_noise =
            |noise: Noise| move |kinds: &Vec<usize>| Likelihood::new(fields.of_kinds(kinds), noise);
        let surface_error = fields.surface_error;
        let noisier = surface_error.map(|error| Noise {
            floor: noise.floor.hypot(error.signal),
            ..noise
        });
        let (mut likelihoods, mut off_surface) = (BTreeMap::new(), BTreeMap::new());
        for layout in layouts {
            let kinds = kinds_of(layout);
            if let Some(noisier) = noisier {
                let off = off_surface.entry(kinds.clone());
                off.or_insert_with_key(with_noise(noisier));
            }
            likelihoods
                .entry(kinds)
                .or_insert_with_key(with_noise(noise));
        }
        Self {
            noise,
            likelihoods,
            off_surface,
            surface_error,
            depths_mm,
            draws,
            dead,
        }
    }

    /// The noise of each film.
    pub fn noise(&self) -> Noise {
        self.noise
    }

    /// A layout's scores at each depth.
    ///
    /// # Panics
    /// Of a layout that wasn't announced.
    pub fn scores(&self, arrangement: &Arrangement) -> Vec<LayoutScore> {
        let mut scores = self.figures(arrangement);
        let (likelihood, own) = self.own(arrangement);
        for (score, depth) in scores.iter_mut().zip(&self.depths_mm) {
            score.alike = alike(likelihood.fields(), *depth, &own, &self.noise);
        }
        for (score, contacts) in scores.iter_mut().zip(self.by_contacts(likelihood, &own)) {
            score.contacts = contacts;
        }
        if self.dead {
            let dead = self.dead_film(likelihood, &own).into_iter();
            scores
                .iter_mut()
                .zip(dead)
                .for_each(|(score, dead)| score.dead = Some(dead));
        }
        scores
    }

    /// Errors at each depth of contacts that differ in nothing, and in each quantity alone, as an estimate has them that knows so; nothing where contacts don't
    /// differ.
    fn by_contacts(&self, likelihood: &Likelihood, own: &Arrangement) -> Vec<Vec<ContactError>> {
        let mut errors = vec![Vec::new(); self.depths_mm.len()];
        for (drawn, law, likelihood) in likelihood.alone() {
            let simulated = simulate(likelihood, &self.depths_mm, own, &self.draws, *drawn);
            let [of, words] = law.map_or(["noise"; 2], |quantity| {
                [quantity.as_str(), quantity.words()]
            });
            for ((errors, depth), found) in errors.iter_mut().zip(&self.depths_mm).zip(simulated) {
                let slope = likelihood.field(*depth).force_slope.abs();
                errors.push(ContactError {
                    of: of.to_owned(),
                    words: words.to_owned(),
                    p95_angle_error_deg: found.p95_angle_deg,
                    force_error_n: found.force_n(slope)[0],
                });
            }
        }
        errors
    }

    /// Bounds and simulated errors alone, at each depth.
    ///
    /// # Panics
    /// Of a layout that wasn't announced.
    pub fn figures(&self, arrangement: &Arrangement) -> Vec<LayoutScore> {
        let (likelihood, own) = self.own(arrangement);
        let simulated = simulate(likelihood, &self.depths_mm, &own, &self.draws, Drawn::All);
        let at = |(depth, simulated): (&f64, &Simulated)| {
            self.score(likelihood.fields(), *depth, &own, simulated)
        };
        let scores = self.depths_mm.iter().zip(&simulated).map(at);
        let mut scores: Vec<LayoutScore> = scores.collect();
        if let Some(error) = self.surface_error {
            let likelihood = &self.off_surface[&kinds_of(arrangement)];
            let off = simulate(likelihood, &self.depths_mm, &own, &self.draws, Drawn::All);
            for ((score, off), depth) in scores.iter_mut().zip(&off).zip(&self.depths_mm) {
                let slope = likelihood.field(*depth).force_slope.abs();
                score.error = Some(of_surface(score, off, (slope, error.force_n)));
            }
        }
        scores
    }

    /// Largest errors over the depths: as assumed, or of contacts that an estimate takes for those of the depths.
    ///
    /// # Panics
    /// Of a layout that wasn't announced.
    pub fn largest_errors(
        &self,
        arrangement: &Arrangement,
        unknown: Option<&[TrueContact]>,
    ) -> LargestErrors {
        let (likelihood, own) = self.own(arrangement);
        let simulated = match unknown {
            None => simulate(likelihood, &self.depths_mm, &own, &self.draws, Drawn::All),
            Some(contacts) => {
                let kinds = kinds_of(arrangement);
                let contacts = contacts.iter().map(|contact| contact.of_kinds(&kinds));
                let at: Vec<_> = self.depths_mm.iter().copied().zip(contacts).collect();
                simulate_unknown(likelihood, &at, &own, &self.draws)
            }
        };
        let mut largest = LargestErrors::default();
        for (depth, found) in self.depths_mm.iter().zip(&simulated) {
            let slope = likelihood.field(*depth).force_slope.abs();
            if found.p95_angle_deg > largest.angle_deg {
                largest.angle_deg = found.p95_angle_deg;
                largest.angle_se_deg = found.p95_angle_se_deg;
            }
            let [force_n, force_se_n] = found.force_n(slope);
            if force_n > largest.force_n {
                largest.force_n = force_n;
                largest.force_se_n = force_se_n;
            }
        }
        largest
    }

    /// The depth where the bound with a flat prior is worst, mm, and that bound, degrees.
    ///
    /// # Panics
    /// Of a layout that wasn't announced.
    pub(crate) fn worst_bound(&self, arrangement: &Arrangement) -> (f64, f64) {
        let (likelihood, own) = self.own(arrangement);
        let at = |&depth: &f64| {
            let bound = bayes_angle_deg(&likelihood.field(depth), &own, &self.noise);
            (depth, bound.unwrap_or(f64::INFINITY))
        };
        let bounds = self.depths_mm.iter().map(at);
        bounds.fold(
            (0.0, 0.0),
            |worst, own| if own.1 > worst.1 { own } else { worst },
        )
    }

    /// The 95th percentile of the angle's error, degrees, and the force's error, N, at a depth by other draws.
    ///
    /// # Panics
    /// Of a layout that wasn't announced.
    pub(crate) fn glimpse(
        &self,
        arrangement: &Arrangement,
        depth_mm: f64,
        draws: &Draws,
    ) -> [f64; 2] {
        let (likelihood, own) = self.own(arrangement);
        let slope = likelihood.field(depth_mm).force_slope.abs();
        let found = &simulate(likelihood, &[depth_mm], &own, draws, Drawn::All)[0];
        [found.p95_angle_deg, found.force_n(slope)[0]]
    }

    /// The likelihood of a layout's kinds of film, and the layout with its kinds numbered as there.
    fn own(&self, arrangement: &Arrangement) -> (&Likelihood, Arrangement) {
        let kinds = kinds_of(arrangement);
        (&self.likelihoods[&kinds], renumbered(arrangement, &kinds))
    }

    fn score(
        &self,
        fields: &DepthFields,
        depth_mm: f64,
        arrangement: &Arrangement,
        simulated: &Simulated,
    ) -> LayoutScore {
        let field = &fields.at(depth_mm);
        let [force_n, force_se_n] = simulated.force_n(field.force_slope.abs());
        LayoutScore {
            simulated_rms_angle_error_deg: Some(simulated.rms_angle_deg),
            simulated_rms_angle_error_deg_se: Some(simulated.rms_angle_se_deg),
            simulated_p95_angle_error_deg: Some(simulated.p95_angle_deg),
            simulated_p95_angle_error_deg_se: Some(simulated.p95_angle_se_deg),
            lost_share: Some(simulated.lost_share),
            simulated_rms_depth_error_mm: Some(simulated.rms_depth_mm),
            force_error_n: Some(force_n),
            force_error_n_se: Some(force_se_n),
            told: told(fields, simulated),
            shear: shear(fields, &self.noise, depth_mm, arrangement),
            ..bounded(field, &self.noise, arrangement)
        }
    }

    /// The film whose loss costs most by the bound over all depths, and what estimates without it are worth at each.
    fn dead_film(&self, likelihood: &Likelihood, arrangement: &Arrangement) -> Vec<DeadFilm> {
        let fields: Vec<LoadField> = self
            .depths_mm
            .iter()
            .map(|depth| likelihood.field(*depth))
            .collect();
        let bounds_without = |film: usize| -> Vec<Option<f64>> {
            let rest = arrangement.without(film);
            fields
                .iter()
                .map(|field| bayes_angle_deg(field, &rest, &self.noise))
                .collect()
        };
        let mut worst = (0, bounds_without(0));
        let sum = |bounds: &[Option<f64>]| bounds.iter().flatten().sum::<f64>();
        for film in 1..arrangement.different_films() {
            let bounds = bounds_without(film);
            if sum(&bounds) > sum(&worst.1) {
                worst = (film, bounds);
            }
        }
        let rest = arrangement.without(worst.0);
        let simulated = match rest.films.is_empty() {
            true => Vec::new(),
            false => simulate(likelihood, &self.depths_mm, &rest, &self.draws, Drawn::All),
        };
        let at = |(k, bound): (usize, Option<f64>)| DeadFilm {
            film: worst.0,
            simulated_p95_angle_error_deg: simulated
                .get(k)
                .map(|simulated| simulated.p95_angle_deg),
            bayes_angle_error_deg: bound,
        };
        worst.1.into_iter().enumerate().map(at).collect()
    }
}

/// A layout's bounds at each depth, with nothing simulated: a thousandth of the work.
pub fn bounds_alone(
    fields: &DepthFields,
    noise: &Noise,
    depths_mm: &[f64],
    arrangement: &Arrangement,
) -> Vec<LayoutScore> {
    let kinds = kinds_of(arrangement);
    let fields = fields.of_kinds(&kinds);
    let own = renumbered(arrangement, &kinds);
    let at = |depth: &f64| LayoutScore {
        shear: shear(&fields, noise, *depth, &own),
        ..bounded(&fields.at(*depth), noise, &own)
    };
    depths_mm.iter().map(at).collect()
}

fn bounded(field: &LoadField, noise: &Noise, arrangement: &Arrangement) -> LayoutScore {
    let bounds = bounds(field, arrangement, noise);
    let known = bounds.as_ref().ok();
    LayoutScore {
        weakest_signal: Some(weakest_signal(field, arrangement)),
        worst_angle_error_deg: known.map(|bounds| bounds.worst_angle_deg),
        rms_angle_error_deg: known.map(|bounds| bounds.rms_angle_deg),
        worst_depth_error_mm: known.map(|bounds| bounds.worst_depth_mm),
        bayes_angle_error_deg: bayes_angle_deg(field, arrangement, noise),
        noise_strain: (!noise.in_volts).then_some(noise.floor),
        noise_v: noise.in_volts.then_some(noise.floor),
        reason: bounds.err(),
        ..LayoutScore::default()
    }
}

/// Kinds of film of a layout, each once, in order.
fn kinds_of(arrangement: &Arrangement) -> Vec<usize> {
    let mut kinds: Vec<usize> = arrangement.films.iter().map(|film| film.kind).collect();
    kinds.sort_unstable();
    kinds.dedup();
    kinds
}

/// The layout with kinds numbered by their places in a list that has them.
fn renumbered(arrangement: &Arrangement, kinds: &[usize]) -> Arrangement {
    let film = |film: &LaidFilm| LaidFilm {
        theta_deg: film.theta_deg,
        kind: kinds.partition_point(|&kind| kind < film.kind),
    };
    Arrangement {
        films: arrangement.films.iter().map(film).collect(),
        period_deg: arrangement.period_deg,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::field::film_field::ShearField;
    use crate::fisher::bounds::tests::{NOISE, gaussian};
    use crate::simulate::simulation::SAMPLES;

    #[test]
    fn a_layout_of_some_kinds_has_the_scores_of_its_own() {
        let fields = gaussian(14.0);
        let layouts = [
            Arrangement::regular(9, &[1], false),
            Arrangement::regular(9, &[0, 1], false),
        ];
        let scorer = Scorer::new(
            &fields,
            NOISE,
            vec![1.0, 0.6],
            layouts.iter(),
            Draws::new(1, SAMPLES, 18),
            true,
        );
        let [alone, both] = [&layouts[0], &layouts[1]].map(|layout| scorer.scores(layout));
        assert_eq!((alone.len(), both.len()), (2, 2));
        let expected = bounds(&fields.at(1.0), &layouts[0], &NOISE).expect("regular");
        assert_eq!(
            alone[0].worst_angle_error_deg,
            Some(expected.worst_angle_deg)
        );
        // Less depth, less signal; a film less, less known; 13 N/mm.
        assert!(alone[1].rms_angle_error_deg > alone[0].rms_angle_error_deg);
        let dead = both[0].dead.expect("asked for");
        assert!(dead.bayes_angle_error_deg > both[0].bayes_angle_error_deg);
        let force = both[0]
            .simulated_rms_depth_error_mm
            .map(|depth| 13.0 * depth);
        assert!(
            (both[0].force_error_n.expect("a force") / force.expect("a depth") - 1.0).abs() < 1e-9
        );
    }

    /// A surface that is off by three quarters of the noise adds a quarter to it: to errors as well, as they are in proportion to it.
    #[test]
    fn a_surface_that_is_off_adds_its_error_to_the_noise() {
        let layout = Arrangement::regular(24, &[0, 1], false);
        let scores = |surface_error| {
            let fields = DepthFields {
                surface_error,
                ..gaussian(14.0)
            };
            let layouts = std::iter::once(&layout);
            let draws = Draws::new(1, SAMPLES, 48);
            Scorer::new(&fields, NOISE, vec![1.0], layouts, draws, false)
                .figures(&layout)
                .swap_remove(0)
        };
        assert_eq!(scores(None).error, None);
        let off = SurfaceError {
            signal: 0.75 * NOISE.floor,
            force_n: 0.4,
        };
        let score = scores(Some(off));
        let error = score.error.expect("of the surface");
        let rms = score.simulated_rms_angle_error_deg.expect("simulated");
        let added = error.simulated_rms_angle_error_deg.expect("of the surface");
        assert!((added / rms - 0.25).abs() < 0.02, "{added} {rms}");
        let force = score.force_error_n.expect("simulated");
        let expected = (1.25 * force).hypot(0.4) - force;
        let added = error.force_error_n.expect("of the surface");
        assert!((added / expected - 1.0).abs() < 0.05, "{added} {expected}");
    }

    #[test]
    fn the_last_film_that_dies_leaves_nothing_known() {
        let one = Arrangement::free(vec![LaidFilm {
            theta_deg: 0.0,
            kind: 0,
        }]);
        let scorer = Scorer::new(
            &gaussian(14.0),
            NOISE,
            vec![1.0],
            std::iter::once(&one),
            Draws::new(1, SAMPLES, 1),
            true,
        );
        let score = &scorer.scores(&one)[0];
        let dead = score.dead.expect("asked for");
        assert_eq!(dead.simulated_p95_angle_error_deg, None);
        assert!((dead.bayes_angle_error_deg.expect("the prior") - 103.923).abs() < 1e-3);
        assert!(score.reason.is_some() && score.simulated_p95_angle_error_deg > Some(90.0));
    }

    /// A shift along changes the first kind of film alone, one across the second, by `across` times the bell.
    fn sheared(across: f64) -> DepthFields {
        let mut fields = gaussian(14.0);
        let bell = |u: i32| (-0.5 * (f64::from(u) / 14.0).powi(2)).exp();
        let over = |of: &dyn Fn(i32) -> f64| (-180..180).map(of).collect::<Vec<f64>>();
        let along = over(&|u| f64::from(u).to_radians().sin() * bell(u));
        let nothing = over(&|_| 0.0);
        fields.sheared = vec![ShearField {
            depth_mm: 1.001,
            force_slopes: [15.0, 11.0],
            slopes: vec![
                [along, nothing.clone()],
                [nothing, over(&|u| across * bell(u))],
            ],
            sliding_n: 6.5,
        }];
        fields
    }

    #[test]
    fn forces_along_and_across_are_told_or_named() {
        let layout = Arrangement::regular(18, &[0, 1], false);
        let score = |fields: &DepthFields, depth: f64| {
            let layouts = std::iter::once(&layout);
            Scorer::new(
                fields,
                NOISE,
                vec![depth],
                layouts,
                Draws::new(1, SAMPLES, 36),
                false,
            )
            .scores(&layout)[0]
                .clone()
        };
        let told = score(&sheared(1.0), 1.0);
        let shear = told.shear.expect("a load that was dragged");
        assert_eq!(shear.reason, None);
        // What is unknown beside it can't make an error smaller.
        assert!(shear.worst_angle_error_deg >= told.worst_angle_error_deg);
        let fields = sheared(1.0);
        let (field, _) = fields.with_shear(1.0).expect("dragged");
        let expected = bounds(&field, &layout, &NOISE).expect("regular");
        let shifts = expected
            .worst_shift_mm
            .map(|shift| shift.expect("an unknown"));
        let forces = [
            15.0 * shifts[0],
            11.0 * shifts[1],
            13.0 * expected.worst_depth_mm,
        ];
        let found = shear.worst_force_error_n.expect("forces");
        for (force, expected) in found.into_iter().flatten().zip(forces) {
            assert!((force / expected - 1.0).abs() < 1e-9, "{force} {expected}");
        }
        let weak = score(&sheared(1e-3), 1.0).shear.expect("dragged");
        assert!(
            weak.reason
                .expect("named")
                .starts_with("the force across isn't known within the 6.5 N")
        );
        // What no film feels takes nothing from what the others tell.
        let unfelt = score(&sheared(0.0), 1.0).shear.expect("dragged");
        assert_eq!(
            unfelt.reason.as_deref(),
            Some("no film feels the force across")
        );
        let [along, across, _] = unfelt.worst_force_error_n.expect("forces");
        assert!(across.is_none() && along <= found[0]);
        assert_eq!(score(&sheared(1.0), 0.6).shear, None);
    }
}
