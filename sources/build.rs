//! Names the only model of this library: that of the environment variable `STRIBECK_MODEL`, such as `friction::LuGre`;
//! `STRIBECK_STACK` is the size of its stack, and `STRIBECK_SLOPES` is 0 if its inputs never have slopes. They concern this
//! crate only: the others are built once for all models. `STRIBECK_LAW` is the only law of a model that has a choice; with
//! `--cfg stribeck_one_law` the library holds no other.

use std::path::PathBuf;
use std::{env, fs};

fn main() {
    for name in ["STRIBECK_MODEL", "STRIBECK_STACK", "STRIBECK_SLOPES", "STRIBECK_LAW"] {
        println!("cargo:rerun-if-env-changed={name}");
    }
    println!("cargo:rerun-if-changed=build.rs");
    let model = env::var("STRIBECK_MODEL").unwrap_or("friction::LuGre".into());
    let out = PathBuf::from(env::var_os("OUT_DIR").expect("cargo names a folder"));
    let has_slopes = env::var("STRIBECK_SLOPES").as_deref() != Ok("0");
    let law = env::var("STRIBECK_LAW").ok();
    let text = format!(
        "/// The model.\npub type Chosen = stribeck::{model};\n\n/// Whether inputs can have slopes.\npub const HAS_SLOPES: bool = \
         {has_slopes};\n\n/// The only law of a model that has a choice.\npub const LAW: Option<&str> = {law:?};\n"
    );
    fs::write(out.join("model.rs"), text).expect("the folder can be written");
    if env::var("CARGO_CFG_TARGET_ARCH").is_ok_and(|architecture| architecture == "wasm32") {
        let stack = env::var("STRIBECK_STACK").unwrap_or("65536".into());
        // The stack is first, so that one that is too small is noticed; the heap base is the end of the memory in use; what
        // refers to data and functions is listed.
        for argument in ["--stack-first", "--export=__heap_base", "--emit-relocs", &format!("-zstack-size={stack}")] {
            println!("cargo:rustc-link-arg={argument}");
        }
    }
}
