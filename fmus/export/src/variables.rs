//! Structs of variables: what `#[derive(Variables)]` implements, and values as they cross the FMI boundary.

use swayless_scalar::Scalar;

use crate::declaration::Declarer;

/// The value of one scalar variable.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Value<'a, R> {
    /// A real number, in SI units.
    Real(R),
    /// An integer.
    Integer(i32),
    /// The length of arrays.
    Size(u32),
    /// A truth value.
    Boolean(bool),
    /// A text.
    Text(&'a str),
    /// An item of an enumeration, counted from 1.
    Enumeration(i32),
}

impl<'a, R> Value<'a, R> {
    /// The same value over another scalar.
    pub fn map<S>(self, f: impl FnOnce(R) -> S) -> Value<'a, S> {
        match self {
            Self::Real(value) => Value::Real(f(value)),
            Self::Integer(value) => Value::Integer(value),
            Self::Size(value) => Value::Size(value),
            Self::Boolean(value) => Value::Boolean(value),
            Self::Text(value) => Value::Text(value),
            Self::Enumeration(value) => Value::Enumeration(value),
        }
    }
}

/// A struct of variables, each of which is declared once at its field; derive it.
///
/// Scalars are counted through all fields in their order; an element of an array counts for itself.
pub trait Variables<R: Scalar>: Clone + Send + 'static {
    /// How many scalars there are.
    const COUNT: usize;
    /// The declared start values.
    fn start() -> Self;
    /// Hands every declaration over, in order.
    fn declare(into: &mut Declarer);
    /// The value of a scalar; the index is below [`COUNT`](Self::COUNT).
    fn get(&self, index: usize) -> Value<'_, R>;
    /// Sets a scalar. Returns whether the value was of its type (and, for an enumeration, one of its items).
    fn set(&mut self, index: usize, value: Value<'_, R>) -> bool;
    /// How many scalars the variable has that begins at the index: 1, an array's length, or 0 inside an array.
    fn extent(index: usize) -> usize;
    /// Visits the real numbers, in order.
    fn each_real(&self, f: &mut impl FnMut(R));
    /// Visits the real numbers to change them, in order.
    fn each_real_mut(&mut self, f: &mut impl FnMut(&mut R));

    /// Copies the real numbers from a slice, in order.
    #[inline]
    fn read_reals(&mut self, from: &[R]) {
        let mut values = from.iter();
        self.each_real_mut(&mut |real| {
            if let Some(value) = values.next() {
                *real = *value;
            }
        });
    }

    /// Copies the real numbers into a slice, in order.
    #[inline]
    fn write_reals(&self, into: &mut [R]) {
        let mut places = into.iter_mut();
        self.each_real(&mut |real| {
            if let Some(place) = places.next() {
                *place = real;
            }
        });
    }
}

/// A model without variables of some kind.
impl<R: Scalar> Variables<R> for () {
    const COUNT: usize = 0;
    fn start() -> Self {}
    fn declare(_: &mut Declarer) {}
    fn get(&self, index: usize) -> Value<'_, R> {
        unreachable!("there is no variable {index} where there are none")
    }
    fn set(&mut self, _: usize, _: Value<'_, R>) -> bool {
        false
    }
    fn extent(_: usize) -> usize {
        0
    }
    fn each_real(&self, _: &mut impl FnMut(R)) {}
    fn each_real_mut(&mut self, _: &mut impl FnMut(&mut R)) {}
}

/// Fills a struct of one scalar from one of another: `f` takes each real number with its index.
pub fn lift<R: Scalar, S: Scalar, T: Variables<S>>(from: &impl Variables<R>, mut f: impl FnMut(usize, R) -> S) -> T {
    let mut lifted = T::start();
    for index in 0..T::COUNT {
        lifted.set(index, from.get(index).map(|real| f(index, real)));
    }
    lifted
}

/// An enumeration; derive it. Values count from 1.
pub trait Enumeration: Copy + 'static {
    /// The name of the type.
    const NAME: &'static str;
    /// Names and descriptions of the items, in order.
    const ITEMS: &'static [(&'static str, &'static str)];
    /// The value of an item.
    fn value(self) -> i32;
    /// The item of a value.
    fn from_value(value: i32) -> Option<Self>;
}
