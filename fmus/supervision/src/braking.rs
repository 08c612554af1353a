//! How fast an axis may be so that it can still slow down in time.

/// How an axis slows down. A velocity holds from one sample to the next, so that a ramp is a staircase.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Braking {
    /// How strongly it slows down (unit of the axis/s²).
    pub deceleration: f64,
    /// The time from one sample to the next (s).
    pub interval: f64,
    /// How late the axis follows (s): it goes on with its velocity for so long.
    pub reaction: f64,
}

impl Braking {
    /// By how much the velocity falls from one sample to the next.
    #[must_use]
    pub fn step(&self) -> f64 {
        self.deceleration * self.interval
    }

    /// The greatest velocity that may be held until the next sample, so that with the deceleration it is down to `last`
    /// when the distance has been gone; `last` itself always may.
    ///
    /// With h the interval, δ = d h the step, and w the last velocity, a velocity w + u that falls by δ at each sample goes
    ///
    /// s(u) = h (u + (u − δ) + (u − 2δ) + …) + w (u/d + h) + (w + u) τ
    ///
    /// while it is above w, or less. Since s(u − δ) = s(u) − (w + u) h − δ τ, an axis that may have a velocity now may have
    /// one less by δ at the next sample: that it can slow down in time is kept up by slowing down. s is a polygon whose
    /// corners are at u = n δ. As h → 0 this is (w + u)² = w² + 2 d s for τ = 0.
    #[must_use]
    pub fn fastest(&self, distance: f64, last: f64) -> f64 {
        let Self { deceleration, interval, reaction } = *self;
        let step = self.step();
        let rest = distance - last * (interval + reaction);
        if rest <= 0.0 {
            return last;
        }
        // The last corner before: a n² + b n = rest.
        let a = 0.5 * step * interval;
        let b = a + last * interval + step * reaction;
        let corner = (2.0 * rest / (b + (b * b + 4.0 * a * rest).sqrt())).floor();
        let slope = interval * (corner + 1.0) + last / deceleration + reaction;
        last + (rest + a * corner * (corner + 1.0)) / slope
    }
}
