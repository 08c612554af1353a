//! Black-box tests of built FMUs.
