//! Values of variables.

use std::ffi::{CStr, CString};
use std::ptr::null;

use swayless_modeldesc::types::DataType;

use super::Instance;
use crate::fuzz::call::{Access, Answer, Values};
use crate::fuzz::library::{array, array_mut, hash};

macro_rules! get {
    ($self:ident, $function:ident, $access:ident, $of:expr) => {{
        let mut values = vec![Default::default(); $access.count];
        let (references, null) = (&$access.references, $access.null);
        // SAFETY: an instance; as many references and places as announced, or NULL.
        let status = unsafe {
            ($self.f.$function?)(
                $self.instance,
                array(references, null && references.is_empty()),
                references.len(),
                array_mut(&mut values, null),
                values.len(),
            )
        };
        Answer { status, bits: values.into_iter().map($of).collect(), ..Answer::default() }
    }};
}

macro_rules! set {
    ($self:ident, $function:ident, $access:ident, $values:expr) => {{
        let values = $values;
        let references = &$access.references;
        // SAFETY: an instance; as many references and values as announced, or NULL.
        let status = unsafe {
            ($self.f.$function?)(
                $self.instance,
                array(references, false),
                references.len(),
                array(&values, $access.null),
                values.len(),
            )
        };
        Answer { status, ..Answer::default() }
    }};
}

impl Instance {
    pub fn get(&self, access: &Access) -> Option<Answer> {
        Some(match access.data_type {
            DataType::Float64 => get!(self, fmi3GetFloat64, access, f64::to_bits),
            DataType::Float32 => get!(self, fmi3GetFloat32, access, |v: f32| v.to_bits().into()),
            DataType::Int8 => get!(self, fmi3GetInt8, access, |v: i8| v as u64),
            DataType::UInt8 => get!(self, fmi3GetUInt8, access, |v: u8| v as u64),
            DataType::Int16 => get!(self, fmi3GetInt16, access, |v: i16| v as u64),
            DataType::UInt16 => get!(self, fmi3GetUInt16, access, |v: u16| v as u64),
            DataType::Int32 => get!(self, fmi3GetInt32, access, |v: i32| v as u64),
            DataType::UInt32 => get!(self, fmi3GetUInt32, access, |v: u32| v as u64),
            DataType::Int64 | DataType::Enumeration => get!(self, fmi3GetInt64, access, |v: i64| v as u64),
            DataType::UInt64 => get!(self, fmi3GetUInt64, access, |v: u64| v),
            DataType::Boolean => get!(self, fmi3GetBoolean, access, |v: u8| v.into()),
            DataType::String => {
                let mut texts = vec![null(); access.count];
                // SAFETY: an instance; as many references and places as announced, or NULL.
                let status = unsafe {
                    (self.f.fmi3GetString?)(
                        self.instance,
                        array(&access.references, false),
                        access.references.len(),
                        array_mut(&mut texts, access.null),
                        texts.len(),
                    )
                };
                // SAFETY: NULL is left out; what an instance returns ends with a NUL and stays until the next call.
                let read =
                    |text: &*const i8| (!text.is_null()).then(|| hash(unsafe { CStr::from_ptr(*text) }.to_bytes()));
                Answer { status, bits: texts.iter().filter_map(read).collect(), ..Answer::default() }
            }
            DataType::Binary => {
                let (mut sizes, mut values) = (vec![0_usize; access.count], vec![null(); access.count]);
                // SAFETY: as above.
                let status = unsafe {
                    (self.f.fmi3GetBinary?)(
                        self.instance,
                        array(&access.references, false),
                        access.references.len(),
                        array_mut(&mut sizes, access.null),
                        array_mut(&mut values, access.null),
                        access.count,
                    )
                };
                Answer { status, ..Answer::default() }
            }
            DataType::Clock => {
                let mut values = vec![0_u8; access.references.len()];
                let (n, references) = (access.references.len(), array(&access.references, false));
                // SAFETY: as above.
                let status = unsafe {
                    (self.f.fmi3GetClock?)(self.instance, references, n, array_mut(&mut values, access.null))
                };
                Answer { status, bits: values.into_iter().map(Into::into).collect(), ..Answer::default() }
            }
        })
    }

    pub fn set(&self, access: &Access, values: &Values) -> Option<Answer> {
        Some(match (access.data_type, values) {
            (DataType::Float64, Values::Floats(v)) => set!(self, fmi3SetFloat64, access, v.clone()),
            (DataType::Float32, Values::Floats(v)) => {
                set!(self, fmi3SetFloat32, access, v.iter().map(|v| *v as f32).collect::<Vec<_>>())
            }
            (DataType::Int8, Values::Integers(v)) => {
                set!(self, fmi3SetInt8, access, v.iter().map(|v| *v as i8).collect::<Vec<_>>())
            }
            (DataType::UInt8, Values::Integers(v)) => {
                set!(self, fmi3SetUInt8, access, v.iter().map(|v| *v as u8).collect::<Vec<_>>())
            }
            (DataType::Int16, Values::Integers(v)) => {
                set!(self, fmi3SetInt16, access, v.iter().map(|v| *v as i16).collect::<Vec<_>>())
            }
            (DataType::UInt16, Values::Integers(v)) => {
                set!(self, fmi3SetUInt16, access, v.iter().map(|v| *v as u16).collect::<Vec<_>>())
            }
            (DataType::Int32, Values::Integers(v)) => {
                set!(self, fmi3SetInt32, access, v.iter().map(|v| *v as i32).collect::<Vec<_>>())
            }
            (DataType::UInt32, Values::Integers(v)) => {
                set!(self, fmi3SetUInt32, access, v.iter().map(|v| *v as u32).collect::<Vec<_>>())
            }
            (DataType::Int64 | DataType::Enumeration, Values::Integers(v)) => {
                set!(self, fmi3SetInt64, access, v.clone())
            }
            (DataType::UInt64, Values::Integers(v)) => {
                set!(self, fmi3SetUInt64, access, v.iter().map(|v| *v as u64).collect::<Vec<_>>())
            }
            (DataType::Boolean, Values::Booleans(v)) => set!(self, fmi3SetBoolean, access, v.clone()),
            (DataType::String, Values::Texts(texts)) => {
                let owned: Vec<_> =
                    texts.iter().map(|text| text.clone().map(|t| CString::new(t).expect("no NUL"))).collect();
                let pointers = owned.iter().map(|text| text.as_ref().map_or(null(), |text| text.as_ptr()));
                set!(self, fmi3SetString, access, pointers.collect::<Vec<_>>())
            }
            (DataType::Binary, Values::Integers(v)) => {
                let sizes: Vec<usize> = v.iter().map(|size| size.unsigned_abs() as usize % 7).collect();
                let values = vec![c"binary".as_ptr().cast(); sizes.len()];
                // SAFETY: as many values as announced, each of at most the size of the text and its NUL.
                let status = unsafe {
                    (self.f.fmi3SetBinary?)(
                        self.instance,
                        array(&access.references, false),
                        access.references.len(),
                        array(&sizes, false),
                        array(&values, access.null),
                        values.len(),
                    )
                };
                Answer { status, ..Answer::default() }
            }
            (DataType::Clock, Values::Booleans(v)) => {
                let references = array(&access.references, false);
                // SAFETY: as many clocks as references are announced.
                let status = unsafe {
                    (self.f.fmi3SetClock?)(self.instance, references, access.references.len(), array(v, access.null))
                };
                Answer { status, ..Answer::default() }
            }
            _ => return None,
        })
    }
}
