//! Time of a solve, by a law fitted to measured solves, and corrected by what this machine has measured.
//!
//! t = a (N / 300)^b with N the cells between nodes in a quarter of the tire ([`Solver::cells`]). `a` and `b` go through the processor times of the
//! reference tire's draft (300 cells) and reference meshes (10 240), one thread, from solves of whole studies. On the coarse and standard meshes between them
//! the laws are at most 1.3 times too long. The exponents
//! are within those of `docs/proof/speed.md`, 1.2 to 1.6.

use std::collections::{BTreeMap, HashMap};

use estimation::error_metrics::order_statistics::upper_median;
use fem_client::scene::{Level, Scene};
use fem_client::solver::{Readout, Solver};

use crate::points::{mirror_class, tire};

/// Cells of the draft mesh of the reference tire.
pub(super) const CELLS: f64 = 300.0;
/// Inflating and pressing from nothing: s on the draft mesh, exponent.
const AFRESH: (f64, f64) = (0.045, 1.29);
/// Law of a solve from a neighbouring equilibrium with its tangent.
const NEAR: (f64, f64) = (0.011, 1.24);
/// Reading a mirror image's strains and storing it, s.
const IMAGE_S: f64 = 0.003;
/// Pressing by steps from the inflated state, as friction asks for, in solves from a neighbour: on the draft and coarse meshes, and on finer ones.
const FRICTION: [f64; 2] = [11.0, 21.0];
/// A solve with a glued film, in solves without.
const FILM: f64 = 2.0;
/// A solve whose ground is dragged along the wheel or across it, and one dragged both ways, in solves of a mesh of that size: on the coarse and the standard mesh.
const DRAGGED: [f64; 2] = [1.3, 2.4];
/// The tangents that the points near a cut point share, in solves from nothing.
const TANGENTS: f64 = 0.6;
/// Memory of a mesh in work: bytes on the draft mesh, exponent, through studies on the draft (34 MB) and the reference mesh (1.3 GB).
const MEMORY: (f64, f64) = (10e6, 1.4);

/// A study's solves may be off what is expected of its machine by this factor, as far as is known before them.
const UNKNOWN: f64 = 3.0;
/// Depth of the ground over the section's radius up to which solves near a cut point keep its tangent, however thin the wall.
const DEEP: f64 = 0.2;
/// A clock's resolution, s.
const SHORTEST_S: f64 = 1e-6;

/// Start of a point's solve.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum How {
    /// Start from nothing, before all others of its mesh.
    Cut,
    /// Start from the cut point's equilibrium with its tangent.
    Near,
    /// Mirror image of another point, which isn't solved.
    Image,
    /// Start from nothing: another inflated tire than the cut point's.
    Afresh,
}

impl How {
    fn law(self) -> Self {
        match self {
            Self::Cut => Self::Afresh,
            other => other,
        }
    }
}

/// Solves that one factor corrects: a mesh and a kind of start.
pub(crate) type TaskKind = (Level, How);

/// A solve by what decides how long it takes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Task {
    pub how: How,
    pub level: Level,
    /// Cells between nodes in a quarter of the tire.
    pub cells: f64,
    /// Factor on the mesh's length, where more of the wheel is meshed finely.
    pub stretch: f64,
    pub friction: bool,
    /// Further work of ground that is dragged, relative.
    pub drag: f64,
    /// Whether a film is glued on.
    pub film: bool,
    /// Whether the ground comes further up than the wall is thick, and than [`DEEP`] of the section's radius: the solve then leaves the shared tangent for tangents of its own, as one with friction
    /// does, and prepares for contact that grows.
    pub deep: bool,
}

impl Task {
    pub fn of(scene: &Scene, solver: &dyn Solver, how: How) -> Self {
        Self::read(scene, &Readout::default(), solver, how)
    }

    /// Describes the solve of a scene of which this is read.
    pub fn read(scene: &Scene, readout: &Readout, solver: &dyn Solver, how: How) -> Self {
        let deepest = scene.ground.depths_mm.iter().copied().fold(0.0, f64::max);
        Self {
            how,
            level: scene.model.level,
            cells: solver.cells(scene) as f64,
            stretch: stretch(scene, readout, solver),
            friction: scene.contact.friction > 0.0,
            drag: drag(scene),
            film: scene.film.is_some(),
            deep: deepest
                > scene
                    .geometry
                    .wall_mm
                    .max(DEEP * scene.geometry.section_radius_mm),
        }
    }

    /// Returns the kind of solves whose factor corrects it.
    pub fn kind(&self) -> TaskKind {
        (self.level, self.how.law())
    }

    /// Returns the time by the law alone, s.
    fn law_s(&self) -> f64 {
        let power = |(a, b): (f64, f64)| a * (self.cells / CELLS).powf(b);
        let slip = if self.friction {
            FRICTION[usize::from(self.level > Level::Coarse)] * power(NEAR)
        } else {
            0.0
        };
        let glued = if self.film { FILM } else { 1.0 };
        match self.how {
            How::Cut | How::Afresh => self.stretch * self.drag * (glued * power(AFRESH) + slip),
            How::Near => self.stretch * self.drag * (glued * power(NEAR) + slip),
            How::Image => IMAGE_S,
        }
    }

    /// Returns the nodes of its surface over those of the draft mesh.
    pub fn surface(&self) -> f64 {
        (self.cells / CELLS).powf(2.0 / 3.0)
    }

    /// Peak memory of such a solve, bytes, without the program's own.
    pub fn memory_bytes(&self) -> f64 {
        let (draft, exponent) = MEMORY;
        draft * self.stretch * (self.cells / CELLS).powf(exponent)
    }
}

/// A mesh that reaches further around the wheel is longer, not thicker: time and memory grow in proportion. What asks for it presses with flat ground, of which
/// half as much is meshed as the law's solves had. Twice as much is where the wheel leans or is dragged across on ground that isn't alike before and behind it.
fn stretch(scene: &Scene, readout: &Readout, solver: &dyn Solver) -> f64 {
    const SYMMETRIC: f64 = 0.5;
    const WHOLE: f64 = 2.0;
    let [own, read] = [solver.cells(scene), solver.cells_read(scene, readout)];
    let longer = read as f64 / own as f64;
    let of_wheel = match (scene.ground.is_alike_across(), scene.ground.is_symmetric()) {
        (false, false) => WHOLE,
        (true, true) if read > own => SYMMETRIC,
        _ => 1.0,
    };
    of_wheel * longer.max(1.0)
}

/// Further work of ground that is dragged: steps, and of the whole tire larger factors.
fn drag(scene: &Scene) -> f64 {
    match scene.ground.shift_mm {
        [0.0, 0.0] => 1.0,
        [_, 0.0] | [0.0, _] => DRAGGED[0],
        _ => DRAGGED[1],
    }
}

/// A solve that this machine has made.
#[derive(Debug, Clone, PartialEq)]
pub struct Sample {
    /// Scene that was solved.
    pub scene: Scene,
    /// Time that it took, s.
    pub wall_s: f64,
    /// Whether others started from it.
    pub cut: bool,
}

/// Speed of this machine.
#[derive(Debug, Clone, PartialEq)]
pub struct Machine {
    /// Solves that run at once, each on a core.
    pub threads: usize,
    /// Solves by which the law was corrected.
    pub samples: usize,
    factors: BTreeMap<TaskKind, f64>,
    overall: f64,
}

/// Times of solves of one kind.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Taken {
    pub solves: usize,
    /// Time by the law alone, s.
    law_s: f64,
    wall_s: f64,
    /// Sum and sum of squares of the logarithms of time over law.
    logs: [f64; 2],
}

impl Taken {
    pub fn add(&mut self, task: &Task, wall_s: f64) {
        let log = (wall_s.max(SHORTEST_S) / task.law_s()).ln();
        self.solves += 1;
        self.law_s += task.law_s();
        self.wall_s += wall_s;
        self.logs[0] += log;
        self.logs[1] += log * log;
    }

    /// Factor by which such solves are expected to be off a time of so many times the law, from those made: sums corrected by Bayes' rule for normal
    /// logarithms. Solves that agree are believed, few that scatter by more than [`UNKNOWN`] hardly.
    fn correction(&self, factor: f64) -> f64 {
        let n = self.solves as f64;
        let variance =
            (self.logs[1] - self.logs[0] * self.logs[0] / n).max(0.0) / (n - 1.0).max(1.0);
        let prior = UNKNOWN.ln().powi(2);
        let weight = prior / (prior + variance / n);
        (self.wall_s / (self.law_s * factor)).powf(weight)
    }
}

impl Machine {
    /// A machine of which nothing is known but how many solves it runs at once.
    pub fn new(threads: usize) -> Self {
        Self::corrected(threads, Vec::new())
    }

    /// A machine that has made these solves. Each mesh and each kind of start is corrected by the median of measured over expected; what was never
    /// measured, by the median of all.
    pub fn measured(threads: usize, samples: &[Sample], solver: &dyn Solver) -> Self {
        Self::corrected(threads, recognised(samples, solver))
    }

    fn corrected(threads: usize, measured: Vec<(Task, f64)>) -> Self {
        let mut ratios: BTreeMap<TaskKind, Vec<f64>> = BTreeMap::new();
        for (task, wall_s) in measured {
            let ratio = wall_s / task.law_s();
            if ratio.is_finite() && ratio > 0.0 {
                let of_kind = ratios.entry(task.kind()).or_default();
                of_kind.push(ratio);
            }
        }
        let all: Vec<f64> = ratios.values().flatten().copied().collect();
        Self {
            threads: threads.max(1),
            samples: all.len(),
            overall: upper_median(all).unwrap_or(1.0),
            factors: ratios
                .into_iter()
                .filter_map(|(kind, ratios)| Some((kind, upper_median(ratios)?)))
                .collect(),
        }
    }

    /// Returns this machine at a study whose solves took this: a kind that wasn't come to yet is off as much as its like on another mesh or, without
    /// any, as all.
    pub(crate) fn revised(&self, taken: &BTreeMap<TaskKind, Taken>) -> Self {
        let correction = |starts: &dyn Fn(How) -> bool| {
            self.mean_over(taken, starts, |own, factor| own.correction(factor))
        };
        let all = correction(&|_| true).unwrap_or(1.0);
        let mut factors = BTreeMap::new();
        for level in Level::ALL {
            for how in [How::Near, How::Afresh] {
                let kind = (level, how);
                let factor = self.factor(&kind);
                let off = match taken.get(&kind) {
                    Some(own) => own.correction(factor),
                    None => correction(&|like| like == how).unwrap_or(all),
                };
                factors.insert(kind, factor * off);
            }
        }
        Self {
            factors,
            overall: self.overall * all,
            ..self.clone()
        }
    }

    /// Time taken over time expected; 1 before the first solve.
    pub(crate) fn off(&self, taken: &BTreeMap<TaskKind, Taken>) -> f64 {
        let ratio = |own: &Taken, factor: f64| own.wall_s / (own.law_s * factor);
        self.mean_over(taken, &|_| true, ratio).unwrap_or(1.0)
    }

    /// Mean of something of the solves that start in such a way, weighed by their expected time; None of none.
    fn mean_over(
        &self,
        taken: &BTreeMap<TaskKind, Taken>,
        starts: &dyn Fn(How) -> bool,
        of: impl Fn(&Taken, f64) -> f64,
    ) -> Option<f64> {
        let own = taken.iter().filter(|((_, how), _)| starts(*how));
        let (sum, expected_s) = own.fold((0.0, 0.0), |(sum, expected_s), (kind, own)| {
            let factor = self.factor(kind);
            let expected = own.law_s * factor;
            (sum + expected * of(own, factor), expected_s + expected)
        });
        (expected_s > 0.0).then(|| sum / expected_s)
    }

    fn factor(&self, kind: &TaskKind) -> f64 {
        *self.factors.get(kind).unwrap_or(&self.overall)
    }

    /// Returns how many times as long as on the machine of the law anything else than a solve takes: as the solves that are least off it, as others may be long for what they press.
    pub(super) fn slowness(&self) -> f64 {
        self.factors
            .values()
            .copied()
            .reduce(f64::min)
            .unwrap_or(1.0)
    }

    /// Expected wall-clock time of a solve, s.
    pub(crate) fn solve_s(&self, task: &Task) -> f64 {
        task.law_s() * self.factor(&task.kind())
    }

    /// Expected time of the tangents that points near such a cut point share, s.
    pub(crate) fn tangents_s(&self, task: &Task) -> f64 {
        let cut = Task {
            how: How::Cut,
            friction: false,
            ..*task
        };
        TANGENTS * self.solve_s(&cut)
    }
}

/// The samples whose kind is known: cut points, and points near one of them. Of mirror images the longer one was solved.
fn recognised(samples: &[Sample], solver: &dyn Solver) -> Vec<(Task, f64)> {
    let cuts: Vec<String> = samples
        .iter()
        .filter(|s| s.cut)
        .map(|s| tire(&s.scene))
        .collect();
    let mut near: HashMap<String, (Task, f64)> = HashMap::new();
    let mut found = Vec::new();
    for sample in samples {
        let tire = tire(&sample.scene);
        if sample.cut {
            found.push((Task::of(&sample.scene, solver, How::Cut), sample.wall_s));
        } else if cuts.contains(&tire) {
            let place = format!("{tire} {:?}", mirror_class(&sample.scene));
            let longest = near
                .entry(place)
                .or_insert((Task::of(&sample.scene, solver, How::Near), 0.0));
            longest.1 = longest.1.max(sample.wall_s);
        }
    }
    found.extend(near.into_values());
    found
}

#[cfg(test)]
mod tests {
    use fem_client::closed_form::ClosedFormSolver;

    use super::*;

    fn task(level: Level, how: How) -> Task {
        let mut scene = Scene::default();
        scene.model.level = level;
        Task::of(&scene, &ClosedFormSolver::new(), how)
    }

    #[test]
    fn the_law_is_near_what_was_measured_on_each_mesh() {
        // Processor times on the machine of docs/proof/speed.md; the fit goes through the outer two.
        let measured = [
            (Level::Draft, 0.037, 0.0104),
            (Level::Coarse, 0.31, 0.074),
            (Level::Standard, 1.06, 0.23),
            (Level::Reference, 3.7, 0.74),
        ];
        for (level, cut_s, near_s) in measured {
            for (how, seconds) in [(How::Cut, cut_s), (How::Near, near_s)] {
                let ratio = task(level, how).law_s() / seconds;
                assert!((0.9..1.7).contains(&ratio), "{level:?} {how:?}: {ratio}");
            }
        }
    }

    #[test]
    fn a_machine_is_corrected_by_the_median_of_what_it_measured() {
        let sample = |depth: f64, wall_s: f64, cut: bool| {
            let mut scene = Scene::default();
            scene.ground.depths_mm[0] = depth;
            Sample { scene, wall_s, cut }
        };
        let near_s = task(Level::Standard, How::Near).law_s();
        let cut_s = task(Level::Standard, How::Cut).law_s();
        let mut samples = vec![
            sample(1.0, 3.0 * cut_s, true),
            sample(0.8, 2.0 * near_s, false),
            sample(0.9, 4.0 * near_s, false),
            sample(1.1, 90.0 * near_s, false),
        ];
        let machine = Machine::measured(2, &samples, &ClosedFormSolver::new());
        assert_eq!(machine.samples, 4);
        let ratio = |machine: &Machine, level, how| {
            machine.solve_s(&task(level, how)) / task(level, how).law_s()
        };
        assert!((ratio(&machine, Level::Standard, How::Near) - 4.0).abs() < 1e-12);
        assert!((ratio(&machine, Level::Standard, How::Cut) - 3.0).abs() < 1e-12);
        // Of 2, 3, 4 and 90 the upper of the middle two.
        assert!((ratio(&machine, Level::Draft, How::Near) - 4.0).abs() < 1e-12);
        assert!((machine.slowness() - 3.0).abs() < 1e-12);
        // What no cut point explains is of unknown kind, and says nothing.
        samples.retain(|sample| !sample.cut);
        assert_eq!(
            Machine::measured(2, &samples, &ClosedFormSolver::new()),
            Machine::new(2)
        );
    }

    #[test]
    fn few_solves_that_scatter_correct_less_than_many_or_than_solves_that_agree() {
        let near = task(Level::Coarse, How::Near);
        let after = |factors: &[f64], times: usize| {
            let mut taken = Taken::default();
            for factor in factors.repeat(times) {
                taken.add(&near, factor * near.law_s());
            }
            taken.correction(1.0)
        };
        for factor in [0.1, 1.0, 70.0] {
            assert!((after(&[factor; 3], 1) / factor - 1.0).abs() < 1e-12);
        }
        // Deep contact: the first three solves near the cut point took so many times the law, all of the study 13 times.
        let deep = [18.0, 18.0, 174.0];
        let mean = deep.iter().sum::<f64>() / 3.0;
        let (few, many) = (after(&deep, 1), after(&deep, 30));
        assert!((13.0 / 3.0..13.0 * 3.0).contains(&few), "{few}");
        assert!((many / mean - 1.0).abs() < 0.1, "{many}");
    }

    #[test]
    fn a_mirror_image_that_took_no_time_is_no_measurement() {
        let side = |station: usize, wall_s: f64, cut: bool| {
            let mut scene = Scene::default();
            scene.ground.depths_mm[station] = 0.9;
            Sample { scene, wall_s, cut }
        };
        let near_s = task(Level::Standard, How::Near).law_s();
        let samples = [
            side(2, 1.0, true),
            side(0, 5.0 * near_s, false),
            side(4, 1e-3, false),
        ];
        let machine = Machine::measured(1, &samples, &ClosedFormSolver::new());
        let expected = machine.solve_s(&task(Level::Standard, How::Near));
        assert!((expected - 5.0 * near_s).abs() < 1e-12);
    }
}
