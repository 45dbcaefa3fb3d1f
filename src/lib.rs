#![doc = include_str!("../README.md")]
//!
//! # The tour
//!
//! A model is one row of `f64` with a declared table ([`mod@model`]); its outputs are written once for every [`number`]
//! type. Models share [`numerics`], [`laws`] and the description of a [`contact`] over a step. [`friction`],
//! [`shock_absorber`] and [`host`] hold one model per file, listed in the [`catalogue`]. An [`instance`] is a model in
//! use; [`fmi2`] and [`c_api`] are its interfaces.

pub mod c_api;
pub mod catalogue;
mod consistency;
pub mod contact;
mod float_mode;
pub mod fmi2;
pub mod friction;
mod guid;
pub mod host;
pub mod instance;
pub mod laws;
pub mod memory;
pub mod model;
pub mod number;
pub mod numerics;
mod panics;
#[cfg(test)]
mod probe;
pub mod reference;
mod serial;
pub mod shock_absorber;
pub mod table;
pub mod unit;
