//! Plain values.

use crate::Scalar;

impl Scalar for f64 {
    #[inline]
    fn sin(self) -> Self {
        f64::sin(self)
    }
    #[inline]
    fn cos(self) -> Self {
        f64::cos(self)
    }
    #[inline]
    fn asin(self) -> Self {
        f64::asin(self)
    }
    #[inline]
    fn atan2(self, x: Self) -> Self {
        f64::atan2(self, x)
    }
    #[inline]
    fn sqrt(self) -> Self {
        f64::sqrt(self)
    }
    #[inline]
    fn clamp(self, least: f64, most: f64) -> Self {
        f64::clamp(self, least, most)
    }
    #[inline]
    fn select(condition: bool, a: Self, b: Self) -> Self {
        if condition { a } else { b }
    }
    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        f64::sin_cos(self)
    }
}
