//! Terminals: variables that are connected together, by the names under which they find each other.

/// A group of variables that a user connects with one line. Members of two connected terminals that have the same name
/// are joined; the rest stays open.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Terminal {
    /// Its name.
    pub name: &'static str,
    /// One line.
    pub description: &'static str,
    /// What it is for, in a word. Terminals of one kind name their members alike, whatever FMU they belong to.
    pub kind: &'static str,
    /// The members: the name of a variable, and the name under which it is a member.
    pub members: &'static [(&'static str, &'static str)],
}
