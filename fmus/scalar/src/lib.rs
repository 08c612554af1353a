//! The number that model equations are written over.
//!
//! An equation written once over [`Scalar`] gives values with `f64`, exact derivatives with [`Dual`] and, with
//! [`Dependence`], the set of variables it depends on. A scalar cannot be compared for order, so an equation cannot
//! switch silently: switching belongs to the discrete state of a model, which changes at events only, and reaches an
//! equation through [`Scalar::select`].

mod dependence;
mod dual;
mod real;

use core::fmt::Debug;
use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use num_traits::{One, Zero};

pub use dependence::{Dependence, How};
pub use dual::Dual;

/// A number of a model equation.
pub trait Scalar:
    Copy
    + Debug
    + PartialEq
    + Send
    + Sync
    + 'static
    + Zero
    + One
    + From<f64>
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Add<f64, Output = Self>
    + Sub<f64, Output = Self>
    + Mul<f64, Output = Self>
    + Div<f64, Output = Self>
    + AddAssign
    + SubAssign
    + MulAssign
    + DivAssign
{
    /// Sine of an angle in rad.
    fn sin(self) -> Self;
    /// Cosine of an angle in rad.
    fn cos(self) -> Self;
    /// Angle in rad in [−π/2, π/2] whose sine this is.
    fn asin(self) -> Self;
    /// Angle in rad of the point (x, self), in (−π, π].
    fn atan2(self, x: Self) -> Self;
    /// Square root; where a derivative is taken, it is 0 at 0.
    fn sqrt(self) -> Self;
    /// The number between two constants that is closest to this one.
    fn clamp(self, least: f64, most: f64) -> Self;
    /// `a` where the discrete condition holds, `b` where not; it depends on both.
    fn select(condition: bool, a: Self, b: Self) -> Self;
    /// Sine and cosine of an angle in rad.
    fn sin_cos(self) -> (Self, Self) {
        (self.sin(), self.cos())
    }
}
