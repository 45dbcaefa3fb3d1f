#![doc = include_str!("../README.md")]
//!
//! # The tour
//!
//! A model is one row of `f64` with a declared table ([`mod@model`]); its outputs are written once for every [`number`]
//! type. Models share [`numerics`], [`laws`] and the description of a [`contact`] over a step. [`friction`],
//! [`component`], [`shock_absorber`] and [`host`] hold one model per file, listed in the [`catalogue`]. An [`instance`]
//! is a model in use, which [`series`] leads along samples of its inputs; a [`batch`] works on many rows of a law at
//! once. The crate exports no C functions: those of FMI and of `stribeck.h` are in `stribeck-ffi`, from which the
//! library in every FMU is made.

// Tests take another road.
#![cfg_attr(not(test), deny(clippy::disallowed_methods))]

pub mod arrays;
pub mod batch;
pub mod catalogue;
pub mod component;
mod consistency;
pub mod contact;
pub mod friction;
pub mod guid;
pub mod host;
pub mod instance;
pub mod laws;
pub mod memory;
pub mod model;
pub mod number;
pub mod numerics;
pub mod reference;
pub mod serial;
pub mod series;
pub mod shock_absorber;
pub mod table;
pub mod unit;

/// Whether a source file, as a panic names it, belongs to this crate.
pub fn is_own_file(file: &str) -> bool {
    file!().strip_suffix("lib.rs").is_some_and(|folder| file.starts_with(folder))
}
