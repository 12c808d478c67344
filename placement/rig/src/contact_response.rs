//! Responses of a tire with its films to a contact: charges and forces, as a rig asks for them.

use documents::layouts::contact_laws::ContactQuantity;

/// Contact of the ground at one instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact {
    /// Depth below the inflated tire's outer radius, mm; 0 and less: in the air.
    pub depth_mm: f64,
    /// Shift of the ground along the wheel and across it, mm.
    pub shift_mm: [f64; 2],
}

impl Contact {
    /// Contact that touches nothing.
    pub(crate) const AIR: Self = Self {
        depth_mm: 0.0,
        shift_mm: [0.0; 2],
    };

    /// Whether nothing touches.
    pub(crate) fn is_air(&self) -> bool {
        self.depth_mm <= 0.0
    }
}

/// Span for which a rig draws what contacts differ in beside angle, depth and shift.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DrawnFor {
    /// Each stance, as the ground below it.
    Stance,
    /// Each run, as the pressure.
    Run,
}

impl DrawnFor {
    /// Returns for which span a quantity is drawn; none for a traction, which is the shear's.
    pub fn of(quantity: ContactQuantity) -> Option<Self> {
        match quantity {
            ContactQuantity::Camber | ContactQuantity::Uneven | ContactQuantity::Rough => {
                Some(Self::Stance)
            }
            ContactQuantity::Pressure | ContactQuantity::Friction => Some(Self::Run),
            ContactQuantity::Traction | ContactQuantity::SideTraction => None,
        }
    }
}

/// Response of a tire with its films to a contact that is pressed slowly. In the air it isn't asked: charges and forces are those of the inflated tire, 0.
pub trait ContactResponse {
    /// Counts the films.
    fn films(&self) -> usize;
    /// Charge at which each film's full scale lies, nC: the largest of its kind at the largest load.
    fn full_scale_nc(&self) -> &[f64];
    /// Capacitance of each film, pF.
    fn capacitance_pf(&self) -> &[f64];
    /// Charge of each film by its warming, nC/K.
    fn warming_nc_per_k(&self) -> &[f64];
    /// The depth that bears a force, N, without a shift; mm.
    fn depth_of_load_mm(&self, load_n: f64) -> f64;
    /// Largest shift along and across up to which the response is known at a depth, mm, before it slides.
    fn sticking_shift_mm(&self, depth_mm: f64) -> [f64; 2];
    /// Lists what contacts differ in beside angle, depth and shift.
    fn differing(&self) -> &[DrawnFor];
    /// The films with the contact at this wheel angle, degrees, and what contacts differ in at these shares of its law, from 0 to 1; without any share at its usual value.
    fn at_angle(&self, contact_deg: f64, shares: &[f64]) -> Box<dyn StanceResponse + '_>;
}

/// Films whose places and contacts can be changed.
pub trait TurnableFilms: ContactResponse + Sized {
    /// Returns the same films, each turned around the wheel by so many degrees.
    fn turned(&self, by_deg: &[f64]) -> Self;
    /// Returns the same films under contacts that differ in angle, depth and shift alone.
    fn alike(&self) -> Self;
}

/// A tire with its films, the contact at one wheel angle.
pub trait StanceResponse {
    /// Force of the ground on the tire: along, across, vertical, N; and the charges of the first films, nC, into their places, of which there may be none.
    fn answer(&self, contact: &Contact, charges_nc: &mut [f64]) -> [f64; 3];
}
