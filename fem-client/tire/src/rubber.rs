//! A scene's rubber as the kernel evaluates it.

use fem::material::{Isochoric, MooneyRivlin, NeoHookean, Ogden, OgdenTerm, Yeoh};
use fem_client::scene::Law;

/// The isochoric law of a rubber.
pub(crate) fn isochoric(law: &Law) -> Box<dyn Isochoric> {
    match law {
        &Law::NeoHookean { c10_mpa: c10 } => Box::new(NeoHookean { c10 }),
        &Law::MooneyRivlin {
            c10_mpa: c10,
            c01_mpa: c01,
        } => Box::new(MooneyRivlin { c10, c01 }),
        &Law::Yeoh {
            c10_mpa: c10,
            c20_mpa: c20,
            c30_mpa: c30,
        } => Box::new(Yeoh { c10, c20, c30 }),
        Law::Ogden { terms } => Box::new(Ogden {
            terms: terms
                .iter()
                .map(|term| OgdenTerm {
                    mu: term.mu_mpa,
                    alpha: term.alpha,
                })
                .collect(),
        }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_kernel_has_the_documents_shear_modulus() {
        for law in Law::all() {
            let kernel = isochoric(&law).shear_modulus();
            assert_eq!(kernel, law.shear_modulus_mpa(), "{law:?}");
        }
    }
}
