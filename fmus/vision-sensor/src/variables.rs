//! The variables of the camera.

use swayless_export::{Scalar, Variables};

/// What an image shows.
pub const SEEN: [&str; 4] = ["swing.radial", "swing.tangential", "hoist.length", "luff.angle"];

#[derive(Clone, Variables)]
pub struct Parameters<R: Scalar> {
    /// Time from one image to the next; 0 for one at every communication point and event.
    #[variable(unit = "s", start = 0.04, min = 0.0, max = 1e3)]
    pub sample_time: R,
    /// Time from an image to what is measured in it.
    #[variable(unit = "s", start = 0.06, min = 0.0, max = 1e3)]
    pub latency: R,
    /// Angle of a pixel in the middle of the image; 0 for no pixels.
    #[variable(unit = "rad", start = 5e-4, min = 0.0, max = 1.0)]
    pub pixel_size: R,
    /// Standard deviation of the noise in each coordinate of the image, before it falls on pixels.
    #[variable(unit = "rad", start = 2e-4, min = 0.0, max = 1.0)]
    pub noise: R,
    /// Where the noise begins: the same seed, the same noise.
    #[variable(start = 1)]
    pub seed: i32,
    /// Full angle that the camera sees, radially as well as tangentially.
    #[variable(unit = "rad", start = 0.8, min = 1e-6, max = 3.0)]
    pub field_of_view: R,
    pub camera: CameraParameters<R>,
    pub leveling: LevelingParameters<R>,
}

#[derive(Clone, Variables)]
pub struct CameraParameters<R: Scalar> {
    /// How far the camera hangs below the pivot (d_c).
    #[variable(unit = "m", start = 0.3, min = 0.0, max = 1e3)]
    pub drop: R,
}

#[derive(Clone, Variables)]
pub struct LevelingParameters<R: Scalar> {
    /// Pitch of the camera per luff angle: 0 if the four bars keep it level, 1 if it is fixed to the boom.
    #[variable(unit = "1", min = -1.0, max = 1.0)]
    pub gain: R,
    /// Luff angle at which the camera is level.
    #[variable(unit = "rad", start = core::f64::consts::FRAC_PI_4, min = -7.0, max = 7.0)]
    pub luff_reference: R,
}

#[derive(Clone, Variables)]
pub struct Inputs<R: Scalar> {
    pub swing: Swing<R>,
    pub hoist: Hoist<R>,
    pub luff: Luff<R>,
}

#[derive(Clone, Variables)]
pub struct Swing<R: Scalar> {
    /// Radial swing angle of what the camera looks at, away from the slewing axis.
    #[variable(unit = "rad")]
    pub radial: R,
    /// Tangential swing angle of what the camera looks at, towards increasing slew.
    #[variable(unit = "rad")]
    pub tangential: R,
}

#[derive(Clone, Variables)]
pub struct Hoist<R: Scalar> {
    /// Length from the pivot to what the camera looks at; the sensor knows it.
    #[variable(unit = "m", start = 10.0)]
    pub length: R,
}

#[derive(Clone, Variables)]
pub struct Luff<R: Scalar> {
    /// Angle of the boom above horizontal.
    #[variable(unit = "rad", start = core::f64::consts::FRAC_PI_4)]
    pub angle: R,
}

#[derive(Clone, Variables)]
pub struct Discrete<R: Scalar> {
    pub measured: Measured<R>,
    /// Whether the last image shows what is measured; if not, the measured values are those of the last that did.
    #[variable(output, clock = "sample delivery", depends_on = SEEN)]
    pub valid: bool,
}

#[derive(Clone, Variables)]
pub struct Measured<R: Scalar> {
    pub swing: MeasuredSwing<R>,
    pub displacement: MeasuredDisplacement<R>,
}

#[derive(Clone, Variables)]
pub struct MeasuredSwing<R: Scalar> {
    /// Measured radial swing angle.
    #[variable(output, unit = "rad", clock = "sample delivery", depends_on = SEEN)]
    pub radial: R,
    /// Measured tangential swing angle.
    #[variable(output, unit = "rad", clock = "sample delivery", depends_on = SEEN)]
    pub tangential: R,
}

#[derive(Clone, Variables)]
pub struct MeasuredDisplacement<R: Scalar> {
    /// Measured radial distance from the vertical through the pivot.
    #[variable(output, unit = "m", clock = "sample delivery", depends_on = SEEN)]
    pub radial: R,
    /// Measured tangential distance from the vertical through the pivot.
    #[variable(output, unit = "m", clock = "sample delivery", depends_on = SEEN)]
    pub tangential: R,
}
