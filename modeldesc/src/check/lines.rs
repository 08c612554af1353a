//! Where the parts of a document stand that do not know it themselves.

use crate::xml_in::Node;
use std::collections::HashMap;

/// The first and the last line of definitions by what they are and how they are called. Empty for a description that
/// was not read.
#[derive(Debug, Default)]
pub(super) struct Lines {
    named: HashMap<(Part, String), (usize, usize)>,
}

/// A part of the document.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Part {
    Root,
    Interface,
    Experiment,
    Unit,
    Type,
    Category,
}

impl Lines {
    pub(super) fn of(root: &Node) -> Self {
        let mut named = vec![(Part::Root, String::new(), root.line)];
        for child in &root.children {
            match child.name.as_str() {
                "ModelExchange" | "CoSimulation" | "ScheduledExecution" => {
                    named.push((Part::Interface, child.name.clone(), child.line));
                }
                "DefaultExperiment" => named.push((Part::Experiment, String::new(), child.line)),
                list @ ("UnitDefinitions" | "TypeDefinitions" | "LogCategories") => {
                    let part = match list {
                        "UnitDefinitions" => Part::Unit,
                        "TypeDefinitions" => Part::Type,
                        _ => Part::Category,
                    };
                    named.extend(child.children.iter().map(|node| (part, name(node), node.line)));
                }
                _ => {}
            }
        }
        let mut lines = Self::default();
        for (part, name, line) in named {
            lines.named.entry((part, name)).or_insert((line, line)).1 = line;
        }
        lines
    }

    /// The line of a part, 0 if it is not known.
    pub(super) fn line(&self, part: Part, name: &str) -> usize {
        self.find(part, name).0
    }

    /// The line of the last part of this name: of two definitions that clash, the later one is to blame.
    pub(super) fn last(&self, part: Part, name: &str) -> usize {
        self.find(part, name).1
    }

    fn find(&self, part: Part, name: &str) -> (usize, usize) {
        self.named.get(&(part, name.to_owned())).copied().unwrap_or_default()
    }
}

fn name(node: &Node) -> String {
    node.attributes.iter().find(|(key, _)| key == "name").map(|(_, value)| value.clone()).unwrap_or_default()
}
