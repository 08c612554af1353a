//! The shapers that a controller works with.

use swayless_shaping::{Kind, Mode, Shaper, convolve, design};

/// ZV for each of up to two modes, one after the other.
#[must_use]
pub fn zero_vibration(modes: [Option<Mode>; 2]) -> Shaper {
    // ZV has a design for every mode, and there is room for four impulses.
    let of =
        |mode: Option<Mode>| mode.and_then(|mode| design(Kind::ZV, mode, 0.0).ok()).unwrap_or_else(Shaper::unshaped);
    let [first, second] = modes.map(of);
    convolve(&first, &second).unwrap_or_else(|_| Shaper::unshaped())
}
