//! Places at which code and data of a module refer to data or to functions, as its linker lists them (`--emit-relocs`).

use std::collections::BTreeMap;
use std::ops::Range;

use anyhow::{Context, Result, bail};
use wasmparser::{KnownCustom, Linking, LinkingSectionReader, RelocSectionReader, RelocationType, SymbolInfo};

/// Start values of a part of the memory.
pub struct Part<'a> {
    pub address: u32,
    /// Bytes of the module before them.
    pub place: u64,
    pub bytes: &'a [u8],
}

/// Something that has an address.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Target {
    /// Data, by the number of their symbol.
    Data(u32),
    /// A function that is called by number.
    Function(u32),
}

/// References of a module. Places are numbers of bytes from its beginning.
#[derive(Default)]
pub struct Links {
    /// Where the contents of the sections begin.
    sections: Vec<u64>,
    /// Bytes of the symbols of data.
    parts: BTreeMap<u32, Range<u64>>,
    /// Functions by symbol.
    functions: BTreeMap<u32, u32>,
    /// Symbols by the place at which they are referred to.
    references: BTreeMap<u64, u32>,
}

impl Links {
    /// Begins the next section.
    pub fn begin_section(&mut self, at: u64) {
        self.sections.push(at);
    }

    /// Reads a section, if it is about links. It follows that of the data.
    pub fn add(&mut self, section: KnownCustom, data: &[Part]) -> Result<()> {
        match section {
            KnownCustom::Linking(reader) => self.add_symbols(&reader, data),
            KnownCustom::Reloc(reader) => self.add_references(&reader),
            _ => Ok(()),
        }
    }

    fn add_symbols(&mut self, reader: &LinkingSectionReader, data: &[Part]) -> Result<()> {
        for part in reader.subsections() {
            if let Linking::SymbolTable(symbols) = part? {
                for (at, symbol) in (0..).zip(symbols) {
                    match symbol? {
                        SymbolInfo::Func { index, .. } => drop(self.functions.insert(at, index)),
                        SymbolInfo::Data { symbol: Some(place), .. } => {
                            let part = data.get(place.index as usize).context("data of an unknown part")?;
                            let begin = part.place + u64::from(place.offset);
                            self.parts.insert(at, begin..begin + u64::from(place.size));
                        }
                        _ => {}
                    }
                }
            }
        }
        Ok(())
    }

    fn add_references(&mut self, reader: &RelocSectionReader) -> Result<()> {
        use RelocationType::{
            FunctionIndexLeb, FunctionOffsetI32, GlobalIndexLeb, MemoryAddrI32, MemoryAddrLeb, MemoryAddrSleb,
            SectionOffsetI32, TableIndexI32, TableIndexSleb, TableNumberLeb, TypeIndexLeb,
        };
        let section = self.sections.get(reader.section_index() as usize).context("links of an unknown section")?;
        for entry in reader.entries() {
            let entry = entry?;
            match entry.ty {
                MemoryAddrI32 | MemoryAddrLeb | MemoryAddrSleb | TableIndexI32 | TableIndexSleb => {
                    self.references.insert(section + u64::from(entry.offset), entry.index);
                }
                // No addresses: calls, types and places in the code.
                FunctionIndexLeb | GlobalIndexLeb | TableNumberLeb | TypeIndexLeb | FunctionOffsetI32
                | SectionOffsetI32 => {}
                other => bail!("links of the type {other:?} are not supported"),
            }
        }
        Ok(())
    }

    /// Whether the linker has listed nothing.
    pub fn is_empty(&self) -> bool {
        self.references.is_empty()
    }

    /// The bytes of a symbol of data.
    pub fn part(&self, symbol: u32) -> Range<u64> {
        self.parts[&symbol].clone()
    }

    /// Data and functions to which these bytes refer.
    pub fn of(&self, bytes: Range<u64>) -> impl Iterator<Item = Target> + '_ {
        self.references.range(bytes).filter_map(|(_, symbol)| self.target(*symbol))
    }

    /// Data or function of a symbol; none if the linker itself defines it, as it does the end of the data.
    fn target(&self, symbol: u32) -> Option<Target> {
        let function = self.functions.get(&symbol).map(|function| Target::Function(*function));
        function.or_else(|| self.parts.contains_key(&symbol).then_some(Target::Data(symbol)))
    }
}
