//! Reading XML: a tree of elements that know their lines.
//!
//! The documents come from anybody. Document type definitions, and with them all entities but the predefined, are
//! refused; nesting is limited; annotations are skipped without being kept.

mod fields;
mod values;

#[cfg(feature = "ssp")]
pub(crate) use fields::check_children_but;
pub(crate) use fields::{Child, Fields, check_children};
pub(crate) use values::{Parse, hex_bytes, parse_list};

use crate::problem::{ReadError, Report};
use quick_xml::XmlVersion;
use quick_xml::events::{BytesDecl, BytesStart, Event};
use quick_xml::name::ResolveResult;
use quick_xml::reader::NsReader;
use std::borrow::Cow;
use std::rc::Rc;

/// Deeper than any sensible system of systems, shallow enough for recursion.
const DEEPEST: usize = 128;

/// Far more than any element of the standards has. Looking for duplicates takes the square of it.
const MOST_ATTRIBUTES: usize = 1000;

/// An element.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Node {
    /// The name without its prefix.
    pub name: String,
    /// The namespace, empty if it has none.
    pub namespace: Rc<str>,
    /// The attributes without a prefix.
    pub attributes: Vec<(String, String)>,
    /// The elements inside.
    pub children: Vec<Node>,
    /// The line of text inside other than white space.
    pub text: Option<usize>,
    /// The line in which it begins, counted from 1.
    pub line: usize,
}

/// The text of a file. The standards want UTF-8, with or without a byte order mark; what declares itself to be Latin-1
/// is read, too, because many exporters did so.
pub(crate) fn decode(bytes: &[u8]) -> Result<Cow<'_, str>, ReadError> {
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    match std::str::from_utf8(bytes) {
        Ok(text) => Ok(text.into()),
        Err(_) if declares_latin1(bytes) => Ok(bytes.iter().copied().map(char::from).collect::<String>().into()),
        Err(error) => {
            let valid = &bytes[..error.valid_up_to()];
            Err(ReadError {
                line: count_lines(valid) + 1,
                message: "the text is not UTF-8; save it as UTF-8".to_owned(),
            })
        }
    }
}

fn declares_latin1(bytes: &[u8]) -> bool {
    let head = bytes.split(|b| *b == b'>').next().unwrap_or_default().to_ascii_lowercase();
    let head = String::from_utf8_lossy(&head);
    head.starts_with("<?xml")
        && ["\"iso-8859-1\"", "'iso-8859-1'", "\"windows-1252\"", "'windows-1252'"]
            .iter()
            .any(|name| head.contains(name))
}

fn count_lines(bytes: &[u8]) -> usize {
    bytes.iter().filter(|b| **b == b'\n').count()
}

/// Parses a document into its root element. A wrong encoding in the declaration is reported but does no harm any more.
pub(crate) fn parse(text: &str, report: &mut Report) -> Result<Node, ReadError> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let mut parser = Parser {
        text,
        reader: NsReader::from_str(text),
        position: 0,
        line: 1,
        namespaces: Vec::new(),
        open: Vec::new(),
        skipped: 0,
        root: None,
    };
    while parser.step(report)? {}
    parser.root.ok_or_else(|| ReadError { line: 0, message: "there is no XML element".to_owned() })
}

struct Parser<'a> {
    text: &'a str,
    reader: NsReader<&'a [u8]>,
    /// Up to where `line` has been counted.
    position: usize,
    line: usize,
    /// Seen so far, shared by the nodes.
    namespaces: Vec<Rc<str>>,
    open: Vec<Node>,
    /// How deep inside annotations.
    skipped: usize,
    root: Option<Node>,
}

impl<'a> Parser<'a> {
    fn error(&self, message: impl Into<String>) -> ReadError {
        ReadError { line: self.line, message: message.into() }
    }

    fn count_to(&mut self, position: u64) {
        let position = usize::try_from(position).unwrap_or(usize::MAX).min(self.text.len());
        if position > self.position {
            self.line += count_lines(&self.text.as_bytes()[self.position..position]);
            self.position = position;
        }
    }

    /// Takes one event; false at the end.
    fn step(&mut self, report: &mut Report) -> Result<bool, ReadError> {
        let at = self.reader.buffer_position();
        self.count_to(at);
        let (namespace, event) = match self.reader.read_resolved_event() {
            Ok((ResolveResult::Bound(namespace), event)) => (Some(namespace.into_inner().to_owned()), event),
            Ok((ResolveResult::Unbound, event)) => (None, event),
            Ok((ResolveResult::Unknown(prefix), _)) => {
                return Err(self.error(format!("the prefix `{prefix}` is not bound to a namespace")));
            }
            Err(error) => {
                let at = self.reader.error_position();
                self.count_to(at);
                return Err(self.error(format!("not well-formed XML: {error}")));
            }
        };
        match event {
            Event::Start(start) => {
                if self.skipped > 0 || self.is_annotation(&start) {
                    self.skipped += 1;
                } else {
                    let node = self.node(&start, namespace)?;
                    self.open.push(node);
                    if self.open.len() > DEEPEST {
                        return Err(self.error(format!("elements are nested more than {DEEPEST} deep")));
                    }
                }
            }
            Event::Empty(start) if self.skipped == 0 && !self.is_annotation(&start) => {
                let node = self.node(&start, namespace)?;
                self.close(node)?;
            }
            Event::End(_) if self.skipped > 0 => self.skipped -= 1,
            Event::End(_) => match self.open.pop() {
                Some(node) => self.close(node)?,
                None => return Err(self.error("an end tag without a start tag")),
            },
            Event::Text(text) if self.skipped == 0 && !text.trim_ascii().is_empty() => {
                self.count_to(at + (text.len() - text.trim_ascii_start().len()) as u64);
                self.text_found()?;
            }
            Event::CData(_) | Event::GeneralRef(_) if self.skipped == 0 => self.text_found()?,
            Event::DocType(_) => {
                return Err(self.error("a document type definition is not allowed here; remove it"));
            }
            Event::Decl(declaration) => self.declaration(&declaration, report)?,
            Event::Eof if !self.open.is_empty() || self.skipped > 0 => {
                let name = self.open.last().map_or("Annotations", |node| &node.name);
                return Err(self.error(format!("the document ends inside `{name}`; it seems to be cut off")));
            }
            Event::Eof => return Ok(false),
            _ => {}
        }
        Ok(true)
    }

    /// Annotations may hold anything, and nothing that we read. The root is never one.
    fn is_annotation(&self, start: &BytesStart<'_>) -> bool {
        !self.open.is_empty()
            && matches!(start.local_name().into_inner(), "Annotations" | "VendorAnnotations" | "Annotation")
    }

    fn declaration(&self, declaration: &BytesDecl<'_>, report: &mut Report) -> Result<(), ReadError> {
        match declaration.encoding() {
            None => Ok(()),
            Some(Ok(name)) if name.eq_ignore_ascii_case("utf-8") || name.eq_ignore_ascii_case("us-ascii") => Ok(()),
            Some(Ok(name)) => {
                report.error(
                    self.line,
                    format!("the encoding is declared as {name} but must be UTF-8; convert the file"),
                );
                Ok(())
            }
            Some(Err(error)) => Err(self.error(format!("not well-formed XML declaration: {error}"))),
        }
    }

    fn node(&mut self, start: &BytesStart<'_>, namespace: Option<String>) -> Result<Node, ReadError> {
        let namespace = namespace.unwrap_or_default();
        let namespace = match self.namespaces.iter().find(|known| ***known == *namespace) {
            Some(known) => known.clone(),
            None => {
                let new: Rc<str> = namespace.into();
                self.namespaces.push(new.clone());
                new
            }
        };
        let mut attributes = Vec::new();
        for (count, attribute) in start.attributes().enumerate() {
            if count >= MOST_ATTRIBUTES {
                return Err(self.error(format!("`{}` has too many attributes", name_for_messages(start))));
            }
            let attribute =
                attribute.map_err(|error| self.error(format!("`{}`: {error}", name_for_messages(start))))?;
            let key = attribute.key.into_inner();
            let value = attribute
                .normalized_value(XmlVersion::Explicit1_0)
                .map_err(|error| self.error(format!("attribute `{key}`: {error}")))?;
            if attribute.value.contains('<') {
                return Err(self.error(format!("attribute `{key}` holds a `<`; write `&lt;`")));
            }
            if let Some(c) = value.chars().find(|c| !is_xml_character(*c)) {
                return Err(self.error(format!("attribute `{key}` holds {c:?}, which XML does not allow")));
            }
            // Attributes with a prefix belong to other standards: xmlns:…, xsi:schemaLocation, ….
            if !key.contains(':') && key != "xmlns" {
                attributes.push((key.to_owned(), value.into_owned()));
            }
        }
        Ok(Node {
            name: start.local_name().into_inner().to_owned(),
            namespace,
            attributes,
            children: Vec::new(),
            text: None,
            line: self.line,
        })
    }

    fn close(&mut self, node: Node) -> Result<(), ReadError> {
        match self.open.last_mut() {
            Some(parent) => parent.children.push(node),
            None if self.root.is_none() => self.root = Some(node),
            None => return Err(self.error(format!("a second root element, `{}`", node.name))),
        }
        Ok(())
    }

    fn text_found(&mut self) -> Result<(), ReadError> {
        match self.open.last_mut() {
            Some(node) => {
                node.text.get_or_insert(self.line);
                Ok(())
            }
            None => Err(self.error("text outside of the root element")),
        }
    }
}

fn name_for_messages(start: &BytesStart<'_>) -> String {
    start.name().into_inner().to_owned()
}

/// `Char` of XML 1.0; surrogates are no `char`s.
fn is_xml_character(c: char) -> bool {
    !matches!(c, '\0'..='\u{8}' | '\u{b}' | '\u{c}' | '\u{e}'..='\u{1f}' | '\u{fffe}' | '\u{ffff}')
}

#[cfg(test)]
mod tests {
    use super::*;

    fn good_or(text: &str) -> Result<Node, ReadError> {
        parse(text, &mut Report::default())
    }

    #[track_caller]
    fn fails(text: &str, line: usize, part: &str) {
        let error = good_or(text).unwrap_err();
        assert_eq!(error.line, line, "{error}");
        assert!(error.message.contains(part), "{error}");
    }

    #[test]
    fn elements_know_their_lines() {
        let root = good_or("<?xml version='1.0'?>\n<a>\n  <b x='1'\n y='2'/>\n  <c/></a>\n").unwrap();
        assert_eq!((root.line, root.children[0].line, root.children[1].line), (2, 3, 5));
        assert_eq!(root.children[0].attributes, [("x".into(), "1".into()), ("y".into(), "2".into())]);
    }

    #[test]
    fn annotations_are_skipped_whatever_they_hold() {
        let deep = "<x>".repeat(10_000) + "text" + &"</x>".repeat(10_000);
        let root = good_or(&format!("<a><Annotations>{deep}</Annotations><Annotations/><b/></a>")).unwrap();
        assert_eq!(root.children.len(), 1);
        assert_eq!(root.text, None);
    }

    #[test]
    fn namespaces_are_resolved() {
        let root = good_or("<p:a xmlns:p='urn:x' p:z='1'><b/></p:a>").unwrap();
        assert_eq!((&*root.name, &*root.namespace, root.attributes.len()), ("a", "urn:x", 0));
        assert_eq!(&*root.children[0].namespace, "");
        fails("<q:a/>", 1, "prefix `q`");
    }

    #[test]
    fn what_is_not_well_formed_is_an_error_with_its_line() {
        fails("", 0, "no XML element");
        fails("<a>\n<b>\n</a>", 3, "well-formed");
        fails("<a>\n\n", 3, "ends inside `a`");
        fails("<a><Annotations>", 1, "cut off");
        fails("<a/><b/>", 1, "second root");
        fails("<a/>\nx", 2, "outside");
        fails("\n<a x='1' x='2'/>", 2, "duplicate");
        fails("<a x='&nbsp;'/>", 1, "nbsp");
        fails("<a x='&#1;'/>", 1, "does not allow");
        fails("<a x='<'/>", 1, "&lt;");
        fails("<!DOCTYPE a [<!ENTITY b 'bb'>]>\n<a x='&b;'/>", 1, "document type");
        fails(&"<a>".repeat(100_000), 1, "nested");
        let many: String = (0..100_000).map(|n| format!(" a{n}=''")).collect();
        fails(&format!("<a{many}/>"), 1, "too many attributes");
    }

    #[test]
    fn other_encodings_are_refused_with_the_line() {
        assert_eq!(decode(b"\xef\xbb\xbf<a/>").unwrap(), "<a/>");
        assert_eq!(decode(b"<a>\n\n\xe4</a>").unwrap_err().line, 3);
        assert_eq!(decode(b"\xff\xfe<\0a\0/\0>\0").unwrap_err().line, 1);
    }

    #[test]
    fn latin_1_is_read_and_reported() {
        let bytes = b"<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?><a b='\xe4'/>";
        let mut report = Report::default();
        let root = parse(&decode(bytes).unwrap(), &mut report).unwrap();
        assert_eq!(root.attributes[0].1, "ä");
        assert!(report.into_problems()[0].message.contains("ISO-8859-1"));
    }
}
