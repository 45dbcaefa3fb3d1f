//! Progress of long work, and its cancellation.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, LazyLock, Once};

use indicatif::{ProgressBar, ProgressStyle};
use signal_hook::consts::SIGINT;
use signal_hook::flag;
use stribeck_solve::solve::Progress;

/// Set by Ctrl-C: work in progress ends early and keeps its results.
pub static CANCELLED: LazyLock<Arc<AtomicBool>> = LazyLock::new(Arc::default);

/// Exit code of a program that Ctrl-C ended.
const INTERRUPTED: i32 = 130;

/// Lets Ctrl-C end the work early; pressed again, it ends the program.
pub fn heed_interrupts() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        // In this order: the first signal finds the flag down. Without a handler Ctrl-C ends the program at once.
        let _ = flag::register_conditional_shutdown(SIGINT, INTERRUPTED, CANCELLED.clone())
            .and_then(|_| flag::register(SIGINT, CANCELLED.clone()));
    });
}

/// A bar on a terminal, nothing elsewhere.
#[derive(Debug)]
pub struct Bar {
    bar: ProgressBar,
    /// End of a run, s.
    until: f64,
    done: std::sync::atomic::AtomicU64,
}

const PARTS: f64 = 1000.0;

impl Bar {
    /// A bar for runs to a time.
    pub fn new(runs: usize, until: f64) -> Bar {
        let bar = ProgressBar::new((runs as f64 * PARTS) as u64);
        if let Ok(style) = ProgressStyle::with_template("{msg} [{bar:40}] {percent} % {eta}") {
            bar.set_style(style.progress_chars("=> "));
        }
        Bar { bar, until, done: 0.into() }
    }

    /// Starts a run.
    pub fn begin(&self, number: usize, name: &str) {
        self.done.store(number as u64, Ordering::Relaxed);
        self.bar.set_message(name.to_owned());
    }

    /// The work has ended.
    pub fn finish(&self) {
        self.bar.finish_and_clear();
    }
}

/// A bar for rows.
#[derive(Debug)]
pub struct Rows(ProgressBar);

impl Rows {
    /// A bar for a number of rows.
    pub fn new(rows: usize) -> Rows {
        let bar = ProgressBar::new(rows as u64);
        if let Ok(style) = ProgressStyle::with_template("[{bar:40}] {pos} of {len} rows, {per_sec}, {eta}") {
            bar.set_style(style.progress_chars("=> "));
        }
        Rows(bar)
    }

    /// Shows the number of finished rows.
    pub fn reached(&self, rows: usize) {
        self.0.set_position(rows as u64);
    }

    /// The work has ended.
    pub fn finish(&self) {
        self.0.finish_and_clear();
    }
}

/// The best cost so far, on a terminal.
#[derive(Debug)]
pub struct Best {
    bar: ProgressBar,
    best: std::sync::Mutex<f64>,
    /// Its unit.
    unit: &'static str,
}

impl Best {
    /// A bar before the first search.
    pub fn new(unit: &'static str) -> Best {
        let bar = ProgressBar::new_spinner();
        if let Ok(style) = ProgressStyle::with_template("{prefix}: {pos} generations, {msg}, {elapsed}") {
            bar.set_style(style);
        }
        Best { bar, best: f64::INFINITY.into(), unit }
    }

    /// Starts the search of a law.
    pub fn begin(&self, law: &str) {
        *self.best.lock().unwrap_or_else(std::sync::PoisonError::into_inner) = f64::INFINITY;
        self.bar.set_prefix(law.to_owned());
        self.bar.set_position(0);
    }

    /// Counts a generation, with the RMS residual of its best member.
    pub fn reached(&self, rms: f64) {
        let mut best = self.best.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        *best = best.min(rms);
        self.bar.set_message(format!("RMS residual {:.4e} {}", *best, self.unit));
        self.bar.inc(1);
    }

    /// The work has ended.
    pub fn finish(&self) {
        self.bar.finish_and_clear();
    }
}

impl Progress for Bar {
    fn reached(&self, time: f64) {
        let done = self.done.load(Ordering::Relaxed) as f64;
        self.bar.set_position(((done + time / self.until) * PARTS) as u64);
    }
}
