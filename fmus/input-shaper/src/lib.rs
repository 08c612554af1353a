//! Input shaper for one axis.
