//! The bytes of a saved state, read without the library: a head, then numbers, then a checksum.

use stribeck::model::{ModelType, Role};

/// Bytes before the first number: magic, format and guid.
pub const HEAD: usize = 8 + 4 + 38;
/// Bytes after the last number.
pub const CHECKSUM: usize = 8;
/// Place of the time among the numbers.
pub const TIME: usize = 0;
/// Place of the flag for outdated outputs.
pub const STALE: usize = 2;
/// Place of the state of the lifecycle.
pub const STATE: usize = 3;
/// Place of the stop time, the one number that may be infinite.
pub const STOP: usize = 6;
/// Place of the first column.
pub const ROW: usize = 7;

/// The numbers of a saved state.
pub fn numbers(bytes: &[u8]) -> Vec<f64> {
    let data = bytes[HEAD..bytes.len() - CHECKSUM].chunks_exact(8);
    data.map(|number| f64::from_le_bytes(number.try_into().expect("eight bytes"))).collect()
}

/// Sets the checksum to that of the bytes before it: FNV-1a of 64 bits.
pub fn seal(bytes: &mut [u8]) {
    let Some(body) = bytes.len().checked_sub(CHECKSUM) else { return };
    let mut hash = 0xcbf2_9ce4_8422_2325u64;
    for byte in &bytes[..body] {
        hash = (hash ^ u64::from(*byte)).wrapping_mul(0x0000_0100_0000_01b3);
    }
    bytes[body..].copy_from_slice(&hash.to_le_bytes());
}

/// Whether two states are the same except for the parts that a reading call may change (results, and whether they are
/// outdated), and for the lifecycle state.
pub fn is_unchanged(model: &ModelType, before: &[f64], after: &[f64], with_results: bool) -> bool {
    let may_differ = |place: usize| {
        let column = place.checked_sub(ROW).and_then(|column| model.table.get(column));
        let is_result = place == STALE || column.is_some_and(|variable| variable.role == Role::Output);
        place == STATE || (is_result && !with_results)
    };
    let pairs = before.iter().zip(after).enumerate();
    before.len() == after.len()
        && pairs.filter(|(place, _)| !may_differ(*place)).all(|(_, (a, b))| a.to_bits() == b.to_bits())
}

/// Whether only events of Model Exchange lead to that state.
pub fn needs_events(model: &ModelType, numbers: &[f64]) -> bool {
    let mut columns = model.table.iter().zip(&numbers[ROW..]);
    columns.any(|(variable, value)| variable.is_settled_by_events() && *value != variable.start)
}

/// Whether everything except the stop time is finite.
pub fn is_finite(numbers: &[f64]) -> bool {
    numbers.iter().enumerate().all(|(place, number)| number.is_finite() || (place == STOP && !number.is_nan()))
}
