//! Shared libraries as the packer reads and joins them: ELF, PE and Mach-O.
#![no_main]

use libfuzzer_sys::fuzz_target;

#[path = "../../fmu-build/src/binary.rs"]
mod binary;
#[path = "../../fmu-build/src/universal.rs"]
mod universal;

/// Bytes of the head of a universal file, and of each row of its table.
const HEAD: usize = 8;
const ROW: usize = 20;

fuzz_target!(|bytes: &[u8]| {
    if let Ok(binary) = binary::read(bytes) {
        let newest = binary.newest_glibc().map(|version| binary::glibc(&format!("GLIBC_{version}")));
        assert!(newest.is_none_or(|newest| newest.is_some()));
    }
    let parts = [bytes.to_vec(), bytes.to_vec()];
    if let Ok(joined) = universal::join(&parts) {
        assert!(joined.len() >= HEAD + parts.len() * (ROW + bytes.len()) && joined.ends_with(bytes));
    }
});
