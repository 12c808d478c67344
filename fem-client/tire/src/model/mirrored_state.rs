//! States of a scene with left and right exchanged, the film's among them.

use fem::problem::State;
use fem::surface::sheet::Sheet;

use super::TireModel;
use crate::mesh::tire_grid::{Extent, TireGrid};

/// A flat state in its parts: displacements of the grid's nodes with the pressures, and displacements of the film's control points.
struct Parts {
    grid: Vec<f64>,
    film: Vec<f64>,
}

impl Parts {
    /// Splits the values into parts; `None` when there are fewer values than the parts have.
    fn of(flat: &[f64], film: usize, pressures: usize) -> Option<Self> {
        let film_ends = flat.len().checked_sub(pressures)?;
        let film_begins = film_ends.checked_sub(3 * film)?;
        Some(Self {
            grid: [&flat[..film_begins], &flat[film_ends..]].concat(),
            film: flat[film_begins..film_ends].to_vec(),
        })
    }

    fn joined(self, pressures: usize) -> Vec<f64> {
        let (displacement, pressure) = self.grid.split_at(self.grid.len() - pressures);
        [displacement, &self.film, pressure].concat()
    }
}

impl TireModel {
    /// A flat state (mm, then MPa) fitted to this mesh: its own, or a quarter's, mirrored to the half. `None` for any other length.
    pub fn fit(&self, flat: &[f64]) -> Option<State> {
        let of_quarter = || self.held_state(&self.of_quarter(flat)?);
        self.held_state(flat).or_else(of_quarter)
    }

    /// A flat state that is held as this model is: other parts of the tire may have as many unknowns.
    fn held_state(&self, flat: &[f64]) -> Option<State> {
        let state = State::from_flat(&self.problem, flat)?;
        let mut supports = self.problem.supports.iter().zip(&state.displacement);
        let is_held = supports.all(|(support, u)| {
            let mut axes = support.iter().zip(u);
            axes.all(|(held, u)| held.is_none_or(|held| held == *u))
        });
        is_held.then_some(state)
    }

    /// A flat state fitted as by [`Self::fit`], or mirrored from one side of the middle plane to both. `None` where a film lies on them.
    pub(crate) fn fit_sides(&self, flat: &[f64]) -> Option<State> {
        let fitted = self.fit(flat);
        if fitted.is_some() || self.film().is_some() {
            return fitted;
        }
        let both = |flat: &[f64]| self.grid.mirror_across(flat);
        let around = || both(&self.one_side().mirror_quarter(flat)?);
        let whole = both(flat).or_else(around)?;
        self.held_state(&whole)
    }

    /// The lines of this grid on one side of the middle plane.
    fn one_side(&self) -> TireGrid {
        let middle = self.grid.phi.len() / 2;
        TireGrid {
            extent: Extent::of(self.grid.extent.is_whole_along(), false),
            phi: self.grid.phi[middle..].to_vec(),
            ..self.grid.clone()
        }
    }

    /// An equilibrium with left and right exchanged; `None` when this is no half mesh, or its film isn't its own mirror image.
    pub fn exchanged(&self, state: &State) -> Option<State> {
        let pressures = state.pressure.len();
        let film = self.film();
        let parts = Parts::of(&state.to_flat(), film.map_or(0, node_count), pressures)?;
        let mirrored = Parts {
            grid: self.grid.mirror_half(&parts.grid)?,
            film: film.map_or(Vec::new(), |sheet| exchanged_film(sheet, &parts.film)),
        };
        State::from_flat(&self.problem, &mirrored.joined(pressures))
    }

    fn of_quarter(&self, flat: &[f64]) -> Option<Vec<f64>> {
        let pressures = self.problem.mesh.brick_count() * self.problem.mesh.order.pressure_modes();
        let film = self.film();
        let meshed = film.map_or(0, |sheet| node_count(sheet) / 2);
        let parts = Parts::of(flat, meshed, pressures / 2)?;
        let mirrored = Parts {
            grid: self.grid.mirror_quarter(&parts.grid)?,
            film: film.map_or(Vec::new(), |sheet| whole_film(sheet, &parts.film)),
        };
        Some(mirrored.joined(pressures))
    }
}

fn node_count(sheet: &Sheet) -> usize {
    sheet.positions.len()
}

/// Control points along the circumference.
fn around(sheet: &Sheet) -> usize {
    sheet.outline.control_points()[0]
}

/// Rows of control points, each along the circumference, read backwards with x turned round.
fn exchanged_film(sheet: &Sheet, film: &[f64]) -> Vec<f64> {
    let rows = film.chunks_exact(3 * around(sheet));
    rows.flat_map(backwards).collect()
}

/// Each row of the meshed half with its mirror image before it.
fn whole_film(sheet: &Sheet, film: &[f64]) -> Vec<f64> {
    let rows = film.chunks_exact(3 * around(sheet) / 2);
    let whole = rows.flat_map(|row| backwards(row).into_iter().chain(row.iter().copied()));
    whole.collect()
}

fn backwards(row: &[f64]) -> Vec<f64> {
    let points = row.chunks_exact(3).rev();
    points.flat_map(|u| [-u[0], u[1], u[2]]).collect()
}
