//! Judgement of layouts: from the fields of both meshes to ranked layouts and what they show.

use fem_client::scene::Level;
use fem_client::solver::Coarser;

use crate::layout::solving::input_shifts::InputShifts;
use crate::layout::solving::layout_fields::MeshFields;
use crate::layout::solving::layout_scenes::{LayoutScenes, Pressed};
use crate::layout::solving::menu_words::menu;
use crate::layout::solving::searched_layouts::search;
use crate::layout::solving::study_layouts::Asked;
use crate::points::RunContext;
use crate::points::RunError;
use crate::points::worker_threads::in_parallel;
use crate::score::map_slopes::MapSlopes;
use documents::layouts::layout_settings::{Layouts, NoiseFloor, direction_name};
use documents::study::Study;
use layouts::arrangement::FilmKind;
use layouts::field::film_field::{LoadField, Noise};
use layouts::fisher::candidate_films::candidates;
use layouts::fisher::dense_ring::knee;
use layouts::ranking::asked_layouts::{AskedLayout, Kinds};
use layouts::ranking::layout_order::{front, rank, tau_of_bound, with_scores};
use layouts::ranking::layout_scores::Scorer;
use layouts::ranking::screening::{Limits, competitors, kept};
use layouts::simulate::draws::Draws;
use layouts::simulate::simulation::SAMPLES;
use results::{
    ContactFindings, FilmAnglesReport, Knee, LayoutFindings, LayoutLoad, LoadShear, MenuFindings,
    RankedLayout, StrainRing,
};

/// Simulated readings of a scored layout over those of one that is screened.
pub(crate) const FULL_TO_SHORT: usize = 5;

/// Fields that were solved on both meshes.
pub(crate) struct Answer<'s> {
    pub level: Level,
    pub scenes: &'s LayoutScenes,
    /// Kinds of film of the finer mesh, with their volts where they are glued.
    pub kinds: Vec<FilmKind>,
    pub fine: MeshFields,
    pub coarse: Option<(MeshFields, Coarser)>,
    /// Error of the response surface over contacts, where they differ.
    pub contacts: Option<ContactFindings>,
    /// Glued films solved around the wheel, where they are.
    pub films: Option<FilmAnglesReport>,
}

/// Judgement of layouts.
pub(crate) struct Judged {
    /// Layouts in their order.
    pub ranked: Vec<RankedLayout>,
    pub findings: LayoutFindings,
    /// Arrangements of these, as they were scored.
    pub scored: Vec<AskedLayout>,
    /// Draws of their simulated readings.
    pub draws: Draws,
}

impl Answer<'_> {
    /// Ranks the layouts, and says what they show. Sources of errors are those at a depth, mm, the study's own.
    pub fn filled(
        &self,
        study: &Study,
        mut asked: Asked,
        (depth_mm, slopes): (f64, Option<&MapSlopes>),
        context: RunContext<'_>,
    ) -> Result<Judged, RunError> {
        let settings = &study.layouts;
        let noise = noise(settings, &self.fine);
        let depths = self.fine.depths();
        let searches = search(
            settings,
            &mut asked,
            &self.fine.fields,
            &depths,
            &noise,
            context,
        )
        .ok_or(RunError::Stopped)?;
        let draws = Draws::new(study.method.seed, samples(self.level), asked.most_films());
        let fine = self.scorer(&self.fine, &asked, study, &draws);
        let menu = self.screen(&mut asked, &fine, study, context)?;
        let coarse = self
            .coarse
            .as_ref()
            .map(|(fields, coarser)| (self.scorer(fields, &asked, study, &draws), *coarser));
        let load_rows = self.loads(settings, study, &asked.kinds, &noise);
        let own_load = self.fine.fields.at(depth_mm);
        let shifts = InputShifts::of(study, slopes, asked.kinds.all(), own_load);
        let scored = in_parallel(asked.layouts.len(), context.threads, context.stop, |i| {
            let AskedLayout {
                arrangement, label, ..
            } = &asked.layouts[i];
            let coarse = coarse
                .as_ref()
                .map(|(scorer, coarser)| (scorer.figures(arrangement), *coarser));
            let scores = fine.scores(arrangement);
            let sources = shifts.as_ref();
            RankedLayout {
                error_sources: sources.and_then(|shifts| shifts.sources(arrangement, &noise)),
                ..with_scores(label.clone(), &load_rows, scores, coarse.as_ref())
            }
        });
        let mut layouts = scored.ok_or(RunError::Stopped)?;
        rank(&mut layouts);
        let candidate_kinds: Vec<FilmKind> = asked
            .candidates
            .iter()
            .map(|&kind| asked.kinds.all()[kind])
            .collect();
        let of_candidates = |fields: &MeshFields| fields.fields.of_kinds(&asked.candidates);
        let coarse_fields = self.coarse.as_ref().map(|(fields, coarser)| {
            (
                of_candidates(fields),
                self::noise(settings, fields),
                coarser.factor,
            )
        });
        let coarse_fields = coarse_fields
            .as_ref()
            .map(|(fields, noise, factor)| (fields, noise, *factor));
        let candidates = candidates(
            &candidate_kinds,
            &of_candidates(&self.fine),
            &depths,
            &noise,
            coarse_fields,
        );
        let findings = LayoutFindings {
            level: self.level.as_str().to_owned(),
            unit: settings.unit().to_owned(),
            size_mm: settings.size_mm,
            coarser_level: self
                .coarse
                .as_ref()
                .map(|(_, coarser)| coarser.level.as_str().to_owned()),
            contacts: self.contacts.clone(),
            films: self.films.clone(),
            assumptions: None,
            menu,
            front: front(&layouts),
            tau_of_bound: tau_of_bound(&layouts),
            searches,
            candidates,
            rings: self.rings(&asked),
            loads: load_rows,
            reasons: self.fine.reasons.clone(),
        };
        Ok(Judged {
            ranked: layouts,
            findings,
            scored: asked.layouts,
            draws,
        })
    }

    /// Scorer on one mesh, with this noise of simulated readings.
    fn scorer(&self, fields: &MeshFields, asked: &Asked, study: &Study, draws: &Draws) -> Scorer {
        let arrangements = asked.layouts.iter().map(|layout| &layout.arrangement);
        // At the fine mesh's depths: a load's depth differs a little between meshes, and its scores are compared.
        Scorer::new(
            &fields.fields,
            noise(&study.layouts, fields),
            self.fine.depths(),
            arrangements,
            draws.clone(),
            study.layouts.dead,
        )
    }

    /// Leaves those layouts of the menu that can't be the best of as few films, and says what was tried.
    fn screen(
        &self,
        asked: &mut Asked,
        scorer: &Scorer,
        study: &Study,
        context: RunContext<'_>,
    ) -> Result<MenuFindings, RunError> {
        let groups = competitors(&asked.layouts);
        let samples = samples(self.level) / FULL_TO_SHORT;
        let draws = Draws::new(study.method.seed, samples, asked.most_films());
        let limits = Limits {
            angle_deg: study.question.angle_deg,
            force_n: study.question.force_n,
        };
        let found = in_parallel(groups.len(), context.threads, context.stop, |k| {
            kept(&groups[k], &asked.layouts, scorer, &draws, limits)
        });
        let kept = found.ok_or(RunError::Stopped)?.concat();
        let screened = groups.iter().map(Vec::len).sum::<usize>() - kept.len();
        let labels: Vec<&RankedLayout> = asked.layouts.iter().map(|layout| &layout.label).collect();
        let sentence = menu(&labels, screened, asked.without_room);
        let all = std::mem::take(&mut asked.layouts).into_iter().enumerate();
        let left = all.filter(|(index, layout)| !layout.of_menu || kept.contains(index));
        asked.layouts = left.map(|(_, layout)| layout).collect();
        Ok(MenuFindings {
            screened,
            without_room: asked.without_room,
            sentence,
        })
    }

    fn loads(
        &self,
        settings: &Layouts,
        study: &Study,
        kinds: &Kinds,
        noise: &Noise,
    ) -> Vec<LayoutLoad> {
        let row =
            |(pressed, reached): (&Pressed, &Result<f64, String>)| {
                let asked_n = match pressed {
                    Pressed::Force(force) => Some(*force),
                    Pressed::Depth(_) => None,
                };
                let asked_mm = match pressed {
                    Pressed::Depth(depth) => Some(*depth),
                    Pressed::Force(_) => None,
                };
                match reached {
                    Err(reason) => LayoutLoad {
                        depth_mm: asked_mm,
                        load_n: asked_n,
                        force_slope_n_per_mm: None,
                        shear: None,
                        knees: Vec::new(),
                        reason: Some(reason.clone()),
                    },
                    Ok(depth) => {
                        let field = self.fine.fields.at(*depth);
                        LayoutLoad {
                            depth_mm: Some(*depth),
                            load_n: Some(asked_n.unwrap_or(field.force_n)),
                            force_slope_n_per_mm: Some(field.force_slope),
                            shear: self.fine.fields.with_shear(*depth).map(|(_, shear)| {
                                LoadShear {
                                    slopes_n_per_mm: shear.force_slopes,
                                    sliding_n: shear.sliding_n,
                                }
                            }),
                            knees: knees(settings, study, kinds, &field, noise),
                            reason: None,
                        }
                    }
                }
            };
        self.scenes
            .loads
            .iter()
            .zip(&self.fine.loads)
            .map(row)
            .collect()
    }

    /// Strains and slopes at the load in the middle, of every kind of film that layouts have.
    fn rings(&self, asked: &Asked) -> Vec<StrainRing> {
        let depths = self.fine.depths();
        let Some(&depth_mm) = depths.get(depths.len() / 2) else {
            return Vec::new();
        };
        let mut used: Vec<usize> = asked
            .layouts
            .iter()
            .flat_map(|layout| &layout.arrangement.films)
            .map(|film| film.kind)
            .collect();
        used.sort_unstable();
        used.dedup();
        let fine = self.fine.fields.at(depth_mm);
        let coarse = self
            .coarse
            .as_ref()
            .map(|(fields, coarser)| (fields.fields.at(depth_mm), coarser.factor));
        let ring = |&kind: &usize| {
            let of = |field: &LoadField| {
                [
                    field.kinds[kind].signal.samples().to_vec(),
                    field.kinds[kind].slopes[0].samples().to_vec(),
                ]
            };
            let [strain, by_depth] = of(&fine);
            let errors = coarse.as_ref().map(|(field, factor)| {
                let [coarse_strain, coarse_slope] = of(field);
                [
                    largest_difference(&strain, &coarse_strain),
                    largest_difference(&by_depth, &coarse_slope),
                ]
                .map(|error| factor * error)
            });
            let FilmKind {
                phi_deg, angle_deg, ..
            } = asked.kinds.all()[kind];
            StrainRing {
                section_deg: phi_deg,
                direction: direction_name(angle_deg),
                depth_mm,
                strain: strain.into_iter().map(to_nanostrain).collect(),
                by_depth: by_depth.into_iter().map(to_nanostrain).collect(),
                strain_error: errors.map(|errors| errors[0]),
                by_depth_error: errors.map(|errors| errors[1]),
            }
        };
        used.iter().map(ring).collect()
    }
}

fn largest_difference(a: &[f64], b: &[f64]) -> f64 {
    a.iter()
        .zip(b)
        .map(|(a, b)| (a - b).abs())
        .fold(0.0, f64::max)
}

/// Rounds to a tenth of what a solve leaves open in a strain.
fn to_nanostrain(strain: f64) -> f64 {
    (strain * 1e9).round() / 1e9 + 0.0
}

/// Errors of a film's reading on a mesh.
pub(crate) fn noise(settings: &Layouts, fields: &MeshFields) -> Noise {
    Noise {
        floor: match settings.noise.floor {
            NoiseFloor::Share(share) => share * fields.crown,
            NoiseFloor::Strain(floor) | NoiseFloor::Volts(floor) => floor,
        },
        in_volts: settings.glued.is_some(),
        gain_std: settings.noise.gain_std,
        place_std_deg: settings.noise.place_std_deg,
    }
}

/// The knee of every section angle and set of films.
fn knees(
    settings: &Layouts,
    study: &Study,
    kinds: &Kinds,
    field: &LoadField,
    noise: &Noise,
) -> Vec<Knee> {
    let mut knees = Vec::new();
    for section_deg in settings.sections_deg() {
        for set in settings.sets(study.directions) {
            let of_set = set
                .iter()
                .map(|&angle_deg| kinds.known(section_deg, angle_deg));
            // A film that has no room there is none of the layouts'.
            let Some(of_set) = of_set.collect::<Option<Vec<usize>>>() else {
                continue;
            };
            knees.extend(knee(field, &of_set, noise).map(|found| Knee {
                section_deg,
                films: set.iter().map(|angle| direction_name(*angle)).collect(),
                units: found.units,
                dense_deg: found.dense_deg,
                of_60_deg: found.of_60_deg,
            }));
        }
    }
    knees
}

/// Simulated readings of a layout at a load: fewer where the mesh is rougher, too.
pub(crate) fn samples(level: Level) -> usize {
    match level {
        Level::Draft => SAMPLES / 4,
        Level::Coarse => SAMPLES / 2,
        Level::Standard | Level::Reference => SAMPLES,
    }
}
