//! Source of an operator's command.
