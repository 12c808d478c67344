//! Contacts as they come, drawn by their laws: readings of a layout's films, and the force.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

use crate::field::film_field::LoadField;
use crate::field::hermite::Turn;
use crate::field::response_surface::Drawn;
use crate::simulate::draws::Draws;
use crate::simulate::normal_pairs::uniform;
use crate::simulate::reading_likelihood::Likelihood;

/// Stream of the seed from which contacts are drawn; readings' noise has the first.
const STREAM: u64 = 1;

/// Contacts at one depth.
pub(super) struct DrawnContacts {
    /// Fields at that depth.
    field: LoadField,
    /// Contacts that differ, one for each sample or one for all; none where none does.
    differing: Vec<TrueContact>,
}

/// A contact as it is, whatever an estimate takes it for.
#[derive(Debug, Clone, PartialEq)]
pub struct TrueContact {
    /// Vertical force, N.
    pub force_n: f64,
    /// Signals by kind of film.
    pub signals: Vec<Turn>,
    /// Values of the quantities that contacts have one of, in their laws' order, then of the loads beside the vertical force; none where an estimate isn't asked for them.
    pub values: Vec<f64>,
}

impl TrueContact {
    /// The contact as some kinds of film feel it, in their order.
    pub(crate) fn of_kinds(&self, kinds: &[usize]) -> Self {
        let signals = kinds.iter().map(|kind| self.signals[*kind].clone());
        Self {
            force_n: self.force_n,
            signals: signals.collect(),
            values: self.values.clone(),
        }
    }
}

impl DrawnContacts {
    /// Draws contacts at a depth, mm, the same for all layouts of one seed.
    pub fn new(likelihood: &Likelihood, depth_mm: f64, (draws, drawn): (&Draws, Drawn)) -> Self {
        let kinds = 0..likelihood.fields().signals.len();
        let surface = likelihood.fields().contacts.iter();
        let differing = surface.flat_map(|surface| {
            let mut rng = ChaCha8Rng::seed_from_u64(draws.seed());
            rng.set_stream(STREAM);
            let kinds = kinds.clone();
            (0..draws.most()).map(move |_| {
                // What isn't asked for is drawn, too: the others stay as they are.
                let shares: Vec<f64> = surface.laws_of_axes().map(|_| uniform(&mut rng)).collect();
                let given = surface.drawn(&shares, drawn);
                let contact = surface.contact(depth_mm, &given);
                let signal = |kind| Turn::new(surface.signal(&contact, kind));
                TrueContact {
                    force_n: surface.force_n(&contact),
                    signals: kinds.clone().map(signal).collect(),
                    values: surface.told_of(&given, &contact),
                }
            })
        });
        Self {
            differing: differing.collect(),
            field: likelihood.field(depth_mm),
        }
    }

    /// Takes every contact at a depth, mm, for this one.
    pub(super) fn all_as(contact: TrueContact, likelihood: &Likelihood, depth_mm: f64) -> Self {
        Self {
            field: likelihood.field(depth_mm),
            differing: vec![contact],
        }
    }

    fn differing(&self, sample: usize) -> Option<&TrueContact> {
        match self.differing.as_slice() {
            [all] => Some(all),
            each => each.get(sample),
        }
    }

    /// Signal in a sample of a kind of film.
    pub fn signal(&self, sample: usize, kind: usize) -> &Turn {
        match self.differing(sample) {
            Some(own) => &own.signals[kind],
            None => &self.field.kinds[kind].signal,
        }
    }

    /// Vertical force of a sample, N; none where contacts don't differ.
    pub fn force_n(&self, sample: usize) -> Option<f64> {
        self.differing(sample).map(|own| own.force_n)
    }

    /// Values of a sample's quantities.
    pub fn values(&self, sample: usize) -> &[f64] {
        self.differing(sample).map_or(&[], |own| &own.values)
    }
}
