//! Directional and adjoint derivatives.

use super::Instance;
use crate::fuzz::call::{Answer, Sensitivity};
use crate::fuzz::library::{UNTOUCHED, array, array_mut};

impl Instance {
    pub fn sensitivity(&self, adjoint: bool, with: &Sensitivity) -> Option<Answer> {
        let mut places = vec![UNTOUCHED; with.count];
        let function = if adjoint { self.f.fmi3GetAdjointDerivative } else { self.f.fmi3GetDirectionalDerivative };
        // SAFETY: an instance; arrays as long as announced.
        let status = unsafe {
            function?(
                self.instance,
                array(&with.unknowns, false),
                with.unknowns.len(),
                array(&with.knowns, false),
                with.knowns.len(),
                array(&with.seed, false),
                with.seed.len(),
                array_mut(&mut places, false),
                places.len(),
            )
        };
        Some(Answer { status, bits: places.into_iter().map(f64::to_bits).collect(), ..Answer::default() })
    }
}
