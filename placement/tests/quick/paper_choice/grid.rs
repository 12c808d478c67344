//! The strains of the shipped study at every point of its full grid: five depths with five Gauss nodes each, standard mesh.

use gsa::campaign::Campaign;
use gsa::law::distribution::Distribution;
use gsa::method::analysis::Analysis;
use gsa::method::{Kind, Method};
use ndarray::Array2;

/// Inputs, and locations with an x and a y strain each.
pub const STATIONS: usize = 5;
/// Nodes of each input.
pub const NODES: usize = 5;
const OUTPUTS: usize = 2 * STATIONS;
const TABLE: &str = include_str!("../../../../docs/proof/paper-choice/strains.csv");

/// Strains of all 3125 points. The table has one of each pair of mirror images.
pub struct Grid {
    inputs: Vec<Distribution>,
    nodes: Vec<f64>,
    strains: Vec<[f64; OUTPUTS]>,
}

impl Grid {
    pub fn new() -> Self {
        let depth = Distribution::uniform(0.7, 1.3).expect("a law");
        let rule = depth.gauss_rule(NODES).expect("a rule");
        let mut strains = vec![[f64::NAN; OUTPUTS]; NODES.pow(STATIONS as u32)];
        for line in TABLE.lines().skip(1) {
            let fields: Vec<&str> = line.split(',').collect();
            let (at, values) = fields.split_at(STATIONS);
            let at: Vec<usize> = at.iter().map(|k| k.parse().expect("a node")).collect();
            let values: Vec<f64> = values
                .iter()
                .map(|v| v.parse().expect("a strain"))
                .collect();
            let mut own: [f64; OUTPUTS] = values.try_into().expect("ten strains");
            strains[position(at.iter())] = own;
            own.as_chunks_mut::<2>().0.reverse();
            strains[position(at.iter().rev())] = own;
        }
        assert!(strains.iter().flatten().all(|strain| strain.is_finite()));
        Self {
            inputs: vec![depth; STATIONS],
            nodes: rule.nodes,
            strains,
        }
    }

    /// Strains at depths: P1 x, P1 y, P2 x, ... Off the grid they are unknown.
    pub fn strains(&self, depths: &[f64]) -> &[f64; OUTPUTS] {
        let node = |depth: &f64| self.nodes.iter().position(|node| node == depth);
        let at: Option<Vec<usize>> = depths.iter().map(node).collect();
        at.map_or(&[f64::NAN; OUTPUTS], |at| {
            &self.strains[position(at.iter())]
        })
    }

    /// Analyses its points by a method, and counts them.
    pub fn analysed(&self, method: Method) -> (Vec<Analysis>, usize) {
        let campaign = Campaign::new(&self.inputs, method).expect("a design");
        let rows: Vec<f64> = campaign
            .points()
            .iter()
            .flat_map(|depths| self.strains(depths))
            .copied()
            .collect();
        let runs = campaign.points().len();
        let values = Array2::from_shape_vec((runs, OUTPUTS), rows).expect("a row each");
        (campaign.analyse(&values.view()).expect("an analysis"), runs)
    }

    /// Root mean square over the law of what the product of the lines through the means misses, over the strain's deviation.
    pub fn misfit_of_product(&self, output: usize, deviation: f64) -> f64 {
        let rule = self.inputs[0].gauss_rule(NODES).expect("a rule");
        let middle = [NODES / 2; STATIONS];
        let at = |nodes: &[usize; STATIONS]| self.strains[position(nodes.iter())][output];
        let centre = at(&middle);
        let mut square = 0.0;
        for flat in 0..self.strains.len() {
            let nodes: [usize; STATIONS] =
                std::array::from_fn(|i| flat / NODES.pow((STATIONS - 1 - i) as u32) % NODES);
            let on_line = |i: usize| {
                let mut line = middle;
                line[i] = nodes[i];
                at(&line)
            };
            let product = centre * (0..STATIONS).map(|i| on_line(i) / centre).product::<f64>();
            let weight: f64 = nodes.iter().map(|j| rule.weights[*j]).product();
            square += weight * (at(&nodes) - product).powi(2);
        }
        square.sqrt() / deviation
    }
}

/// Place of a point in the list, the first input's node counting most.
fn position<'a>(nodes: impl Iterator<Item = &'a usize>) -> usize {
    nodes.fold(0, |at, node| at * NODES + node)
}

/// The whole grid as a method.
pub fn tensor() -> Method {
    Method {
        nodes: NODES,
        check_points: 0,
        ..Method::of(Kind::Tensor)
    }
}

/// The shipped study's method with a seed and a number of check points.
pub fn mdrm(check_points: usize, seed: u64) -> Method {
    Method {
        nodes: NODES,
        check_points,
        seed,
        ..Method::of(Kind::Mdrm)
    }
}

/// Largest difference of two lists of indices.
pub fn difference(a: &[f64], b: &[f64]) -> f64 {
    let pairs = a.iter().zip(b);
    pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}
