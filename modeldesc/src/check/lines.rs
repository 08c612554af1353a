//! Where the parts of a document stand that do not know it themselves.

use crate::xml_in::Node;

/// The lines of definitions by what they are and how they are called. Empty for a description that was not read.
#[derive(Debug, Default)]
pub(super) struct Lines {
    named: Vec<(Part, String, usize)>,
}

/// A part of the document.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
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
        Self { named }
    }

    /// The line of a part, 0 if it is not known.
    pub(super) fn line(&self, part: Part, name: &str) -> usize {
        self.nth(part, name, 0)
    }

    /// The line of the last part of this name: of two definitions that clash, the later one is to blame.
    pub(super) fn last(&self, part: Part, name: &str) -> usize {
        let count = self.named.iter().filter(|(p, n, _)| *p == part && n == name).count();
        self.nth(part, name, count.saturating_sub(1))
    }

    fn nth(&self, part: Part, name: &str, n: usize) -> usize {
        self.named.iter().filter(|(p, known, _)| *p == part && known == name).nth(n).map_or(0, |(_, _, line)| *line)
    }
}

fn name(node: &Node) -> String {
    node.attributes.iter().find(|(key, _)| key == "name").map(|(_, value)| value.clone()).unwrap_or_default()
}
