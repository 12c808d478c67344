//! The stand-in solver for tests of what stands above: closed formulas in place of finite elements.
//!
//! The formulas of `field` have the shape of the real answer, not its figures.
//!
//! As an iterative solver's, the answer carries a trace of the start state: 1e-12 of its size. So a caller that starts
//! from whatever is at hand is found out by a test of equality to the bit.

mod field;

use std::time::{Duration, Instant};

use self::field::Field;
use crate::scene::Scene;
use crate::solver::sides;
use crate::solver::{
    Cost, NoEquilibrium, Reached, SolveError, SolveRequest, Solved, Solver, by_depth_only,
};

/// Interval at which a delayed solve looks at the caller's flag.
const SLICE: Duration = Duration::from_millis(2);

/// Answers from closed formulas, at once or after a delay.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ClosedFormSolver {
    depth_limit_mm: Option<f64>,
    delay: Duration,
}

impl ClosedFormSolver {
    /// A solver that answers every scene at once.
    pub fn new() -> Self {
        Self::default()
    }

    /// Has no equilibrium for a scene with a station deeper than this, mm.
    #[must_use]
    pub fn with_depth_limit(mut self, depth_limit_mm: f64) -> Self {
        self.depth_limit_mm = Some(depth_limit_mm);
        self
    }

    /// Takes this long for each solve.
    #[must_use]
    pub fn with_delay(mut self, delay: Duration) -> Self {
        self.delay = delay;
        self
    }

    fn wait(&self, request: &SolveRequest<'_>) -> Result<(), SolveError> {
        let begun = Instant::now();
        loop {
            if request.watch.is_stopped() {
                return Err(SolveError::Stopped);
            }
            match self.delay.checked_sub(begun.elapsed()) {
                Some(rest) if !rest.is_zero() => std::thread::sleep(rest.min(SLICE)),
                _ => return Ok(()),
            }
        }
    }

    fn check_depths(&self, scene: &Scene) -> Result<(), SolveError> {
        let limit = self.depth_limit_mm.unwrap_or(f64::INFINITY);
        let deepest = scene.ground.depths_mm.iter().copied().fold(0.0, f64::max);
        if deepest <= limit {
            return Ok(());
        }
        let share = limit / deepest;
        Err(SolveError::NoEquilibrium {
            status: NoEquilibrium::NotConverged,
            detail: format!(
                "no equilibrium beyond a depth of {limit} mm; the deepest station asks for {deepest} mm"
            ),
            reached: Reached {
                load_n: None,
                pressure_mpa: scene.pressure.internal_mpa,
                depths_mm: scene
                    .ground
                    .depths_mm
                    .iter()
                    .map(|depth| share * depth)
                    .collect(),
            },
        })
    }
}

impl Solver for ClosedFormSolver {
    fn version(&self) -> String {
        "closed-form 2".to_owned()
    }

    fn solve(&self, request: &SolveRequest<'_>) -> Result<Solved, SolveError> {
        let begun = Instant::now();
        let mut faults = by_depth_only(request.scene);
        faults.extend(sides::none_of(&request.readout.derivatives));
        if !faults.is_empty() {
            return Err(SolveError::Refused { faults });
        }
        self.wait(request)?;
        self.check_depths(request.scene)?;
        let field = Field::new(request.scene, request.start);
        let newton_iterations = if request.start.is_some() { 4 } else { 12 };
        let response = field.response(request, newton_iterations);
        let wall_s = begun.elapsed().as_secs_f64();
        let cost = Cost {
            wall_s,
            factorisation_s: 0.5 * wall_s,
            substitution_s: 0.125 * wall_s,
            assembly_s: 0.25 * wall_s,
            newton_iterations,
            factorisations: newton_iterations,
        };
        Ok(Solved {
            response,
            cost,
            state: field.state(request.scene),
        })
    }
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::AtomicBool;

    use super::field::TRACE;
    use super::*;
    use crate::solver::{Grid, Readout, Response, RingLine, StartState};

    static GO: AtomicBool = AtomicBool::new(false);

    fn solve(
        solver: &ClosedFormSolver,
        scene: &Scene,
        start: Option<&StartState>,
    ) -> Result<Solved, SolveError> {
        let grid = Grid {
            circumferential: 7,
            meridional: 3,
            half_width_deg: 45.0,
        };
        let readout = Readout {
            grid: Some(grid),
            shape: true,
            positions: true,
            rings: [0.0, 90.0].map(RingLine::at).to_vec(),
            fine_deg: None,
            gauges: Vec::new(),
            films: Vec::new(),
            derivatives: Vec::new(),
        };
        solver.solve(&SolveRequest {
            scene,
            readout: &readout,
            start,
            watch: &GO,
        })
    }

    #[test]
    fn every_part_of_the_response_is_there_and_symmetric() {
        let response = solve(&ClosedFormSolver::new(), &Scene::default(), None)
            .unwrap()
            .response;
        assert_eq!(
            response
                .locations
                .iter()
                .map(|l| l.name.as_str())
                .collect::<String>(),
            "P1P2P3P4P5"
        );
        // Mirror points take the same sums in another order: rounding alone.
        for (left, right) in [(0, 4), (1, 3)] {
            let difference = response.locations[left].strain.y - response.locations[right].strain.y;
            assert!(difference.abs() < 1e-15);
        }
        let map = response.map.unwrap();
        assert_eq!(
            (map.theta_deg.len(), map.phi_deg.len(), map.strain.x.len()),
            (7, 3, 21)
        );
        assert_eq!(map.strain.y[10], response.locations[2].strain.y);
        let shape = map.shape.unwrap();
        assert_eq!(shape.inflated_mm.len(), 21);
        // The reference tire grows by 1 % at 0.2 MPa; the crown's inner surface lies a wall above the outer one.
        assert!((shape.inflated_mm[10][2] + 50.5 - 3.0).abs() < 1e-13);
        assert!(shape.displacement_mm[10][2] > shape.displacement_mm[0][2]);
        assert_eq!(response.rings.len(), 2);
        assert_eq!(
            (
                response.rings[0].theta_deg[0],
                response.rings[0].theta_deg.len()
            ),
            (-180.0, 360)
        );
        assert_eq!(response.rings[0].strain.x[180], response.section.crown.x);
        assert_eq!(response.rings[1].strain.y[180], response.section.sidewall.y);
    }

    /// Solvers may leave forces out, as this one does.
    #[test]
    fn an_answer_without_forces_reads_back() {
        let solved = solve(&ClosedFormSolver::new(), &Scene::default(), None).unwrap();
        let text = serde_json::to_string(&solved.response).unwrap();
        assert!(!text.contains("force_n"));
        let read: Response = serde_json::from_str(&text).unwrap();
        assert_eq!(read, solved.response);
    }

    #[test]
    fn the_circumferential_strain_changes_sign_with_depth() {
        let at = |depth: f64| {
            let mut scene = Scene::default();
            scene.ground.depths_mm.fill(depth);
            solve(&ClosedFormSolver::new(), &scene, None)
                .unwrap()
                .response
                .section
                .crown
        };
        assert!(at(1.0).x > 0.0 && at(2.0).x < 0.0);
        assert!(at(2.0).y > at(1.0).y);
    }

    #[test]
    fn a_start_leaves_a_trace_and_nothing_more() {
        let solver = ClosedFormSolver::new();
        let first = solve(&solver, &Scene::default(), None).unwrap();
        let again = solve(&solver, &Scene::default(), Some(&first.state)).unwrap();
        assert_eq!(
            again.response,
            solve(&solver, &Scene::default(), Some(&first.state))
                .unwrap()
                .response
        );
        let difference = (again.response.reaction_n / first.response.reaction_n - 1.0).abs();
        assert!(difference > 0.0 && difference < 2.0 * TRACE, "{difference}");
    }

    #[test]
    fn depths_beyond_the_limit_have_no_equilibrium() {
        let mut scene = Scene::default();
        scene.ground.depths_mm[4] = 1.5;
        let error =
            solve(&ClosedFormSolver::new().with_depth_limit(1.2), &scene, None).unwrap_err();
        let SolveError::NoEquilibrium {
            status, reached, ..
        } = error
        else {
            panic!("{error}")
        };
        assert_eq!(status, NoEquilibrium::NotConverged);
        assert!((reached.depths_mm[4] - 1.2).abs() < 1e-15);
    }

    #[test]
    fn a_stop_ends_a_long_solve() {
        let solver = ClosedFormSolver::new().with_delay(Duration::from_secs(3600));
        let stop = AtomicBool::new(false);
        let (scene, readout) = (Scene::default(), Readout::default());
        let request = SolveRequest {
            scene: &scene,
            readout: &readout,
            start: None,
            watch: &stop,
        };
        std::thread::scope(|threads| {
            let solving = threads.spawn(|| solver.solve(&request));
            stop.store(true, std::sync::atomic::Ordering::Relaxed);
            assert_eq!(solving.join().unwrap().unwrap_err(), SolveError::Stopped);
        });
    }
}
