//! A layout's films on a tire whose responses are in a table: what a virtual rig asks.

use fem_client::scene::Film;
use fem_client::solver::FilmSignal;

use crate::response_table::differing_contacts::{DifferingContacts, StanceChanges};
use crate::response_table::solved_table::{FilmNodes, ResponseTable};
use crate::signals::answers::signal_of_tension;
use layouts::arrangement::LaidFilm;
use rig::contact_response::{Contact, ContactResponse, DrawnFor, StanceResponse, TurnableFilms};

/// Films around a wheel, each of a kind of the table, whose signals are volts of the open circuit.
#[derive(Debug, Clone, PartialEq)]
pub struct LaidFilms<'t> {
    table: &'t ResponseTable,
    /// Quantities that contacts differ in besides angle, depth and shift; none where they are alike.
    differing: Option<&'t DifferingContacts>,
    films: Vec<LaidFilm>,
    /// Capacitance of one film, pF.
    capacitance_pf: f64,
    full_scales_nc: Vec<f64>,
    capacitances_pf: Vec<f64>,
    warming_nc_per_k: Vec<f64>,
}

impl<'t> LaidFilms<'t> {
    /// Films of these kinds in the table, all made as this one.
    pub fn new(table: &'t ResponseTable, film: &Film, films: &[LaidFilm]) -> Self {
        let FilmSignal {
            capacitance_pf,
            charge_by_warming_nc_per_k,
            ..
        } = signal_of_tension(film, [0.0; 2]);
        let full_scale =
            |film: &LaidFilm| charge_nc(table.largest_of_kind(film.kind), capacitance_pf);
        Self {
            table,
            differing: None,
            capacitance_pf,
            full_scales_nc: films.iter().map(full_scale).collect(),
            capacitances_pf: vec![capacitance_pf; films.len()],
            warming_nc_per_k: vec![charge_by_warming_nc_per_k; films.len()],
            films: films.to_vec(),
        }
    }

    /// Returns these films under contacts that differ so.
    #[must_use]
    pub fn under(self, differing: Option<&'t DifferingContacts>) -> Self {
        Self { differing, ..self }
    }

    /// Returns these films, with what they are wired to, on another tire, whose contacts differ as on theirs.
    pub fn on<'o>(&self, table: &'o ResponseTable) -> LaidFilms<'o>
    where
        't: 'o,
    {
        LaidFilms {
            table,
            differing: self.differing,
            capacitance_pf: self.capacitance_pf,
            full_scales_nc: self.full_scales_nc.clone(),
            capacitances_pf: self.capacitances_pf.clone(),
            warming_nc_per_k: self.warming_nc_per_k.clone(),
            films: self.films.clone(),
        }
    }
}

/// Returns the charge of the volts of an open circuit, nC.
fn charge_nc(volts: f64, capacitance_pf: f64) -> f64 {
    1e-3 * volts * capacitance_pf
}

impl ContactResponse for LaidFilms<'_> {
    fn films(&self) -> usize {
        self.films.len()
    }

    fn full_scale_nc(&self) -> &[f64] {
        &self.full_scales_nc
    }

    fn capacitance_pf(&self) -> &[f64] {
        &self.capacitances_pf
    }

    fn warming_nc_per_k(&self) -> &[f64] {
        &self.warming_nc_per_k
    }

    fn depth_of_load_mm(&self, load_n: f64) -> f64 {
        self.table.depth_of_load_mm(load_n)
    }

    fn sticking_shift_mm(&self, depth_mm: f64) -> [f64; 2] {
        [self.table.largest_shift_mm(depth_mm); 2]
    }

    fn differing(&self) -> &[DrawnFor] {
        self.differing.map_or(&[], DifferingContacts::drawn)
    }

    fn at_angle(&self, contact_deg: f64, shares: &[f64]) -> Box<dyn StanceResponse + '_> {
        let apart = |film: &LaidFilm| (film.kind, film.theta_deg - contact_deg);
        let apart: Vec<(usize, f64)> = self.films.iter().map(apart).collect();
        let differing = self.differing.filter(|_| !shares.is_empty());
        Box::new(FilmsAtAngle {
            table: self.table,
            nodes: self.table.film_nodes(apart.iter().copied()),
            changes: differing.map(|differing| differing.of_stance(shares, &apart)),
            capacitance_pf: self.capacitance_pf,
        })
    }
}

impl TurnableFilms for LaidFilms<'_> {
    fn turned(&self, by_deg: &[f64]) -> Self {
        let mut turned = self.clone();
        for (film, by) in turned.films.iter_mut().zip(by_deg) {
            film.theta_deg += by;
        }
        turned
    }

    fn alike(&self) -> Self {
        self.clone().under(None)
    }
}

/// The films with the contact at one wheel angle.
struct FilmsAtAngle<'t> {
    table: &'t ResponseTable,
    nodes: FilmNodes,
    /// Changes of the stance's contact; none of the usual one.
    changes: Option<StanceChanges>,
    capacitance_pf: f64,
}

impl StanceResponse for FilmsAtAngle<'_> {
    fn answer(&self, contact: &Contact, charges_nc: &mut [f64]) -> [f64; 3] {
        let weights = self.table.weights(contact.depth_mm, contact.shift_mm);
        for (film, charge) in charges_nc.iter_mut().enumerate() {
            *charge = charge_nc(self.nodes.signal(film, &weights), self.capacitance_pf);
        }
        let force_n = self.table.force_n(&weights);
        let Some(changes) = &self.changes else {
            return force_n;
        };
        let (volts, changed_n) = changes.at(contact.depth_mm, charges_nc.len());
        for (charge, volts) in charges_nc.iter_mut().zip(volts) {
            *charge += charge_nc(volts, self.capacitance_pf);
        }
        [0, 1, 2].map(|axis| force_n[axis] + changed_n[axis])
    }
}

#[cfg(test)]
mod tests {
    use fem_client::scene::Scene;

    use super::*;
    use crate::response_table::solved_table::tests::{field, table_of};
    use documents::signals::signal_settings::SignalSettings;
    use layouts::arrangement::{Arrangement, FilmKind};

    fn film() -> Film {
        SignalSettings::on(&Scene::default()).film
    }

    #[test]
    fn a_wheel_that_turned_reads_what_it_read_before() {
        let kinds = [FilmKind::point(0.0, 90.0), FilmKind::point(30.0, 0.0)];
        let (table, settings) = table_of(&kinds, 0.5);
        let film = film();
        let six = Arrangement::regular(6, &[0, 1], false);
        let turned: Vec<LaidFilm> = six
            .films
            .iter()
            .map(|film| LaidFilm {
                theta_deg: film.theta_deg + 17.0,
                ..*film
            })
            .collect();
        let [six, turned] = [&six.films, &turned].map(|films| LaidFilms::new(&table, &film, films));
        let contact = Contact {
            depth_mm: 1.0,
            shift_mm: [0.4 * settings.shift_mm(20.0), 0.0],
        };
        let charges = |films: &LaidFilms<'_>, contact_deg: f64| {
            let mut charges = vec![0.0; films.films()];
            films
                .at_angle(contact_deg, &[])
                .answer(&contact, &mut charges);
            charges
        };
        let before = charges(&six, 8.0);
        for (a, b) in before.iter().zip(charges(&turned, 25.0)) {
            assert!((a - b).abs() < 1e-12 * six.full_scale_nc()[0]);
        }
        // The third film is the second unit's first: 60 degrees around, 52 from the contact.
        let expected = field(1.0, [0.4, 0.0], 52.0, 0.0, 90.0);
        assert!((before[2] - charge_nc(expected, six.capacitance_pf()[0])).abs() < 1e-8);
        assert_eq!(
            six.at_angle(8.0, &[]).answer(&contact, &mut []),
            turned.at_angle(0.0, &[]).answer(&contact, &mut [])
        );
    }
}
