//! Names the only model of this library: that of the environment variable `STRIBECK_MODEL`, such as `friction::LuGre`;
//! `STRIBECK_STACK` is the size of its stack. Both concern this crate only: the others are built once for all models.

use std::path::PathBuf;
use std::{env, fs};

fn main() {
    println!("cargo:rerun-if-env-changed=STRIBECK_MODEL");
    println!("cargo:rerun-if-env-changed=STRIBECK_STACK");
    println!("cargo:rerun-if-changed=build.rs");
    let model = env::var("STRIBECK_MODEL").unwrap_or("friction::LuGre".into());
    let out = PathBuf::from(env::var_os("OUT_DIR").expect("cargo names a folder"));
    let text = format!("/// The model.\npub type Chosen = stribeck::{model};\n");
    fs::write(out.join("model.rs"), text).expect("the folder can be written");
    if env::var("CARGO_CFG_TARGET_ARCH").is_ok_and(|architecture| architecture == "wasm32") {
        let stack = env::var("STRIBECK_STACK").unwrap_or("65536".into());
        // The stack is first, so that one that is too small is noticed; the heap base is the end of the memory in use.
        for argument in ["--stack-first", "--export=__heap_base", &format!("-zstack-size={stack}")] {
            println!("cargo:rustc-link-arg={argument}");
        }
    }
}
