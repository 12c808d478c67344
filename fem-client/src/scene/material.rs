//! The rubber of a scene.

use serde::Serialize;

/// Rubber: an isochoric law and its compressibility.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Material {
    /// Isochoric law with its parameters.
    #[serde(flatten)]
    pub law: Law,
    /// Compressibility, 1/MPa: the bulk modulus is 2/d1; 0 is exactly incompressible.
    pub d1_per_mpa: f64,
}

/// Isochoric laws, in the invariants I1, I2 and principal stretches l1, l2, l3 of J^(-1/3) F.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(tag = "model", rename_all = "kebab-case")]
pub enum Law {
    /// W = c10 (I1 - 3).
    NeoHookean {
        /// Half of the shear modulus, MPa.
        c10_mpa: f64,
    },
    /// W = c10 (I1 - 3) + c01 (I2 - 3).
    MooneyRivlin {
        /// First constant, MPa.
        c10_mpa: f64,
        /// Second constant, MPa.
        c01_mpa: f64,
    },
    /// W = c10 (I1 - 3) + c20 (I1 - 3)^2 + c30 (I1 - 3)^3.
    Yeoh {
        /// Half of the initial shear modulus, MPa.
        c10_mpa: f64,
        /// Weight of the square, MPa.
        c20_mpa: f64,
        /// Weight of the cube, MPa.
        c30_mpa: f64,
    },
    /// W = sum of (2 mu / alpha^2) (l1^alpha + l2^alpha + l3^alpha - 3).
    Ogden {
        /// Terms; their mu add up to the initial shear modulus.
        terms: Vec<OgdenTerm>,
    },
}

/// One term of Ogden's law.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct OgdenTerm {
    /// Share of the initial shear modulus, MPa.
    pub mu_mpa: f64,
    /// Exponent.
    pub alpha: f64,
}

impl Default for Material {
    /// The paper's rubber.
    fn default() -> Self {
        Self {
            law: Law::mooney_rivlin(),
            d1_per_mpa: 0.0,
        }
    }
}

/// The default parameters: those of the paper's rubber, or the nearest to it with the same shear modulus.
impl Law {
    /// Mooney-Rivlin as in the paper.
    pub fn mooney_rivlin() -> Self {
        Self::MooneyRivlin {
            c10_mpa: 0.144,
            c01_mpa: 0.036,
        }
    }

    /// Neo-Hookean with the paper's shear modulus.
    pub fn neo_hookean() -> Self {
        Self::NeoHookean { c10_mpa: 0.18 }
    }

    /// Yeoh with the paper's shear modulus, which neither softens nor stiffens.
    pub fn yeoh() -> Self {
        Self::Yeoh {
            c10_mpa: 0.18,
            c20_mpa: 0.0,
            c30_mpa: 0.0,
        }
    }

    /// Ogden's form of the paper's rubber.
    pub fn ogden() -> Self {
        let term = |mu_mpa, alpha| OgdenTerm { mu_mpa, alpha };
        Self::Ogden {
            terms: vec![term(0.288, 2.0), term(0.072, -2.0)],
        }
    }

    /// All laws with their default parameters.
    pub fn all() -> [Self; 4] {
        [
            Self::mooney_rivlin(),
            Self::neo_hookean(),
            Self::yeoh(),
            Self::ogden(),
        ]
    }

    /// The name in documents.
    pub fn model(&self) -> &'static str {
        match self {
            Self::NeoHookean { .. } => "neo-hookean",
            Self::MooneyRivlin { .. } => "mooney-rivlin",
            Self::Yeoh { .. } => "yeoh",
            Self::Ogden { .. } => "ogden",
        }
    }

    /// The name for people.
    pub fn title(&self) -> &'static str {
        match self {
            Self::NeoHookean { .. } => "neo-Hookean",
            Self::MooneyRivlin { .. } => "Mooney-Rivlin",
            Self::Yeoh { .. } => "Yeoh",
            Self::Ogden { .. } => "Ogden",
        }
    }

    /// The fields of its parameters.
    pub fn fields(&self) -> &'static [&'static str] {
        match self {
            Self::NeoHookean { .. } => &["c10_mpa"],
            Self::MooneyRivlin { .. } => &["c10_mpa", "c01_mpa"],
            Self::Yeoh { .. } => &["c10_mpa", "c20_mpa", "c30_mpa"],
            Self::Ogden { .. } => &["terms"],
        }
    }

    /// Shear modulus in the reference state, MPa.
    pub fn shear_modulus_mpa(&self) -> f64 {
        match self {
            Self::NeoHookean { c10_mpa } | Self::Yeoh { c10_mpa, .. } => 2.0 * c10_mpa,
            Self::MooneyRivlin { c10_mpa, c01_mpa } => 2.0 * (c10_mpa + c01_mpa),
            Self::Ogden { terms } => terms.iter().map(|term| term.mu_mpa).sum(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_defaults_have_the_papers_shear_modulus() {
        for law in Law::all() {
            let modulus = law.shear_modulus_mpa();
            assert!((modulus - 0.36).abs() < 1e-15, "{law:?}: {modulus}");
        }
    }

    #[test]
    fn a_document_has_the_model_its_parameters_and_the_compressibility() {
        for law in Law::all() {
            let (model, fields) = (law.model(), law.fields());
            let d1_per_mpa = 0.5;
            let document = serde_json::to_value(Material { law, d1_per_mpa }).unwrap();
            assert_eq!(document["model"], model);
            let names: Vec<&str> = document
                .as_object()
                .unwrap()
                .keys()
                .map(String::as_str)
                .collect();
            let expected = [&["model"], fields, &["d1_per_mpa"]].concat();
            assert_eq!(names, expected);
        }
    }
}
