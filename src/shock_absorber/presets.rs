//! Named parameter sets of the shock absorber.

use crate::model::Preset;

/// All presets.
pub(crate) const ALL: &[Preset] = &[
    Preset { name: "front", source: "Formula Student, front axle: the start values", values: &[] },
    Preset {
        name: "rear",
        source: "Formula Student, rear axle: spring of Zips Racing ZR26 (MIT licence), otherwise as front",
        values: &[("spring.k", 35_000.0)],
    },
    Preset {
        name: "damper_table",
        source: "Example of a digressive damper: the table of the start values",
        values: &[("damper.mode", 2.0)],
    },
    Preset {
        name: "magnetorheological",
        source: "Spencer, Dyke, Sain, Carlson (1997): their damper, whose accumulator the spring replaces; otherwise as front",
        values: &[("damper.mode", 4.0)],
    },
    Preset {
        name: "frictionless",
        source: "Example without friction: the start values otherwise",
        values: &[("friction.model", 1.0)],
    },
    Preset {
        name: "damper_and_friction",
        source: "Example for a host with its own spring and stops; the guidance is derived from length and stroke",
        values: &[
            ("spring.enabled", 0.0),
            ("gas.enabled", 0.0),
            ("bump.enabled", 0.0),
            ("rebound.enabled", 0.0),
            ("geom.guidance_derived", 1.0),
        ],
    },
    published("koelsch_1994", "Koelsch 1994: 25 N (Novais 2024, Table 2.1)", &const { levels(25.0, 25.0) }),
    published(
        "manger_1995_low",
        "Manger 1995: lower end of 30 N to 45 N (Novais 2024, Table 2.1)",
        &const { levels(30.0, 30.0) },
    ),
    published(
        "manger_1995_high",
        "Manger 1995: upper end of 30 N to 45 N (Novais 2024, Table 2.1)",
        &const { levels(45.0, 45.0) },
    ),
    published(
        "lizarraga_2008_measured",
        "Lizarraga 2008, measured: 22 N in compression, 15 N in extension (Novais 2024, Table 2.1)",
        &const { levels(22.0, 15.0) },
    ),
    published(
        "lizarraga_2008_simulated",
        "Lizarraga 2008, simulated: 32 N in compression, 23 N in extension (Novais 2024, Table 2.1)",
        &const { levels(32.0, 23.0) },
    ),
    published(
        "fujimoto_2018_low",
        "Fujimoto 2018: lower end of 20 N to 150 N (Novais 2024, Table 2.1)",
        &const { levels(20.0, 20.0) },
    ),
    published(
        "fujimoto_2018_high",
        "Fujimoto 2018: upper end of 20 N to 150 N (Novais 2024, Table 2.1)",
        &const { levels(150.0, 150.0) },
    ),
    published(
        "wegener_2020_low",
        "Wegener 2020: half of the lower end of 75 N to 350 N per axle (Novais 2024, Table 2.1)",
        &const { levels(37.5, 37.5) },
    ),
    published(
        "wegener_2020_high",
        "Wegener 2020: half of the upper end of 75 N to 350 N per axle (Novais 2024, Table 2.1)",
        &const { levels(175.0, 175.0) },
    ),
    published(
        "koerner_mayer_2020_low",
        "Koerner and Mayer 2020: lower end of 20 N to 70 N in compression and 10 N to 40 N in extension (Novais 2024, Table 2.1)",
        &const { levels(20.0, 10.0) },
    ),
    published(
        "koerner_mayer_2020_high",
        "Koerner and Mayer 2020: upper end of 20 N to 70 N in compression and 10 N to 40 N in extension (Novais 2024, Table 2.1)",
        &const { levels(70.0, 40.0) },
    ),
    published(
        "herzog_augsburg_2021",
        "Herzog and Augsburg 2021: 35 N in compression, 30 N in extension (Novais 2024, Table 2.1; doi:10.3390/vehicles3020014)",
        &const { levels(35.0, 30.0) },
    ),
    published(
        "deubel_prokop_2024_low",
        "Deubel and Prokop 2024, with side load: lower end of 62 N to 134 N (Novais 2024, Table 2.1; doi:10.1177/09544070231201688)",
        &const { levels(62.0, 62.0) },
    ),
    published(
        "deubel_prokop_2024_high",
        "Deubel and Prokop 2024, with side load: upper end of 62 N to 134 N (Novais 2024, Table 2.1; doi:10.1177/09544070231201688)",
        &const { levels(134.0, 134.0) },
    ),
];

const fn published(name: &'static str, source: &'static str, values: &'static Levels) -> Preset {
    Preset { name, source, values }
}

type Levels = [(&'static str, f64); 9];

/// Friction measured at slow motion, in N, as one contact independent of the load. The sources give no breakaway peak,
/// so there is none.
const fn levels(compression: f64, extension: f64) -> Levels {
    let level = 0.5 * (compression + extension);
    [
        ("c1.mu_s", 0.0),
        ("c1.mu_k", 0.0),
        ("c1.preload_s", level),
        ("c1.preload_k", level),
        ("c2.mu_s", 0.0),
        ("c2.mu_k", 0.0),
        ("c2.preload_s", 0.0),
        ("c2.preload_k", 0.0),
        ("friction.asymmetry", (compression - extension) / (compression + extension)),
    ]
}
