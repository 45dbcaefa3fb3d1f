//! Names the only model of this library: that of the environment variable `STRIBECK_MODEL`, such as `friction::LuGre`.

use std::path::PathBuf;
use std::{env, fs};

fn main() {
    println!("cargo:rerun-if-env-changed=STRIBECK_MODEL");
    println!("cargo:rerun-if-changed=build.rs");
    let model = env::var("STRIBECK_MODEL").unwrap_or("friction::LuGre".into());
    let out = PathBuf::from(env::var_os("OUT_DIR").expect("cargo names a folder"));
    let text = format!("/// The model.\npub type Chosen = stribeck::{model};\n");
    fs::write(out.join("model.rs"), text).expect("the folder can be written");
}
