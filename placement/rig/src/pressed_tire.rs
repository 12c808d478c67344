//! Forces of one contact after another, the rubber's relaxation with them.

use crate::contact_response::{Contact, ContactResponse, StanceResponse};
use crate::gait::stance::Stance;
use crate::relaxation::Relaxation;
use documents::rig::rig_settings::Branch;

/// A tire that is pressed at even intervals.
pub(crate) struct PressedTire<'r, R: ?Sized> {
    response: &'r R,
    relaxation: Relaxation,
    /// The stance that was asked last, by its number.
    stance: Option<(usize, Box<dyn StanceResponse + 'r>)>,
}

/// Effect of a contact that touches.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pressed {
    /// Force over that of slow pressing.
    pub factor: f64,
    /// Force of the ground on the tire: along, across, vertical, N.
    pub force_n: [f64; 3],
}

impl<'r, R: ContactResponse + ?Sized> PressedTire<'r, R> {
    /// A tire at rest, to be pressed at intervals, s.
    pub fn new(response: &'r R, relaxation: &[Branch], interval_s: f64) -> Self {
        Self {
            response,
            relaxation: Relaxation::new(relaxation, interval_s),
            stance: None,
        }
    }

    /// Returns what the contact at the next instant makes, the first films' charges by slow pressing among it, nC; None in the air, where these are left as
    /// they are.
    pub fn next(
        &mut self,
        stance: &Stance,
        contact: &Contact,
        charges_nc: &mut [f64],
    ) -> Option<Pressed> {
        if contact.is_air() {
            self.relaxation.factor(0.0);
            return None;
        }
        let asked = self.stance.take();
        let (_, films) = self.stance.insert(match asked {
            Some((number, films)) if number == stance.number => (number, films),
            _ => (
                stance.number,
                self.response.at_angle(stance.contact_deg, &stance.shares),
            ),
        });
        let slow_n = films.answer(contact, charges_nc);
        let factor = self.relaxation.factor(slow_n[2]);
        Some(Pressed {
            factor,
            force_n: slow_n.map(|force| factor * force),
        })
    }
}
