//! Figures of the thesis, for comparison.
//!
//! # Source
//! F. Novais, "A critical analysis on friction force models in dynamical systems", MSc thesis, University of Minho (2024).

/// Solvers of the thesis.
pub const CLASSES: [&str; 4] = ["ode45", "ode15s", "ode23s", "ode78"];

/// Average times of the thesis, Table 6.5, in s, with each of [`CLASSES`]. None where it did not converge.
pub const TABLE_6_5: &[(&str, [Option<f64>; 4])] = &[
    ("Karnopp", [Some(1.4239), Some(1.9092), None, Some(2.2380)]),
    ("BengisuAkay", [Some(1.7400), Some(2.4848), Some(1.3448), Some(2.6984)]),
    ("Andersson", [Some(2.6665), Some(2.3516), Some(1.2756), Some(4.2416)]),
    ("Awrejcewicz", [Some(1.4188), Some(2.2201), Some(1.1813), Some(2.1865)]),
    ("Specker", [Some(1.5924), Some(2.2854), Some(1.4331), Some(2.4739)]),
    ("LinearStiction", [Some(1.7217), Some(2.3644), Some(1.1405), Some(2.6100)]),
    ("Hollars", [Some(1.6364), Some(2.2919), Some(1.2626), Some(2.5369)]),
    ("BrownMcPhee", [Some(1.8278), Some(2.5609), Some(1.4607), Some(2.8658)]),
];
