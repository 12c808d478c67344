//! Comparisons of a film's figures: with the bare wall's, and with those of a coarser mesh.

use super::film_state::{FilmError, FilmSignal, FilmState};
use super::{Readout, Response, SolveError, SolveRequest, Solved, Solver};
use crate::scene::{Film, Scene};

/// Fills in what the film of a solved scene would read without stiffness, and the errors of what it reads: two solves more. Where one of them has no equilibrium, its
/// figures stay absent. Nothing is done without a film.
///
/// # Errors
/// [`SolveError`], but for [`SolveError::NoEquilibrium`].
pub fn compare_film(
    solver: &dyn Solver,
    request: &SolveRequest<'_>,
    solved: &mut Solved,
) -> Result<(), SolveError> {
    let (Some(film), Some(state)) = (&request.scene.film, &mut solved.response.film) else {
        return Ok(());
    };
    state.bare = bare(solver, request, film)?;
    state.error = error(solver, request, state)?;
    Ok(())
}

fn bare(
    solver: &dyn Solver,
    request: &SolveRequest<'_>,
    film: &Film,
) -> Result<Option<FilmSignal>, SolveError> {
    let scene = Scene {
        film: None,
        ..request.scene.clone()
    };
    let readout = Readout {
        films: vec![film.clone()],
        ..Readout::default()
    };
    let response = response(solver, &scene, &readout, request)?;
    Ok(response.and_then(|response| response.films.first().copied()))
}

fn error(
    solver: &dyn Solver,
    request: &SolveRequest<'_>,
    state: &FilmState,
) -> Result<Option<FilmError>, SolveError> {
    let Some(coarser) = solver.coarser(request.scene) else {
        return Ok(None);
    };
    let mut scene = request.scene.clone();
    scene.model.level = coarser.level;
    let response = response(solver, &scene, &Readout::default(), request)?;
    let coarse = response.and_then(|response| response.film);
    Ok(coarse.map(|coarse| FilmError::between(coarser.factor, &state.signal, &coarse.signal)))
}

fn response(
    solver: &dyn Solver,
    scene: &Scene,
    readout: &Readout,
    request: &SolveRequest<'_>,
) -> Result<Option<Response>, SolveError> {
    let request = SolveRequest {
        scene,
        readout,
        start: None,
        watch: request.watch,
    };
    match solver.solve(&request) {
        Ok(solved) => Ok(Some(solved.response)),
        Err(SolveError::NoEquilibrium { .. }) => Ok(None),
        Err(error) => Err(error),
    }
}
