//! Messages to the importer, by category.

use std::ffi::{CStr, CString};
use std::fmt::{self, Write};

use stribeck::memory::{self, OUT_OF_MEMORY};

/// A log category of FMI: those of 2.0.5 section 2.2.4, which 3.0 has as well.
pub struct Category {
    /// Name, as in modelDescription.xml.
    pub name: &'static CStr,
    /// Messages reported under it.
    pub description: &'static str,
}

/// Values that make no sense but are accepted.
pub const WARNING: Category = Category {
    name: c"logStatusWarning",
    description: "Values that were accepted although they make no sense, such as an unconnected input at 0.",
};
/// Refused values.
pub const DISCARD: Category =
    Category { name: c"logStatusDiscard", description: "Values that were refused, with the limit they break." };
/// Refused calls.
pub const ERROR: Category = Category { name: c"logStatusError", description: "Calls that failed, with the reason." };
/// The category that stands for all.
pub const ALL: Category = Category { name: c"logAll", description: "All messages." };

/// Every category of this library.
pub const CATEGORIES: [Category; 4] = [WARNING, DISCARD, ERROR, ALL];

/// The logger of an importer.
pub(crate) trait Logger {
    /// Whether the importer has given one.
    fn is_given(&self) -> bool;

    /// Passes a message on. It may throw.
    ///
    /// # Safety
    /// The functions must be those of an importer.
    unsafe fn send(&self, level: Level, category: &Category, text: &CStr);
}

/// Severity of a message, which is also the status that an importer gets with it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Level {
    Warning,
    Discard,
    Error,
}

/// The importer's logger and its settings.
///
/// A message is stored first, and logged after everything else in a call is done. The logger of a C++ host may throw:
/// no function that the exception passes may have anything to clean up, because that would be done by the unwinder of
/// this library, and the unwinders of two libraries need not be compatible. For the same reason the text belongs to the
/// log, which frees it later if necessary.
pub(crate) struct Log<L> {
    logger: L,
    hears: Hears,
    /// `None` if memory ran out.
    message: Option<CString>,
    waiting: Option<Reason>,
    told: Told,
}

/// The categories that the importer has enabled.
///
/// `loggingOn` enables debug logging, but the reason of a failure is not debug output: many importers leave it off, and
/// their users would not see any reason. As in the Reference-FMUs errors are logged in any case, and here also the
/// values that a user has set wrongly or left open. Only SetDebugLogging switches those off.
#[derive(Clone, Copy)]
struct Hears {
    warning: bool,
    /// Warnings of parameters that are those of the literature.
    note: bool,
    discard: bool,
    /// Answers to a solver's trials and to queries, which are discarded in the ordinary course of a run.
    trial: bool,
    error: bool,
}

impl Hears {
    /// All categories, or none.
    fn all(enabled: bool) -> Hears {
        Hears { warning: enabled, note: enabled, discard: enabled, trial: enabled, error: enabled }
    }
}

impl<L: Logger> Log<L> {
    /// A log that reports failures even without `loggingOn`.
    pub fn new(logger: L, debug: bool) -> Log<L> {
        Log::hearing(logger, Hears { note: debug, trial: debug, ..Hears::all(true) })
    }

    /// A log that reports nothing without `loggingOn`, as FMI 3.0 requires (section 2.3.1).
    pub fn strict(logger: L, enabled: bool) -> Log<L> {
        Log::hearing(logger, Hears::all(enabled))
    }

    fn hearing(logger: L, hears: Hears) -> Log<L> {
        Log { logger, hears, message: None, waiting: None, told: Told::default() }
    }

    /// Switches the named category; `None` if it does not exist.
    pub fn switch(&mut self, category: &CStr, enabled: bool) -> Option<()> {
        let hears = &mut self.hears;
        if category == WARNING.name {
            (hears.warning, hears.note) = (enabled, enabled);
        } else if category == DISCARD.name {
            (hears.discard, hears.trial) = (enabled, enabled);
        } else if category == ERROR.name {
            hears.error = enabled;
        } else if category == ALL.name {
            *hears = Hears::all(enabled);
        } else {
            return None;
        }
        Some(())
    }

    /// Stores a message for [`Log::tell`] if the importer has enabled its category.
    pub fn keep(&mut self, reason: Reason, text: fmt::Arguments) {
        let is_heard = match reason {
            Reason::Warning => self.hears.warning,
            Reason::Note => self.hears.note,
            Reason::Discard => self.hears.discard,
            Reason::Trial => self.hears.trial,
            Reason::Error => self.hears.error,
        };
        if is_heard && self.logger.is_given() {
            self.message = memory::c_text(&memory::text(Doubled(text))).ok();
            self.waiting = Some(reason);
        }
    }

    /// Stores a warning, once.
    pub fn warn(&mut self, text: &str) {
        if self.hears.warning && self.told.is_new(text) {
            self.keep(Reason::Warning, format_args!("{text}"));
        }
    }

    /// Stores a warning that the importer hears only with `loggingOn`.
    pub fn note(&mut self, text: &str) {
        self.keep(Reason::Note, format_args!("{text}"));
    }

    /// Whether a message is pending.
    #[inline(always)]
    pub fn is_waiting(&self) -> bool {
        self.waiting.is_some()
    }

    /// Passes the pending message to the importer's logger, which may throw.
    #[cold]
    #[inline(never)]
    pub fn tell(&mut self) {
        let (level, category) = match self.waiting.take() {
            None => return,
            Some(Reason::Warning | Reason::Note) => (Level::Warning, &WARNING),
            Some(Reason::Discard | Reason::Trial) => (Level::Discard, &DISCARD),
            Some(Reason::Error) => (Level::Error, &ERROR),
        };
        let text = self.message.as_deref().unwrap_or(OUT_OF_MEMORY);
        // SAFETY: the logger is that of the importer.
        unsafe { self.logger.send(level, category, text) };
        self.message = None;
    }
}

/// Why a call is logged.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Reason {
    /// Done, but it makes no sense.
    Warning,
    /// Done, with parameters of which there is something to say.
    Note,
    /// A value was refused.
    Discard,
    /// A solver's trial or a query was discarded.
    Trial,
    /// A call was refused.
    Error,
}

/// Warnings already logged: an instance logs none twice, and no more than these.
#[derive(Default)]
struct Told {
    marks: [u64; 16],
    count: usize,
}

impl Told {
    fn is_new(&mut self, text: &str) -> bool {
        // FNV-1a, 64 bits.
        let mark = text
            .bytes()
            .fold(0xcbf2_9ce4_8422_2325_u64, |mark, byte| (mark ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3));
        let Some((told, rest)) = self.marks.split_at_mut_checked(self.count) else { return false };
        let Some(place) = rest.first_mut().filter(|_| !told.contains(&mark)) else { return false };
        *place = mark;
        self.count += 1;
        true
    }
}

/// A message logged where no instance can store it: of a fixed length, so that nothing needs to be freed. Longer texts
/// are truncated.
pub(crate) struct Line {
    bytes: [u8; 512],
    length: usize,
}

impl Line {
    pub const EMPTY: Line = Line { bytes: [0; 512], length: 0 };

    pub fn write(&mut self, text: fmt::Arguments) {
        // An error says that the text is truncated, as intended.
        let _ = write!(self, "{}", Doubled(text));
    }

    /// The text, up to the first zero.
    pub fn text(&self) -> &CStr {
        CStr::from_bytes_until_nul(&self.bytes).unwrap_or_default()
    }
}

impl Write for Line {
    fn write_str(&mut self, more: &str) -> fmt::Result {
        // A zero remains at the end, and no character is split.
        let room = self.bytes.len() - 1 - self.length;
        let fits = (0..=more.len().min(room)).rev().find(|end| more.is_char_boundary(*end)).unwrap_or_default();
        self.bytes[self.length..self.length + fits].copy_from_slice(&more.as_bytes()[..fits]);
        self.length += fits;
        if fits == more.len() { Ok(()) } else { Err(fmt::Error) }
    }
}

/// A text in which each `#` is doubled: a single one introduces a reference to a variable in FMI's messages.
struct Doubled<'a>(fmt::Arguments<'a>);

impl fmt::Display for Doubled<'_> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        struct Doubling<'a, 'b>(&'a mut fmt::Formatter<'b>);
        impl fmt::Write for Doubling<'_, '_> {
            fn write_str(&mut self, text: &str) -> fmt::Result {
                for (at, piece) in text.split('#').enumerate() {
                    self.0.write_str(if at == 0 { "" } else { "##" })?;
                    self.0.write_str(piece)?;
                }
                Ok(())
            }
        }
        fmt::write(&mut Doubling(f), self.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sixteen_warnings_are_reported_once_each() {
        let mut told = Told::default();
        for n in 0..16 {
            assert!(told.is_new(&format!("warning {n}")));
            assert!(!told.is_new(&format!("warning {n}")));
        }
        assert!(!told.is_new("warning 16"));
    }
}
