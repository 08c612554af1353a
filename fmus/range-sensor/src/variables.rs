//! The variables of the laser.

use swayless_export::{Scalar, Variables};

#[derive(Clone, Variables)]
pub struct Parameters<R: Scalar> {
    /// Time from one sample to the next; 0 for one at every communication point and event.
    #[variable(unit = "s", start = 0.02, min = 0.0, max = 1e3)]
    pub sample_time: R,
    /// Time from a sample to the measured distance.
    #[variable(unit = "s", start = 0.012, min = 0.0, max = 1e3)]
    pub latency: R,
    /// Smallest difference between measured distances; 0 for none.
    #[variable(unit = "m", start = 1e-3, min = 0.0, max = 1e3)]
    pub resolution: R,
    /// Greatest distance that can be measured.
    #[variable(unit = "m", start = 250.0, min = 0.0, max = 1e6)]
    pub range: R,
    /// Standard deviation of the noise, before the distance is rounded to the resolution.
    #[variable(unit = "m", start = 1e-3, min = 0.0, max = 1e3)]
    pub noise: R,
    /// Where the noise begins: the same seed, the same noise.
    #[variable(start = 1)]
    pub seed: i32,
}

#[derive(Clone, Variables)]
pub struct Inputs<R: Scalar> {
    /// Distance from the laser to its target.
    #[variable(unit = "m", start = 10.0)]
    pub distance: R,
}

#[derive(Clone, Variables)]
pub struct Discrete<R: Scalar> {
    pub measured: Measured<R>,
    /// Whether the target was in range at the last sample; if not, the measured distance is that of the last that was.
    #[variable(output, clock = "sample delivery", depends_on = ["distance"])]
    pub valid: bool,
}

#[derive(Clone, Variables)]
pub struct Measured<R: Scalar> {
    /// Measured distance.
    #[variable(output, unit = "m", clock = "sample delivery", depends_on = ["distance"])]
    pub distance: R,
}
