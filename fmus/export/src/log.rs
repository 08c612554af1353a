//! Log messages: their categories, and the sink that an FMI version provides.

use std::sync::Arc;

/// How a call ended when it did not end well. The numbers are the same in FMI 2.0 and FMI 3.0.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// The call was refused; the instance is unchanged.
    Discard = 2,
    /// The instance cannot go on before it is reset.
    Error = 3,
    /// No instance can go on.
    Fatal = 4,
}

/// A log category.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Category {
    /// Events.
    Events,
    /// What a returned status means.
    Status(Severity),
}

impl Category {
    /// All categories with their descriptions, in the order of their bits.
    pub const ALL: [(&'static str, &'static str); 5] = [
        ("logEvents", "State events and time events"),
        ("logStatusDiscard", "Why a function returned Discard"),
        ("logStatusError", "Why a function returned Error"),
        ("logStatusFatal", "Why a function returned Fatal"),
        ("logAll", "All messages"),
    ];

    fn position(self) -> usize {
        match self {
            Self::Events => 0,
            Self::Status(severity) => severity as usize - 1,
        }
    }

    /// Its name.
    pub fn name(self) -> &'static str {
        Self::ALL[self.position()].0
    }
}

/// Takes the messages of an instance to the importer.
pub trait Sink: Send + Sync {
    /// Hands a message over, with the status as FMI numbers it.
    fn emit(&self, instance: &str, status: i32, category: &str, message: &str);
}

/// The log of an instance.
pub struct Log {
    sink: Arc<dyn Sink>,
    on: bool,
    /// One bit for each of [`Category::ALL`].
    categories: u8,
}

impl Log {
    /// A log of all categories.
    pub fn new(sink: Arc<dyn Sink>, on: bool) -> Self {
        Self { sink, on, categories: u8::MAX }
    }

    /// A second log with the same sink and the settings of now.
    pub fn twin(&self) -> Self {
        Self { sink: Arc::clone(&self.sink), ..*self }
    }

    /// Turns logging on or off for the categories named, for all if there are none. Returns the first unknown name.
    pub fn set<'a>(&mut self, on: bool, names: impl ExactSizeIterator<Item = &'a str>) -> Result<(), String> {
        let mut bits = if names.len() == 0 { u8::MAX } else { 0 };
        for name in names {
            match Category::ALL.iter().position(|(known, _)| *known == name) {
                Some(4) => bits = u8::MAX,
                Some(bit) => bits |= 1 << bit,
                None => return Err(name.to_string()),
            }
        }
        self.on = on;
        self.categories = bits;
        Ok(())
    }

    /// Whether a message of the category would be handed over. Errors always are.
    pub fn wants(&self, category: Category) -> bool {
        category >= Category::Status(Severity::Error) || self.on && self.categories >> category.position() & 1 == 1
    }

    /// Hands a message over, if it is wanted.
    pub fn write(&self, instance: &str, category: Category, message: &str) {
        if self.wants(category) {
            let status = match category {
                Category::Events => 0,
                Category::Status(severity) => severity as i32,
            };
            self.sink.emit(instance, status, category.name(), message);
        }
    }
}

impl PartialOrd for Category {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        self.position().partial_cmp(&other.position())
    }
}
