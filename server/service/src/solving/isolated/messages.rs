//! Messages between the two processes: a line of JSON each way.
//!
//! Floats are written with as many digits as read back to the bit, states as the bytes in which they are stored.

use document::fault::Fault;
use fem_client::hexadecimal::{from_hexadecimal, hexadecimal};
use fem_client::scene::Scene;
use fem_client::solver::{
    Cost, NoEquilibrium, Reached, Readout, Response, SolveError, SolveRequest, Solved, StartState,
};
use serde::{Deserialize, Serialize};
use serde_json::Value;

/// Order to solve, as [`SolveRequest`] has it.
#[derive(Debug, Serialize, Deserialize)]
pub(super) struct Order {
    scene: Value,
    readout: Readout,
    start: Option<String>,
}

impl Order {
    pub(super) fn of(request: &SolveRequest<'_>) -> Self {
        Self {
            scene: request.scene.to_value(),
            readout: request.readout.clone(),
            start: request.start.map(|start| hexadecimal(&start.to_bytes())),
        }
    }

    /// Scene, readout and start of the request.
    pub(super) fn parts(self) -> Result<(Scene, Readout, Option<StartState>), SolveError> {
        let mut faults = Vec::new();
        let scene = Scene::from_value(&self.scene, "", &mut faults);
        let scene = scene.ok_or(SolveError::Refused { faults })?;
        let start = self.start.as_deref().map(state).transpose()?;
        Ok((scene, self.readout, start))
    }
}

/// Answer to an order.
#[derive(Debug, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(super) enum Answer {
    Solved {
        response: Box<Response>,
        cost: Cost,
        state: String,
        /// Processor time of the process, s.
        cpu_s: f64,
    },
    NoEquilibrium {
        status: NoEquilibrium,
        detail: String,
        reached: Reached,
    },
    Refused {
        faults: Vec<Fault>,
    },
    Broken {
        detail: String,
    },
}

impl Answer {
    pub(super) fn of(outcome: Result<Solved, SolveError>, cpu_s: f64) -> Self {
        match outcome {
            Ok(solved) => Self::Solved {
                response: Box::new(solved.response),
                cost: solved.cost,
                state: hexadecimal(&solved.state.to_bytes()),
                cpu_s,
            },
            Err(SolveError::NoEquilibrium {
                status,
                detail,
                reached,
            }) => Self::NoEquilibrium {
                status,
                detail,
                reached,
            },
            Err(SolveError::Refused { faults }) => Self::Refused { faults },
            Err(SolveError::Broken { detail }) => Self::Broken { detail },
            Err(other) => Self::Broken {
                detail: other.to_string(),
            },
        }
    }

    /// The outcome and the processor time that it took, s.
    pub(super) fn outcome(self) -> (Result<Solved, SolveError>, f64) {
        let error = match self {
            Self::Solved {
                response,
                cost,
                state: bytes,
                cpu_s,
            } => {
                let solved = state(&bytes).map(|state| Solved {
                    response: *response,
                    cost,
                    state,
                });
                return (solved, cpu_s);
            }
            Self::NoEquilibrium {
                status,
                detail,
                reached,
            } => SolveError::NoEquilibrium {
                status,
                detail,
                reached,
            },
            Self::Refused { faults } => SolveError::Refused { faults },
            Self::Broken { detail } => SolveError::Broken { detail },
        };
        (Err(error), 0.0)
    }
}

fn state(text: &str) -> Result<StartState, SolveError> {
    let bytes = from_hexadecimal(text).unwrap_or_default();
    StartState::from_bytes(&bytes).map_err(|error| SolveError::Broken {
        detail: error.to_string(),
    })
}
