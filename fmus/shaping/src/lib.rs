//! Design and analysis of input shapers.
