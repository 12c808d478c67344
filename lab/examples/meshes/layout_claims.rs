//! Do the claimed errors of the mesh cover the true ones in layouts? Bounds and simulated errors on every level against those of a mesh that is finer in every
//! direction than the finest level, on eight tires at three loads. The second table of `docs/proof/claims.md`.
//!
//! `cargo run --release -p lab --example layout_claims [TIRE...]`, half an hour on two cores and 4 GB for all tires.

mod eight_tires;
mod held_claims;

use std::sync::atomic::AtomicBool;

use documents::layouts::layout_settings::{LayoutLoads, Layouts};
use fem_client::scene::{Level, Scene};
use fem_client::solver::{Coarser, SolveRequest, StartState};
use layouts::arrangement::{Arrangement, FilmKind};
use layouts::field::film_field::Noise;
use layouts::ranking::layout_order::with_scores;
use layouts::ranking::layout_scores::Scorer;
use layouts::simulate::draws::Draws;
use layouts::simulate::simulation::SAMPLES;
use placement::layout::solving::layout_fields::{MeshFields, mesh_fields};
use placement::layout::solving::layout_scenes::{LayoutScenes, readout};
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};
use results::{LayoutError, LayoutLoad, LayoutScore, RankedLayout};
use tire::embedded::EmbeddedSolver;
use tire::mesh::tire_grid::MeshPlan;
use tire::mesh_error::coarser;
use tire::model::mesh_plan_for;

use eight_tires::{finer, study, tires};
use held_claims::{SHARE, held, over, quantile};

/// Loads over the mean of a tire's depths.
const LOADS: [f64; 3] = [0.5, 1.0, 2.0];
const UNITS: [usize; 6] = [6, 9, 12, 18, 24, 30];
/// Noise over the crown's largest strain.
const NOISE: f64 = 0.02;
/// Claims of simulated figures have so many standard errors of the simulation beside the mesh's.
const DEVIATIONS: f64 = 2.0;

const WHAT: [&str; 2] = ["bounds", "simulated"];

fn main() {
    let asked: Vec<String> = std::env::args().skip(1).collect();
    let mut tires = tires();
    tires.retain(|(name, ..)| {
        asked.is_empty() || asked.iter().any(|asked| name.contains(asked.as_str()))
    });
    println!(
        "| level | of | figures | error over the figure, {SHARE} are within | by figure: hold | over true | by layout: hold | over true | {SHARE} need |"
    );
    println!("|{}", " --- |".repeat(9));
    let of_tires: Vec<_> = tires
        .par_iter()
        .map(|(_, scene, depth)| {
            let scene = study(scene.clone(), *depth).expect("a study").scene;
            of_tire(&scene, &LOADS.map(|load| load * depth))
        })
        .collect();
    for (k, level) in Level::ALL.iter().skip(1).enumerate() {
        for (what, name) in WHAT.iter().enumerate() {
            let mut all = Judged::default();
            of_tires.iter().for_each(|judged| all.add(&judged[k][what]));
            println!("| {} | {name} | {all} |", level.as_str());
        }
    }
}

/// Scores of every layout at every load.
type Scores = Vec<Vec<LayoutScore>>;

/// Claims on every level with a coarser one, of bounds and of simulated figures.
fn of_tire(tire: &Scene, loads: &[f64]) -> Vec<[Judged; 2]> {
    let levels = Level::ALL.iter().map(|level| (*level, false));
    let meshes = levels.chain([(Level::Reference, true)]);
    let fields: Vec<MeshFields> = meshes
        .map(|(level, is_truth)| fields(tire, loads, level, is_truth))
        .collect();
    let truth = &fields[Level::ALL.len()];
    let depths: Vec<f64> = truth.loads.iter().flatten().copied().collect();
    let layouts = layouts();
    let scores_on = |fields: &MeshFields| -> Scores {
        let noise = Noise {
            floor: NOISE * fields.crown,
            in_volts: false,
            gain_std: 0.0,
            place_std_deg: 0.0,
        };
        let films = layouts.iter().map(|layout| layout.films.len());
        let draws = Draws::new(1, SAMPLES, films.max().unwrap_or(0));
        let depths = depths.clone();
        let scorer = Scorer::new(&fields.fields, noise, depths, layouts.iter(), draws, false);
        layouts
            .iter()
            .map(|layout| scorer.figures(layout))
            .collect()
    };
    let scores: Vec<Scores> = fields.iter().map(scores_on).collect();
    let on_level = |k: usize| {
        let mut scene = tire.clone();
        scene.model.level = Level::ALL[k];
        let coarser = coarser(&scene).expect("a coarser level");
        judged(
            &depths,
            &scores[k],
            (&scores[k - 1], coarser),
            &scores[Level::ALL.len()],
        )
    };
    (1..Level::ALL.len()).map(on_level).collect()
}

fn judged(
    depths: &[f64],
    own: &Scores,
    (before, coarser): (&Scores, Coarser),
    truth: &Scores,
) -> [Judged; 2] {
    let load = |depth: &f64| LayoutLoad {
        depth_mm: Some(*depth),
        load_n: None,
        force_slope_n_per_mm: None,
        shear: None,
        knees: Vec::new(),
        reason: None,
    };
    let loads: Vec<LayoutLoad> = depths.iter().map(load).collect();
    let mut all = [Judged::default(), Judged::default()];
    for ((own, before), truth) in own.iter().zip(before).zip(truth) {
        let claimed = with_scores(
            RankedLayout::default(),
            &loads,
            own.clone(),
            Some(&(before.clone(), coarser)),
        );
        for ((load, before), truth) in claimed.loads.iter().zip(before).zip(truth) {
            for (all, figures) in all.iter_mut().zip([&BOUNDS, &SIMULATED]) {
                for figure in figures {
                    all.judge(figure, (&load.score, before, truth), coarser);
                }
            }
        }
    }
    all
}

/// A figure of a score, what is claimed of it, and its standard error by the number of samples.
struct Figure {
    value: fn(&LayoutScore) -> Option<f64>,
    claim: fn(&LayoutError) -> Option<f64>,
    standard_error: fn(&LayoutScore) -> Option<f64>,
}

const BOUNDS: [Figure; 3] = [
    Figure {
        value: |score| score.worst_angle_error_deg,
        claim: |error| error.worst_angle_error_deg,
        standard_error: |_| Some(0.0),
    },
    Figure {
        value: |score| score.rms_angle_error_deg,
        claim: |error| error.rms_angle_error_deg,
        standard_error: |_| Some(0.0),
    },
    Figure {
        value: |score| score.worst_depth_error_mm,
        claim: |error| error.worst_depth_error_mm,
        standard_error: |_| Some(0.0),
    },
];
const SIMULATED: [Figure; 3] = [
    Figure {
        value: |score| score.simulated_rms_angle_error_deg,
        claim: |error| error.simulated_rms_angle_error_deg,
        standard_error: |score| score.simulated_rms_angle_error_deg_se,
    },
    Figure {
        value: |score| score.simulated_p95_angle_error_deg,
        claim: |error| error.simulated_p95_angle_error_deg,
        standard_error: |score| score.simulated_p95_angle_error_deg_se,
    },
    Figure {
        value: |score| score.force_error_n,
        claim: |error| error.force_error_n,
        standard_error: |score| score.force_error_n_se,
    },
];

/// True errors, and what is claimed of each.
#[derive(Default)]
struct Judged {
    errors: Vec<f64>,
    /// True errors over the figures.
    relative: Vec<f64>,
    /// Claims by a figure's own difference.
    by_figure: Vec<f64>,
    /// Claims by the largest difference of a layout, as a study makes them, without the part of the simulation: all meshes have the same noise.
    by_layout: Vec<f64>,
}

impl Judged {
    /// Judges a figure, unless some mesh has none.
    fn judge(
        &mut self,
        figure: &Figure,
        (own, before, truth): (&LayoutScore, &LayoutScore, &LayoutScore),
        coarser: Coarser,
    ) {
        let found = || {
            let values = (
                (figure.value)(own)?,
                (figure.value)(before)?,
                (figure.value)(truth)?,
            );
            let claim = (figure.claim)(own.error.as_ref()?)?;
            Some((values, claim, (figure.standard_error)(own)?))
        };
        let Some(((own, before, truth), claim, standard_error)) = found() else {
            return;
        };
        let of_simulation = DEVIATIONS * standard_error;
        let of_mesh = (claim * claim - of_simulation * of_simulation)
            .max(0.0)
            .sqrt();
        self.errors.push((own - truth).abs());
        self.relative.push((own / truth - 1.0).abs());
        self.by_figure.push(coarser.factor * (own - before).abs());
        self.by_layout.push(of_mesh);
    }

    fn add(&mut self, other: &Self) {
        self.errors.extend(&other.errors);
        self.relative.extend(&other.relative);
        self.by_figure.extend(&other.by_figure);
        self.by_layout.extend(&other.by_layout);
    }
}

impl std::fmt::Display for Judged {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self {
            errors,
            relative,
            by_figure,
            by_layout,
        } = self;
        write!(
            f,
            "{} | {:.1} % | {:.1} % | {:.1} | {:.1} % | {:.1} | {:.2}",
            errors.len(),
            100.0 * quantile(relative.clone(), SHARE),
            held(errors, by_figure),
            1.0 / over(errors, by_figure, 0.5),
            held(errors, by_layout),
            1.0 / over(errors, by_layout, 0.5),
            over(errors, by_layout, SHARE)
        )
    }
}

/// Films along x, along y, and both, at the crown and the shoulder; of both at the crown also in turn.
fn layouts() -> Vec<Arrangement> {
    let mut all = Vec::new();
    for units in UNITS {
        for kinds in [[0, 1], [2, 3]] {
            for kinds in [&kinds[..1], &kinds[1..], &kinds] {
                all.push(Arrangement::regular(units, kinds, false));
            }
        }
        all.push(Arrangement::regular(units, &[0, 1], true));
    }
    all
}

/// Fields of points at the crown and the shoulder along x and y.
fn fields(tire: &Scene, loads: &[f64], level: Level, is_truth: bool) -> MeshFields {
    let kinds = [(0.0, 0.0), (0.0, 90.0), (45.0, 0.0), (45.0, 90.0)];
    let kinds = kinds.map(|(section_deg, angle_deg)| FilmKind::point(section_deg, angle_deg));
    let settings = Layouts {
        loads: LayoutLoads::Depths(loads.to_vec()),
        ..Layouts::default()
    };
    let scenes = LayoutScenes::of(&settings, tire).expect("loads");
    let (solver, stop, readout) = (
        EmbeddedSolver::default(),
        AtomicBool::new(false),
        readout(&kinds),
    );
    let (mut states, mut outcomes): (Vec<StartState>, _) = (Vec::new(), Vec::new());
    let plan = |scene: &Scene| -> MeshPlan {
        let plan = mesh_plan_for(scene, level, &readout);
        if is_truth { finer(plan) } else { plan }
    };
    for (k, scene) in scenes.scenes(level).iter().enumerate() {
        let depth = scene.ground.depths_mm[0];
        let apart = |state: &&StartState| (state.depths_mm[0] - depth).abs();
        let start = states.iter().min_by(|a, b| apart(a).total_cmp(&apart(b)));
        let request = SolveRequest {
            scene,
            readout: &readout,
            start,
            watch: &stop,
        };
        let solved = solver.solve_on(&request, &plan(scene));
        let solved = solved.expect("an equilibrium");
        outcomes.push(Ok(solved.response));
        if k < loads.len() {
            states.push(solved.state);
        }
    }
    mesh_fields(&scenes, &kinds, &outcomes).expect("fields")
}
