//! Figures that the published study prints of its estimators: its tables 4, 5, 6, 8 and 9, one by one.

use estimation::recipe::{FeatureSet, Kind};

/// Names of the forces, in the order of the printed rows.
pub const AXES: [&str; 3] = ["fx", "fy", "fz"];

/// NRMSE of the ablation, %: forces along, across and vertical.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Ablation {
    /// Number of the table.
    pub table: u32,
    /// The model.
    pub model: Kind,
    /// The features it was given.
    pub features: FeatureSet,
    /// %
    pub nrmse_percent: [f64; 3],
}

/// Tables 4 and 5. "Without slopes" is given values and rolling statistics.
pub(crate) const ABLATIONS: [Ablation; 8] = [
    ablation(4, Kind::Gpr, FeatureSet::Raw, [10.96, 1.33, 20.42]),
    ablation(4, Kind::Gpr, FeatureSet::Rolling, [6.74, 7.42, 17.88]),
    ablation(4, Kind::Gpr, FeatureSet::Slopes, [8.74, 7.91, 17.13]),
    ablation(4, Kind::Gpr, FeatureSet::All, [7.53, 7.39, 16.53]),
    ablation(5, Kind::Ann, FeatureSet::Raw, [8.56, 8.50, 12.46]),
    ablation(5, Kind::Ann, FeatureSet::Rolling, [7.35, 7.76, 9.11]),
    ablation(5, Kind::Ann, FeatureSet::Slopes, [7.47, 7.75, 9.82]),
    ablation(5, Kind::Ann, FeatureSet::All, [6.66, 7.47, 8.04]),
];

const fn ablation(
    table: u32,
    model: Kind,
    features: FeatureSet,
    nrmse_percent: [f64; 3],
) -> Ablation {
    Ablation {
        table,
        model,
        features,
        nrmse_percent,
    }
}

/// NRMSE, %; RMSE, N; R2.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Triple {
    /// %
    pub nrmse_percent: f64,
    /// N
    pub rmse_n: f64,
    /// Coefficient of determination.
    pub r2: f64,
}

/// Two cells of one force in one printed row.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pair {
    /// Name of the gait.
    pub gait: &'static str,
    /// The first and the second cell of each force.
    pub cells: [[Triple; 2]; 3],
}

/// Table 6: a Gaussian process and a neural network.
pub const FREQUENCIES: [Pair; 3] = [
    Pair {
        gait: "1 Hz",
        cells: [
            [
                triple(12.71, 0.2310, -0.3510),
                triple(14.47, 0.2628, -0.7526),
            ],
            [
                triple(9.17, 0.2361, -0.0831),
                triple(14.09, 0.3627, -1.5603),
            ],
            [
                triple(14.22, 1.2448, -0.3668),
                triple(13.58, 2.3793, 0.5702),
            ],
        ],
    },
    Pair {
        gait: "2 Hz",
        cells: [
            [triple(9.03, 0.1569, 0.3433), triple(13.71, 0.2381, -0.5144)],
            [triple(9.11, 0.2208, 0.4215), triple(12.45, 0.3016, -0.0808)],
            [triple(19.58, 1.6984, 0.4275), triple(19.91, 1.7272, 0.4076)],
        ],
    },
    Pair {
        gait: "5 Hz",
        cells: [
            [
                triple(11.23, 0.1515, 0.5152),
                triple(36.12, 0.4873, -4.0197),
            ],
            [
                triple(18.55, 0.2433, 0.2151),
                triple(36.05, 0.4728, -1.9664),
            ],
            [triple(20.89, 2.5322, 0.4426), triple(17.26, 2.0916, 0.6197)],
        ],
    },
];

/// Gaits of tables 8 and 9.
pub const LOW: &str = "low frequency";
/// See [`LOW`].
pub(crate) const HIGH: &str = "high frequency";
/// See [`LOW`].
pub(crate) const TRANSITION: &str = "gait transition";

/// Table 8: a Gaussian process before and after temporal cross-validation.
pub(crate) const PROCESSES: [Pair; 3] = [
    Pair {
        gait: LOW,
        cells: [
            [triple(10.17, 0.1416, 0.7047), triple(10.05, 0.1399, 0.7116)],
            [triple(12.13, 0.1412, 0.6194), triple(12.87, 0.1497, 0.0706)],
            [triple(17.81, 1.4161, 0.6194), triple(15.47, 1.2305, 0.7126)],
        ],
    },
    Pair {
        gait: HIGH,
        cells: [
            [triple(11.49, 0.2266, 0.6313), triple(11.25, 0.2219, 0.6465)],
            [triple(9.11, 0.1181, 0.6911), triple(9.77, 0.1266, 0.6451)],
            [triple(21.71, 1.9763, 0.5424), triple(19.84, 1.7332, 0.6480)],
        ],
    },
    Pair {
        gait: TRANSITION,
        cells: [
            [triple(15.37, 0.1710, 0.3885), triple(15.56, 0.1731, 0.3730)],
            [triple(10.77, 0.1921, 0.1657), triple(10.36, 0.1848, 0.2280)],
            [triple(22.37, 2.0179, 0.3816), triple(20.12, 1.8144, 0.5001)],
        ],
    },
];

/// Table 9: a neural network before and after.
pub(crate) const NETWORKS: [Pair; 3] = [
    Pair {
        gait: LOW,
        cells: [
            [triple(16.25, 0.2262, 0.2445), triple(16.19, 0.2255, 0.2496)],
            [triple(13.09, 0.1523, 0.0362), triple(11.17, 0.1300, 0.2977)],
            [triple(14.64, 1.1640, 0.7424), triple(18.42, 1.4647, 0.5922)],
        ],
    },
    Pair {
        gait: HIGH,
        cells: [
            [triple(12.34, 0.2434, 0.5745), triple(17.13, 0.3378, 0.1800)],
            [triple(17.77, 0.2304, 0.1756), triple(18.90, 0.2451, 0.3301)],
            [triple(21.85, 1.9889, 0.5362), triple(16.42, 1.4948, 0.7380)],
        ],
    },
    Pair {
        gait: TRANSITION,
        cells: [
            [triple(20.24, 0.2251, 0.0629), triple(18.35, 0.2041, 0.1262)],
            [triple(9.93, 0.1771, 0.2883), triple(11.66, 0.2081, 0.0179)],
            [triple(20.17, 1.8189, 0.4965), triple(15.43, 1.3914, 0.7053)],
        ],
    },
];

const fn triple(nrmse_percent: f64, rmse_n: f64, r2: f64) -> Triple {
    Triple {
        nrmse_percent,
        rmse_n,
        r2,
    }
}
