//! Equilibrium at a prescribed volume.

use crate::linear::factor::Inertia;
use crate::linear::setup::SetupError;
use crate::linear::sparsity::NONE;
use crate::linear::system::Imbalance;
use crate::load::pressure::PressureSurface;
use crate::newton::iteration::{Cause, Effort, Newton, NotConverged, is_lost};
use crate::newton::watch::Watch;
use crate::problem::{Loads, Problem, State};

/// Newton iterations of one equilibrium; those that are found take six to ten.
const MOST_ITERATIONS: usize = 20;

/// An equilibrium of the inflated body.
#[derive(Debug, Clone, PartialEq)]
pub struct Inflated {
    /// Displacements and element pressures.
    pub state: State,
    /// Pressure on the pressure surface, MPa.
    pub pressure: f64,
    /// Volume that the pressure surface encloses with the origin, mm^3.
    pub volume: f64,
    /// Slope dp/dV of the path, MPa/mm^3: negative beyond a limit point.
    pub slope: f64,
    /// Signs of the pivots of the tangent under constant pressure: a negative one where that pressure isn't stable.
    pub inertia: Inertia,
}

/// Newton's method with the cavity's volume prescribed.
#[derive(Debug)]
pub struct VolumeControl<'p> {
    problem: &'p Problem,
    surface: &'p PressureSurface,
    newton: Newton<'p>,
}

impl<'p> VolumeControl<'p> {
    /// Sets a problem up: its supports hold fully, and there is no ground.
    ///
    /// # Errors
    /// [`SetupError`] as [`Newton::new`].
    ///
    /// # Panics
    /// When the problem has no pressure surface.
    pub fn new(problem: &'p Problem) -> Result<Self, SetupError> {
        let surface = problem.pressure.as_ref();
        let mut newton = Newton::new(problem)?;
        newton.settings.max_iterations = MOST_ITERATIONS;
        Ok(Self {
            problem,
            surface: surface.expect("the problem has a cavity"),
            newton,
        })
    }

    /// Time and iterations spent.
    pub fn effort(&self) -> Effort {
        self.newton.effort
    }

    /// The body without pressure.
    ///
    /// # Errors
    /// [`NotConverged`] when its tangent is singular.
    pub fn reference(&mut self, watch: &dyn Watch) -> Result<Inflated, NotConverged> {
        let state = State::reference(self.problem);
        let volume = self.volume(&state);
        self.solve_from(state, 0.0, volume, watch)
    }

    /// The equilibrium whose volume is that of a state which is nearly in balance with this pressure, MPa.
    ///
    /// # Errors
    /// [`NotConverged`] with the residual history and the cause.
    pub fn at(
        &mut self,
        state: State,
        pressure: f64,
        watch: &dyn Watch,
    ) -> Result<Inflated, NotConverged> {
        let volume = self.volume(&state);
        self.solve_from(state, pressure, volume, watch)
    }

    /// The equilibrium at another volume (mm^3), found from a near one.
    ///
    /// # Errors
    /// [`NotConverged`] with the residual history and the cause.
    pub fn solve(
        &mut self,
        near: &Inflated,
        volume: f64,
        watch: &dyn Watch,
    ) -> Result<Inflated, NotConverged> {
        self.solve_from(near.state.clone(), near.pressure, volume, watch)
    }

    fn solve_from(
        &mut self,
        mut state: State,
        mut pressure: f64,
        target: f64,
        watch: &dyn Watch,
    ) -> Result<Inflated, NotConverged> {
        let mut history: Vec<Imbalance> = Vec::new();
        let mut indefinite = false;
        self.newton.hold(&state, 1.0);
        loop {
            let loads = Loads {
                pressure,
                support_factor: 1.0,
                ..Loads::default()
            };
            let imbalance = self.newton.imbalance(&state, &loads);
            history.push(imbalance);
            let settings = self.newton.settings;
            let volume = self.volume(&state);
            let gap = target - volume;
            let worst = imbalance.worst().max((gap / target).abs());
            watch.iterated(worst);
            let cause = if !worst.is_finite() || worst > settings.divergence {
                Some(Cause::Diverged)
            } else if history.len() > settings.max_iterations || is_lost(&history[1..]) {
                Some(Cause::Iterations)
            } else if watch.is_stopped() {
                Some(Cause::Stopped)
            } else {
                None
            };
            let fail = |cause| NotConverged {
                history: history.clone(),
                cause,
                indefinite,
            };
            if let Some(cause) = cause {
                return Err(fail(cause));
            }
            let inertia = self.newton.linearise(&state, &loads, watch).map_err(fail)?;
            let border = self.border(&state).map_err(fail)?;
            if worst <= settings.tolerance {
                return Ok(Inflated {
                    state,
                    pressure,
                    volume,
                    slope: 1.0 / border.volume_per_pressure,
                    inertia,
                });
            }
            let change = self.step(&border, gap);
            let fraction = self.newton.advance(&mut state, &loads).map_err(fail)?;
            pressure += fraction * change;
            indefinite |= !inertia.is_positive();
        }
    }

    /// Combines the two solutions in the Newton step and returns the change of pressure.
    fn step(&mut self, border: &Border, gap: f64) -> f64 {
        let increments = self.newton.increments_mut();
        let by_residual: f64 = border
            .gradient
            .iter()
            .zip(increments.iter())
            .map(|(g, du)| g * du)
            .sum();
        let change = (gap - by_residual) / border.volume_per_pressure;
        for (du, b) in increments.iter_mut().zip(&border.response) {
            *du += change * b;
        }
        change
    }

    fn border(&mut self, state: &State) -> Result<Border, Cause> {
        let gradient = self.volume_gradient(state);
        let mut response = gradient.clone();
        self.newton.solve_linear(state, &mut response)?;
        let volume_per_pressure = gradient.iter().zip(&response).map(|(g, b)| g * b).sum();
        Ok(Border {
            gradient,
            response,
            volume_per_pressure,
        })
    }

    fn volume(&self, state: &State) -> f64 {
        let mesh = &self.problem.mesh;
        self.surface
            .enclosed_volume(|node| state.position(mesh, node))
    }

    /// Derivative of the volume by the free displacements: minus the residual of a unit pressure.
    fn volume_gradient(&self, state: &State) -> Vec<f64> {
        let equations = self.newton.equations();
        let mut gradient = vec![0.0; equations.count];
        for nodes in self.surface.surface.iter() {
            let positions: Vec<_> = nodes
                .iter()
                .map(|&node| state.position(&self.problem.mesh, node))
                .collect();
            let mut residual = vec![0.0; 3 * nodes.len()];
            self.surface.integrate(1.0, &positions, &mut residual, None);
            for (equation, force) in equations.of(nodes).zip(residual) {
                if equation != NONE {
                    gradient[equation as usize] -= force;
                }
            }
        }
        gradient
    }
}

/// Border of the tangent at one state, in mm, N and MPa.
struct Border {
    /// g, the volume's gradient.
    gradient: Vec<f64>,
    /// b = K^-1 g.
    response: Vec<f64>,
    /// g . b = dV/dp.
    volume_per_pressure: f64,
}
