//! Orders and loops.
