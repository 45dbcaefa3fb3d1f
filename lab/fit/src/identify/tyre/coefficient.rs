//! Coefficients of the Magic Formula 5.2 and 6.1 as parameters: where they are searched, and what a test needs to show
//! them.

use stribeck::host::FormulaVersion;

/// Excitation that a test must have so that a coefficient can be seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Needs {
    /// Slip to both sides, beyond the peak of the force.
    Slip,
    /// Several loads.
    Load,
    /// Several cambers.
    Camber,
    /// Longitudinal slip and side slip at once.
    Both,
    /// Several inflation pressures.
    Pressure,
}

impl Needs {
    /// The remedy, in words.
    pub fn remedy(self) -> &'static str {
        match self {
            Needs::Slip => "sweep the slip to both sides, beyond the peak of the force",
            Needs::Load => "test at more loads",
            Needs::Camber => "test at more cambers, to both sides",
            Needs::Both => "test braking and cornering at once",
            Needs::Pressure => "test at more inflation pressures",
        }
    }
}

/// A coefficient as a parameter; all numbers are chosen from published sets.
#[derive(Clone, Copy, Debug)]
pub(super) struct Coefficient {
    /// Name in the library; the key of a file in upper case.
    pub name: &'static str,
    /// Value from which it is searched.
    pub start: f64,
    /// Range in which it is searched.
    pub range: [f64; 2],
    /// Change that is large.
    pub large: f64,
    /// Measurement that shows it.
    pub needs: Needs,
}

const fn coefficient(name: &'static str, start: f64, range: [f64; 2], large: f64, needs: Needs) -> Coefficient {
    Coefficient { name, start, range, large, needs }
}

use Needs::{Both, Camber, Load, Pressure, Slip};

/// Coefficients that are found together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Group {
    Lateral,
    Longitudinal,
    CombinedX,
    CombinedY,
    Aligning,
    Arm,
}

/// Number of the groups.
pub(super) const GROUPS: usize = 6;

/// The groups of a version of the formula, in the order of [`Group`].
pub(super) fn groups(version: FormulaVersion) -> [Vec<&'static Coefficient>; GROUPS] {
    const FIVE: [&[Coefficient]; GROUPS] = [LATERAL, LONGITUDINAL, COMBINED_X, COMBINED_Y, ALIGNING, ARM];
    const SIX: [&[Coefficient]; GROUPS] = [LATERAL_6, LONGITUDINAL_6, COMBINED_X_6, COMBINED_Y_6, ALIGNING_6, &[]];
    let is_six = version == FormulaVersion::Six;
    std::array::from_fn(|group| {
        let more = if is_six { SIX[group] } else { &[] };
        FIVE[group].iter().filter(|one| !(is_six && one.name == ONLY_FIVE)).chain(more).collect()
    })
}

/// The coefficient that only version 5.2 has.
const ONLY_FIVE: &str = "phy3";

/// Force along y in pure side slip.
const LATERAL: &[Coefficient] = &[
    coefficient("pcy1", 1.4, [0.8, 2.4], 0.4, Slip),
    coefficient("pdy1", 1.2, [0.1, 4.0], 0.3, Slip),
    coefficient("pdy2", -0.1, [-2.0, 2.0], 0.2, Load),
    coefficient("pdy3", 0.0, [-30.0, 30.0], 3.0, Camber),
    coefficient("pey1", -0.5, [-15.0, 1.0], 1.0, Slip),
    coefficient("pey2", 0.0, [-10.0, 10.0], 1.0, Load),
    coefficient("pey3", 0.0, [-5.0, 5.0], 0.5, Slip),
    coefficient("pey4", 0.0, [-40.0, 40.0], 5.0, Camber),
    coefficient("pky1", -30.0, [-200.0, -1.0], 10.0, Load),
    coefficient("pky2", 2.0, [0.2, 20.0], 1.0, Load),
    coefficient("pky3", 0.0, [-10.0, 10.0], 0.5, Camber),
    coefficient("phy1", 0.0, [-0.1, 0.1], 0.005, Slip),
    coefficient("phy2", 0.0, [-0.1, 0.1], 0.005, Load),
    coefficient("phy3", 0.0, [-1.0, 1.0], 0.05, Camber),
    coefficient("pvy1", 0.0, [-0.5, 0.5], 0.03, Slip),
    coefficient("pvy2", 0.0, [-0.5, 0.5], 0.03, Load),
    coefficient("pvy3", 0.0, [-5.0, 5.0], 0.3, Camber),
    coefficient("pvy4", 0.0, [-5.0, 5.0], 0.3, Camber),
];

/// Force along x in pure longitudinal slip.
const LONGITUDINAL: &[Coefficient] = &[
    coefficient("pcx1", 1.6, [0.8, 2.4], 0.4, Slip),
    coefficient("pdx1", 1.2, [0.1, 4.0], 0.3, Slip),
    coefficient("pdx2", -0.1, [-2.0, 2.0], 0.2, Load),
    coefficient("pdx3", 0.0, [-30.0, 30.0], 3.0, Camber),
    // Not from 0, where pex4 changes nothing.
    coefficient("pex1", 0.3, [-15.0, 1.0], 1.0, Slip),
    coefficient("pex2", 0.0, [-10.0, 10.0], 1.0, Load),
    coefficient("pex3", 0.0, [-10.0, 10.0], 1.0, Load),
    coefficient("pex4", 0.0, [-5.0, 5.0], 0.5, Slip),
    coefficient("pkx1", 25.0, [1.0, 200.0], 10.0, Slip),
    coefficient("pkx2", 0.0, [-100.0, 100.0], 10.0, Load),
    coefficient("pkx3", 0.0, [-5.0, 5.0], 0.3, Load),
    coefficient("phx1", 0.0, [-0.1, 0.1], 0.005, Slip),
    coefficient("phx2", 0.0, [-0.1, 0.1], 0.005, Load),
    coefficient("pvx1", 0.0, [-0.5, 0.5], 0.03, Slip),
    coefficient("pvx2", 0.0, [-0.5, 0.5], 0.03, Load),
];

/// Reduction of the force along x by side slip. The formula is even in `rbx2`.
const COMBINED_X: &[Coefficient] = &[
    coefficient("rbx1", 12.0, [1.0, 60.0], 5.0, Both),
    coefficient("rbx2", 10.0, [0.0, 60.0], 5.0, Both),
    coefficient("rcx1", 1.0, [0.3, 2.0], 0.3, Both),
    coefficient("rex1", 0.0, [-10.0, 1.0], 1.0, Both),
    coefficient("rex2", 0.0, [-5.0, 5.0], 1.0, Load),
    coefficient("rhx1", 0.0, [-0.1, 0.1], 0.01, Both),
];

/// Reduction of the force along y by longitudinal slip. The formula is even in `rby2` and `rvy4`, and does not change
/// if `rvy5` and `rvy6` both change sign.
const COMBINED_Y: &[Coefficient] = &[
    coefficient("rby1", 10.0, [1.0, 60.0], 5.0, Both),
    coefficient("rby2", 10.0, [0.0, 60.0], 5.0, Both),
    coefficient("rby3", 0.0, [-0.1, 0.1], 0.02, Both),
    coefficient("rcy1", 1.0, [0.3, 2.0], 0.3, Both),
    coefficient("rey1", 0.0, [-10.0, 1.0], 1.0, Both),
    coefficient("rey2", 0.0, [-5.0, 5.0], 1.0, Load),
    coefficient("rhy1", 0.0, [-0.1, 0.1], 0.01, Both),
    coefficient("rhy2", 0.0, [-0.1, 0.1], 0.01, Load),
    coefficient("rvy1", 0.01, [-2.0, 2.0], 0.1, Both),
    coefficient("rvy2", 0.0, [-2.0, 2.0], 0.1, Load),
    coefficient("rvy3", 0.0, [-100.0, 100.0], 10.0, Camber),
    coefficient("rvy4", 10.0, [0.0, 60.0], 10.0, Both),
    coefficient("rvy5", 1.9, [0.2, 4.0], 1.0, Both),
    coefficient("rvy6", 10.0, [0.0, 60.0], 10.0, Both),
];

/// Moment about z in pure side slip.
const ALIGNING: &[Coefficient] = &[
    coefficient("qbz1", 10.0, [0.1, 60.0], 5.0, Slip),
    coefficient("qbz2", 0.0, [-30.0, 30.0], 3.0, Load),
    coefficient("qbz3", 0.0, [-30.0, 30.0], 3.0, Load),
    coefficient("qbz4", 0.0, [-10.0, 10.0], 1.0, Camber),
    coefficient("qbz5", 0.0, [-10.0, 10.0], 1.0, Camber),
    coefficient("qbz9", 15.0, [0.0, 100.0], 10.0, Slip),
    coefficient("qcz1", 1.1, [0.5, 3.0], 0.3, Slip),
    coefficient("qdz1", 0.1, [-0.5, 0.5], 0.03, Slip),
    coefficient("qdz2", 0.0, [-0.5, 0.5], 0.03, Load),
    coefficient("qdz3", 0.0, [-20.0, 20.0], 1.0, Camber),
    coefficient("qdz4", 0.0, [-100.0, 100.0], 10.0, Camber),
    coefficient("qdz6", 0.001, [-0.1, 0.1], 0.005, Slip),
    coefficient("qdz7", 0.0, [-0.1, 0.1], 0.005, Load),
    coefficient("qdz8", 0.0, [-3.0, 3.0], 0.1, Camber),
    coefficient("qdz9", 0.0, [-3.0, 3.0], 0.1, Camber),
    coefficient("qez1", -1.0, [-20.0, 1.0], 1.0, Slip),
    coefficient("qez2", 0.0, [-20.0, 20.0], 1.0, Load),
    coefficient("qez3", 0.0, [-20.0, 20.0], 1.0, Load),
    coefficient("qez4", 0.0, [-5.0, 5.0], 0.5, Slip),
    coefficient("qez5", 0.0, [-20.0, 20.0], 3.0, Camber),
    coefficient("qhz1", 0.0, [-0.1, 0.1], 0.005, Slip),
    coefficient("qhz2", 0.0, [-0.1, 0.1], 0.005, Load),
    coefficient("qhz3", 0.0, [-1.0, 1.0], 0.05, Camber),
    coefficient("qhz4", 0.0, [-1.0, 1.0], 0.05, Camber),
];

/// Moment arm of the force along x.
const ARM: &[Coefficient] = &[
    coefficient("ssz1", 0.0, [-1.0, 1.0], 0.03, Both),
    coefficient("ssz2", 0.0, [-1.0, 1.0], 0.03, Both),
    coefficient("ssz3", 0.0, [-10.0, 10.0], 0.3, Camber),
    coefficient("ssz4", 0.0, [-10.0, 10.0], 0.3, Camber),
];

/// Additions of version 6.1 to the force along y in pure side slip.
const LATERAL_6: &[Coefficient] = &[
    coefficient("pey5", 0.0, [-200.0, 200.0], 20.0, Camber),
    coefficient("pky5", 0.0, [-100.0, 100.0], 5.0, Camber),
    coefficient("pky6", 0.0, [-10.0, 10.0], 0.5, Camber),
    coefficient("pky7", 0.0, [-10.0, 10.0], 0.5, Camber),
    coefficient("ppy1", 0.0, [-10.0, 10.0], 0.3, Pressure),
    coefficient("ppy2", 0.0, [-10.0, 10.0], 0.5, Pressure),
    coefficient("ppy3", 0.0, [-5.0, 5.0], 0.1, Pressure),
    coefficient("ppy4", 0.0, [-10.0, 10.0], 0.3, Pressure),
    coefficient("ppy5", 0.0, [-10.0, 10.0], 0.5, Pressure),
];

/// Additions of version 6.1 to the force along x in pure longitudinal slip.
const LONGITUDINAL_6: &[Coefficient] = &[
    coefficient("ppx1", 0.0, [-10.0, 10.0], 0.3, Pressure),
    coefficient("ppx2", 0.0, [-20.0, 20.0], 1.0, Pressure),
    coefficient("ppx3", 0.0, [-5.0, 5.0], 0.1, Pressure),
    coefficient("ppx4", 0.0, [-10.0, 10.0], 0.3, Pressure),
];

/// Addition of version 6.1 to the reduction of the force along x by side slip.
const COMBINED_X_6: &[Coefficient] = &[coefficient("rbx3", 0.0, [-500.0, 500.0], 50.0, Camber)];

/// Addition of version 6.1 to the reduction of the force along y by longitudinal slip.
const COMBINED_Y_6: &[Coefficient] = &[coefficient("rby4", 0.0, [-500.0, 500.0], 50.0, Camber)];

/// Additions of version 6.1 to the moment about z in pure side slip.
const ALIGNING_6: &[Coefficient] = &[
    coefficient("qdz10", 0.0, [-30.0, 30.0], 1.0, Camber),
    coefficient("qdz11", 0.0, [-30.0, 30.0], 1.0, Camber),
    coefficient("ppz1", 0.0, [-10.0, 10.0], 0.3, Pressure),
    coefficient("ppz2", 0.0, [-10.0, 10.0], 0.5, Pressure),
];
