//! The contract of every law, and what the constructors refuse.

use gsa::law::distribution::{Distribution, DistributionError};
use gsa::law::rule::RuleError;

/// Checks what holds for every law.
fn check_distribution(law: Distribution) {
    for k in 1..1000 {
        let p = f64::from(k) / 1000.0;
        let x = law.inverse_cdf(p);
        // The cdf has a few eps, and x one, which weighs what its neighbours differ by.
        let conditioning = law.cdf(x.next_up()) - law.cdf(x.next_down());
        assert!(
            (law.cdf(x) - p).abs() < 1e-13 + conditioning,
            "{law:?} p = {p} {:e}",
            law.cdf(x) - p
        );
    }
    assert!(law.cdf(law.mean()) > 0.0 && law.cdf(law.mean()) < 1.0);
    let rule = law.gauss_rule(20).expect("a rule");
    let moment = |f: &dyn Fn(f64) -> f64| -> f64 {
        rule.nodes
            .iter()
            .zip(&rule.weights)
            .map(|(&x, w)| w * f(x))
            .sum()
    };
    let mean = moment(&|x| x);
    let variance = moment(&|x| (x - law.mean()) * (x - law.mean()));
    // 20 Hermite nodes integrate exp(2 sigma t), sigma <= 1, to 1e-12 (remainder (2 sigma)^40 / 40! * 20!)
    assert!(
        (mean - law.mean()).abs() <= 1e-12 * (law.mean().abs() + law.std()),
        "{law:?}"
    );
    assert!(
        (variance.sqrt() - law.std()).abs() <= 1e-10 * law.std(),
        "{law:?}"
    );
    assert!(
        rule.nodes
            .iter()
            .all(|&x| x >= law.inverse_cdf(0.0) && x <= law.inverse_cdf(1.0))
    );
}

#[test]
fn every_law_keeps_the_contract() {
    check_distribution(Distribution::uniform(0.7, 1.3).unwrap());
    check_distribution(Distribution::uniform(-5e150, 2e151).unwrap());
    check_distribution(Distribution::normal(0.0, 1.0).unwrap());
    check_distribution(Distribution::normal(-3.0, 0.02).unwrap());
    check_distribution(Distribution::lognormal(7.71, 1.0056).unwrap());
    check_distribution(Distribution::lognormal(-2.0, 0.1).unwrap());
    check_distribution(Distribution::exponential(0.4).unwrap());
    check_distribution(Distribution::gamma(0.2, 3.0).unwrap());
    check_distribution(Distribution::gamma(2.5, 3.0).unwrap());
    check_distribution(Distribution::gamma(1e4, 1e-3).unwrap());
    check_distribution(Distribution::weibull(0.6, 2.0).unwrap());
    check_distribution(Distribution::weibull(3.0, 2.0).unwrap());
    check_distribution(Distribution::beta(0.3, 0.4, -1.0, 1.0).unwrap());
    check_distribution(Distribution::beta(2.0, 7.0, 0.0, 1.0).unwrap());
    check_distribution(Distribution::gumbel(-1.0, 0.3).unwrap());
    check_distribution(Distribution::triangular(1.0, 1.5, 4.0).unwrap());
    check_distribution(Distribution::triangular(-3.0, 4.0, 4.0).unwrap());
    for (law, low, high) in [
        (Distribution::normal(0.0, 1.0), 6.0, 8.0),
        (Distribution::normal(0.0, 1.0), -2.0, 1.0),
        (Distribution::lognormal(0.0, 0.8), 0.5, 4.0),
        (Distribution::gamma(2.5, 3.0), 1.0, 20.0),
        (Distribution::weibull(0.6, 2.0), 0.0, 5.0),
        (Distribution::gumbel(1013.0, 558.0), 500.0, 3000.0),
        (Distribution::beta(0.3, 0.4, 0.0, 1.0), 0.0, 0.5),
        (Distribution::triangular(0.0, 1.0, 4.0), 0.5, 3.0),
        (Distribution::uniform(0.0, 9.0), -1.0, 3.0),
        (Distribution::exponential(1.0), 30.0, 40.0),
    ] {
        check_distribution(law.unwrap().truncated(low, high).unwrap());
    }
}

#[test]
fn middle_node_is_the_mean_to_the_bit() {
    for law in [
        Distribution::uniform(0.7, 1.3).unwrap(),
        Distribution::uniform(0.1, 0.30000000000000004).unwrap(),
        Distribution::normal(0.1, 0.3).unwrap(),
        Distribution::beta(0.4, 0.4, 0.7, 1.3).unwrap(),
        Distribution::triangular(0.7, 1.0, 1.3).unwrap(),
        Distribution::normal(1.0, 0.3)
            .unwrap()
            .truncated(0.7, 1.3)
            .unwrap(),
        Distribution::uniform(0.0, 9.0)
            .unwrap()
            .truncated(0.7, 1.3)
            .unwrap(),
    ] {
        for nodes in (1..=63).step_by(2) {
            assert_eq!(
                law.gauss_rule(nodes).unwrap().nodes[nodes / 2].to_bits(),
                law.mean().to_bits()
            );
        }
    }
}

#[test]
fn quantiles_match_tables() {
    let normal = Distribution::normal(0.0, 1.0).unwrap();
    // 30-digit values of sqrt(2) erfinv(2p - 1)
    let table = [
        (1e-09, -5.9978070150076865),
        (0.003, -2.7477813854449926),
        (0.023, -1.9953933101678247),
        (0.1, -1.2815515655446004),
        (0.4, -0.2533471031357997),
        (0.975, 1.9599639845400538),
    ];
    for (p, z) in table {
        assert!(
            (normal.inverse_cdf(p) - z).abs() < 1e-14 * z.abs(),
            "{p} {z} {}",
            normal.inverse_cdf(p)
        );
    }
    // 30-digit values of Phi(z)
    let table = [
        (-6.0, 9.86587645037698e-10),
        (-2.0, 0.02275013194817921),
        (-0.5, 0.3085375387259869),
        (0.25, 0.5987063256829237),
        (3.0, 0.9986501019683699),
    ];
    for (z, p) in table {
        // The density turns an eps of z into z^2 eps of a small p.
        assert!(
            (normal.cdf(z) - p).abs() < 1e-14 * p,
            "{z} {p} {}",
            normal.cdf(z)
        );
    }
    assert_eq!((normal.cdf(-400.0), normal.cdf(400.0)), (0.0, 1.0));
    let uniform = Distribution::uniform(-1.0, 3.0).unwrap();
    assert_eq!(
        (uniform.inverse_cdf(0.0), uniform.inverse_cdf(1.0)),
        (-1.0, 3.0)
    );
    assert_eq!((uniform.cdf(-9.0), uniform.cdf(9.0)), (0.0, 1.0));
}

#[test]
fn invalid_laws_cannot_be_built() {
    use DistributionError::*;
    assert_eq!(
        Distribution::uniform(1.0, 1.0),
        Err(EmptyRange { min: 1.0, max: 1.0 })
    );
    assert_eq!(
        Distribution::uniform(2.0, 1.0),
        Err(EmptyRange { min: 2.0, max: 1.0 })
    );
    assert!(matches!(
        Distribution::uniform(f64::NAN, 1.0),
        Err(NotFinite {
            parameter: "min",
            ..
        })
    ));
    assert!(matches!(
        Distribution::uniform(0.0, f64::INFINITY),
        Err(NotFinite {
            parameter: "max",
            ..
        })
    ));
    assert!(matches!(
        Distribution::uniform(-1.7e308, 1.7e308),
        Err(MomentOutOfRange { .. })
    ));
    assert_eq!(
        Distribution::normal(0.0, 0.0),
        Err(NotPositive {
            parameter: "std",
            value: 0.0
        })
    );
    assert!(matches!(
        Distribution::normal(f64::NEG_INFINITY, 1.0),
        Err(NotFinite { .. })
    ));
    assert_eq!(
        Distribution::lognormal(0.0, -1.0),
        Err(NotPositive {
            parameter: "sigma",
            value: -1.0
        })
    );
    for (mu, sigma) in [(800.0, 1.0), (0.0, 40.0), (-800.0, 1.0), (0.0, 1e200)] {
        assert_eq!(
            Distribution::lognormal(mu, sigma),
            Err(MomentOutOfRange { kind: "lognormal" })
        );
    }
}

#[test]
fn a_law_too_narrow_for_its_mean_has_no_rule() {
    let law = Distribution::normal(1.0, 1e-17).unwrap();
    assert_eq!(
        law.gauss_rule(5),
        Err(RuleError::Coincident { index: 0, nodes: 5 })
    );
    let law = Distribution::lognormal(650.0, 7.0).unwrap();
    assert!(matches!(
        law.gauss_rule(64),
        Err(RuleError::OutOfRange { .. })
    ));
}

#[test]
fn documents_read_names_and_parameters() {
    let law = Distribution::lognormal(0.0, 0.8).unwrap();
    assert_eq!(law.kind(), "lognormal");
    assert_eq!(law.parameters(), [("mu", 0.0), ("sigma", 0.8)]);
}

#[test]
fn extremes_are_right_or_named() {
    use DistributionError::*;
    let shape = |parameter, value| Err(ShapeOutOfRange { parameter, value });
    assert_eq!(Distribution::gamma(1e-7, 1.0), shape("shape", 1e-7));
    assert_eq!(Distribution::beta(1.0, 1e13, 0.0, 1.0), shape("beta", 1e13));
    // The second moment, Gamma(1 + 200), is beyond 1e308.
    let out = |kind| Err(MomentOutOfRange { kind });
    assert_eq!(Distribution::weibull(0.01, 1.0), out("weibull"));
    assert_eq!(Distribution::exponential(1e-310), out("exponential"));
    // Polynomials of degree 64 reach out to where no double holds the weight.
    let heavy = Distribution::weibull(0.1, 1.0).unwrap();
    assert!(heavy.gauss_rule(5).is_ok());
    assert_eq!(
        heavy.gauss_rule(64),
        Err(RuleError::NotConverged { nodes: 64 })
    );
    let normal = Distribution::normal(0.0, 1.0).unwrap();
    let cut = |low, high| normal.truncated(low, high);
    assert_eq!(
        cut(2.0, 1.0),
        Err(EmptyTruncation {
            low: 2.0,
            high: 1.0
        })
    );
    assert!(matches!(cut(0.0, f64::NAN), Err(NotFinite { .. })));
    assert_eq!(
        cut(0.0, 1.0).and_then(|law| law.truncated(0.0, 0.5)),
        Err(TruncatedTwice)
    );
    let beta = Distribution::beta(2.0, 2.0, 0.0, 1.0).unwrap();
    let nothing = NothingLeft {
        low: 1.0,
        high: 2.0,
    };
    assert_eq!(beta.truncated(1.0, 2.0), Err(nothing));
    // Three doubles have no room for five nodes.
    let narrow = cut(1.0, 1.0 + 2.0 * f64::EPSILON).unwrap();
    assert!(matches!(
        narrow.gauss_rule(5),
        Err(RuleError::Coincident { .. })
    ));
}

#[test]
fn a_truncation_beyond_the_law_changes_nothing() {
    // Between ends where no more than 1e-20 of the law is left, all but the outermost weights stay.
    for (law, low, high) in [
        (Distribution::lognormal(0.0, 0.5), -1.0, 1e4),
        (Distribution::gamma(3.0, 1.0), -5.0, 1e4),
        (Distribution::normal(0.0, 1.0), -30.0, 30.0),
        (Distribution::beta(2.0, 5.0, 0.0, 1.0), -1.0, 2.0),
    ] {
        let law = law.unwrap();
        let cut = law.truncated(low, high).unwrap();
        assert!((cut.mean() / law.mean() - 1.0).abs() < 1e-14 || law.mean() == 0.0);
        assert!((cut.std() / law.std() - 1.0).abs() < 1e-14, "{law:?}");
        let (a, b) = (law.gauss_rule(9).unwrap(), cut.gauss_rule(9).unwrap());
        for j in 0..9 {
            // as in tests/rules.rs: (N^2 + 64) eps, from either rule
            assert!((a.weights[j] / b.weights[j] - 1.0).abs() < 2.0 * 145.0 * f64::EPSILON);
            let size = a.nodes[j].abs().max(law.std());
            assert!((a.nodes[j] - b.nodes[j]).abs() < 1e-13 * size, "{law:?}");
        }
    }
}
