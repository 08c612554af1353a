//! Writing XML: elements with escaped attributes, in the order they are given, indented.

use quick_xml::Writer;
use quick_xml::events::attributes::Attribute;
use quick_xml::events::{BytesDecl, BytesEnd, BytesStart, Event};
use quick_xml::name::QName;
use std::borrow::Cow;

/// A start tag in the making.
pub(crate) struct Element {
    start: BytesStart<'static>,
    name: &'static str,
    illegal: Option<IllegalCharacter>,
}

/// A character that XML 1.0 cannot hold, not even escaped.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct IllegalCharacter {
    pub element: &'static str,
    pub attribute: String,
    pub character: char,
}

impl Element {
    pub(crate) fn new(name: &'static str) -> Self {
        Self { start: BytesStart::new(name), name, illegal: None }
    }

    /// An attribute.
    pub(crate) fn text(mut self, key: &str, value: &str) -> Self {
        match escape(value) {
            Ok(value) => self.start.push_attribute(Attribute { key: QName(key), value }),
            Err(character) => {
                self.illegal.get_or_insert(IllegalCharacter {
                    element: self.name,
                    attribute: key.to_owned(),
                    character,
                });
            }
        }
        self
    }

    /// An attribute that may be absent.
    pub(crate) fn maybe(self, key: &str, value: Option<&str>) -> Self {
        match value {
            Some(value) => self.text(key, value),
            None => self,
        }
    }

    /// An attribute of type `xs:double`.
    pub(crate) fn float(self, key: &str, value: f64) -> Self {
        self.text(key, &float(value))
    }

    /// An attribute of type `xs:double` that may be absent.
    pub(crate) fn maybe_float(self, key: &str, value: Option<f64>) -> Self {
        match value {
            Some(value) => self.float(key, value),
            None => self,
        }
    }

    /// An attribute whose default is false.
    pub(crate) fn flag(self, key: &str, value: bool) -> Self {
        if value { self.text(key, "true") } else { self }
    }

    /// An attribute with a default, which is not written.
    pub(crate) fn unless_default<T: PartialEq + ToString>(self, key: &str, value: T, default: T) -> Self {
        if value == default { self } else { self.text(key, &value.to_string()) }
    }
}

/// A document in the making. The first illegal character is kept until the end, so that the walk over the content needs
/// no error handling of its own.
pub(crate) struct Document {
    writer: Writer<Vec<u8>>,
    open: Vec<&'static str>,
    illegal: Option<IllegalCharacter>,
}

impl Document {
    pub(crate) fn new() -> Self {
        let mut document =
            Self { writer: Writer::new_with_indent(Vec::new(), b' ', 2), open: Vec::new(), illegal: None };
        document.event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)));
        document
    }

    fn event(&mut self, event: Event<'_>) {
        // A `Vec` takes every byte; the result only exists because other sinks may not.
        let written = self.writer.write_event(event);
        debug_assert!(written.is_ok());
    }

    fn note(&mut self, illegal: Option<IllegalCharacter>) {
        if self.illegal.is_none() {
            self.illegal = illegal;
        }
    }

    /// An element without content.
    pub(crate) fn empty(&mut self, element: Element) {
        self.note(element.illegal);
        self.event(Event::Empty(element.start));
    }

    /// Opens an element; [`Document::close`] ends it.
    pub(crate) fn open(&mut self, element: Element) {
        self.note(element.illegal);
        self.open.push(element.name);
        self.event(Event::Start(element.start));
    }

    /// Ends the innermost open element.
    pub(crate) fn close(&mut self) {
        if let Some(name) = self.open.pop() {
            self.event(Event::End(BytesEnd::new(name)));
        }
    }

    /// An element that is only there when its content is: the standards' lists may be absent but not empty.
    pub(crate) fn list<T>(&mut self, name: &'static str, items: &[T], mut each: impl FnMut(&mut Self, &T)) {
        if items.is_empty() {
            return;
        }
        self.open(Element::new(name));
        for item in items {
            each(self, item);
        }
        self.close();
    }

    /// The text, with a newline at its end.
    pub(crate) fn finish(mut self) -> Result<String, IllegalCharacter> {
        while !self.open.is_empty() {
            self.close();
        }
        match self.illegal {
            Some(illegal) => Err(illegal),
            None => {
                let mut text = String::from_utf8_lossy(&self.writer.into_inner()).into_owned();
                text.push('\n');
                Ok(text)
            }
        }
    }
}

/// A number as `xs:double` writes it, with the fewest digits that read back to the same bits.
pub(crate) fn float(value: f64) -> String {
    if value.is_nan() {
        "NaN".to_owned()
    } else if value.is_infinite() {
        if value > 0.0 { "INF" } else { "-INF" }.to_owned()
    } else {
        // unlike `{}`, `{:?}` writes 1e300 and not three hundred digits
        format!("{value:?}")
    }
}

/// The items of an `xs:list`.
pub(crate) fn join<T>(items: &[T], each: impl Fn(&T) -> String) -> String {
    items.iter().map(each).collect::<Vec<_>>().join(" ")
}

/// `xs:hexBinary`.
pub(crate) fn hex(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02X}")).collect()
}

/// An attribute value; line breaks and tabs are written as references, or else the parser would make them spaces.
fn escape(value: &str) -> Result<Cow<'static, str>, char> {
    let mut escaped = String::with_capacity(value.len());
    for c in value.chars() {
        match c {
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '&' => escaped.push_str("&amp;"),
            '"' => escaped.push_str("&quot;"),
            '\t' => escaped.push_str("&#9;"),
            '\n' => escaped.push_str("&#10;"),
            '\r' => escaped.push_str("&#13;"),
            '\0'..='\u{1f}' | '\u{fffe}' | '\u{ffff}' => return Err(c),
            c => escaped.push(c),
        }
    }
    Ok(Cow::Owned(escaped))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_xs_doubles() {
        for (value, text) in [
            (0.0, "0.0"),
            (-0.0, "-0.0"),
            (0.1, "0.1"),
            (1e300, "1e300"),
            (f64::INFINITY, "INF"),
            (f64::NEG_INFINITY, "-INF"),
            (f64::NAN, "NaN"),
        ] {
            assert_eq!(float(value), text);
        }
    }

    #[test]
    fn what_xml_cannot_hold_is_refused() {
        let mut document = Document::new();
        document.empty(Element::new("a").text("b", "x\u{1}"));
        let illegal = document.finish().unwrap_err();
        assert_eq!((illegal.element, illegal.character), ("a", '\u{1}'));
    }

    #[test]
    fn white_space_in_attributes_survives() {
        let mut document = Document::new();
        document.empty(Element::new("a").text("b", "<1>\n\t\"&"));
        assert_eq!(
            document.finish().unwrap(),
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<a b=\"&lt;1&gt;&#10;&#9;&quot;&amp;\"/>\n"
        );
    }
}
