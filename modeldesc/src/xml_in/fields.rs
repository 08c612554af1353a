//! Taking an element apart: every attribute is asked for once, and what nobody asked for is reported.

use super::{Node, Parse, parse_list};
use crate::problem::Report;

/// The attributes of an element while they are read.
pub(crate) struct Fields<'a> {
    node: &'a Node,
    asked: Vec<&'static str>,
}

impl<'a> Fields<'a> {
    pub(crate) fn of(node: &'a Node) -> Self {
        Self { node, asked: Vec::new() }
    }

    /// An attribute as it stands.
    pub(crate) fn get(&mut self, key: &'static str) -> Option<&'a str> {
        self.asked.push(key);
        self.node.attributes.iter().find(|(name, _)| name == key).map(|(_, value)| value.as_str())
    }

    /// A text that may be absent.
    pub(crate) fn text(&mut self, key: &'static str) -> Option<String> {
        self.get(key).map(str::to_owned)
    }

    /// A text that must be there; its absence is reported.
    pub(crate) fn required(&mut self, key: &'static str, report: &mut Report) -> String {
        self.text(key).unwrap_or_else(|| {
            self.missing(key, report);
            String::new()
        })
    }

    fn missing(&self, key: &str, report: &mut Report) {
        report.error(self.node.line, format!("`{}` needs the attribute `{key}`", self.node.name));
    }

    /// A value that may be absent; what is no such value is reported and counts as absent.
    pub(crate) fn value<T: Parse>(&mut self, key: &'static str, report: &mut Report) -> Option<T> {
        let text = self.get(key)?;
        let value = T::parse(text);
        if value.is_none() {
            self.wrong(key, text, T::EXPECTED, report);
        }
        value
    }

    /// A value that must be there; its absence is reported.
    pub(crate) fn required_value<T: Parse + Default>(&mut self, key: &'static str, report: &mut Report) -> T {
        let before = self.get(key).is_some();
        if !before {
            self.missing(key, report);
        }
        self.value(key, report).unwrap_or_default()
    }

    /// A list that may be absent.
    pub(crate) fn list<T: Parse>(&mut self, key: &'static str, report: &mut Report) -> Option<Vec<T>> {
        let text = self.get(key)?;
        match parse_list(text) {
            Ok(list) => Some(list),
            Err(item) => {
                self.wrong(key, &item, T::EXPECTED, report);
                None
            }
        }
    }

    /// A flag whose default is false.
    pub(crate) fn flag(&mut self, key: &'static str, report: &mut Report) -> bool {
        self.value(key, report).unwrap_or(false)
    }

    /// One of several names.
    pub(crate) fn one_of<T: Copy>(
        &mut self,
        key: &'static str,
        names: &[(&'static str, T)],
        report: &mut Report,
    ) -> Option<T> {
        let text = self.get(key)?;
        let found = names.iter().find(|(name, _)| *name == text.trim_ascii()).map(|(_, value)| *value);
        if found.is_none() {
            let names: Vec<&str> = names.iter().map(|(name, _)| *name).collect();
            self.wrong(key, text, &format!("one of {}", names.join(", ")), report);
        }
        found
    }

    /// One of several names, which must be there; its absence is reported.
    pub(crate) fn required_one_of<T: Copy>(
        &mut self,
        key: &'static str,
        names: &[(&'static str, T)],
        report: &mut Report,
    ) -> Option<T> {
        if self.get(key).is_none() {
            self.missing(key, report);
        }
        self.one_of(key, names, report)
    }

    fn wrong(&self, key: &str, text: &str, expected: &str, report: &mut Report) {
        let short: String = text.chars().take(40).collect();
        report.error(self.node.line, format!("`{key}` of `{}` is `{short}` but must be {expected}", self.node.name));
    }

    /// The attributes that nobody asked for.
    pub(crate) fn others(&self) -> impl Iterator<Item = &'a str> {
        self.node.attributes.iter().map(|(key, _)| key.as_str()).filter(|key| !self.asked.contains(key))
    }

    /// Reports the attributes that nobody asked for, and text where only elements may be.
    pub(crate) fn finish(self, report: &mut Report) {
        for key in self.others() {
            report.error(self.node.line, format!("`{}` has no attribute `{key}`; remove it", self.node.name));
        }
        if let Some(line) = self.node.text {
            report.error(line, format!("`{}` must not hold text", self.node.name));
        }
    }
}

/// How often an element may stand in its parent.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Child {
    /// Exactly once.
    Once(&'static str),
    /// Once or not at all.
    Maybe(&'static str),
    /// Any number of times.
    Many(&'static str),
    /// At least once: a list that must not be empty.
    Some(&'static str),
}

impl Child {
    fn name(self) -> &'static str {
        match self {
            Self::Once(name) | Self::Maybe(name) | Self::Many(name) | Self::Some(name) => name,
        }
    }
}

/// Reports elements that do not belong into `node`, stand in the wrong order, too often, or not at all.
pub(crate) fn check_children(node: &Node, allowed: &[Child], report: &mut Report) {
    check_children_but(node, allowed, &[], report);
}

/// Like [`check_children`], but `ignored` elements may stand anywhere.
pub(crate) fn check_children_but(node: &Node, allowed: &[Child], ignored: &[&str], report: &mut Report) {
    let mut seen = vec![0_usize; allowed.len()];
    let mut last = 0;
    for child in node.children.iter().filter(|child| !ignored.contains(&child.name.as_str())) {
        match allowed.iter().position(|candidate| candidate.name() == child.name) {
            None => {
                report.error(child.line, format!("`{}` does not belong into `{}`; remove it", child.name, node.name))
            }
            Some(position) => {
                if position < last {
                    report.error(child.line, format!("`{}` must stand before `{}`", child.name, allowed[last].name()));
                }
                last = last.max(position);
                seen[position] += 1;
                if seen[position] == 2 && matches!(allowed[position], Child::Once(_) | Child::Maybe(_)) {
                    report.error(child.line, format!("`{}` stands twice in `{}`", child.name, node.name));
                }
            }
        }
    }
    for (child, seen) in allowed.iter().zip(seen) {
        if let (Child::Once(name) | Child::Some(name), 0) = (child, seen) {
            report.error(node.line, format!("`{}` needs the element `{name}`", node.name));
        }
    }
}
