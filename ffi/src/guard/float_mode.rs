//! The floating-point mode of the host: traps, rounding, denormal numbers.
//!
//! The laws are written for the default mode of IEEE 754, in which an overflow or a division by zero gives a value that
//! is found and refused later, not a signal that ends the host. They are computed in that mode whatever the mode of the
//! host, so results do not depend on it.

/// The default mode, until it is dropped: then the mode of the host is restored.
pub(crate) struct DefaultMode {
    /// Mode of the host, if it differs.
    host: Option<Mode>,
}

impl DefaultMode {
    /// Sets the default mode. Reading the mode costs a few nanoseconds, changing it more: most hosts have the default.
    #[inline(always)]
    pub fn enter() -> DefaultMode {
        let mode = control::read();
        if mode & !control::FLAGS == control::DEFAULT {
            return DefaultMode { host: None };
        }
        control::write(control::DEFAULT);
        DefaultMode { host: Some(mode) }
    }
}

impl Drop for DefaultMode {
    #[inline(always)]
    fn drop(&mut self) {
        if let Some(mode) = self.host {
            control::write(mode);
        }
    }
}

type Mode = control::Mode;

/// The control and status register MXCSR (Intel 64 and IA-32 Architectures Software Developer's Manual, volume 1,
/// section 10.2.3).
#[cfg(all(target_arch = "x86_64", not(miri)))]
mod control {
    use std::arch::asm;

    pub type Mode = u32;
    /// All exceptions masked, round to nearest, denormal numbers kept.
    pub const DEFAULT: Mode = 0x1F80;
    /// Exceptions that have occurred.
    pub const FLAGS: Mode = 0x3F;

    #[inline(always)]
    pub fn read() -> Mode {
        let mut mode = 0;
        // SAFETY: stores the register into a variable.
        unsafe { asm!("stmxcsr [{}]", in(reg) &raw mut mode, options(nostack, preserves_flags)) };
        mode
    }

    #[inline(always)]
    pub fn write(mode: Mode) {
        // SAFETY: loads the default mode, in which Rust expects to run, or the one in which the host called.
        unsafe { asm!("ldmxcsr [{}]", in(reg) &raw const mode, options(nostack, preserves_flags)) };
    }
}

/// The control register FPCR (Arm Architecture Reference Manual for A-profile, section C5.2).
#[cfg(all(target_arch = "aarch64", not(miri)))]
mod control {
    use std::arch::asm;

    pub type Mode = u64;
    pub const DEFAULT: Mode = 0;
    /// The exceptions that have occurred are in another register.
    pub const FLAGS: Mode = 0;

    #[inline(always)]
    pub fn read() -> Mode {
        let mode;
        // SAFETY: copies the register.
        unsafe { asm!("mrs {}, fpcr", out(reg) mode, options(nostack, preserves_flags)) };
        mode
    }

    #[inline(always)]
    pub fn write(mode: Mode) {
        // SAFETY: loads the default mode, in which Rust expects to run, or the one in which the host has called.
        unsafe { asm!("msr fpcr, {}", in(reg) mode, options(nostack, preserves_flags)) };
    }
}

/// On other processors the mode of the host stays. Miri, which cannot run assembly, has the default mode only.
#[cfg(any(miri, not(any(target_arch = "x86_64", target_arch = "aarch64"))))]
mod control {
    pub type Mode = u32;
    pub const DEFAULT: Mode = 0;
    pub const FLAGS: Mode = 0;

    pub fn read() -> Mode {
        DEFAULT
    }

    pub fn write(_: Mode) {}
}
