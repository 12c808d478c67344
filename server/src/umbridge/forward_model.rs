//! Model `forward`: values of a study's inputs to strains at its locations and the reaction, with derivatives.
//!
//! Each level has a cut point, all inputs at their means, which is solved from nothing; every other point starts from its equilibrium. What was asked once is known.

use std::collections::HashMap;
use std::sync::atomic::AtomicBool;
use std::sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError};

use document::fault::Fault;
use documents::study::Study;
use documents::study::plan::scene_at;
use fem_client::scene::Level;
use fem_client::solver::{Readout, Response, SolveError, SolveRequest, Solver, StartState};
use serde_json::Value;

/// Points that are kept, some hundred bytes each.
const MOST_KNOWN: usize = 100_000;
/// Names of the outputs, in their order.
pub(super) const OUTPUTS: [&str; 3] = ["strain_x", "strain_y", "reaction_n"];

/// A study as a model.
pub(crate) struct ForwardModel {
    study: Study,
    solver: Arc<dyn Solver>,
    stop: Arc<AtomicBool>,
    /// Equilibria of the cut points, by level; none where there is none.
    cuts: Mutex<HashMap<&'static str, Arc<OnceLock<Option<StartState>>>>>,
    known: Mutex<HashMap<Asked, Arc<Answer>>>,
    locations: usize,
    has_derivatives: bool,
}

/// Point that was asked for: values by their bits, level, and whether with derivatives.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
struct Asked {
    values: Vec<u64>,
    level: &'static str,
    with_derivatives: bool,
}

/// Answer at a point.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Answer {
    /// Values by output: strains x and y at each location, and the reaction, N.
    pub values: [Vec<f64>; 3],
    /// Derivatives by input: as the values are.
    pub derivatives: Vec<[Vec<f64>; 3]>,
}

/// Reason why there is no answer.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum NoAnswer {
    /// Values or a level that the study doesn't take, a sentence.
    Refused(String),
    /// Loads without equilibrium, a sentence.
    NoEquilibrium(String),
    /// The solver broke or was stopped, a sentence.
    Broken(String),
}

impl ForwardModel {
    /// Solves the cut point of the study's own level; `stop` ends all solves.
    ///
    /// # Errors
    /// When the cut point has no answer.
    pub fn begin(
        study: Study,
        solver: Arc<dyn Solver>,
        stop: Arc<AtomicBool>,
    ) -> Result<Self, NoAnswer> {
        let mut model = Self {
            study,
            solver,
            stop,
            cuts: Mutex::default(),
            known: Mutex::default(),
            locations: 0,
            has_derivatives: false,
        };
        let (means, level) = (model.means(), model.study.level);
        let cut = model.answer(&means, level, true);
        model.has_derivatives = cut.is_ok();
        let cut = cut.or_else(|_| model.answer(&means, level, false))?;
        model.locations = cut.values[0].len();
        Ok(model)
    }

    /// Number of inputs.
    pub fn inputs(&self) -> usize {
        self.study.inputs.len()
    }

    /// Names of the inputs, in their order.
    pub fn names(&self) -> String {
        let names: Vec<&str> = self
            .study
            .inputs
            .iter()
            .map(|input| input.name.as_str())
            .collect();
        names.join(", ")
    }

    /// Numbers of each output.
    pub fn sizes(&self) -> [usize; 3] {
        [self.locations, self.locations, 1]
    }

    /// Whether it has derivatives, which friction leaves none of.
    pub(super) fn has_derivatives(&self) -> bool {
        self.has_derivatives
    }

    /// Level of the study.
    pub fn level(&self) -> Level {
        self.study.level
    }

    fn means(&self) -> Vec<f64> {
        self.study
            .inputs
            .iter()
            .map(|input| input.distribution.mean())
            .collect()
    }

    /// The answer at values of the inputs, on a level.
    ///
    /// # Errors
    /// See [`NoAnswer`].
    pub fn answer(
        &self,
        values: &[f64],
        level: Level,
        with_derivatives: bool,
    ) -> Result<Arc<Answer>, NoAnswer> {
        let asked = |with_derivatives| Asked {
            values: values.iter().map(|value| value.to_bits()).collect(),
            level: level.as_str(),
            with_derivatives,
        };
        let both = [with_derivatives, true].map(asked);
        if let Some(known) = both
            .iter()
            .find_map(|asked| lock(&self.known).get(asked).cloned())
        {
            return Ok(known);
        }
        let is_cut = values == self.means();
        let start = if is_cut { None } else { self.cut(level) };
        let (response, state) = self.solve(values, level, with_derivatives, start.as_ref())?;
        if is_cut {
            // Whoever came first: all are the same.
            let _ = self.cell(level).set(Some(state));
        }
        let answer = Arc::new(Answer::of(&response)?);
        let mut known = lock(&self.known);
        if known.len() < MOST_KNOWN {
            known.insert(asked(with_derivatives), answer.clone());
        }
        Ok(answer)
    }

    /// Equilibrium that points of a level start from.
    fn cut(&self, level: Level) -> Option<StartState> {
        let cell = self.cell(level);
        let solved = || {
            let solved = self.solve(&self.means(), level, false, None).ok();
            solved.map(|(_, state)| state)
        };
        cell.get_or_init(solved).clone()
    }

    fn cell(&self, level: Level) -> Arc<OnceLock<Option<StartState>>> {
        lock(&self.cuts).entry(level.as_str()).or_default().clone()
    }

    fn solve(
        &self,
        values: &[f64],
        level: Level,
        with_derivatives: bool,
        start: Option<&StartState>,
    ) -> Result<(Response, StartState), NoAnswer> {
        let mut scene = scene_at(&self.study, values).map_err(|faults| refused(&faults))?;
        scene.model.level = level;
        let paths = self.study.inputs.iter().filter(|_| with_derivatives);
        let readout = Readout {
            derivatives: paths.map(|input| input.vary.clone()).collect(),
            ..Readout::default()
        };
        let request = SolveRequest {
            scene: &scene,
            readout: &readout,
            start,
            watch: &*self.stop,
        };
        match self.solver.solve(&request) {
            Ok(solved) => Ok((solved.response, solved.state)),
            Err(SolveError::Refused { faults }) => Err(refused(&faults)),
            Err(error @ SolveError::NoEquilibrium { .. }) => {
                Err(NoAnswer::NoEquilibrium(error.to_string()))
            }
            Err(error) => Err(NoAnswer::Broken(error.to_string())),
        }
    }
}

impl Answer {
    fn of(response: &Response) -> Result<Self, NoAnswer> {
        let strains = |of: fn(&[f64; 2]) -> f64| {
            let pairs = response
                .locations
                .iter()
                .map(|one| [one.strain.x, one.strain.y]);
            pairs.map(|pair| of(&pair)).collect()
        };
        let values = [
            strains(|[x, _]| *x),
            strains(|[_, y]| *y),
            vec![response.reaction_n],
        ];
        let derivatives: Option<Vec<_>> = response
            .derivatives
            .iter()
            .map(|one| by_output(&one.of))
            .collect();
        let derivatives = derivatives.ok_or_else(|| {
            NoAnswer::Broken("the solver gives no derivatives of strains".to_owned())
        })?;
        let answer = Self {
            values,
            derivatives,
        };
        let all = answer
            .derivatives
            .iter()
            .chain([&answer.values])
            .flatten()
            .flatten();
        let is_finite = all.into_iter().all(|number| number.is_finite());
        match is_finite {
            true => Ok(answer),
            false => Err(NoAnswer::Broken(
                "the solver's answer isn't finite".to_owned(),
            )),
        }
    }
}

/// Derivatives of the outputs, among those of a response.
fn by_output(of: &serde_json::Map<String, Value>) -> Option<[Vec<f64>; 3]> {
    let locations = of.get("locations")?.as_array()?;
    let strains = |name: &str| -> Option<Vec<f64>> {
        let strain = |location: &Value| location.get(name)?.as_f64();
        locations.iter().map(strain).collect()
    };
    let [x, y, reaction] = OUTPUTS;
    Some([strains(x)?, strains(y)?, vec![of.get(reaction)?.as_f64()?]])
}

fn refused(faults: &[Fault]) -> NoAnswer {
    let faults: Vec<String> = faults.iter().map(Fault::to_string).collect();
    NoAnswer::Refused(faults.join("; "))
}

/// A map is whole even when a thread panicked while it was locked.
fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
