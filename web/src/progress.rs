//! Progress of a search.

#[cfg(target_family = "wasm")]
#[link(wasm_import_module = "page")]
unsafe extern "C" {
    #[link_name = "progress"]
    fn tell(rms: f64);
}

/// Tells the host what is not explained so far, in N; there is nobody to tell outside of WebAssembly.
pub fn progress(rms: f64) {
    #[cfg(target_family = "wasm")]
    // SAFETY: it takes a number and returns.
    unsafe {
        tell(rms);
    }
    #[cfg(not(target_family = "wasm"))]
    let _ = rms;
}
