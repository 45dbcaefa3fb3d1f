//! MAT files made byte by byte, after the description of the format.

use super::*;
use crate::{DISPLACEMENT, FORCE, TIME};

/// An element of a file: kind, length, bytes, up to a multiple of eight.
fn element(kind: u32, bytes: &[u8]) -> Vec<u8> {
    let mut all = [kind.to_le_bytes(), (bytes.len() as u32).to_le_bytes()].concat();
    all.extend(bytes);
    all.resize(all.len().next_multiple_of(8), 0);
    all
}

/// A variable of a class, with its dimensions and what the class has after its name.
fn variable(class: u8, name: &str, dimensions: [u32; 2], rest: &[Vec<u8>]) -> Vec<u8> {
    let dimensions = dimensions.map(u32::to_le_bytes).concat();
    let head = [element(6, &[class, 0, 0, 0, 0, 0, 0, 0]), element(5, &dimensions), element(1, name.as_bytes())];
    element(14, &[head.concat(), rest.concat()].concat())
}

fn matrix(name: &str, columns: &[&[f64]]) -> Vec<u8> {
    let bytes: Vec<u8> = columns.concat().iter().flat_map(|value| value.to_le_bytes()).collect();
    variable(6, name, [columns[0].len() as u32, columns.len() as u32], &[element(9, &bytes)])
}

fn cells(name: &str, texts: &[&str]) -> Vec<u8> {
    let text = |text: &&str| {
        let letters: Vec<u8> = text.encode_utf16().flat_map(u16::to_le_bytes).collect();
        variable(4, "", [1, text.len() as u32], &[element(17, &letters)])
    };
    variable(1, name, [1, texts.len() as u32], &texts.iter().map(text).collect::<Vec<_>>())
}

fn structure(name: &str, fields: &[(&str, Vec<u8>)]) -> Vec<u8> {
    let padded = |(field, _): &(&str, Vec<u8>)| {
        let mut bytes = field.as_bytes().to_vec();
        bytes.resize(32, 0);
        bytes
    };
    let names: Vec<u8> = fields.iter().flat_map(padded).collect();
    let values: Vec<u8> = fields.iter().flat_map(|(_, value)| value.clone()).collect();
    // The length of the names is a small element.
    let length = [[5, 0, 4, 0], 32u32.to_le_bytes()].concat();
    variable(2, name, [1, 1], &[length, element(1, &names), values])
}

fn file(header: &str, end: [u8; 4], variables: &[Vec<u8>]) -> Vec<u8> {
    [format!("{header:<124}").as_bytes(), &end, &variables.concat()].concat()
}

/// Table of a file, or the reason why it has none, without the name of the file.
fn read_bytes(bytes: &[u8]) -> Result<Sheet, String> {
    let file = tempfile::NamedTempFile::with_suffix(".mat").unwrap();
    std::fs::write(file.path(), bytes).unwrap();
    let name = format!("{}: ", file.path().display());
    crate::table(file.path(), None).map_err(|error| error.to_string().replace(&name, ""))
}

fn loaded(variables: &[Vec<u8>]) -> Result<Sheet, String> {
    read_bytes(&file(PLAIN, LITTLE, variables))
}

const LITTLE: [u8; 4] = [0, 1, b'I', b'M'];

const PLAIN: &str = "MATLAB 5.0 MAT-file, Platform: PCWIN64";

/// As tyre machines write it: vectors, and their units in a structure.
#[test]
fn units_come_from_the_structure_of_the_channels() {
    let fields = [("name", cells("", &["time", "force", "SR"])), ("units", cells("", &["ms", "kN", "none"]))];
    let vectors = [matrix("time", &[&[1.0, 2.0]]), matrix("force", &[&[3.0, 4.0]]), matrix("SR", &[&[5.0, 6.0]])];
    let all = [&vectors[..], &[structure("channel", &fields)]].concat();
    let sheet = loaded(&all).unwrap();
    assert_eq!(sheet.column(&TIME).unwrap(), Some(vec![1e-3, 2e-3]));
    assert_eq!(sheet.column(&FORCE).unwrap(), Some(vec![3e3, 4e3]));
    assert_eq!(sheet.unit("SR"), Some(""));
}

/// Vectors as fields, as the columns of a matrix, and one structure for each channel.
#[test]
fn vectors_may_be_in_the_structure() {
    let head = || vec![("name", cells("", &["time", "force"])), ("units", cells("", &["ms", "kN"]))];
    let with = |more: Vec<(&'static str, Vec<u8>)>| structure("channel", &[head(), more].concat());
    let fields = with(vec![("time", matrix("", &[&[1.0, 2.0]])), ("force", matrix("", &[&[3.0, 4.0]]))]);
    let data = with(vec![("data", matrix("", &[&[1.0, 2.0], &[3.0, 4.0]]))]);
    for one in [fields, data] {
        let sheet = loaded(&[one, matrix("displacement", &[&[7.0, 8.0]])]).unwrap();
        assert_eq!(sheet.column(&TIME).unwrap(), Some(vec![1e-3, 2e-3]));
        assert_eq!(sheet.column(&FORCE).unwrap(), Some(vec![3e3, 4e3]));
        assert_eq!(sheet.column(&DISPLACEMENT).unwrap(), Some(vec![7.0, 8.0]));
    }
}

#[test]
fn what_cannot_be_read_is_refused_with_a_way_out() {
    let hdf5 =
        [&file("MATLAB 7.3 MAT-file, Platform: PCWIN64", [0, 2, b'I', b'M'], &[]), &[0; 384][..], b"\x89HDF\r\n"];
    let refusal = |bytes: &[u8]| read_bytes(bytes).unwrap_err();
    assert_eq!(refusal(&hdf5.concat()), "the file is MAT 7.3, which is HDF5: save it in MATLAB with -v7");
    assert_eq!(refusal(b"time,force\n1,2\n"), "the file is not MAT 4 or 5 (save it in MATLAB with -v7)");
    let uneven = structure("channel", &[("name", cells("", &["a", "b"])), ("units", cells("", &["s"]))]);
    assert_eq!(loaded(&[uneven]).unwrap_err(), "channel: 2 names, 1 units; must be as many");
    assert_eq!(loaded(&[]).unwrap_err(), "the file has no vectors");
    let others = [matrix("a", &[&[1.0, 2.0], &[3.0, 4.0]]), cells("b", &["x"]), variable(3, "c", [1, 1], &[])];
    let text = loaded(&others).unwrap_err();
    assert_eq!(text, "the file has no vectors; it has a (2 x 2), b{1} (text), c (object)");
    let many: Vec<Vec<u8>> = (0..10).map(|number| matrix(&format!("s{number}"), &[&[1.0]])).collect();
    assert!(loaded(&many).unwrap_err().ends_with("s6 (1 x 1), s7 (1 x 1) and 2 more"));
}

/// Variables that are not read are named: in a note, and where a column is not found.
#[test]
fn what_is_not_read_is_noted() {
    let complex = element(
        14,
        &[element(6, &[6, 8, 0, 0, 0, 0, 0, 0]), element(5, &[1, 0, 0, 0, 2, 0, 0, 0]), element(1, b"z")].concat(),
    );
    let data = structure("channel", &[("name", cells("", &["a"])), ("data", matrix("", &[&[1.0, 2.0], &[3.0, 4.0]]))]);
    let sheet = loaded(&[matrix("time", &[&[1.0, 2.0]]), complex, data]).unwrap();
    let note = "not read: z (complex numbers), channel.data (not a vector for each of 1 names)";
    assert_eq!(sheet.note(), Some(note));
    assert_eq!(sheet.missing("force").to_string(), format!("no column 'force'; there are time; {note}"));
}

/// Structures in structures, arrays of them, and cells; a name that occurs twice is that of its place.
#[test]
fn nested_vectors_are_found_by_name_or_place() {
    let inner = |value: f64| structure("", &[("force", matrix("", &[&[value, 0.5]]))]);
    let both = [element(5, &[32, 0, 0, 0]), element(1, &[b"run", &[0; 29][..]].concat())];
    let runs = variable(
        2,
        "rig",
        [1, 2],
        &[&both[..], &[inner(1.0), inner(2.0)]].concat().concat().chunks(8).map(<[u8]>::to_vec).collect::<Vec<_>>(),
    );
    let single = structure("deep", &[("er", structure("", &[("time", matrix("", &[&[7.0, 8.0]]))]))]);
    let cell = variable(1, "c", [1, 2], &[matrix("", &[&[1.0]]), matrix("", &[&[5.0, 6.0]])]);
    let sheet = loaded(&[runs, single, cell]).unwrap();
    assert_eq!(sheet.names().collect::<Vec<_>>(), ["rig(1).run.force", "rig(2).run.force", "time", "c{2}"]);
    assert_eq!(sheet.column_named("rig(2).run.force", &FORCE).unwrap(), Some(vec![2.0, 0.5]));
    assert_eq!(sheet.column(&TIME).unwrap(), Some(vec![7.0, 8.0]));
}

/// The unit of a channel is that of its own structure; for a vector that is in neither of two it would be a guess.
#[test]
fn units_of_structures_are_not_mixed_up() {
    let run = |name: &str, unit: &str| {
        let head = [("name", cells("", &["force"])), ("units", cells("", &[unit]))];
        structure(name, &[&head[..], &[("data", matrix("", &[&[1.0, 2.0]]))]].concat())
    };
    let sheet = loaded(&[run("a", "N"), run("b", "kN")]).unwrap();
    assert_eq!(["a.force", "b.force"].map(|name| sheet.unit(name).unwrap().to_owned()), ["N", "kN"]);
    let text = loaded(&[run("a", "N"), run("b", "kN"), matrix("force", &[&[1.0, 2.0]])]).unwrap_err();
    assert_eq!(text, "force: the file gives several units, N, kN");
}

/// Characters of one, two and four bytes, and one text for each row.
#[test]
fn names_may_have_any_characters() {
    let text = |kind, bytes: &[u8], dimensions| variable(4, "", dimensions, &[element(kind, bytes)]);
    let wide: Vec<u8> = [0x46u32, 0x3bc].iter().flat_map(|letter| letter.to_le_bytes()).collect();
    let names = [
        text(1, b"F\xb5", [1, 2]),
        text(2, b"F\xb5", [1, 2]),
        text(4, &[0x46, 0, 0xb5, 0], [1, 2]),
        text(16, "F\u{3bc}".as_bytes(), [1, 2]),
        text(18, &wide, [1, 2]),
    ];
    for (name, wanted) in names.into_iter().zip(["F\u{b5}", "F\u{b5}", "F\u{b5}", "F\u{3bc}", "F\u{3bc}"]) {
        let sheet = loaded(&[structure("a", &[("name", name), ("data", matrix("", &[&[1.0, 2.0]]))])]).unwrap();
        assert!(sheet.has(wanted), "{:?}", sheet.names().collect::<Vec<_>>());
    }
    // Two rows of five letters, column after column.
    let rows = text(1, b"tfiomrec e", [2, 5]);
    let both = structure("a", &[("name", rows), ("data", matrix("", &[&[1.0, 2.0, 5.0], &[3.0, 4.0, 6.0]]))]);
    let sheet = loaded(&[both]).unwrap();
    assert_eq!(sheet.column(&FORCE).unwrap(), Some(vec![3.0, 4.0, 6.0]));
}

#[test]
fn numbers_of_every_kind_are_read() {
    let mut parts = Vec::new();
    let kinds: [(u32, Vec<u8>); 10] = [
        (1, [-1i8, 2].iter().flat_map(|number| number.to_le_bytes()).collect()),
        (2, vec![255, 2]),
        (3, [-300i16, 2].iter().flat_map(|number| number.to_le_bytes()).collect()),
        (4, [65_535u16, 2].iter().flat_map(|number| number.to_le_bytes()).collect()),
        (5, [-70_000i32, 2].iter().flat_map(|number| number.to_le_bytes()).collect()),
        (6, [u32::MAX, 2].iter().flat_map(|number| number.to_le_bytes()).collect()),
        (7, [0.5f32, 2.0].iter().flat_map(|number| number.to_le_bytes()).collect()),
        (9, [0.1f64, 2.0].iter().flat_map(|number| number.to_le_bytes()).collect()),
        (12, [-(1i64 << 40), 2].iter().flat_map(|number| number.to_le_bytes()).collect()),
        (13, [1u64 << 63, 2].iter().flat_map(|number| number.to_le_bytes()).collect()),
    ];
    for (kind, bytes) in &kinds {
        parts.push(variable(6, &format!("k{kind}"), [2, 1], &[element(*kind, bytes)]));
    }
    let sheet = loaded(&parts).unwrap();
    let firsts =
        [-1.0, 255.0, -300.0, 65_535.0, -70_000.0, 4_294_967_295.0, 0.5, 0.1, -1_099_511_627_776.0, 2f64.powi(63)];
    for ((kind, _), first) in kinds.iter().zip(firsts) {
        assert_eq!(sheet.column_named(&format!("k{kind}"), &FORCE).unwrap(), Some(vec![first, 2.0]), "{kind}");
    }
}

/// The most significant byte first, as old workstations write, and no zeros after the last element.
#[test]
fn the_order_of_bytes_is_that_of_the_header() {
    let word = |value: u32| value.to_be_bytes();
    let name = [[0, 4, 0, 1], *b"time"].concat();
    let values = [word(3), word(6), [0, 3, 0, 4], [0xff, 0xfe, 0, 0]].concat();
    let head = [word(6), word(8), word(10), word(0), word(5), word(8), word(1), word(3)].concat();
    let content = [head, name, values[..14].to_vec()].concat();
    let whole = [&word(14)[..], &word(content.len() as u32), &content].concat();
    let sheet = read_bytes(&file(PLAIN, [1, 0, b'M', b'I'], &[whole])).unwrap();
    assert_eq!(sheet.column(&TIME).unwrap(), Some(vec![3.0, 4.0, -2.0]));
}

/// A compressed variable; what is damaged in it is named by both places.
#[test]
fn compressed_variables_are_read() {
    use std::io::Write;

    let compressed = |bytes: &[u8]| {
        let mut encoder = flate2::write::ZlibEncoder::new(Vec::new(), flate2::Compression::best());
        encoder.write_all(bytes).unwrap();
        let bytes = encoder.finish().unwrap();
        [&15u32.to_le_bytes()[..], &(bytes.len() as u32).to_le_bytes(), &bytes].concat()
    };
    let time = matrix("time", &[&[1.0, 2.0]]);
    let sheet = loaded(&[compressed(&time), compressed(&matrix("force", &[&[3.0, 4.0]]))]).unwrap();
    assert_eq!([&TIME, &FORCE].map(|of| sheet.column(of).unwrap()), [Some(vec![1.0, 2.0]), Some(vec![3.0, 4.0])]);
    let cut = loaded(&[compressed(&time[..time.len() - 4])]).unwrap_err();
    assert_eq!(cut, "byte 128: compressed, byte 8: an element has 72 bytes, but there are 68");
    let mut spoilt = compressed(&time);
    let last = spoilt.len() - 1;
    spoilt[last] ^= 1;
    assert!(loaded(&[spoilt]).unwrap_err().starts_with("byte 128: a compressed variable is damaged ("));
}

/// Every place of a damage is the byte at which a reader of the format stumbles.
#[test]
fn damage_is_named_with_its_byte() {
    let refusal = |variables: &[Vec<u8>]| loaded(variables).unwrap_err();
    assert_eq!(refusal(&[vec![0; 3]]), "byte 128: a tag has 4 bytes, but there are 3");
    assert_eq!(refusal(&[vec![1, 0, 5, 0, 0, 0, 0, 0]]), "byte 128: a small element has 5 bytes, must have at most 4");
    let wrong = variable(6, "a", [3, 1], &[element(9, &[0; 16])]);
    assert_eq!(refusal(&[wrong]), "byte 184: 16 bytes, must be 3 numbers of 8 bytes");
    let wrong = variable(6, "a", [3, 1], &[element(8, &[0; 24])]);
    assert_eq!(refusal(&[wrong]), "byte 184: kind 8, must be one of numbers");
    assert_eq!(refusal(&[variable(6, "a", [3, 1], &[])]), "byte 184: ends before the numbers");
    let text = refusal(&[variable(6, "a", [u32::MAX, 1], &[])]);
    assert_eq!(text, "byte 152: dimensions [4294967295, 1] are impossible");
    let many = [element(6, &[6, 0, 0, 0, 0, 0, 0, 0]), element(5, &[1; 132])].concat();
    assert_eq!(refusal(&[element(14, &many)]), "byte 152: 33 dimensions, must be at most 32");
    let none = variable(1, "a", [1 << 30, 1 << 30], &[]);
    assert_eq!(refusal(&[none]), "byte 184: ends before a cell or field");
    let deep = (0..100).fold(matrix("", &[&[1.0, 2.0]]), |inner, _| variable(1, "", [1, 1], &[inner]));
    assert!(refusal(&[deep]).ends_with("nested more than 64 levels deep"));
}

/// The header of a variable of MAT 4, its name, and its numbers.
fn version_4(kind: u32, name: &str, [height, width]: [u32; 2], rest: &[u8]) -> Vec<u8> {
    let header = [kind, height, width, 0, name.len() as u32 + 1];
    let word = |value: u32| if kind >= 1000 { value.to_be_bytes() } else { value.to_le_bytes() };
    [&header.map(word).concat()[..], name.as_bytes(), &[0], rest].concat()
}

#[test]
fn version_4_is_read() {
    let text = version_4(51, "remark", [1, 2], b"ab");
    let short: Vec<u8> = [-2i16, 3].iter().flat_map(|number| number.to_le_bytes()).collect();
    let double: Vec<u8> = [0.25f64, 0.5].iter().flat_map(|number| number.to_le_bytes()).collect();
    let sparse = version_4(2, "s", [1, 3], &[0; 24]);
    let little = [text, version_4(30, "force", [2, 1], &short), sparse, version_4(0, "time", [1, 2], &double)].concat();
    let big: Vec<u8> = [0.25f64, 0.5].iter().flat_map(|number| number.to_be_bytes()).collect();
    let sheet = read_bytes(&little).unwrap();
    assert_eq!(sheet.column(&FORCE).unwrap(), Some(vec![-2.0, 3.0]));
    assert_eq!(sheet.note(), Some("not read: s (sparse matrix)"));
    for bytes in [little.clone(), version_4(1000, "time", [2, 1], &big)] {
        assert_eq!(read_bytes(&bytes).unwrap().column(&TIME).unwrap(), Some(vec![0.25, 0.5]));
    }
    let cut = read_bytes(&little[..little.len() - 1]).unwrap_err();
    assert_eq!(cut, "byte 130: a matrix is longer than the 15 bytes that are there");
    let strange = [&little[..], &version_4(60, "a", [1, 1], &[])].concat();
    assert_eq!(read_bytes(&strange).unwrap_err(), "byte 146: kind 60 of a variable, which MAT 4 does not have");
}
