//! XML from structs.

use quick_xml::se::{QuoteLevel, Serializer};
use serde::Serialize;

/// Namespace of the elements that all files share.
pub const COMMON: &str = "http://ssp-standard.org/SSP1/SystemStructureCommon";

/// The text of a document, whose type names the root element.
pub fn text(document: &impl Serialize) -> String {
    let mut text = String::from("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    let mut serializer = Serializer::new(&mut text);
    serializer.indent(' ', 2).set_quote_level(QuoteLevel::Full);
    document.serialize(serializer).expect("structs of strings and numbers have a text");
    text + "\n"
}
