//! The memory of a module as it is at first: the parts that are needed and not zero.

use std::collections::BTreeSet;

use super::links::Target;
use super::module::Module;

/// Zeros in a row that are left out: as many bytes as address and length of a part.
const ROW: usize = 8;

/// Bytes with the address of the first one.
pub type Part = (u32, Vec<u8>);

/// The parts of the memory of a module that hold some of its data.
pub fn parts(module: &Module, targets: &BTreeSet<Target>) -> Vec<Part> {
    module
        .data
        .iter()
        .flat_map(|data| {
            let mut bytes = vec![0; data.bytes.len()];
            for target in targets {
                if let Target::Data(symbol) = target {
                    let symbol = module.links.part(*symbol);
                    let (begin, end) =
                        (symbol.start.max(data.place), symbol.end.min(data.place + data.bytes.len() as u64));
                    if begin < end {
                        let needed = (begin - data.place) as usize..(end - data.place) as usize;
                        bytes[needed.clone()].copy_from_slice(&data.bytes[needed]);
                    }
                }
            }
            without_zeros(data.address, &bytes)
        })
        .collect()
}

/// The bytes that follow an address, without zeros at the ends and rows of them.
fn without_zeros(address: u32, bytes: &[u8]) -> Vec<Part> {
    let mut found: Vec<Part> = Vec::new();
    for (at, byte) in (address..).zip(bytes).filter(|(_, byte)| **byte != 0) {
        let near = found.last_mut().filter(|(begin, part)| ((at - begin) as usize) < part.len() + ROW);
        if let Some((begin, part)) = near {
            part.resize((at - *begin) as usize, 0);
            part.push(*byte);
        } else {
            found.push((at, vec![*byte]));
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_of_zeros_are_left_out() {
        assert_eq!(without_zeros(100, &[0; 20]), []);
        let mut bytes = vec![0, 1, 2];
        bytes.extend([0; ROW - 1]);
        bytes.push(3);
        bytes.extend([0; ROW]);
        bytes.extend([4, 0, 5, 0]);
        let first = [&[1, 2][..], &[0; ROW - 1], &[3]].concat();
        assert_eq!(without_zeros(100, &bytes), [(101, first), (119, vec![4, 0, 5])]);
    }
}
