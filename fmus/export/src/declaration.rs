//! Declarations of variables, and the walk that collects them.

use crate::unit::Unit;
use crate::variables::Enumeration;

/// The type of a variable.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Kind {
    /// A real number.
    Real,
    /// An integer.
    Integer,
    /// A structural parameter: the length of arrays.
    Size,
    /// A truth value.
    Boolean,
    /// A text.
    Text,
    /// One of some items.
    Enumeration {
        /// The name of the type.
        name: &'static str,
        /// Names and descriptions of the items.
        items: &'static [(&'static str, &'static str)],
    },
}

impl Kind {
    /// The kind of an enumeration.
    pub const fn enumeration<E: Enumeration>() -> Self {
        Self::Enumeration { name: E::NAME, items: E::ITEMS }
    }
}

/// What is declared of a variable at its field.
#[derive(Debug, Clone, PartialEq)]
pub struct Declaration {
    /// Its name; the names of the groups around it stand before, each with a dot.
    pub name: String,
    /// Its documentation.
    pub description: &'static str,
    /// Its type.
    pub kind: Kind,
    /// The length of an array.
    pub dimension: Option<usize>,
    /// Its unit.
    pub unit: Option<&'static Unit>,
    /// The least value.
    pub min: Option<f64>,
    /// The greatest value.
    pub max: Option<f64>,
    /// A typical magnitude.
    pub nominal: Option<f64>,
    /// A state or discrete variable that is an output.
    pub output: bool,
    /// A parameter that may change while the simulation runs.
    pub tunable: bool,
    /// An input that changes at events only.
    pub discrete: bool,
    /// A state whose initial value is calculated.
    pub calculated: bool,
    /// The structural parameter that sets the length of an array; its dimension is the greatest one.
    pub length: Option<&'static str>,
    /// Another name of the variable.
    pub alias: Option<&'static str>,
    /// The clocks that a discrete variable is computed by, with spaces between their names.
    pub clock: Option<&'static str>,
    /// The inputs and states that a discrete variable depends on; `None` means all.
    pub depends_on: Option<&'static [&'static str]>,
    /// The index of its first scalar within its struct.
    pub first: usize,
}

impl Declaration {
    /// How many scalars it has.
    pub fn count(&self) -> usize {
        self.dimension.unwrap_or(1)
    }

    /// The names of the clocks that it is computed by.
    pub fn clocks(&self) -> impl Iterator<Item = &'static str> {
        self.clock.unwrap_or_default().split_whitespace()
    }

    /// Whether a number lies within the bounds.
    pub fn allows(&self, value: f64) -> bool {
        value.is_finite() && self.min.is_none_or(|min| value >= min) && self.max.is_none_or(|max| value <= max)
    }
}

/// Collects declarations and puts the names of groups before them.
#[derive(Default)]
pub struct Declarer {
    prefix: String,
    found: Vec<Declaration>,
}

impl Declarer {
    /// Takes a variable with nothing said but this; what else is said of it is set in place, so that a declaration is
    /// little code: there are many.
    pub fn variable(
        &mut self,
        name: &str,
        description: &'static str,
        kind: Kind,
        dimension: Option<usize>,
    ) -> &mut Declaration {
        let first = self.found.last().map_or(0, |last| last.first + last.count());
        self.found.push_mut(Declaration {
            name: [&self.prefix, name].concat(),
            description,
            kind,
            dimension,
            unit: None,
            min: None,
            max: None,
            nominal: None,
            output: false,
            tunable: false,
            discrete: false,
            calculated: false,
            length: None,
            alias: None,
            clock: None,
            depends_on: None,
            first,
        })
    }

    /// Takes the variables of a group.
    pub fn group(&mut self, name: &str, declare: fn(&mut Self)) {
        let length = self.prefix.len();
        self.prefix.push_str(name);
        self.prefix.push('.');
        declare(self);
        self.prefix.truncate(length);
    }

    /// All that was declared.
    pub fn into_declarations(self) -> Vec<Declaration> {
        self.found
    }
}
