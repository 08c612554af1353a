//! Quantisation: what a sensor can tell apart.

/// The multiple of `step` that is next to a value; the value itself where `step` is 0, or too small to make a difference.
#[must_use]
pub fn quantise(value: f64, step: f64) -> f64 {
    let steps = value / step;
    // From here on floating-point numbers lie no closer than the steps.
    const FINEST: f64 = 1.0 / f64::EPSILON;
    if steps.is_nan() || steps.abs() >= FINEST {
        return value;
    }
    // 0 has no sign.
    steps.round() * step + 0.0
}
