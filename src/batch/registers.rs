//! Kinds of registers, of which a processor has some.

use std::sync::OnceLock;

/// Registers for the lanes of a batch.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Registers {
    /// None: one row after the other.
    Scalar,
    /// Two lanes, of every 64-bit ARM processor.
    Neon,
    /// Four lanes, of nearly every x86-64 processor.
    Avx2,
    /// Eight lanes.
    Avx512,
}

impl Registers {
    /// All kinds, each with its name in lower case.
    const ALL: [(Registers, &'static str); 4] = [
        (Registers::Scalar, "scalar"),
        (Registers::Neon, "neon"),
        (Registers::Avx2, "avx2"),
        (Registers::Avx512, "avx512"),
    ];

    /// Whether this processor has them.
    pub fn are_here(self) -> bool {
        match self {
            Registers::Scalar => true,
            Registers::Neon => cfg!(target_arch = "aarch64"),
            #[cfg(target_arch = "x86_64")]
            Registers::Avx2 => is_x86_feature_detected!("avx2"),
            #[cfg(target_arch = "x86_64")]
            Registers::Avx512 => is_x86_feature_detected!("avx512f") && is_x86_feature_detected!("avx512dq"),
            #[cfg(not(target_arch = "x86_64"))]
            Registers::Avx2 | Registers::Avx512 => false,
        }
    }

    /// All that this processor has.
    pub fn here() -> impl Iterator<Item = Registers> {
        Registers::ALL.into_iter().map(|(registers, _)| registers).filter(|registers| registers.are_here())
    }

    /// The widest that this processor has, none wider than the environment variable `STRIBECK_REGISTERS` says (`scalar`,
    /// `neon`, `avx2` or `avx512`). The bits are the same with all of them.
    pub fn best() -> Registers {
        static BEST: OnceLock<Registers> = OnceLock::new();
        *BEST.get_or_init(|| {
            let widest = std::env::var("STRIBECK_REGISTERS").ok().and_then(|text| Registers::of(&text));
            let admitted = |registers: &Registers| widest.is_none_or(|widest| *registers <= widest);
            Registers::here().filter(admitted).last().unwrap_or(Registers::Scalar)
        })
    }

    /// The kind of this name.
    fn of(name: &str) -> Option<Registers> {
        Registers::ALL.into_iter().find(|(_, known)| *known == name).map(|(registers, _)| registers)
    }
}
