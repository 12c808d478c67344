//! The contract of every isochoric law, and closed forms of Mooney-Rivlin.

use fem::material::{Isochoric, MooneyRivlin};
use fem::tensor::{Tensor, cofactor, determinant, multiply, transpose};
use proptest::prelude::*;

const RUBBER: MooneyRivlin = MooneyRivlin {
    c10: 0.144,
    c01: 0.036,
};

fn shifted(f: &Tensor, component: usize, step: f64) -> Tensor {
    let mut g = *f;
    g[component / 3][component % 3] += step;
    g
}

/// Largest difference between the stress and central differences of the energy, and between the tangent and those of the
/// stress.
fn difference_errors(material: &dyn Isochoric, f: &Tensor, h: f64) -> (f64, f64) {
    let (stress, tangent) = material.stress_and_tangent(f);
    let (mut in_stress, mut in_tangent): (f64, f64) = (0.0, 0.0);
    for c in 0..9 {
        let (plus, minus) = (shifted(f, c, h), shifted(f, c, -h));
        let slope = (material.energy(&plus) - material.energy(&minus)) / (2.0 * h);
        in_stress = in_stress.max((slope - stress[c / 3][c % 3]).abs());
        let (up, down) = (material.stress(&plus), material.stress(&minus));
        for r in 0..9 {
            let slope = (up[r / 3][r % 3] - down[r / 3][r % 3]) / (2.0 * h);
            in_tangent = in_tangent.max((slope - tangent[r][c]).abs());
        }
    }
    (in_stress, in_tangent)
}

/// What every law must satisfy at any deformation.
fn check_material(material: &dyn Isochoric, f: &Tensor) {
    let (stress, tangent) = material.stress_and_tangent(f);
    let size = stress
        .iter()
        .flatten()
        .fold(material.shear_modulus(), |m, p| m.max(p.abs()));
    assert_eq!(
        stress,
        material.stress(f),
        "both routes give the same stress"
    );
    for r in 0..9 {
        for c in 0..r {
            let asymmetry = (tangent[r][c] - tangent[c][r]).abs();
            // Sums of about ten terms of the tangent's size.
            let scale = tangent.iter().flatten().fold(0.0f64, |m, a| m.max(a.abs()));
            assert!(
                asymmetry <= 1e-14 * scale,
                "asymmetry {asymmetry:e} at {r} {c}"
            );
        }
    }
    // Central differences err by h^2 times a third derivative, until round-off: halving h divides the error by four.
    let (coarse, fine) = (
        difference_errors(material, f, 2e-3),
        difference_errors(material, f, 1e-3),
    );
    for (name, coarse, fine) in [("stress", coarse.0, fine.0), ("tangent", coarse.1, fine.1)] {
        let slope = (coarse / fine).log2();
        assert!(
            (slope - 2.0).abs() < 0.1 || fine < 1e-11 * size / 1e-3,
            "{name}: slope {slope}, error {fine:e}"
        );
    }
    // Isochoric: uniform scaling changes nothing, so the stress is orthogonal to F.
    let work: f64 = stress
        .iter()
        .flatten()
        .zip(f.iter().flatten())
        .map(|(p, f)| p * f)
        .sum();
    assert!(
        work.abs() < 1e-13 * size * 10.0,
        "dilatational work {work:e}"
    );
}

fn rotation(axis: [f64; 3], angle: f64) -> Tensor {
    let length = axis.iter().map(|a| a * a).sum::<f64>().sqrt();
    let [x, y, z] = axis.map(|a| a / length);
    let (s, c) = angle.sin_cos();
    let t = 1.0 - c;
    [
        [t * x * x + c, t * x * y - s * z, t * x * z + s * y],
        [t * x * y + s * z, t * y * y + c, t * y * z - s * x],
        [t * x * z - s * y, t * y * z + s * x, t * z * z + c],
    ]
}

fn deformations() -> impl Strategy<Value = Tensor> {
    prop::array::uniform9(-0.35..0.35f64)
        .prop_map(|d| {
            let mut f = fem::tensor::IDENTITY;
            for c in 0..9 {
                f[c / 3][c % 3] += d[c];
            }
            f
        })
        .prop_filter("not inverted", |f| determinant(f) > 0.3)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn the_contract_holds_at_random_deformations(f in deformations()) {
        check_material(&RUBBER, &f);
        check_material(&MooneyRivlin { c10: 0.4, c01: 0.0 }, &f);
    }

    #[test]
    fn a_rotation_of_the_frame_turns_the_stress_and_leaves_the_energy(
        f in deformations(), axis in prop::array::uniform3(0.1..1.0f64), angle in -3.0..3.0f64,
    ) {
        let q = rotation(axis, angle);
        let turned = multiply(&q, &f);
        let size = RUBBER.shear_modulus();
        prop_assert!((RUBBER.energy(&turned) - RUBBER.energy(&f)).abs() < 1e-12 * size);
        let (expected, stress) = (multiply(&q, &RUBBER.stress(&f)), RUBBER.stress(&turned));
        for (a, b) in stress.iter().flatten().zip(expected.iter().flatten()) {
            prop_assert!((a - b).abs() < 1e-12 * size);
        }
        // Isotropy: a rotation of the reference turns the stress from the right.
        let rotated = multiply(&f, &transpose(&q));
        let expected = multiply(&RUBBER.stress(&f), &transpose(&q));
        for (a, b) in RUBBER.stress(&rotated).iter().flatten().zip(expected.iter().flatten()) {
            prop_assert!((a - b).abs() < 1e-12 * size);
        }
    }
}

#[test]
fn the_reference_state_is_free_of_stress_and_has_the_shear_modulus() {
    let (stress, tangent) = RUBBER.stress_and_tangent(&fem::tensor::IDENTITY);
    assert_eq!(RUBBER.energy(&fem::tensor::IDENTITY), 0.0);
    assert!(stress.iter().flatten().all(|p| p.abs() < 1e-16));
    // A_1212 of an isochoric law in the stress-free reference is the shear modulus.
    assert!((tangent[1][1] - 0.36).abs() < 1e-15, "{}", tangent[1][1]);
}

/// Nominal stress of a volume-preserving stretch whose third direction is free.
fn nominal(stretches: [f64; 3]) -> [f64; 3] {
    let f = [
        [stretches[0], 0.0, 0.0],
        [0.0, stretches[1], 0.0],
        [0.0, 0.0, stretches[2]],
    ];
    let (stress, g) = (RUBBER.stress(&f), cofactor(&f));
    let p = -stress[2][2] / g[2][2];
    [0, 1, 2].map(|i| stress[i][i] + p * g[i][i])
}

#[test]
fn homogeneous_stretches_give_the_closed_forms() {
    let (c10, c01) = (RUBBER.c10, RUBBER.c01);
    for l in [0.5f64, 0.8, 1.1, 1.5, 2.0, 3.0] {
        let uniaxial = nominal([l, l.powf(-0.5), l.powf(-0.5)])[0];
        assert!(
            (uniaxial - 2.0 * (c10 + c01 / l) * (l - l.powi(-2))).abs()
                < 1e-14 * (1.0 + uniaxial.abs()) * 10.0
        );
        let equibiaxial = nominal([l, l, l.powi(-2)])[0];
        let exact = 2.0 * (c10 + c01 * l * l) * (l - l.powi(-5));
        assert!(
            (equibiaxial - exact).abs() < 1e-13 * (1.0 + exact.abs()),
            "{equibiaxial} {exact}"
        );
        let planar = nominal([l, 1.0, 1.0 / l])[0];
        let exact = 2.0 * (c10 + c01) * (l - l.powi(-3));
        assert!(
            (planar - exact).abs() < 1e-13 * (1.0 + exact.abs()),
            "{planar} {exact}"
        );
    }
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
    }
}

#[test]
fn von_mises_of_stretches_is_that_of_the_cauchy_stress() {
    let l = [1.3, 0.9, 1.0 / (1.3 * 0.9)];
    let f = [[l[0], 0.0, 0.0], [0.0, l[1], 0.0], [0.0, 0.0, l[2]]];
    let stress = RUBBER.stress(&f);
    let s = [0, 1, 2].map(|i| stress[i][i] * l[i]);
    let expected =
        (0.5 * ((s[0] - s[1]).powi(2) + (s[1] - s[2]).powi(2) + (s[2] - s[0]).powi(2))).sqrt();
    assert!((RUBBER.von_mises(l) - expected).abs() < 1e-15);
}
