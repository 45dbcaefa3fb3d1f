//! Shared libraries as the packer reads and joins them: ELF, PE and Mach-O.
#![no_main]

use libfuzzer_sys::fuzz_target;

#[path = "../../fmu-build/src/build/binary.rs"]
mod binary;
#[path = "../../fmu-build/src/build/universal.rs"]
mod universal;

fuzz_target!(|bytes: &[u8]| {
    for part in universal::parts(bytes).unwrap_or_default() {
        if let Ok(binary) = binary::read(part) {
            let newest = binary.newest_glibc().map(|version| binary::glibc(&format!("GLIBC_{version}")));
            assert!(newest.is_none_or(|newest| newest.is_some()));
        }
    }
    if let Ok(joined) = universal::join(&[bytes.to_vec(), bytes.to_vec()]) {
        assert_eq!(universal::parts(&joined).ok(), Some(vec![bytes, bytes]));
    }
});
