//! Values with their exact derivative in one direction.

use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use num_traits::{One, Zero};

use crate::Scalar;

/// A value and how fast it changes in one direction: forward differentiation, exact but for rounding.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Dual {
    /// The value.
    pub value: f64,
    /// Its derivative in the direction.
    pub tangent: f64,
}

impl Dual {
    /// A value that changes.
    pub fn new(value: f64, tangent: f64) -> Self {
        Self { value, tangent }
    }

    /// f(self), where f has the value and slope given there.
    fn chain(self, value: f64, slope: f64) -> Self {
        // What does not change stays so, even where the slope is infinite.
        let tangent = if self.tangent == 0.0 { 0.0 } else { slope * self.tangent };
        Self { value, tangent }
    }
}

impl From<f64> for Dual {
    fn from(value: f64) -> Self {
        Self { value, tangent: 0.0 }
    }
}

impl Zero for Dual {
    fn zero() -> Self {
        Self::default()
    }
    fn is_zero(&self) -> bool {
        *self == Self::default()
    }
}

impl One for Dual {
    fn one() -> Self {
        1.0.into()
    }
}

impl Neg for Dual {
    type Output = Self;
    fn neg(self) -> Self {
        Self::new(-self.value, -self.tangent)
    }
}

impl Add for Dual {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::new(self.value + other.value, self.tangent + other.tangent)
    }
}

impl Sub for Dual {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::new(self.value - other.value, self.tangent - other.tangent)
    }
}

impl Mul for Dual {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self::new(self.value * other.value, self.tangent * other.value + self.value * other.tangent)
    }
}

impl Div for Dual {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        Self::new(value, (self.tangent - value * other.tangent) / other.value)
    }
}

macro_rules! with_constants {
    ($($operator:ident::$function:ident, $assign:ident::$function_assign:ident;)*) => { $(
        impl $operator<f64> for Dual {
            type Output = Self;
            fn $function(self, other: f64) -> Self {
                self.$function(Self::from(other))
            }
        }
        impl $assign for Dual {
            fn $function_assign(&mut self, other: Self) {
                *self = self.$function(other);
            }
        }
    )* };
}

with_constants! {
    Add::add, AddAssign::add_assign;
    Sub::sub, SubAssign::sub_assign;
    Mul::mul, MulAssign::mul_assign;
    Div::div, DivAssign::div_assign;
}

impl Scalar for Dual {
    fn sin(self) -> Self {
        self.chain(self.value.sin(), self.value.cos())
    }
    fn cos(self) -> Self {
        self.chain(self.value.cos(), -self.value.sin())
    }
    fn asin(self) -> Self {
        self.chain(self.value.asin(), 1.0 / (1.0 - self.value * self.value).sqrt())
    }
    fn atan2(self, x: Self) -> Self {
        let (y, square) = (self, self.value * self.value + x.value * x.value);
        // At the origin there is no derivative; 0 is as good as any and no NaN.
        let tangent = if square == 0.0 { 0.0 } else { (x.value * y.tangent - y.value * x.tangent) / square };
        Self::new(y.value.atan2(x.value), tangent)
    }
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        if root == 0.0 { Self::new(root, 0.0) } else { self.chain(root, 0.5 / root) }
    }
    fn clamp(self, least: f64, most: f64) -> Self {
        let inside = self.value >= least && self.value <= most;
        self.chain(self.value.clamp(least, most), if inside { 1.0 } else { 0.0 })
    }
    fn select(condition: bool, a: Self, b: Self) -> Self {
        if condition { a } else { b }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The derivative by a sixth-order central difference.
    fn difference(f: impl Fn(f64) -> f64, x: f64) -> f64 {
        let h = 1e-2;
        let pair = |n: f64| f(x + n * h) - f(x - n * h);
        (45.0 * pair(1.0) - 9.0 * pair(2.0) + pair(3.0)) / (60.0 * h)
    }

    fn expression<R: Scalar>(x: R) -> R {
        let (sin, cos) = (x * 0.7).sin_cos();
        let mut sum = (sin * 0.4 + 0.1).asin() / (cos * cos + 1.5) - x.atan2(cos * 2.0);
        sum *= (x * x + 2.0).sqrt();
        sum += R::select(true, x.clamp(-9.0, 9.0), R::zero()) - R::one() * 3.0;
        -sum
    }

    #[test]
    fn derivatives_are_those_of_differences() {
        for i in -10..=10 {
            let x = 0.19 * f64::from(i);
            let dual = expression(Dual::new(x, 2.0));
            assert_eq!(dual.value, expression(x));
            let expected = 2.0 * difference(expression, x);
            assert!((dual.tangent - expected).abs() < 1e-9, "{x}: {} for {expected}", dual.tangent);
        }
    }

    #[test]
    fn no_derivative_at_rest_is_no_number() {
        let moving = Dual::new(0.0, 1.0);
        assert_eq!((moving * moving).sqrt().tangent, 0.0);
        assert_eq!(moving.atan2(Dual::zero()).tangent, 0.0);
        assert_eq!(Dual::one().asin().tangent, 0.0);
        assert_eq!(Dual::new(2.0, 1.0).clamp(0.0, 1.0), Dual::one());
    }
}
