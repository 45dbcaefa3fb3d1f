//! Progress of a search, and its end before its time.

#[cfg(target_family = "wasm")]
#[link(wasm_import_module = "page")]
unsafe extern "C" {
    #[link_name = "progress"]
    fn tell(rms: f64) -> i32;
}

/// Tells the host what is not explained so far, in N; returns whether the host wants the search to end. There is nobody
/// to tell outside of WebAssembly.
pub fn progress(rms: f64) -> bool {
    #[cfg(target_family = "wasm")]
    {
        // SAFETY: it takes a number and returns one.
        unsafe { tell(rms) != 0 }
    }
    #[cfg(not(target_family = "wasm"))]
    {
        let _ = rms;
        false
    }
}
