//! Joins libraries for Intel and Apple processors into one file, as macOS loads them (Apple, "Mach-O Programming
//! Topics" and the header `mach-o/fat.h`): a table of the parts, big-endian, and then the parts. Static libraries, which
//! are archives of such files, are joined in the same way.

use anyhow::{Context, Result, bail, ensure};
use object::read::archive::ArchiveFile;
use object::read::macho::{FatArch, MachOFatFile32};

const FAT_MAGIC: u32 = 0xcafe_babe;
const MACH_O_64: u32 = 0xfeed_facf;
const CPU_X86_64: u32 = 0x0100_0007;
const CPU_ARM64: u32 = 0x0100_000c;

/// Length of the table's head and of one of its rows.
const HEAD: usize = 8;
const ROW: usize = 20;

/// The universal file of these 64-bit libraries.
pub fn join(parts: &[Vec<u8>]) -> Result<Vec<u8>> {
    let mut table = words(&[FAT_MAGIC, number(parts.len())?]);
    let mut body = Vec::new();
    let start = HEAD + ROW * parts.len();
    for part in parts {
        let [magic, processor, kind] = first_words(code_in(part)?)?;
        ensure!(magic == MACH_O_64, "a part of a universal file must be a 64-bit Mach-O file");
        let page = page_size_exponent(processor)?;
        let offset = (start + body.len()).next_multiple_of(1 << page);
        body.resize(offset - start, 0);
        body.extend_from_slice(part);
        table.extend(words(&[processor, kind, number(offset)?, number(part.len())?, page]));
    }
    table.extend(body);
    Ok(table)
}

/// The libraries in a universal file; any other file is one library.
pub fn parts(file: &[u8]) -> Result<Vec<&[u8]>> {
    if !file.starts_with(&FAT_MAGIC.to_be_bytes()) {
        return Ok(vec![file]);
    }
    let rows = MachOFatFile32::parse(file).context("not a universal file")?.arches();
    rows.iter().map(|row| row.data(file).context("a part of the universal file is truncated")).collect()
}

/// A part begins on a page of its processor: 4 KiB on Intel, 16 KiB on Apple's.
fn page_size_exponent(processor: u32) -> Result<u32> {
    match processor {
        CPU_X86_64 => Ok(12),
        CPU_ARM64 => Ok(14),
        _ => bail!("processor {processor:#x}: macOS runs only on x86-64 and ARM64"),
    }
}

/// A library, or the first file of code in a static one.
fn code_in(part: &[u8]) -> Result<&[u8]> {
    if !part.starts_with(&object::archive::MAGIC) {
        return Ok(part);
    }
    for member in ArchiveFile::parse(part).context("not an archive")?.members() {
        let code = member.and_then(|member| member.data(part)).context("a file of the archive is truncated")?;
        if code.starts_with(&MACH_O_64.to_le_bytes()) {
            return Ok(code);
        }
    }
    bail!("a part of a universal file is an archive without a 64-bit Mach-O file")
}

fn first_words(part: &[u8]) -> Result<[u32; 3]> {
    let bytes = part.first_chunk::<12>().context("a part of a universal file is truncated")?;
    let word = |at: usize| u32::from_le_bytes([bytes[at], bytes[at + 1], bytes[at + 2], bytes[at + 3]]);
    Ok([word(0), word(4), word(8)])
}

fn words(words: &[u32]) -> Vec<u8> {
    words.iter().flat_map(|word| word.to_be_bytes()).collect()
}

fn number(number: usize) -> Result<u32> {
    u32::try_from(number).context("a universal file cannot be longer than 4 GiB")
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The head of a Mach-O file, filled up to a length.
    fn part(processor: u32, length: usize) -> Vec<u8> {
        let mut bytes: Vec<u8> = [MACH_O_64, processor, 3].iter().flat_map(|word| word.to_le_bytes()).collect();
        bytes.resize(length, 7);
        bytes
    }

    #[test]
    fn an_independent_reader_finds_the_parts() {
        let parts = [part(CPU_X86_64, 5001), part(CPU_ARM64, 70_000)];
        let joined = join(&parts).unwrap();
        let file = MachOFatFile32::parse(joined.as_slice()).unwrap();
        let [intel, apple] = file.arches() else { panic!("two parts") };
        for (row, part, architecture) in
            [(intel, &parts[0], object::Architecture::X86_64), (apple, &parts[1], object::Architecture::Aarch64)]
        {
            assert_eq!(row.architecture(), architecture);
            assert_eq!(row.data(joined.as_slice()).unwrap(), part);
            assert_eq!(row.offset() % (1 << row.align()), 0);
        }
        assert_eq!((intel.align(), apple.align()), (12, 14));
        assert_eq!(super::parts(&joined).unwrap(), parts);
        assert_eq!(super::parts(&parts[0]).unwrap(), [&parts[0]]);
        assert!(super::parts(&joined[..70_000]).unwrap_err().to_string().contains("truncated"));
    }

    /// An archive with one file, as `ar` writes it.
    fn archive(name: &str, file: &[u8]) -> Vec<u8> {
        let head = format!("!<arch>\n{name:<16}{:<12}{:<6}{:<6}{:<8}{:<10}`\n", 0, 0, 0, 644, file.len());
        [head.as_bytes(), file].concat()
    }

    #[test]
    fn static_libraries_are_joined_by_the_processors_of_their_code() {
        let archives = [archive("a.o/", &part(CPU_X86_64, 100)), archive("b.o/", &part(CPU_ARM64, 60))];
        let joined = join(&archives).unwrap();
        let file = MachOFatFile32::parse(joined.as_slice()).unwrap();
        let found: Vec<_> = file.arches().iter().map(FatArch::architecture).collect();
        assert_eq!(found, [object::Architecture::X86_64, object::Architecture::Aarch64]);
        assert_eq!(super::parts(&joined).unwrap(), archives);
        let refused = join(&[archive("c.txt/", b"text")]).unwrap_err().to_string();
        assert!(refused.contains("archive without"), "{refused}");
    }

    #[test]
    fn other_files_are_refused() {
        let refused = |part: Vec<u8>| join(&[part]).unwrap_err().to_string();
        assert!(refused(b"\x7fELF\x02\x01\x01\0\0\0\0\0".to_vec()).contains("64-bit Mach-O"));
        assert!(refused(vec![0xcf, 0xfa]).contains("truncated"));
        assert!(refused(part(12, 100)).contains("processor 0xc"));
    }
}
