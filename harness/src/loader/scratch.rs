//! Memory for values on their way between Rust's types and C's, kept so that no call allocates twice.

use std::ffi::{CStr, c_char};
use std::fmt::Display;
use std::mem::{align_of, size_of};

use crate::slave::{Failure, Status};

/// A type whose values may be any bits.
///
/// # Safety
/// Every pattern of bits is a value, and neither size nor alignment exceeds that of `u64`.
pub(super) unsafe trait Plain: Copy {}

macro_rules! plain {
    ($($type:ty),*) => {
        $(
            // SAFETY: a number of at most 64 bits.
            unsafe impl Plain for $type {}
            const _: () = assert!(size_of::<$type>() <= size_of::<u64>() && align_of::<$type>() <= align_of::<u64>());
        )*
    };
}
plain!(i8, u8, i16, u16, i32, u32, i64, u64, f32);

/// See the module.
#[derive(Default)]
pub(super) struct Scratch {
    words: Vec<u64>,
    bytes: Vec<u8>,
    pointers: Vec<*const c_char>,
}

impl Scratch {
    /// Room for `count` values; what they are is left from before.
    pub(super) fn of<T: Plain>(&mut self, count: usize) -> &mut [T] {
        if self.words.len() < count {
            self.words.resize(count, 0);
        }
        // SAFETY: there are at least `count` words, each initialized, at least as large and as aligned as a `T`, and
        // any bits are a `T`; the slice borrows the words exclusively.
        unsafe { std::slice::from_raw_parts_mut(self.words.as_mut_ptr().cast(), count) }
    }

    /// Room for `count` strings from an FMU, all NULL.
    pub(super) fn pointers(&mut self, count: usize) -> &mut [*const c_char] {
        self.pointers.clear();
        self.pointers.resize(count, std::ptr::null());
        &mut self.pointers
    }

    /// Copies the strings that an FMU has just put into [`pointers`](Self::pointers); NULL is an empty one.
    ///
    /// # Safety
    /// Each pointer is NULL or points to a string that ends with a NUL, with no call of the FMU since it was got.
    pub(super) unsafe fn copy_strings(&self, values: &mut [String]) {
        for (value, &pointer) in values.iter_mut().zip(&self.pointers) {
            value.clear();
            if !pointer.is_null() {
                // SAFETY: the caller's promise.
                value.push_str(&unsafe { CStr::from_ptr(pointer) }.to_string_lossy());
            }
        }
    }

    /// These values as another type; one that does not fit is refused.
    pub(super) fn fill<T: Plain, V: Copy + Display>(
        &mut self,
        call: &'static str,
        values: &[V],
        convert: impl Fn(V) -> Option<T>,
    ) -> Result<&[T], Failure> {
        let room = self.of::<T>(values.len());
        for (place, &value) in room.iter_mut().zip(values) {
            *place = convert(value).ok_or_else(|| {
                Failure::new(call, Status::NotCalled, format!("{value} does not fit the variable's type"))
            })?;
        }
        Ok(room)
    }

    /// C strings of these texts, valid until the scratch is used again.
    pub(super) fn strings(&mut self, call: &'static str, values: &[String]) -> Result<&[*const c_char], Failure> {
        self.bytes.clear();
        for value in values {
            if value.contains('\0') {
                return Err(Failure::new(call, Status::NotCalled, format!("{value:?} contains a NUL")));
            }
            self.bytes.extend_from_slice(value.as_bytes());
            self.bytes.push(0);
        }
        self.pointers.clear();
        let mut rest = self.bytes.as_slice();
        for value in values {
            self.pointers.push(rest.as_ptr().cast());
            rest = &rest[value.len() + 1..];
        }
        Ok(&self.pointers)
    }
}
