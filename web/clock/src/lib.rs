//! Time as `web_time` gives it to crates that also run in a browser.
//!
//! The crate of that name asks the browser through wasm-bindgen, whose imports a plain WebAssembly does not have. Here the
//! clock of a browser stands still: what we use of those crates has no limits on time.

#[cfg(not(all(target_family = "wasm", target_os = "unknown")))]
pub use std::time::{Duration, Instant};

#[cfg(all(target_family = "wasm", target_os = "unknown"))]
pub use still::{Duration, Instant};

#[cfg(all(target_family = "wasm", target_os = "unknown"))]
mod still {
    pub use std::time::Duration;

    /// The only instant.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
    pub struct Instant;

    impl Instant {
        /// It is always now.
        pub fn now() -> Instant {
            Instant
        }

        /// Nothing passes.
        pub fn elapsed(&self) -> Duration {
            Duration::ZERO
        }
    }
}
