//! Vector drive of one crane axis.
