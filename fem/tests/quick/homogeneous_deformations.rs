//! Closed forms of homogeneous deformations, and rubber's published curves.

use fem::material::{Isochoric, MooneyRivlin, NeoHookean, Ogden, OgdenTerm, Yeoh};
use fem::tensor::{Tensor, cofactor, multiply, transpose};

const RUBBER: MooneyRivlin = MooneyRivlin {
    c10: 0.144,
    c01: 0.036,
};
const YEOH: Yeoh = Yeoh {
    c10: 0.17,
    c20: -0.002,
    c30: 6e-5,
};

/// Ogden's fit of Treloar's rubber (R. W. Ogden, Proc. R. Soc. Lond. A 326 (1972) 565): 6.3, 0.012 and -0.1 kg/cm^2 with
/// exponents 1.3, 5 and -2, in this crate's weights: alpha / 2 times as large.
fn treloar_rubber() -> Ogden {
    let terms = [(6.3, 1.3), (0.012, 5.0), (-0.1, -2.0)];
    let term = |(mu, alpha)| OgdenTerm {
        mu: 0.5 * alpha * mu * KG_PER_CM2,
        alpha,
    };
    Ogden {
        terms: terms.map(term).to_vec(),
    }
}

/// MPa.
const KG_PER_CM2: f64 = 0.0980665;

/// Nominal stress of a volume-preserving stretch whose third direction is free.
fn nominal(material: &dyn Isochoric, stretches: [f64; 3]) -> f64 {
    let f: Tensor =
        std::array::from_fn(|i| std::array::from_fn(|j| if i == j { stretches[i] } else { 0.0 }));
    let (stress, g) = (material.stress(&f), cofactor(&f));
    let p = -stress[2][2] / g[2][2];
    stress[0][0] + p * g[0][0]
}

fn uniaxial(l: f64) -> [f64; 3] {
    [l, l.powf(-0.5), l.powf(-0.5)]
}

fn equibiaxial(l: f64) -> [f64; 3] {
    [l, l, l.powi(-2)]
}

fn planar(l: f64) -> [f64; 3] {
    [l, 1.0, 1.0 / l]
}

/// Checks a law against nominal stresses of uniaxial, equibiaxial and planar tension.
fn check_closed_forms(material: &dyn Isochoric, exact: impl Fn(f64) -> [f64; 3]) {
    for l in [0.5f64, 0.8, 1.0, 1.1, 1.5, 2.0, 3.0] {
        let computed = [uniaxial(l), equibiaxial(l), planar(l)].map(|s| nominal(material, s));
        for (computed, exact) in computed.into_iter().zip(exact(l)) {
            // The stress at the free face, up to l^4 times larger, cancels.
            let tolerance = 1e-14 * (1.0 + exact.abs()) * l.max(1.0 / l).powi(4);
            assert!(
                (computed - exact).abs() < tolerance,
                "{material:?} at {l}: {computed} for {exact}"
            );
        }
    }
}

#[test]
fn laws_of_the_first_and_second_invariant_give_their_closed_forms() {
    let of_slopes = |slope: &dyn Fn(f64) -> f64, c01: f64, l: f64| {
        let [i_uniaxial, i_biaxial, i_planar] =
            [uniaxial(l), equibiaxial(l), planar(l)].map(|s| s.iter().map(|l| l * l).sum::<f64>());
        [
            2.0 * (slope(i_uniaxial) + c01 / l) * (l - l.powi(-2)),
            2.0 * (slope(i_biaxial) + c01 * l * l) * (l - l.powi(-5)),
            2.0 * (slope(i_planar) + c01) * (l - l.powi(-3)),
        ]
    };
    check_closed_forms(&RUBBER, |l| of_slopes(&|_| RUBBER.c10, RUBBER.c01, l));
    check_closed_forms(&NeoHookean { c10: 0.18 }, |l| of_slopes(&|_| 0.18, 0.0, l));
    let slope =
        |i1: f64| YEOH.c10 + 2.0 * YEOH.c20 * (i1 - 3.0) + 3.0 * YEOH.c30 * (i1 - 3.0).powi(2);
    check_closed_forms(&YEOH, |l| of_slopes(&slope, 0.0, l));
}

#[test]
fn ogden_gives_its_closed_forms() {
    let rubber = treloar_rubber();
    check_closed_forms(&rubber, |l| {
        let sum = |transverse: f64| {
            rubber
                .terms
                .iter()
                .map(|t| {
                    2.0 * t.mu / t.alpha * (l.powf(t.alpha) - l.powf(transverse * t.alpha)) / l
                })
                .sum()
        };
        [sum(-0.5), sum(-2.0), sum(-1.0)]
    });
}

/// L. R. G. Treloar, Trans. Faraday Soc. 40 (1944) 59: stretch and nominal stress, kg/cm^2.
#[test]
fn ogdens_fit_follows_treloars_measurements() {
    let rubber = treloar_rubber();
    let tension = [
        (1.9, 5.1),
        (3.02, 8.8),
        (4.03, 12.5),
        (5.36, 19.9),
        (6.15, 27.4),
        (6.85, 38.5),
        (7.25, 49.6),
    ];
    let biaxial = [
        (1.2, 3.32),
        (1.42, 5.18),
        (1.94, 7.78),
        (2.49, 9.79),
        (3.43, 14.7),
        (4.07, 20.1),
        (4.45, 24.7),
    ];
    let mut worst: f64 = 0.0;
    for (state, points) in [
        (uniaxial as fn(f64) -> [f64; 3], tension),
        (equibiaxial, biaxial),
    ] {
        for (l, measured) in points {
            let deviation = nominal(&rubber, state(l)) / (measured * KG_PER_CM2) - 1.0;
            println!(
                "stretch {l}: measured {measured} kg/cm^2, deviation {:.1} %",
                100.0 * deviation
            );
            worst = worst.max(deviation.abs());
        }
    }
    // The fit's own deviation, set after seeing it: 11.6 % at the stretch 1.9 and 10.4 % at the steep end. A wrong exponent
    // or weight is off by a multiple.
    assert!(worst < 0.12, "{worst}");
}

#[test]
fn simple_shear_gives_the_closed_forms() {
    for g in [0.1f64, 0.5, 1.0, 2.0] {
        let f = [[1.0, g, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        // Cauchy stress P F^T, J = 1; normal differences are free of the pressure.
        let cauchy = multiply(&RUBBER.stress(&f), &transpose(&f));
        assert!((cauchy[0][1] - 0.36 * g).abs() < 1e-14 * (1.0 + g));
        assert!(
            (cauchy[0][0] - cauchy[2][2] - 2.0 * RUBBER.c10 * g * g).abs() < 1e-14 * (1.0 + g * g)
        );
        assert!(
            (cauchy[1][1] - cauchy[2][2] + 2.0 * RUBBER.c01 * g * g).abs() < 1e-14 * (1.0 + g * g)
        );
        // I1 = 3 + g^2 and sigma_12 = 2 W'(I1) g.
        let yeoh = multiply(&YEOH.stress(&f), &transpose(&f))[0][1];
        let slope = YEOH.c10 + 2.0 * YEOH.c20 * g * g + 3.0 * YEOH.c30 * g.powi(4);
        assert!((yeoh - 2.0 * slope * g).abs() < 1e-14 * (1.0 + g));
        // Principal stretches l and 1 / l with l - 1 / l = g: sigma_12 is the principal difference times l / (1 + l^2).
        let l = 0.5 * (g + (g * g + 4.0).sqrt());
        let rubber = treloar_rubber();
        let terms = rubber.terms.iter();
        let difference: f64 = terms
            .map(|t| 2.0 * t.mu / t.alpha * (l.powf(t.alpha) - l.powf(-t.alpha)))
            .sum();
        let ogden = multiply(&rubber.stress(&f), &transpose(&f))[0][1];
        assert!((ogden - difference * l / (1.0 + l * l)).abs() < 1e-14 * (1.0 + g));
    }
}
