//! The memory of a module as it is at first: the pieces that are needed and not zero.

use std::collections::BTreeSet;

use super::links::Target;
use super::module::Module;

/// Zeros in a row that are left out: as many bytes as address and length of a piece.
const ROW: usize = 8;

/// Bytes with the address of the first one.
pub type Piece = (u32, Vec<u8>);

/// The pieces of the memory of a module that hold these data.
pub fn pieces(module: &Module, targets: &BTreeSet<Target>) -> Vec<Piece> {
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
fn without_zeros(address: u32, bytes: &[u8]) -> Vec<Piece> {
    let mut found: Vec<Piece> = Vec::new();
    for (at, byte) in (address..).zip(bytes).filter(|(_, byte)| **byte != 0) {
        let near = found.last_mut().filter(|(begin, piece)| ((at - begin) as usize) < piece.len() + ROW);
        if let Some((begin, piece)) = near {
            piece.resize((at - *begin) as usize, 0);
            piece.push(*byte);
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
