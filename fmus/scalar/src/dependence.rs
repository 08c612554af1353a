//! Which variables a result depends on, and how.

use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use num_traits::{One, Zero};

use crate::Scalar;

/// How a result depends on a variable, from the simplest on: it is a·v + b, with a factor a that never changes, is
/// fixed when the simulation starts, changes with tunable parameters, or changes at events; or it is none of these.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum How {
    /// Linear, with a constant factor.
    Constant = 1,
    /// Linear, with a factor that is fixed when the simulation starts.
    Fixed,
    /// Linear, with a factor that changes with tunable parameters.
    Tunable,
    /// Linear, with a factor that changes at events.
    Discrete,
    /// In any other way.
    Dependent,
}

const ALL: [How; 5] = [How::Constant, How::Fixed, How::Tunable, How::Discrete, How::Dependent];

/// A set of variables with how a result depends on each: every operation unites the sets of its operands.
///
/// A set holds 64 members. A model with more variables is traced in windows of 64, one evaluation each, so that the
/// scalar stays a plain number and a model of any size can be traced.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Dependence {
    /// The members on which the result depends at least so intricately; each set contains the next.
    at_least: [u64; ALL.len()],
    /// What the result is as a factor of something else.
    factor: How,
}

impl Dependence {
    /// How many members a set can hold.
    pub const WINDOW: usize = u64::BITS as usize;

    /// A number that depends on no member and is constant, fixed, … as a factor.
    pub const fn number(factor: How) -> Self {
        Self { at_least: [0; ALL.len()], factor }
    }

    /// The variable itself: the set of one member, which is empty when the member lies outside the window.
    pub fn on(member: usize) -> Self {
        let mut set = Self::number(How::Dependent);
        set.at_least[0] = if member < Self::WINDOW { 1 << member } else { 0 };
        set
    }

    /// Something that depends on every member in some way.
    pub fn everything() -> Self {
        Self { at_least: [u64::MAX; ALL.len()], factor: How::Dependent }
    }

    /// How the result depends on the member, if it does.
    pub fn how(self, member: usize) -> Option<How> {
        let is_at_least = |how: &How| member < Self::WINDOW && self.at_least[*how as usize - 1] >> member & 1 == 1;
        ALL.into_iter().rev().find(is_at_least)
    }

    /// Whether the set has the member.
    pub fn contains(self, member: usize) -> bool {
        self.how(member).is_some()
    }

    /// Whether every member is in the set.
    pub fn is_everything(self) -> bool {
        self.at_least[0] == u64::MAX
    }

    /// The same members, each at least so intricately. Not inlined, as below: it stands wherever an equation multiplies,
    /// and libraries stay small.
    #[inline(never)]
    fn by(mut self, factor: How) -> Self {
        for level in 0..factor as usize {
            self.at_least[level] |= self.at_least[0];
        }
        self
    }

    /// A function of it that is not linear; it changes no more often than its argument.
    #[must_use]
    pub fn bent(self) -> Self {
        self.by(How::Dependent)
    }

    #[inline(never)]
    fn united(mut self, other: Self) -> Self {
        for (mine, theirs) in self.at_least.iter_mut().zip(other.at_least) {
            *mine |= theirs;
        }
        self.factor = self.factor.max(other.factor);
        self
    }
}

impl From<f64> for Dependence {
    fn from(_: f64) -> Self {
        Self::number(How::Constant)
    }
}

impl Zero for Dependence {
    fn zero() -> Self {
        Self::number(How::Constant)
    }
    fn is_zero(&self) -> bool {
        false
    }
}

impl One for Dependence {
    fn one() -> Self {
        Self::number(How::Constant)
    }
}

impl Neg for Dependence {
    type Output = Self;
    fn neg(self) -> Self {
        self
    }
}

macro_rules! operators {
    ($($operator:ident::$function:ident, $assign:ident::$function_assign:ident, $of:expr;)*) => { $(
        impl $operator for Dependence {
            type Output = Self;
            fn $function(self, other: Self) -> Self {
                let of: fn(Self, Self) -> Self = $of;
                of(self, other)
            }
        }
        impl $operator<f64> for Dependence {
            type Output = Self;
            fn $function(self, _: f64) -> Self {
                self
            }
        }
        impl $assign for Dependence {
            fn $function_assign(&mut self, other: Self) {
                *self = $operator::$function(*self, other);
            }
        }
    )* };
}

operators! {
    Add::add, AddAssign::add_assign, Self::united;
    Sub::sub, SubAssign::sub_assign, Self::united;
    Mul::mul, MulAssign::mul_assign, |a, b| a.by(b.factor).united(b.by(a.factor));
    Div::div, DivAssign::div_assign, |a, b| a.by(b.factor).united(b.bent());
}

impl Scalar for Dependence {
    fn sin(self) -> Self {
        self.bent()
    }
    fn cos(self) -> Self {
        self.bent()
    }
    fn asin(self) -> Self {
        self.bent()
    }
    fn atan2(self, x: Self) -> Self {
        self.united(x).bent()
    }
    fn sqrt(self) -> Self {
        self.bent()
    }
    fn clamp(self, _: f64, _: f64) -> Self {
        self.bent()
    }
    fn select(_: bool, a: Self, b: Self) -> Self {
        let mut either = a.united(b).by(How::Discrete);
        either.factor = either.factor.max(How::Discrete);
        either
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_result_depends_on_every_operand() {
        let (a, b, c) = (Dependence::on(0), Dependence::on(5), Dependence::on(63));
        let mut sum = (a * 2.0 + 1.0).sin() / b.sqrt();
        assert!(sum.contains(0) && sum.contains(5) && !sum.contains(1));
        sum -= Dependence::select(false, c, 0.0.into());
        assert!(sum.contains(63) && sum.contains(0) && !sum.contains(1));
        assert!((0..64).all(|member| !Dependence::on(64).contains(member)));
    }

    #[test]
    fn a_factor_says_how() {
        let (x, y) = (Dependence::on(0), Dependence::on(1));
        let [fixed, tunable, discrete] = [How::Fixed, How::Tunable, How::Discrete].map(Dependence::number);
        let result = x * 3.0 - y * fixed;
        assert_eq!((result.how(0), result.how(1), result.how(2)), (Some(How::Constant), Some(How::Fixed), None));
        assert_eq!((x * fixed.sin() / tunable).how(0), Some(How::Tunable));
        assert_eq!((x * discrete + x).how(0), Some(How::Discrete));
        assert_eq!(Dependence::select(true, x * fixed, y).how(0), Some(How::Discrete));
        assert_eq!((x * y).how(0), Some(How::Dependent));
        assert_eq!((fixed / x).how(0), Some(How::Dependent));
        assert_eq!((x * x).how(0), Some(How::Dependent));
        assert_eq!(x.cos().how(0), Some(How::Dependent));
        assert!(Dependence::everything().is_everything() && !(x + y).is_everything());
    }
}
