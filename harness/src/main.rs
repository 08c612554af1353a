//! The `swayless` command.

fn main() {}
