//! Types of values.

use anyhow::{Result, bail};
use wasmparser::{BlockType, ValType};

/// Type of a value of WebAssembly.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    I32,
    I64,
    F32,
    F64,
}

impl Kind {
    pub fn of(kind: ValType) -> Result<Kind> {
        Ok(match kind {
            ValType::I32 => Kind::I32,
            ValType::I64 => Kind::I64,
            ValType::F32 => Kind::F32,
            ValType::F64 => Kind::F64,
            other => bail!("values of type {other} are not supported"),
        })
    }

    /// The only value of a block, if there is one.
    pub fn of_block(block: BlockType) -> Result<Option<Kind>> {
        match block {
            BlockType::Empty => Ok(None),
            BlockType::Type(kind) => Kind::of(kind).map(Some),
            BlockType::FuncType(_) => bail!("blocks with several values are not supported"),
        }
    }

    /// The type in C.
    pub fn c(self) -> &'static str {
        match self {
            Kind::I32 => "u32",
            Kind::I64 => "u64",
            Kind::F32 => "float",
            Kind::F64 => "double",
        }
    }

    /// Letter of the variables of this type.
    pub fn letter(self) -> char {
        match self {
            Kind::I32 => 'i',
            Kind::I64 => 'j',
            Kind::F32 => 'f',
            Kind::F64 => 'd',
        }
    }
}
