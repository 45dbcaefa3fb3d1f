//! The types of the page are those of the library.

#[test]
fn types_of_the_page_are_those_of_the_library() {
    let written = include_str!("../page/types.ts");
    let wanted = stribeck_page::types();
    let differs = written.lines().zip(wanted.lines()).find(|(written, wanted)| written != wanted);
    assert!(written == wanted, "run `cargo run -p stribeck-page --example types`: {differs:?}");
}
