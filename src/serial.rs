//! A snapshot as bytes, to be kept in a file or passed to another process.
//!
//! Little-endian, the same on every platform: magic, format number, guid of the model, then time, flags, the owner's
//! own numbers, row, slopes and memory as f64, further numbers of the owner, and an FNV-1a checksum of all that. Foreign, truncated and damaged bytes
//! are refused.

use std::fmt;

use crate::instance::Snapshot;
use crate::memory;
use crate::model::{Brief, Fault, ModelType, Role, Variable};

const MAGIC: &[u8; 8] = b"STRIBECK";
/// Incremented when the layout changes; bytes of another format are refused.
const FORMAT: u32 = 1;
const HEAD: usize = MAGIC.len() + 4 + 38;
const CHECKSUM: usize = 8;
/// Time and two flags.
const OWN: usize = 3;

/// Numbers that the owner of an instance adds.
pub const OWNERS: usize = 4;

/// Number of bytes of a snapshot of this model.
pub fn size(model: &ModelType) -> usize {
    size_with(model, 0)
}

/// The same with so many further numbers of the owner.
pub fn size_with(model: &ModelType, further: usize) -> usize {
    HEAD + 8 * (OWN + OWNERS + 2 * model.table.len() + model.memory + further) + CHECKSUM
}

/// Writes a snapshot into `bytes`, which must have exactly [`size`] bytes.
pub fn write(model: &ModelType, snapshot: &Snapshot, owners: [f64; OWNERS], bytes: &mut [u8]) {
    write_with(model, snapshot, owners, [], bytes);
}

/// The same with further numbers of the owner, into exactly [`size_with`] bytes.
pub fn write_with(
    model: &ModelType,
    snapshot: &Snapshot,
    owners: [f64; OWNERS],
    further: impl IntoIterator<Item = f64>,
    bytes: &mut [u8],
) {
    let flags = [snapshot.slopes_are_new, snapshot.stale].map(|flag| f64::from(u8::from(flag)));
    let numbers = [snapshot.time].into_iter().chain(flags).chain(owners);
    let numbers = numbers.chain(snapshot.row.iter().copied()).chain(snapshot.slope.iter().copied());
    let numbers = numbers.chain(snapshot.memory.iter().copied()).chain(further);
    let (body, checksum) = bytes.split_at_mut(bytes.len() - CHECKSUM);
    let (head, data) = body.split_at_mut(HEAD);
    head[..8].copy_from_slice(MAGIC);
    head[8..12].copy_from_slice(&FORMAT.to_le_bytes());
    head[12..].copy_from_slice(model.guid().as_bytes());
    for (place, number) in data.chunks_exact_mut(8).zip(numbers) {
        place.copy_from_slice(&number.to_le_bytes());
    }
    checksum.copy_from_slice(&hash(body).to_le_bytes());
}

/// Rejects the bytes of a snapshot of `model`.
fn refuse<T>(model: &ModelType, why: fmt::Arguments) -> Result<T, Fault> {
    Err(Fault::new(format_args!("serialised state of {}: {why}", model.name)))
}

/// The numbers in the bytes of a snapshot of `model`, if origin, size and checksum are right.
fn numbers<'a>(model: &ModelType, size: usize, bytes: &'a [u8]) -> Result<impl Iterator<Item = f64> + use<'a>, Fault> {
    // The origin is checked first: bytes of another version also have another size.
    let Some(head) = bytes.get(..HEAD).filter(|head| head.starts_with(MAGIC)) else {
        return refuse(model, format_args!("not a state of this library"));
    };
    if head[8..12] != FORMAT.to_le_bytes() {
        return refuse(model, format_args!("written in another format by another version of this library"));
    }
    if &head[12..] != model.guid().as_bytes() {
        return refuse(model, format_args!("it belongs to another model or another version of it"));
    }
    if bytes.len() != size {
        return refuse(model, format_args!("{} bytes, {size} are expected", bytes.len()));
    }
    let (body, checksum) = bytes.split_at(bytes.len() - CHECKSUM);
    if checksum != hash(body).to_le_bytes() {
        return refuse(model, format_args!("damaged, the checksum differs"));
    }
    Ok(body[HEAD..].chunks_exact(8).map(|bytes| f64::from_le_bytes(bytes.try_into().unwrap_or_default())))
}

/// Rejects a value that its variable does not admit.
fn check_row(model: &ModelType, row: &[f64]) -> Result<(), Fault> {
    for (variable, value) in model.table.iter().zip(row) {
        // A solver may set states beyond their bounds on its way to a result.
        let may_be_any = variable.role == Role::Output || (model.model_exchange && variable.is_continuous_state());
        let sound = if may_be_any { value.is_finite() } else { variable.admits(*value) };
        if !sound {
            return Err(variable.fault(*value));
        }
        if variable.is_advice && value.to_bits() != variable.start.to_bits() {
            let text = format_args!(
                "{} = {}: must be {}, a state has no advice",
                variable.path,
                Brief(*value),
                variable.start
            );
            return Err(Fault::new(text));
        }
    }
    Ok(())
}

/// Reads a snapshot of `model` back.
pub fn read(model: &ModelType, bytes: &[u8]) -> Result<(Snapshot, [f64; OWNERS]), Fault> {
    read_with(model, &mut [], bytes)
}

/// The same with further numbers of the owner.
pub fn read_with(model: &ModelType, further: &mut [f64], bytes: &[u8]) -> Result<(Snapshot, [f64; OWNERS]), Fault> {
    let mut numbers = numbers(model, size_with(model, further.len()), bytes)?;
    let mut take = || numbers.next().unwrap_or(f64::NAN);
    let [time, slopes_are_new, stale] = std::array::from_fn(|_| take());
    let owners = std::array::from_fn(|_| take());
    let columns = model.table.len();
    let mut row = memory::filled(0.0, columns)?;
    let mut slope = memory::filled(0.0, columns)?;
    row.fill_with(&mut take);
    let mut memory = memory::filled(0.0, model.memory)?;
    slope.fill_with(&mut take);
    memory.fill_with(&mut take);
    further.fill_with(&mut take);
    check_row(model, &row)?;
    let is_sound =
        |(variable, slope): (Variable, &f64)| slope.is_finite() && (*slope == 0.0 || variable.role == Role::Input);
    if !time.is_finite() || !model.table.iter().zip(&*slope).all(is_sound) {
        return refuse(model, format_args!("time or a slope is not finite, or the slope does not belong to an input"));
    }
    if !memory.iter().all(|value| value.is_finite()) {
        return refuse(model, format_args!("a number of the memory is not finite"));
    }
    let (Some(slopes_are_new), Some(stale)) = (flag(slopes_are_new), flag(stale)) else {
        return refuse(model, format_args!("the flags are {slopes_are_new} and {stale}: must be 0 or 1"));
    };
    Ok((Snapshot { row, memory, slope, slopes_are_new, stale, time }, owners))
}

/// A flag that was written as a number. Compared bit by bit, so that writing it again gives the same bytes.
pub fn flag(number: f64) -> Option<bool> {
    [false, true].into_iter().find(|flag| f64::from(*flag).to_bits() == number.to_bits())
}

/// FNV-1a of 64 bits (RFC 9923).
fn hash(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(*byte)).wrapping_mul(0x0000_0100_0000_01b3))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::instance::Instance;

    fn bytes_of(name: &str) -> (&'static ModelType, Vec<u8>) {
        let model = crate::catalogue::by_name(name).expect("a model of the catalogue");
        let mut instance = Instance::new(model);
        instance.set_time(1.25);
        instance.set_column(0, 0.5).unwrap();
        instance.set_slope(0, -3.0).unwrap();
        let mut bytes = vec![0; size(model)];
        write(model, &instance.save(), [1.0, 2.0, 3.0, 4.0], &mut bytes);
        (model, bytes)
    }

    #[test]
    fn what_is_written_is_read_back() {
        let (model, bytes) = bytes_of("LuGre");
        let (snapshot, owners) = read(model, &bytes).expect("valid bytes");
        assert_eq!((snapshot.time, snapshot.row[0], snapshot.slope[0]), (1.25, 0.5, -3.0));
        assert!(snapshot.slopes_are_new && snapshot.stale);
        assert_eq!(owners, [1.0, 2.0, 3.0, 4.0]);
    }

    #[test]
    fn every_damaged_byte_is_noticed() {
        let (model, bytes) = bytes_of("Dahl");
        for at in 0..bytes.len() {
            let mut damaged = bytes.clone();
            damaged[at] ^= 0x10;
            assert!(read(model, &damaged).is_err(), "byte {at}");
        }
        assert!(read(model, &bytes[1..]).is_err());
        assert!(read(model, &[]).is_err());
    }

    /// Restoring would drop it, so that what is saved afterwards would be another state.
    #[test]
    fn advice_that_was_written_into_a_state_is_refused() {
        let (model, mut bytes) = bytes_of("ShockAbsorber");
        let place = HEAD + 8 * (OWN + OWNERS + model.find("step_limit").expect("the advice of a strut"));
        bytes[place..place + 8].copy_from_slice(&(-5e-108f64).to_le_bytes());
        let body = bytes.len() - CHECKSUM;
        let checksum = hash(&bytes[..body]);
        bytes[body..].copy_from_slice(&checksum.to_le_bytes());
        let text = read(model, &bytes).expect_err("refused").to_string();
        assert!(text.starts_with("step_limit = -5e-108: must be 0, a state has no advice"), "{text}");
    }

    /// Damage with a matching checksum.
    #[test]
    fn a_fitting_checksum_does_not_make_bytes_sound() {
        let (model, bytes) = bytes_of("Dahl");
        let body = bytes.len() - CHECKSUM;
        let first_slope = HEAD + 8 * (OWN + OWNERS + model.table.len());
        let mu_k = model.find("mu_k").expect("a variable of Dahl");
        let damages: [(&str, usize, Vec<u8>); 7] = [
            ("flag", HEAD + 8, 0.5f64.to_le_bytes().into()),
            ("sign of a flag", HEAD + 16, (-0.0f64).to_le_bytes().into()),
            ("format", 8, 2u32.to_le_bytes().into()),
            ("time", HEAD, f64::NAN.to_le_bytes().into()),
            ("row", HEAD + 8 * (OWN + OWNERS), f64::INFINITY.to_le_bytes().into()),
            ("slope", first_slope, f64::NAN.to_le_bytes().into()),
            ("slope of a parameter", first_slope + 8 * mu_k, 1f64.to_le_bytes().into()),
        ];
        for (what, at, damage) in damages {
            let mut damaged = bytes.clone();
            damaged[at..at + damage.len()].copy_from_slice(&damage);
            let checksum = hash(&damaged[..body]);
            damaged[body..].copy_from_slice(&checksum.to_le_bytes());
            assert!(read(model, &damaged).is_err(), "{what}");
        }
    }

    /// The elements of a law that have no variables.
    #[test]
    fn memory_beside_the_row_is_written_and_read_back() {
        let model = crate::catalogue::by_name("MaxwellSlip").expect("a model of the catalogue");
        let mut snapshot = Instance::new(model).save();
        for (at, value) in snapshot.memory.iter_mut().enumerate() {
            *value = 0.5 + at as f64;
        }
        let mut bytes = vec![0; size(model)];
        write(model, &snapshot, [0.0; OWNERS], &mut bytes);
        assert_eq!(read(model, &bytes).map(|(read, _)| read), Ok(snapshot.clone()));
        if let Some(last) = snapshot.memory.last_mut() {
            *last = f64::NAN;
        }
        write(model, &snapshot, [0.0; OWNERS], &mut bytes);
        assert!(read(model, &bytes).is_err());
    }

    #[test]
    fn another_model_refuses_the_bytes() {
        let (_, bytes) = bytes_of("CoulombStiction");
        let karnopp = crate::catalogue::by_name("Karnopp").expect("a model of the catalogue");
        assert!(read(karnopp, &bytes).is_err());
    }

    /// A matching checksum does not make a value admissible.
    #[test]
    fn values_outside_their_bounds_are_refused_by_name() {
        let (model, _) = bytes_of("LuGre");
        let mut snapshot = Instance::new(model).save();
        let column = model.find("sigma_0").expect("a variable of LuGre");
        snapshot.row[column] = -1.0;
        let mut bytes = vec![0; size(model)];
        write(model, &snapshot, [0.0; OWNERS], &mut bytes);
        let fault = read(model, &bytes).expect_err("sigma_0 = -1");
        assert_eq!(fault.0, "sigma_0 = -1: must be > 0 and finite");
    }
}
