//! XML, one element per line.

use std::io;

use anyhow::Result;
use quick_xml::events::{BytesDecl, Event};
use quick_xml::writer::{ElementWriter, Writer};

/// A document that is being written.
pub type Xml = Writer<Vec<u8>>;

/// Attributes of an element, in their order.
pub type Attributes = Vec<(&'static str, String)>;

/// Elements that have one attribute per line if there are many, so that changing one changes one line.
const TALL: [&str; 4] = ["fmiModelDescription", "ModelExchange", "CoSimulation", "fmiReferences"];

/// The text of a document with this root.
pub fn document(
    root: &'static str,
    attributes: Attributes,
    children: impl FnOnce(&mut Xml) -> io::Result<()>,
) -> Result<String> {
    let mut xml = Writer::new_with_indent(Vec::new(), b' ', 2);
    xml.write_event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)))?;
    parent(&mut xml, root, attributes, children)?;
    Ok(String::from_utf8(xml.into_inner())? + "\n")
}

/// An element with children.
pub fn parent(
    xml: &mut Xml,
    name: &'static str,
    attributes: Attributes,
    children: impl FnOnce(&mut Xml) -> io::Result<()>,
) -> io::Result<()> {
    element(xml, name, &attributes).write_inner_content(children)?;
    Ok(())
}

/// An element without children.
pub fn leaf(xml: &mut Xml, name: &'static str, attributes: Attributes) -> io::Result<()> {
    element(xml, name, &attributes).write_empty()?;
    Ok(())
}

fn element<'a>(xml: &'a mut Xml, name: &'static str, attributes: &Attributes) -> ElementWriter<'a, Vec<u8>> {
    let is_long = attributes.len() > 8 && TALL.contains(&name);
    attributes.iter().fold(xml.create_element(name), |tag, (key, value)| {
        let tag = if is_long { tag.new_line() } else { tag };
        tag.with_attribute((*key, value.as_str()))
    })
}
