//! Products of ln p at a layout's films, by the angle of the contact.

use std::cell::OnceCell;

use crate::arrangement::Arrangement;
use crate::field::separated::Separated;
use crate::simulate::lanes::{dot, in_lanes};
use crate::simulate::reading_likelihood::Products;

/// Products' functions at an angle.
pub(super) struct Functions {
    /// Functions with readings at each film, product after product.
    pub linear: Vec<f64>,
    /// Functions without readings, summed over the films.
    pub constant: Vec<f64>,
}

/// Products' functions of a layout at angles around the wheel, made where they are asked for.
pub(super) struct TurnedProducts<'l> {
    pub own: &'l Products,
    arrangement: Arrangement,
    /// Functions by part of a turn.
    functions: Vec<OnceCell<Functions>>,
}

impl<'l> TurnedProducts<'l> {
    /// Prepares the functions of a layout at the middles of so many parts of a turn.
    pub fn new(own: &'l Products, arrangement: &Arrangement, angles: usize) -> Self {
        Self {
            own,
            arrangement: arrangement.clone(),
            functions: (0..angles).map(|_| OnceCell::new()).collect(),
        }
    }

    /// Number of films.
    pub fn films(&self) -> usize {
        self.arrangement.films.len()
    }

    /// The middle of a part of a turn, degrees.
    pub fn angle_deg(&self, angle: usize) -> f64 {
        (angle as f64 + 0.5) * 360.0 / self.functions.len() as f64
    }

    /// The functions at a part of a turn.
    pub fn at(&self, angle: usize) -> &Functions {
        self.functions[angle].get_or_init(|| {
            let parts = &self.own.parts;
            let films = |field| at_films(field, &self.arrangement, self.angle_deg(angle));
            let constant = films(&parts.constant);
            let of_films = constant.chunks_exact(self.films());
            Functions {
                linear: films(&parts.linear),
                constant: of_films.map(|films| films.iter().sum()).collect(),
            }
        })
    }

    /// Number of the products that are summed, with the zeros behind them.
    pub(super) fn row_len(&self) -> usize {
        self.own.coefficients.row_len()
    }

    /// Adds the products' functions at a part of a turn, after these readings, to a list, and the zeros behind them.
    pub(super) fn add_after(&self, angle: usize, readings: &[f64], list: &mut Vec<f64>) {
        let Functions { linear, constant } = self.at(angle);
        let end = list.len() + self.row_len();
        for films in linear.chunks_exact(self.films()) {
            list.push(dot(films, readings));
        }
        list.extend(constant.iter().map(|sum| -0.5 * sum));
        list.resize(end, 0.0);
    }

    /// The sum of products, at a part of a depth.
    pub fn log(&self, products: &[f64], depth: usize) -> f64 {
        in_lanes(self.own.coefficients.row(depth), products)
    }

    /// The part of ln p without readings, at parts of a turn and of a depth.
    pub fn constant(&self, [angle, depth]: [usize; 2]) -> f64 {
        let sums = &self.at(angle).constant;
        let coefficients = self.own.coefficients.at(depth);
        -0.5 * dot(&coefficients[coefficients.len() - sums.len()..], sums)
    }
}

/// Returns each product's function at each film with the contact at an angle.
fn at_films(field: &Separated, arrangement: &Arrangement, angle_deg: f64) -> Vec<f64> {
    let product = |r: usize| {
        let films = arrangement.films.iter();
        films.map(move |film| field.functions[film.kind][r].at(film.theta_deg - angle_deg))
    };
    (0..field.rank()).flat_map(product).collect()
}
