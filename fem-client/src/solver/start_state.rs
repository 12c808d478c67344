//! Start states as bytes, for storage.
//!
//! All integers and floats are little-endian; a list or text is its length as u64, then its items:
//!
//! | part | bytes |
//! |---|---|
//! | `strainsite-start` | 16 |
//! | version, u32 | 4 |
//! | inflated_key, inflated, pressure_mpa, depths_mm, camber_deg, equilibrium | as they come |
//! | SHA-256 of all before | 32 |
//!
//! Version 1 has no camber_deg: all its wheels were upright.

use sha2::{Digest, Sha256};

use crate::solver::StartState;

const MAGIC: &[u8; 16] = b"strainsite-start";
const VERSION: u32 = 2;
/// The version before wheels could lean.
const UPRIGHT: u32 = 1;
const HASH_BYTES: usize = 32;

/// Bytes that aren't a start state.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum StartStateError {
    /// The first bytes are those of something else.
    #[error("these bytes aren't a start state")]
    NotAStartState,
    /// A state of another version of the format.
    #[error("start state of format version {found}; this program reads version {VERSION}")]
    OtherVersion {
        /// Version found.
        found: u32,
    },
    /// Cut short, or changed.
    #[error("the start state is damaged: {what}")]
    Damaged {
        /// Sign of the damage, in words.
        what: &'static str,
    },
}

impl StartState {
    /// The state as bytes, from which [`StartState::from_bytes`] restores it bit for bit.
    pub fn to_bytes(&self) -> Vec<u8> {
        let numbers = self.inflated.len() + self.depths_mm.len() + self.equilibrium.len();
        let mut bytes = Vec::with_capacity(128 + self.inflated_key.len() + 8 * numbers);
        bytes.extend_from_slice(MAGIC);
        bytes.extend_from_slice(&VERSION.to_le_bytes());
        put_length(&mut bytes, self.inflated_key.len());
        bytes.extend_from_slice(self.inflated_key.as_bytes());
        put_numbers(&mut bytes, &self.inflated);
        bytes.extend_from_slice(&self.pressure_mpa.to_le_bytes());
        put_numbers(&mut bytes, &self.depths_mm);
        bytes.extend_from_slice(&self.camber_deg.to_le_bytes());
        put_numbers(&mut bytes, &self.equilibrium);
        let hash = Sha256::digest(&bytes);
        bytes.extend_from_slice(&hash);
        bytes
    }

    /// Restores a state from its bytes.
    ///
    /// # Errors
    /// When the bytes are something else, of another version, cut short or changed.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, StartStateError> {
        if !bytes.starts_with(MAGIC) {
            return Err(StartStateError::NotAStartState);
        }
        let mut cursor = Cursor {
            rest: &bytes[MAGIC.len()..],
        };
        let version = u32::from_le_bytes(cursor.take()?);
        if ![UPRIGHT, VERSION].contains(&version) {
            return Err(StartStateError::OtherVersion { found: version });
        }
        let (body, hash) = bytes
            .split_at_checked(bytes.len() - HASH_BYTES.min(bytes.len()))
            .unwrap_or_default();
        if Sha256::digest(body).as_slice() != hash {
            return Err(StartStateError::Damaged {
                what: "its hash differs",
            });
        }
        let state = Self {
            inflated_key: cursor.text()?,
            inflated: cursor.numbers()?,
            pressure_mpa: f64::from_le_bytes(cursor.take()?),
            depths_mm: cursor.numbers()?,
            camber_deg: match version {
                UPRIGHT => 0.0,
                _ => f64::from_le_bytes(cursor.take()?),
            },
            equilibrium: cursor.numbers()?,
        };
        if cursor.rest.len() == HASH_BYTES {
            Ok(state)
        } else {
            Err(CUT_SHORT)
        }
    }
}

const CUT_SHORT: StartStateError = StartStateError::Damaged {
    what: "its lengths don't add up",
};

fn put_length(bytes: &mut Vec<u8>, length: usize) {
    bytes.extend_from_slice(&(length as u64).to_le_bytes());
}

fn put_numbers(bytes: &mut Vec<u8>, numbers: &[f64]) {
    put_length(bytes, numbers.len());
    bytes.extend(numbers.iter().flat_map(|number| number.to_le_bytes()));
}

/// The bytes not read yet. Lengths are checked against them before anything is allocated.
struct Cursor<'b> {
    rest: &'b [u8],
}

impl<'b> Cursor<'b> {
    fn take<const N: usize>(&mut self) -> Result<[u8; N], StartStateError> {
        let (taken, rest) = self.rest.split_first_chunk().ok_or(CUT_SHORT)?;
        self.rest = rest;
        Ok(*taken)
    }

    fn items(&mut self, size: usize) -> Result<&'b [u8], StartStateError> {
        let length = usize::try_from(u64::from_le_bytes(self.take()?)).map_err(|_| CUT_SHORT)?;
        let bytes = length.checked_mul(size).ok_or(CUT_SHORT)?;
        let (taken, rest) = self.rest.split_at_checked(bytes).ok_or(CUT_SHORT)?;
        self.rest = rest;
        Ok(taken)
    }

    fn text(&mut self) -> Result<String, StartStateError> {
        let bytes = self.items(1)?.to_vec();
        String::from_utf8(bytes).map_err(|_| StartStateError::Damaged {
            what: "its key isn't text",
        })
    }

    fn numbers(&mut self) -> Result<Vec<f64>, StartStateError> {
        let (chunks, _) = self.items(8)?.as_chunks();
        Ok(chunks
            .iter()
            .map(|chunk| f64::from_le_bytes(*chunk))
            .collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn state() -> StartState {
        StartState {
            inflated_key: "carcass, 0.2 MPa, \u{b5}".to_owned(),
            inflated: vec![0.1 + 0.2, -0.0, f64::MIN_POSITIVE / 2.0],
            pressure_mpa: 0.2,
            depths_mm: vec![],
            camber_deg: -7.5,
            equilibrium: (0..1000).map(|i| f64::from(i).sin()).collect(),
        }
    }

    fn bits(numbers: &[f64]) -> Vec<u64> {
        numbers.iter().map(|number| number.to_bits()).collect()
    }

    #[test]
    fn a_state_survives_bit_for_bit() {
        let (before, after) = (
            state(),
            StartState::from_bytes(&state().to_bytes()).unwrap(),
        );
        assert_eq!(after, before);
        assert_eq!(bits(&after.inflated), bits(&before.inflated));
        assert_eq!(bits(&after.equilibrium), bits(&before.equilibrium));
        assert_eq!(after.to_bytes(), before.to_bytes());
    }

    #[test]
    fn a_state_of_the_version_before_is_upright() {
        let upright = StartState {
            depths_mm: vec![1.0, 0.5],
            camber_deg: 0.0,
            ..state()
        };
        let mut bytes = upright.to_bytes();
        bytes[MAGIC.len()..MAGIC.len() + 4].copy_from_slice(&UPRIGHT.to_le_bytes());
        let after = HASH_BYTES + 8 * (upright.equilibrium.len() + 1);
        let camber = bytes.len() - after - 8;
        bytes.drain(camber..camber + 8);
        let body = bytes.len() - HASH_BYTES;
        let hash = Sha256::digest(&bytes[..body]);
        bytes[body..].copy_from_slice(&hash);
        assert_eq!(StartState::from_bytes(&bytes), Ok(upright));
    }

    #[test]
    fn no_cut_and_no_flipped_bit_passes() {
        let bytes = StartState {
            equilibrium: vec![1.5],
            ..state()
        }
        .to_bytes();
        for end in 0..bytes.len() {
            assert!(
                StartState::from_bytes(&bytes[..end]).is_err(),
                "cut at {end}"
            );
        }
        for i in 0..bytes.len() {
            let mut changed = bytes.clone();
            changed[i] ^= 0x40;
            assert!(StartState::from_bytes(&changed).is_err(), "changed at {i}");
        }
        assert!(StartState::from_bytes(&[bytes, vec![0]].concat()).is_err());
    }

    #[test]
    fn lengths_that_lie_are_refused() {
        let mut bytes = [
            MAGIC.as_slice(),
            &VERSION.to_le_bytes(),
            &u64::MAX.to_le_bytes(),
        ]
        .concat();
        let hash = Sha256::digest(&bytes);
        bytes.extend_from_slice(&hash);
        assert_eq!(StartState::from_bytes(&bytes), Err(CUT_SHORT));
    }

    #[test]
    fn another_version_is_named() {
        let mut bytes = state().to_bytes();
        bytes[MAGIC.len()] = 9;
        assert_eq!(
            StartState::from_bytes(&bytes),
            Err(StartStateError::OtherVersion { found: 9 })
        );
    }
}
