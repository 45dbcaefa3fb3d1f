//! Writes the types of the page's questions and answers into `page/types.ts`.

fn main() -> std::io::Result<()> {
    std::fs::write(concat!(env!("CARGO_MANIFEST_DIR"), "/page/types.ts"), stribeck_page::types())
}
