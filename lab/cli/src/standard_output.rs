//! The standard output of the program: `print!` and `println!` of the standard library end it with a panic when whoever
//! reads the output has closed it, as `head` and `less` do.

use std::fmt::Arguments;
use std::io::{ErrorKind, Write, stdout};
use std::process::exit;

/// Writes a text. Where nobody reads it any more, the program goes on, since it may have files to write.
pub fn write(text: Arguments) {
    match stdout().write_fmt(text) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            eprintln!("stribeck: standard output: {error}");
            exit(1);
        }
        _ => {}
    }
}

macro_rules! print {
    ($($text:tt)*) => { $crate::standard_output::write(format_args!($($text)*)) };
}

macro_rules! println {
    ($($text:tt)*) => {{ print!($($text)*); print!("\n"); }};
}
