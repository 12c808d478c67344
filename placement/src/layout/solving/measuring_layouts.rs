//! Solves what layouts ask for, after the study's own points, and puts layouts and what they show into its result.

use std::sync::atomic::{AtomicUsize, Ordering};

use fem_client::scene::{Level, Scene};
use fem_client::solver::{Coarser, Readout, Solver};

use crate::layout::arrangement::{FilmKind, LaidFilm};
use crate::layout::field::film_field::{LoadField, Noise};
use crate::layout::fisher::dense_ring::knee;
use crate::layout::layout_settings::{Layouts, NoiseFloor, direction_name};
use crate::layout::opinions::candidate_films::{agreement, candidates};
use crate::layout::ranking::asked_layouts::{
    AskedLayout, Kinds, asked_layouts, listed, search_films,
};
use crate::layout::ranking::layout_order::{front, rank, tau_of_bound, with_scores};
use crate::layout::ranking::layout_scores::Scorer;
use crate::layout::search::{KEPT, SearchPlaces};
use crate::layout::simulate::simulation::SAMPLES;
use crate::layout::solving::layout_fields::{MeshFields, mesh_fields};
use crate::layout::solving::layout_scenes::{LayoutScenes, Pressed, readout};
use crate::result::{
    Knee, LayoutFindings, LayoutLoad, LayoutScore, LayoutSearch, RankedLayout, StrainRing,
    StudyResult,
};
use crate::run::{Place, RunContext, RunError, outcomes_of};
use crate::study::Study;
use crate::study::plan::Plan;

const ORDER_NOTE: &str = "Layouts are in the order of their simulated error (95th percentile at the worst load) times the root of the number of films; their \
     Cramer-Rao bounds are lower, and far lower where two places look alike.";

/// Fills in a result's layouts. The points have ordinals from `first` on.
///
/// # Errors
/// See [`RunError`]; the result is unchanged then.
pub(crate) fn measure(
    first: usize,
    study: &Study,
    plan: &Plan,
    result: &mut StudyResult,
    context: RunContext<'_>,
) -> Result<(), RunError> {
    if !study.layouts.is_asked() {
        return Ok(());
    }
    let asked = Asked::of(study);
    let scenes = LayoutScenes::of(&study.layouts, &plan.points[0]);
    let mut solves = 0;
    let answer = match scenes {
        Err(reason) => Err(reason),
        Ok(scenes) => {
            let mut on_mesh = |level: Level| {
                let all = scenes.scenes(level);
                let place = Place {
                    first: first + solves,
                    of: first + solves + all.len(),
                };
                solves += all.len();
                solved(&scenes, &all, &asked, plan, place, context)
            };
            let level = study
                .layouts
                .level_on(&on_level(&plan.points[0], study.level));
            let coarser = context.solver.coarser(&on_level(&plan.points[0], level));
            let fine = on_mesh(level)?;
            let coarse =
                coarser.map(|coarser| Ok::<_, RunError>((on_mesh(coarser.level)?, coarser)));
            let coarse = coarse.transpose()?;
            fine.map(|fine| {
                Answer {
                    level,
                    scenes: &scenes,
                    fine,
                    coarse: coarse.and_then(|(fields, coarser)| Some((fields.ok()?, coarser))),
                }
                .filled(study, asked.clone(), context)
            })
        }
    };
    result.cost.layout_solves = solves;
    match answer {
        Ok(found) => {
            let (layouts, findings) = found?;
            result.notes.push(ORDER_NOTE.to_owned());
            result.layouts = layouts;
            result.layout_findings = Some(findings);
        }
        Err(reason) => {
            result.layouts = without_scores(&asked, &reason);
            result.layout_findings = Some(LayoutFindings {
                reasons: vec![reason],
                ..LayoutFindings::default()
            });
        }
    }
    Ok(())
}

/// All that is solved for a study's layouts: the scenes of each mesh, and what is read of them.
pub(crate) fn layout_series(
    study: &Study,
    plan: &Plan,
    solver: &dyn Solver,
) -> Vec<(Vec<Scene>, Readout)> {
    if !study.layouts.is_asked() {
        return Vec::new();
    }
    let Ok(scenes) = LayoutScenes::of(&study.layouts, &plan.points[0]) else {
        return Vec::new();
    };
    let readout = readout(Asked::of(study).kinds.all());
    let level = study
        .layouts
        .level_on(&on_level(&plan.points[0], study.level));
    let coarser = solver
        .coarser(&on_level(&plan.points[0], level))
        .map(|coarser| coarser.level);
    let levels = [Some(level), coarser].into_iter().flatten();
    levels
        .map(|level| (scenes.scenes(level), readout.clone()))
        .collect()
}

/// Films of the largest layout.
pub(crate) fn largest_layout(study: &Study) -> usize {
    let asked = Asked::of(study)
        .layouts
        .into_iter()
        .map(|layout| layout.arrangement.films.len());
    let searched = study
        .layouts
        .search
        .iter()
        .flat_map(|search| search.films.iter().copied());
    asked.chain(searched).max().unwrap_or(0)
}

/// How often a layout is scored at a load on a mesh: those that a search finds, and those with a film dead, are scored, too.
pub(crate) fn scorings(study: &Study, plan: &Plan, solver: &dyn Solver) -> usize {
    let series = layout_series(study, plan, solver).len();
    let loads =
        LayoutScenes::of(&study.layouts, &plan.points[0]).map_or(0, |scenes| scenes.loads.len());
    let found = study
        .layouts
        .search
        .as_ref()
        .map_or(0, |search| search.films.len() * KEPT);
    let layouts = Asked::of(study).layouts.len() + found;
    layouts * loads * (series + usize::from(study.layouts.dead && series > 0))
}

/// Simulated readings of a layout at a load: fewer where the mesh is rougher, too.
fn samples(level: Level) -> usize {
    match level {
        Level::Draft => SAMPLES / 4,
        Level::Coarse => SAMPLES / 2,
        Level::Standard | Level::Reference => SAMPLES,
    }
}

fn on_level(scene: &Scene, level: Level) -> Scene {
    let mut scene = scene.clone();
    scene.model.level = level;
    scene
}

/// Layouts, kinds of film and places of the search, as a document asks for them.
#[derive(Clone)]
struct Asked {
    kinds: Kinds,
    layouts: Vec<AskedLayout>,
    candidates: Vec<usize>,
    places: Vec<LaidFilm>,
}

impl Asked {
    fn of(study: &Study) -> Self {
        let mut kinds = Kinds::of_crown();
        let layouts = asked_layouts(&study.layouts, study.directions, &mut kinds);
        let search = study.layouts.search.as_ref();
        let places = search.map_or_else(Vec::new, |search| search_films(search, &mut kinds));
        let geometry = &study.scene.geometry;
        let inner = geometry.section_radius_mm - geometry.wall_mm;
        // A wall's thickness off the bead, where the clamp makes strains of its own.
        let farthest = geometry.bead_angle_deg - (geometry.wall_mm / inner).to_degrees();
        Self {
            candidates: kinds.candidates(farthest),
            kinds,
            layouts,
            places,
        }
    }
}

/// What one mesh answers. Without the first load there is nothing to start from: that costs the layouts, not the study.
fn solved(
    scenes: &LayoutScenes,
    all: &[Scene],
    asked: &Asked,
    plan: &Plan,
    place: Place,
    context: RunContext<'_>,
) -> Result<Result<MeshFields, String>, RunError> {
    let values = vec![plan.values()[0].clone(); all.len()];
    match outcomes_of(all, &values, &readout(asked.kinds.all()), place, context) {
        Ok(outcomes) => Ok(mesh_fields(scenes, asked.kinds.all(), &outcomes)),
        Err(error @ (RunError::PointsFailed { .. } | RunError::Refused { .. })) => {
            Ok(Err(format!("Layouts have no scores: {error}")))
        }
        Err(error) => Err(error),
    }
}

fn without_scores(asked: &Asked, reason: &str) -> Vec<RankedLayout> {
    let unscored = |(row, layout): (usize, &AskedLayout)| RankedLayout {
        rank: row + 1,
        rank_certain: Some(false),
        score: LayoutScore {
            reason: Some(reason.to_owned()),
            ..LayoutScore::default()
        },
        ..layout.label.clone()
    };
    asked.layouts.iter().enumerate().map(unscored).collect()
}

/// What was solved on both meshes.
struct Answer<'s> {
    level: Level,
    scenes: &'s LayoutScenes,
    fine: MeshFields,
    coarse: Option<(MeshFields, Coarser)>,
}

impl Answer<'_> {
    fn filled(
        &self,
        study: &Study,
        mut asked: Asked,
        context: RunContext<'_>,
    ) -> Result<(Vec<RankedLayout>, LayoutFindings), RunError> {
        let settings = &study.layouts;
        let noise = noise(settings, &self.fine);
        let depths = self.depths();
        let loads: Vec<LoadField> = depths
            .iter()
            .map(|depth| self.fine.fields.at(*depth))
            .collect();
        let searches = search(settings, &mut asked, &loads, &noise);
        let fine = self.scorer(&self.fine, &asked, study);
        let coarse = self
            .coarse
            .as_ref()
            .map(|(fields, coarser)| (self.scorer(fields, &asked, study), coarser.factor));
        let load_rows = self.loads(settings, study, &mut asked.kinds, &noise);
        let scored = in_parallel(asked.layouts.len(), context, |i| {
            let AskedLayout { arrangement, label } = &asked.layouts[i];
            let coarse = coarse
                .as_ref()
                .map(|(scorer, factor)| (scorer.figures(arrangement), *factor));
            let coarse = coarse
                .as_ref()
                .map(|(scores, factor)| (&scores[..], *factor));
            with_scores(label.clone(), &load_rows, fine.scores(arrangement), coarse)
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
            coarser_level: self
                .coarse
                .as_ref()
                .map(|(_, coarser)| coarser.level.as_str().to_owned()),
            front: front(&layouts),
            tau_of_bound: tau_of_bound(&layouts),
            searches,
            agreement: agreement(&candidates),
            candidates,
            rings: self.rings(&asked),
            loads: load_rows,
            reasons: Vec::new(),
        };
        Ok((layouts, findings))
    }

    /// Depths of the loads that were reached on both meshes, mm.
    fn depths(&self) -> Vec<f64> {
        self.fine.loads.iter().flatten().copied().collect()
    }

    fn scorer(&self, fields: &MeshFields, asked: &Asked, study: &Study) -> Scorer {
        let arrangements = asked.layouts.iter().map(|layout| &layout.arrangement);
        // At the fine mesh's depths: a load's depth differs a little between meshes, and its scores are compared.
        Scorer::new(
            &fields.fields,
            noise(&study.layouts, fields),
            self.depths(),
            arrangements,
            (study.method.seed, samples(self.level)),
            study.layouts.dead,
        )
    }

    fn loads(
        &self,
        settings: &Layouts,
        study: &Study,
        kinds: &mut Kinds,
        noise: &Noise,
    ) -> Vec<LayoutLoad> {
        let row = |(pressed, reached): (&Pressed, &Result<f64, String>)| {
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
                    knees: Vec::new(),
                    reason: Some(reason.clone()),
                },
                Ok(depth) => {
                    let field = self.fine.fields.at(*depth);
                    LayoutLoad {
                        depth_mm: Some(*depth),
                        load_n: Some(asked_n.unwrap_or(field.force_n)),
                        force_slope_n_per_mm: Some(field.force_slope),
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
        let depths = self.depths();
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
            let FilmKind { phi_deg, angle_deg } = asked.kinds.all()[kind];
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

/// Rounded to a tenth of what a solve leaves open in a strain.
fn to_nanostrain(strain: f64) -> f64 {
    (strain * 1e9).round() / 1e9 + 0.0
}

fn noise(settings: &Layouts, fields: &MeshFields) -> Noise {
    Noise {
        floor: match settings.noise.floor {
            NoiseFloor::Share(share) => share * fields.crown,
            NoiseFloor::Strain(strain) => strain,
        },
        gain_std: settings.noise.gain_std,
        place_std_deg: settings.noise.place_std_deg,
    }
}

/// The knee of every section angle and set of films.
fn knees(
    settings: &Layouts,
    study: &Study,
    kinds: &mut Kinds,
    field: &LoadField,
    noise: &Noise,
) -> Vec<Knee> {
    let mut knees = Vec::new();
    for section_deg in settings.sections_deg() {
        for set in settings.sets(study.directions) {
            let of_set: Vec<usize> = set
                .iter()
                .map(|&angle_deg| {
                    kinds.number(FilmKind {
                        phi_deg: section_deg,
                        angle_deg,
                    })
                })
                .collect();
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

/// Searches for the best layouts of each number of films, and adds them to those that are scored.
fn search(
    settings: &Layouts,
    asked: &mut Asked,
    loads: &[LoadField],
    noise: &Noise,
) -> Vec<LayoutSearch> {
    let Some(search) = &settings.search else {
        return Vec::new();
    };
    let places = SearchPlaces::new(asked.places.clone(), loads, noise);
    let mut reports = Vec::new();
    for &films in &search.films {
        let found = places.search(films);
        let laid = |found: &[usize]| -> Vec<LaidFilm> {
            found.iter().map(|&place| places.film(place)).collect()
        };
        for (k, layout) in found.best.iter().enumerate() {
            let name = format!("best {films} films, {}", k + 1);
            asked
                .layouts
                .push(listed(name, laid(&layout.places), &asked.kinds));
        }
        let best = &found.best[0];
        reports.push(LayoutSearch {
            films,
            places: places.count(),
            method: if found.is_exhaustive {
                "exhaustive"
            } else {
                "greedy and exchange"
            }
            .to_owned(),
            looked_at: found.looked_at,
            bayes_angle_error_deg: best.bayes_angle_deg,
            best: laid(&best.places)
                .iter()
                .map(|film| asked.kinds.place(film))
                .collect(),
        });
    }
    reports
}

/// What `of` makes of each number below `count`, on all threads; `None` when the study is stopped meanwhile.
fn in_parallel<T: Send>(
    count: usize,
    context: RunContext<'_>,
    of: impl Fn(usize) -> T + Sync,
) -> Option<Vec<T>> {
    let next = AtomicUsize::new(0);
    let work = || {
        let mut done = Vec::new();
        while !context.stop.load(Ordering::Relaxed) {
            let i = next.fetch_add(1, Ordering::Relaxed);
            if i >= count {
                break;
            }
            done.push((i, of(i)));
        }
        done
    };
    let mut all: Vec<(usize, T)> = std::thread::scope(|scope| {
        let threads: Vec<_> = (0..context.threads.min(count))
            .map(|_| scope.spawn(work))
            .collect();
        threads
            .into_iter()
            .flat_map(|thread| thread.join().unwrap_or_default())
            .collect()
    });
    all.sort_by_key(|(i, _)| *i);
    (all.len() == count).then(|| all.into_iter().map(|(_, done)| done).collect())
}
