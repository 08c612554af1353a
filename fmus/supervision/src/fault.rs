//! What can be wrong.

use serde::{Deserialize, Serialize};

/// What is wrong.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Fault {
    /// Nothing.
    #[default]
    None,
    /// A command or the swing is no number, or beyond what can be.
    Input,
    /// A position has not been valid for too long.
    PositionInvalid,
    /// A position has for too long been where the axis cannot be.
    PositionImplausible,
    /// A position does not change although the axis should have moved.
    PositionFrozen,
    /// The hook has not been seen for too long.
    HookInvalid,
}

/// A fault, and the axis that it is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Finding {
    /// What is wrong.
    pub fault: Fault,
    /// The axis, counted from 1; 0 if it is of none.
    pub axis: u8,
}

impl Finding {
    /// Nothing is wrong.
    pub const NONE: Self = Self { fault: Fault::None, axis: 0 };

    /// This, or the other if this is nothing.
    #[must_use]
    pub fn or(self, other: Self) -> Self {
        match (self.is_fault(), other.is_fault()) {
            (true, _) => self,
            (false, true) => other,
            (false, false) => Self::NONE,
        }
    }

    /// Whether something is wrong.
    #[must_use]
    pub fn is_fault(&self) -> bool {
        self.fault != Fault::None
    }
}
