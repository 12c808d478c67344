//! The path of growing volume: to a pressure, or to what ends it before.

use super::bordering::{Inflated, VolumeControl};
use crate::newton::iteration::{Cause, NotConverged};
use crate::newton::watch::Watch;

/// Largest growth of the volume from one equilibrium to the next.
const GROWTH: f64 = 0.2;
/// Smallest growth that is tried before the path is given up.
const SMALLEST_GROWTH: f64 = 1e-3;
/// Share of a growth that is tried next when it failed.
const CUT_BACK: f64 = 0.25;
/// Newton iterations of a whole path: forty equilibria from the reference to the tear of any rubber, or ten that are hard.
const MOST_ITERATIONS: usize = 240;
/// Relative distance of two pressures between which it is told that a body buckles.
const BUCKLING_TOLERANCE: f64 = 0.02;
/// Relative accuracy of a limit pressure.
pub const LIMIT_TOLERANCE: f64 = 1e-6;
/// Relative width of a bracket around a limit point below which its volume can't be told better: the slope may have kinks.
const NARROWEST: f64 = 1e-7;

/// End of a path.
#[derive(Debug, Clone, PartialEq)]
pub enum Ending {
    /// The nearest equilibrium found at the pressure asked for.
    Reached(Inflated),
    /// A maximum of the pressure.
    LimitPoint(Inflated),
    /// Loss of stability on a rising path: the body buckles between this equilibrium and a pressure, MPa.
    Unstable {
        /// The last stable equilibrium.
        below: Inflated,
        /// A pressure, MPa, at which it isn't stable any more.
        above: f64,
    },
    /// The largest volume, with the pressure still rising.
    Outgrown(Inflated),
    /// The last equilibrium that was found.
    Lost {
        /// The last stable equilibrium.
        last: Inflated,
        /// Cause of the last attempt's end.
        failure: NotConverged,
    },
}

impl VolumeControl<'_> {
    /// Follows the path from a stable equilibrium, at growing volume, up to a pressure (MPa, may be infinite) or a largest
    /// volume (mm^3). Steps that fail or end in an unstable equilibrium are cut back.
    pub fn inflate(
        &mut self,
        start: &Inflated,
        pressure: f64,
        largest_volume: f64,
        watch: &dyn Watch,
    ) -> Ending {
        let most = self.effort().iterations + MOST_ITERATIONS;
        let mut last = start.clone();
        let (mut growth, mut cut) = (GROWTH, false);
        let mut unstable: Option<f64> = None;
        loop {
            let volume = f64::min(last.volume * (1.0 + growth), largest_volume);
            let exhausted = growth < SMALLEST_GROWTH || self.effort().iterations > most;
            match self.solve(&last, volume, watch) {
                Ok(next) if next.slope <= 0.0 => {
                    return self.at_maximum(last, next, pressure, watch);
                }
                Ok(next) if !next.inertia.is_positive() => {
                    let above = unstable.map_or(next.pressure, |known| known.min(next.pressure));
                    let near = above - last.pressure <= BUCKLING_TOLERANCE * above;
                    if near || exhausted {
                        return Ending::Unstable { below: last, above };
                    }
                    unstable = Some(above);
                    (growth, cut) = (CUT_BACK * growth, true);
                }
                Ok(next) if next.pressure >= pressure => {
                    let passed = next.pressure - pressure < pressure - last.pressure;
                    return Ending::Reached(if passed { next } else { last });
                }
                Ok(next) if volume >= largest_volume => return Ending::Outgrown(next),
                Ok(next) => {
                    // What was unstable below it lies on another branch.
                    unstable = unstable.filter(|above| *above > next.pressure);
                    last = next;
                    // A step that has just been cut back is kept once, or it would fail again at once.
                    if !std::mem::take(&mut cut) {
                        growth = f64::min(2.0 * growth, GROWTH);
                    }
                }
                Err(failure) if exhausted || failure.cause == Cause::Stopped => {
                    return match unstable {
                        Some(above) if failure.cause != Cause::Stopped => {
                            Ending::Unstable { below: last, above }
                        }
                        _ => Ending::Lost { last, failure },
                    };
                }
                Err(_) => (growth, cut) = (CUT_BACK * growth, true),
            }
        }
    }

    /// The end of a path whose pressure has a maximum between two equilibria.
    fn at_maximum(
        &mut self,
        rising: Inflated,
        falling: Inflated,
        pressure: f64,
        watch: &dyn Watch,
    ) -> Ending {
        match self.maximum(rising.clone(), falling, watch) {
            Ok(limit) if limit.pressure >= pressure => Ending::Reached(rising),
            Ok(limit) => Ending::LimitPoint(limit),
            Err(other) => match *other {
                Ending::Unstable { below, .. } if below.pressure >= pressure => {
                    Ending::Reached(below)
                }
                other => other,
            },
        }
    }

    /// Finds where a body loses its stability between a stable and an unstable equilibrium of a rising path.
    fn buckling(&mut self, stable: Inflated, unstable: &Inflated, watch: &dyn Watch) -> Ending {
        let (mut below, mut above) = (stable, unstable.pressure);
        let mut volume = unstable.volume;
        while above - below.pressure > BUCKLING_TOLERANCE * above {
            let middle = 0.5 * (below.volume + volume);
            match self.solve(&below, middle, watch) {
                Ok(next) if next.inertia.is_positive() => below = next,
                Ok(next) => {
                    above = above.min(next.pressure);
                    volume = middle;
                }
                // The bracket is true as it is.
                Err(_) => break,
            }
        }
        Ending::Unstable { below, above }
    }

    /// Root of the slope between a rising and a falling equilibrium, by regula falsi with the Illinois rule. The pressure
    /// differs from the maximum's by less than slope times width of the bracket. Another ending where the path can't be followed,
    /// or the body buckles before.
    fn maximum(
        &mut self,
        mut rising: Inflated,
        mut falling: Inflated,
        watch: &dyn Watch,
    ) -> Result<Inflated, Box<Ending>> {
        let (mut up, mut down) = (rising.slope, falling.slope);
        loop {
            let width = falling.volume - rising.volume;
            let volume = rising.volume + width * up / (up - down);
            let next = match self.solve(&rising, volume, watch) {
                Ok(next) => next,
                Err(failure) => {
                    let last = rising;
                    return Err(Box::new(Ending::Lost { last, failure }));
                }
            };
            let near = next.slope.abs() * width <= LIMIT_TOLERANCE * next.pressure;
            // At the maximum itself the sign of one pivot is a matter of round-off.
            if !near && next.slope > 0.0 && !next.inertia.is_positive() {
                return Err(Box::new(self.buckling(rising, &next, watch)));
            }
            if near || width <= NARROWEST * volume {
                return Ok(next);
            }
            if next.slope > 0.0 {
                (up, down) = (next.slope, 0.5 * down);
                rising = next;
            } else {
                (up, down) = (0.5 * up, next.slope);
                falling = next;
            }
        }
    }
}
