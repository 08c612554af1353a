//! Which variables a result depends on.

use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use num_traits::{One, Zero};

use crate::Scalar;

/// A set of variables, one bit each: every operation unites the sets of its operands.
///
/// A set holds 64 members. A model with more variables is traced in windows of 64, one evaluation each, so that the
/// scalar stays a plain number and a model of any size can be traced.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Dependence(pub u64);

impl Dependence {
    /// How many members a set can hold.
    pub const WINDOW: usize = u64::BITS as usize;

    /// The set of one member, which is empty when the member lies outside the window.
    pub fn on(member: usize) -> Self {
        Self(if member < Self::WINDOW { 1 << member } else { 0 })
    }

    /// Whether the set has the member.
    pub fn contains(self, member: usize) -> bool {
        member < Self::WINDOW && self.0 >> member & 1 == 1
    }
}

impl From<f64> for Dependence {
    fn from(_: f64) -> Self {
        Self(0)
    }
}

impl Zero for Dependence {
    fn zero() -> Self {
        Self(0)
    }
    fn is_zero(&self) -> bool {
        false
    }
}

impl One for Dependence {
    fn one() -> Self {
        Self(0)
    }
}

impl Neg for Dependence {
    type Output = Self;
    fn neg(self) -> Self {
        self
    }
}

macro_rules! united {
    ($($operator:ident::$function:ident, $assign:ident::$function_assign:ident;)*) => { $(
        #[allow(clippy::suspicious_arithmetic_impl, reason = "a result depends on both operands, whatever is done")]
        impl $operator for Dependence {
            type Output = Self;
            fn $function(self, other: Self) -> Self {
                Self(self.0 | other.0)
            }
        }
        impl $operator<f64> for Dependence {
            type Output = Self;
            fn $function(self, _: f64) -> Self {
                self
            }
        }
        #[allow(clippy::suspicious_op_assign_impl, reason = "a result depends on both operands, whatever is done")]
        impl $assign for Dependence {
            fn $function_assign(&mut self, other: Self) {
                self.0 |= other.0;
            }
        }
    )* };
}

united! {
    Add::add, AddAssign::add_assign;
    Sub::sub, SubAssign::sub_assign;
    Mul::mul, MulAssign::mul_assign;
    Div::div, DivAssign::div_assign;
}

impl Scalar for Dependence {
    fn sin(self) -> Self {
        self
    }
    fn cos(self) -> Self {
        self
    }
    fn asin(self) -> Self {
        self
    }
    fn atan2(self, x: Self) -> Self {
        self + x
    }
    fn sqrt(self) -> Self {
        self
    }
    fn clamp(self, _: f64, _: f64) -> Self {
        self
    }
    fn select(_: bool, a: Self, b: Self) -> Self {
        a + b
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_result_depends_on_every_operand() {
        let (a, b, c) = (Dependence::on(0), Dependence::on(5), Dependence::on(63));
        let mut sum = (a * 2.0 + 1.0).sin() / b.sqrt();
        assert_eq!(sum, Dependence(1 | 1 << 5));
        sum -= Dependence::select(false, c, 0.0.into());
        assert!(sum.contains(63) && sum.contains(0) && !sum.contains(1));
        assert_eq!(Dependence::on(64), Dependence(0));
    }
}
