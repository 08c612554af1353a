//! Black-box tests of built FMUs: everything is in `tests/blackbox`.
