//! A tire's responses between what was solved.

use fem_client::solver::{Response, Ring};

use crate::layout::solving::glued::angle_residual::AngleResidual;
use crate::layout::solving::layout_fields::samples;
use crate::layout::solving::layout_scenes::readout;
use crate::layout::solving::mirror_parts::{mirrored, part};
use crate::response_table::drag_basis::{DRAGS, PARTS, PRODUCTS, products};
use crate::response_table::table_scenes::Pressing;
use crate::response_table::table_settings::TableSettings;
use layouts::arrangement::FilmKind;
use layouts::field::hermite::{DEGREES, Nodes, Shares, Turn, summed};

/// Parts that the pull along the wheel and the one across have: each is odd in its own shift alone.
const OF_PULL: [usize; 2] = [1, 2];

/// Signals of all kinds of film, and forces, over load, shift of the ground and wheel angle.
///
/// Between loads they are cubic in the depth of the undragged ground, between shifts polynomials (`drag_basis`), around the wheel cubic between degrees. Ground
/// that doesn't press has signals and forces of zero.
#[derive(Debug, Clone, PartialEq)]
pub struct ResponseTable {
    settings: TableSettings,
    /// Depths of the undragged ground, mm, none first; and the loads there, N.
    depths: Nodes,
    loads_n: Vec<f64>,
    /// Depths that were dragged, none first.
    dragged: Nodes,
    kinds: Vec<KindTable>,
    /// Pull along and across, N, by dragged depth and product.
    pulls: Vec<[f64; PRODUCTS]>,
}

/// Signals of one kind of film.
#[derive(Debug, Clone, PartialEq)]
struct KindTable {
    /// Signals by depth.
    undragged: Vec<Turn>,
    /// Signals that dragging adds, by dragged depth, then product.
    added: Vec<Vec<Turn>>,
}

/// Weights of every node of a table at one contact.
#[derive(Debug, Clone, PartialEq)]
pub struct Weights {
    undragged: Shares,
    dragged: Shares,
    products: [f64; PRODUCTS],
}

/// Signals of some films with the contact at one wheel angle, at all nodes.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct FilmNodes {
    /// Signals by film, then depth.
    undragged: Vec<Vec<f64>>,
    /// Signals by film, then dragged depth and product.
    added: Vec<Vec<f64>>,
}

impl ResponseTable {
    /// Makes the table of the answers to undragged and dragged pressings.
    ///
    /// # Errors
    /// Why there is none.
    pub fn new(
        settings: &TableSettings,
        kinds: &[FilmKind],
        undragged: &[(Pressing, &Response)],
        dragged: &[(Pressing, &Response)],
    ) -> Result<Self, String> {
        let mut loads: Vec<(f64, f64, &Response)> = Vec::new();
        for (pressing, response) in undragged {
            let depth_mm = response.depth_mm;
            loads.push((pressing.load_n, depth_mm, response));
        }
        loads.sort_by(|a, b| a.0.total_cmp(&b.0));
        if loads.is_empty()
            || loads.windows(2).any(|pair| pair[1].1 <= pair[0].1)
            || loads[0].1 <= 0.0
        {
            return Err("a larger load has no larger depth".to_owned());
        }
        let depth_of = |load_n: f64| {
            loads
                .iter()
                .find(|load| load.0 == load_n)
                .map(|load| load.1)
        };
        let groups: Vec<&[(Pressing, &Response)]> = dragged.chunks(DRAGS.len()).collect();
        let mut dragged_depths = vec![0.0];
        for group in &groups {
            dragged_depths
                .push(depth_of(group[0].0.load_n).ok_or("a dragged load wasn't solved undragged")?);
        }
        if groups.is_empty() {
            // Nothing is added at any depth.
            dragged_depths.push(loads[loads.len() - 1].1);
        }
        let tables = kinds
            .iter()
            .map(|kind| KindTable::new(kind, kinds, &loads, &groups));
        let kinds = tables
            .collect::<Option<_>>()
            .ok_or("the solver gives no strains around the wheel")?;
        let mut pulls = vec![[0.0; PRODUCTS]];
        for group in &groups {
            pulls.push(pulls_of(group)?);
        }
        pulls.resize(dragged_depths.len(), [0.0; PRODUCTS]);
        let with_none = |of: fn(&(f64, f64, &Response)) -> f64| {
            std::iter::once(0.0).chain(loads.iter().map(of)).collect()
        };
        Ok(Self {
            settings: settings.clone(),
            depths: Nodes::about_even(with_none(|load| load.1)),
            loads_n: with_none(|load| load.0),
            dragged: Nodes::about_even(dragged_depths),
            kinds,
            pulls,
        })
    }

    /// Weights at a depth of the undragged ground, mm, with the ground shifted, mm; both are taken into the solved range.
    pub fn weights(&self, depth_mm: f64, shift_mm: [f64; 2]) -> Weights {
        let [undragged, dragged] = [&self.depths, &self.dragged].map(|nodes| {
            let [value, _] = nodes.shares(depth_mm);
            value
        });
        let largest = self.settings.shift_mm(self.load_of(&undragged));
        let share = |shift: f64| match largest > 0.0 {
            true => (shift / largest).clamp(-1.0, 1.0),
            false => 0.0,
        };
        Weights {
            undragged,
            dragged,
            products: products(shift_mm.map(share)),
        }
    }

    /// Force of the ground on the tire: along the wheel, across, and vertical, N.
    pub fn force_n(&self, weights: &Weights) -> [f64; 3] {
        let pull = |part: usize| {
            let of_drags = |pulls: &[f64; PRODUCTS]| -> f64 {
                let drags = (0..DRAGS.len()).map(|drag| drag * PARTS.len() + part);
                drags
                    .map(|product| weights.products[product] * pulls[product])
                    .sum()
            };
            summed(&weights.dragged, |node| of_drags(&self.pulls[node]))
        };
        let [along, across] = OF_PULL.map(pull);
        [along, across, self.load_of(&weights.undragged)]
    }

    /// The largest load, N.
    pub fn largest_load_n(&self) -> f64 {
        self.settings.largest_load_n
    }

    fn load_of(&self, undragged: &Shares) -> f64 {
        summed(undragged, |node| self.loads_n[node])
    }

    /// The depth that bears a load, N, up to the largest, mm.
    pub fn depth_of_load_mm(&self, load_n: f64) -> f64 {
        let load_n = load_n.clamp(0.0, self.settings.largest_load_n);
        self.depths.place_of(load_n, |node| self.loads_n[node])
    }

    /// The shift along or across at a depth up to which the table was solved, mm.
    pub fn largest_shift_mm(&self, depth_mm: f64) -> f64 {
        let [undragged, _] = self.depths.shares(depth_mm);
        self.settings.shift_mm(self.load_of(&undragged))
    }

    /// Signal of a kind of film around the wheel, a sample each degree from -180.
    pub fn samples(&self, kind: usize, weights: &Weights) -> Vec<f64> {
        let table = &self.kinds[kind];
        let sample = |degree: usize| {
            let of = |turn: &Turn| turn.samples()[degree];
            weights.sum(
                |node| of(&table.undragged[node]),
                |node, product| of(&table.added[node][product]),
            )
        };
        (0..DEGREES).map(sample).collect()
    }

    /// The largest signal of a kind of film, whatever the load, the shift and the place.
    pub(crate) fn largest_of_kind(&self, kind: usize) -> f64 {
        let samples = self.kinds[kind].undragged.iter().flat_map(Turn::samples);
        samples.fold(0.0, |largest: f64, sample| largest.max(sample.abs()))
    }

    /// Adds to a kind's signals on undragged ground what its transfer misses.
    pub(crate) fn add_undragged(&mut self, kind: usize, missing: &AngleResidual) {
        let undragged = &mut self.kinds[kind].undragged;
        for (turn, depth_mm) in undragged.iter_mut().zip(self.depths.places()) {
            let mut samples = turn.samples().to_vec();
            missing.add_to(*depth_mm, &mut samples);
            *turn = Turn::new(samples);
        }
    }

    /// Signals at all nodes, of films of these kinds so many degrees from the contact.
    pub(crate) fn film_nodes(
        &self,
        films: impl Iterator<Item = (usize, f64)> + Clone,
    ) -> FilmNodes {
        let undragged = films.clone().map(|(kind, apart_deg)| {
            let turns = self.kinds[kind].undragged.iter();
            turns.map(|turn| turn.at(apart_deg)).collect()
        });
        let added = films.map(|(kind, apart_deg)| {
            let turns = self.kinds[kind].added.iter().flatten();
            turns.map(|turn| turn.at(apart_deg)).collect()
        });
        FilmNodes {
            undragged: undragged.collect(),
            added: added.collect(),
        }
    }
}

impl Weights {
    fn sum(&self, undragged: impl Fn(usize) -> f64, added: impl Fn(usize, usize) -> f64) -> f64 {
        let of_node = |node: usize| -> f64 {
            let products = self.products.iter().enumerate();
            products
                .map(|(product, weight)| weight * added(node, product))
                .sum()
        };
        summed(&self.undragged, undragged) + summed(&self.dragged, of_node)
    }
}

impl FilmNodes {
    /// The signal of a film.
    pub fn signal(&self, film: usize, weights: &Weights) -> f64 {
        let (undragged, added) = (&self.undragged[film], &self.added[film]);
        let of_node = |node: usize| product(&weights.products, &added[node * PRODUCTS..]);
        summed(&weights.undragged, |node| undragged[node]) + summed(&weights.dragged, of_node)
    }
}

/// The scalar product, summed in lanes that a processor adds at once: a rig asks for it millions of times.
fn product(weights: &[f64; PRODUCTS], added: &[f64]) -> f64 {
    const LANES: usize = 8;
    let mut sums = [0.0; LANES];
    let (weights, added) = (weights.chunks_exact(LANES), added.chunks_exact(LANES));
    for (weights, added) in weights.zip(added) {
        for lane in 0..LANES {
            sums[lane] += weights[lane] * added[lane];
        }
    }
    sums.iter().sum()
}

impl KindTable {
    fn new(
        kind: &FilmKind,
        kinds: &[FilmKind],
        loads: &[(f64, f64, &Response)],
        dragged: &[&[(Pressing, &Response)]],
    ) -> Option<Self> {
        let lines = readout(kinds).rings;
        let read = mirrored(kinds).rings;
        let part_of = |response: &Response, odd: [bool; 2]| {
            let ring = |line| part(line, odd, 1.0, &read, &response.rings);
            let rings: Vec<Ring> = lines.iter().map(ring).collect::<Option<_>>()?;
            samples(&rings, kind, kinds)
        };
        let none = || vec![0.0; DEGREES];
        let mut undragged = vec![Turn::new(none())];
        for (_, _, response) in loads {
            undragged.push(Turn::new(part_of(response, [false; 2])?));
        }
        let still = |load_n: f64| {
            let load = loads.iter().position(|load| load.0 == load_n)?;
            Some(undragged[load + 1].samples())
        };
        let zero = || vec![Turn::new(none()); PRODUCTS];
        let mut added = vec![zero()];
        for group in dragged {
            let mut turns = Vec::with_capacity(PRODUCTS);
            for (pressing, response) in *group {
                for odd in PARTS {
                    let mut samples = part_of(response, odd)?;
                    if odd == [false; 2] {
                        let still = still(pressing.load_n)?;
                        samples
                            .iter_mut()
                            .zip(still)
                            .for_each(|(sample, still)| *sample -= still);
                    }
                    turns.push(Turn::new(samples));
                }
            }
            added.push(turns);
        }
        if dragged.is_empty() {
            added.push(zero());
        }
        Some(Self { undragged, added })
    }
}

/// Pulls at one dragged load.
fn pulls_of(group: &[(Pressing, &Response)]) -> Result<[f64; PRODUCTS], String> {
    let mut pulls = [0.0; PRODUCTS];
    for (drag, (_, response)) in group.iter().enumerate() {
        let force = response.force_n.ok_or("the solver gives no force")?;
        for (axis, part) in OF_PULL.into_iter().enumerate() {
            pulls[drag * PARTS.len() + part] = force[axis];
        }
    }
    Ok(pulls)
}

#[cfg(test)]
pub(crate) mod tests {
    use std::sync::atomic::AtomicBool;

    use fem_client::closed_form::ClosedFormSolver;
    use fem_client::scene::{Level, Scene};
    use fem_client::solver::direction::PerDirection;
    use fem_client::solver::{Readout, RingLine, SolveRequest, Solver};

    use super::*;
    use crate::response_table::table_scenes::TableScenes;

    const DEPTH_OF_LOAD: f64 = 0.05;

    /// A field with both mirror planes that grows with the depth d, mm, and is a polynomial of the shifts as shares of the largest.
    pub(crate) fn field(d: f64, [x, y]: [f64; 2], u: f64, phi: f64, angle: f64) -> f64 {
        let (u, phi, angle) = (u.to_radians(), phi.to_radians(), angle.to_radians());
        let (straight, turned) = (angle.cos().powi(2), angle.sin() * angle.cos());
        let still = u.cos() * phi.cos() + 3.0 * u.sin() * phi.sin() * turned;
        let along = u.sin() * phi.cos() * (1.0 + straight) + u.cos() * phi.sin() * turned;
        let across = u.cos() * phi.sin() * (1.0 + straight) + u.sin() * phi.cos() * turned;
        let both = u.sin() * phi.sin() + u.cos() * phi.cos() * turned;
        d * (still * (1.0 + x * x - 0.3 * y.powi(4))
            + along * (x + 0.2 * x.powi(3))
            + across * y
            + both * x * y.powi(3))
    }

    /// Returns what a solver answers to a pressing of that tire.
    fn answer(base: &Response, lines: &[RingLine], pressing: &Pressing) -> Response {
        let d = DEPTH_OF_LOAD * pressing.load_n;
        let ring = |line: &RingLine| {
            let around = |angle: f64| {
                (-180..180)
                    .map(|u| field(d, pressing.shares, f64::from(u), line.section_deg, angle))
                    .collect()
            };
            Ring {
                section_deg: line.section_deg,
                theta_deg: (-180..180).map(f64::from).collect(),
                strain: PerDirection {
                    x: around(0.0),
                    y: around(90.0),
                },
                turned: line.turned_deg.iter().map(|angle| around(*angle)).collect(),
            }
        };
        let [x, y] = pressing.shares;
        Response {
            reaction_n: pressing.load_n,
            force_n: Some([d * x * (1.0 + y * y), -d * y, pressing.load_n]),
            depth_mm: d,
            rings: lines.iter().map(ring).collect(),
            ..base.clone()
        }
    }

    /// A response whose fields are put in.
    fn base() -> Response {
        let (scene, readout, go) = (Scene::default(), Readout::default(), AtomicBool::new(false));
        let request = SolveRequest {
            scene: &scene,
            readout: &readout,
            start: None,
            watch: &go,
        };
        let solved = ClosedFormSolver::new().solve(&request);
        solved.expect("a response").response
    }

    /// Returns what that tire answers to a pressing, read for these kinds of film.
    pub(crate) fn answers_to(kinds: &[FilmKind], pressing: &Pressing) -> Response {
        answer(&base(), &mirrored(kinds).rings, pressing)
    }

    /// The table of that tire with the kinds of film.
    pub(crate) fn table_of(kinds: &[FilmKind], friction: f64) -> (ResponseTable, TableSettings) {
        let settings = TableSettings::new(30.0, 12.5, friction, Level::Coarse);
        let scenes = TableScenes::new(&Scene::default(), settings.clone());
        let (base, lines) = (base(), mirrored(kinds).rings);
        let answers = |pressings: Vec<Pressing>| -> Vec<(Pressing, Response)> {
            let answer = |pressing| (pressing, answer(&base, &lines, &pressing));
            pressings.into_iter().map(answer).collect()
        };
        let (undragged, dragged) = (answers(scenes.undragged()), answers(scenes.dragged()));
        let [undragged, dragged] = [&undragged, &dragged]
            .map(|list| list.iter().map(|(p, r)| (*p, r)).collect::<Vec<_>>());
        let table = ResponseTable::new(&settings, kinds, &undragged, &dragged).expect("a table");
        (table, settings)
    }

    fn kinds() -> Vec<FilmKind> {
        [(0.0, 0.0), (0.0, 90.0), (30.0, 90.0), (-30.0, 40.0)]
            .map(|(phi, angle)| FilmKind::point(phi, angle))
            .to_vec()
    }

    #[test]
    fn a_field_that_the_table_can_be_is_met_everywhere() {
        let kinds = kinds();
        let (table, settings) = table_of(&kinds, 0.5);
        for (load_n, shares) in [
            (30.0, [1.0, -1.0]),
            (11.7, [-0.3, 0.8]),
            (0.4, [0.0, 0.0]),
            (23.0, [0.9, 0.1]),
        ] {
            let d = DEPTH_OF_LOAD * load_n;
            assert!((table.depth_of_load_mm(load_n) - d).abs() < 1e-12);
            let weights = table.weights(d, shares.map(|share| share * settings.shift_mm(load_n)));
            for (number, kind) in kinds.iter().enumerate() {
                let samples = table.samples(number, &weights);
                for (u, sample) in (-180..180).zip(samples) {
                    let expected = field(d, shares, f64::from(u), kind.phi_deg, kind.angle_deg);
                    assert!(
                        (sample - expected).abs() < 1e-11,
                        "{load_n} {shares:?} {kind:?} {u}: {sample} {expected}"
                    );
                }
            }
            let expected = [
                d * shares[0] * (1.0 + shares[1] * shares[1]),
                -d * shares[1],
                load_n,
            ];
            for (found, expected) in table.force_n(&weights).iter().zip(expected) {
                assert!((found - expected).abs() < 1e-11, "{found} {expected}");
            }
        }
    }

    #[test]
    fn films_read_the_field_where_they_stand() {
        let kinds = kinds();
        let (table, settings) = table_of(&kinds, 0.5);
        let weights = table.weights(1.0, [0.5 * settings.shift_mm(20.0), 0.0]);
        let nodes = table.film_nodes([(1, 12.25), (3, -40.0)].into_iter());
        for (film, (kind, apart)) in [(1, 12.25), (3, -40.0)].into_iter().enumerate() {
            let FilmKind {
                phi_deg, angle_deg, ..
            } = kinds[kind];
            let expected = field(1.0, [0.5, 0.0], apart, phi_deg, angle_deg);
            // A cubic between degrees: h^4 / 384 of a fourth derivative of some 5, h in radians.
            assert!(
                (nodes.signal(film, &weights) - expected).abs() < 5e-9,
                "{film}"
            );
        }
    }

    #[test]
    fn beyond_the_table_the_nearest_contact_answers_and_air_is_nothing() {
        let kinds = kinds();
        let (table, _) = table_of(&kinds, 0.5);
        let [deepest, deeper] =
            [1.5, 9.0].map(|depth| table.samples(0, &table.weights(depth, [0.0; 2])));
        assert_eq!(deepest, deeper);
        assert_eq!(table.force_n(&table.weights(0.0, [0.1, 0.1])), [0.0; 3]);
        assert!((table.largest_of_kind(0) - 1.5).abs() < 1e-12);
    }

    #[test]
    fn ground_without_friction_pulls_nothing() {
        let kinds = kinds();
        let (table, _) = table_of(&kinds, 0.0);
        let weights = table.weights(1.0, [0.3, 0.3]);
        assert_eq!(table.force_n(&weights)[..2], [0.0; 2]);
        assert_eq!(
            table.samples(0, &weights),
            table.samples(0, &table.weights(1.0, [0.0; 2]))
        );
    }
}
