//! Writes the files that derive from the tables of the models, checks them, and packs FMUs.

mod dependencies;
mod project;
mod text;
mod xml;

fn main() {
    for m in stribeck::catalogue::models() { print!("{}", xml::model_description(m, project::release_date()).unwrap()); }
}
