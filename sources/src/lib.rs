//! One model behind functions of numbers: the WebAssembly from which `fmu-build sources` makes C.
//!
//! The module imports nothing, and its memory never grows: an instance of the module has one instance of the model, all of
//! whose memory is allocated by [`calls::model_create`]. Texts and bytes are read and written at addresses that the
//! functions return. There is no function for what C does without the model: arrays, the states of FMI, logs.

mod calls;
mod law;
mod model;
#[cfg(target_arch = "wasm32")]
mod room;
mod state;
