//! A camera below the pivot that looks down at the payload (thesis 4.1.1, 6.2.2).
//!
//! With n the unit vector from pivot to payload and κ = d_c/ℓ, a level camera a distance d_c below the pivot sees the
//! payload at u = n_r/(−n_z − κ), v = n_t/(−n_z − κ). It turns with the crane: u is radial, v tangential. Mounted on a boom
//! by four bars that are not quite a parallelogram, it pitches about the tangential axis through the pivot, by ε, positive
//! where it looks outwards; then it sees n turned back by ε.

/// A camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// How far below the pivot it hangs (m): d_c ≥ 0.
    pub drop: f64,
    /// The full angle that it sees along each axis of its image (rad), less than π.
    pub field_of_view: f64,
}

/// Where a payload is, as it follows from an image.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Located {
    /// How far it is from the vertical through the pivot (m), radial and tangential.
    pub displacement: [f64; 2],
    /// Its swing (rad), radial and tangential.
    pub swing: [f64; 2],
}

impl Camera {
    /// The image [u, v] of a payload at `length` (m) from the pivot with `swing` (rad), radial and tangential, seen by a
    /// camera that is pitched by `pitch` (rad); none if it is not below the camera or outside of the field of view.
    #[must_use]
    pub fn image(&self, length: f64, swing: [f64; 2], pitch: f64) -> Option<[f64; 2]> {
        let ((sin_phi, cos_phi), (sin_beta, cos_beta)) = (swing[0].sin_cos(), swing[1].sin_cos());
        let (n_r, n_t, n_z) = (sin_phi, cos_phi * sin_beta, -cos_phi * cos_beta);
        let (sin, cos) = pitch.sin_cos();
        let (n_r, n_z) = (n_r * cos + n_z * sin, n_z * cos - n_r * sin);
        let depth = -n_z - self.drop / length;
        if !(length > 0.0 && depth > 0.0) {
            return None;
        }
        let edge = (0.5 * self.field_of_view).tan();
        let image = [n_r / depth, n_t / depth];
        image.iter().all(|coordinate| coordinate.abs() <= edge).then_some(image)
    }

    /// Where the payload is that has the image [u, v], if the camera is level and the payload at `length` (m); none if it
    /// cannot be below the camera.
    ///
    /// The payload lies h below the camera with (h + d_c)² + (u² + v²) h² = ℓ².
    #[must_use]
    pub fn locate(&self, length: f64, [u, v]: [f64; 2]) -> Option<Located> {
        let kappa = self.drop / length;
        if !(length > 0.0 && kappa < 1.0) {
            return None;
        }
        // The positive root for h/ℓ, in the form that cancels nothing: q = u² + v², (1 − κ²)/(κ + √(1 + q(1 − κ²))).
        let rest = (1.0 - kappa) * (1.0 + kappa);
        let h = rest / (kappa + (1.0 + (u * u + v * v) * rest).sqrt());
        let (radial, tangential) = (u * h, v * h);
        Some(Located {
            displacement: [radial * length, tangential * length],
            swing: [radial.clamp(-1.0, 1.0).asin(), tangential.atan2(h + kappa)],
        })
    }
}
