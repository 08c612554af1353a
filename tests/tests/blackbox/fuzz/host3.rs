//! An instance of FMI 3.0.

use std::ffi::{CStr, CString, c_void};
use std::ptr::{null, null_mut};

use swayless_abi::fmi3::*;
use swayless_modeldesc::types::DataType;

use super::call::{Access, Answer, Call, Sensitivity, Values};
use super::library::{Host, Kind, SLOTS, UNTOUCHED, array, array_mut, hash};

type Messages = Vec<(i32, std::string::String)>;

pub struct Instance {
    f: Functions,
    instance: *mut c_void,
    states: [FMUState; SLOTS],
    log: Box<Messages>,
}

unsafe extern "C" fn log(environment: *mut c_void, status: Status, category: String, message: String) {
    assert!(!category.is_null() && !message.is_null());
    // SAFETY: the environment is the log of an `Instance`; texts are not NULL and end with one.
    unsafe {
        let text = CStr::from_ptr(message).to_str().expect("UTF-8");
        assert!(!text.is_empty() && !text.ends_with('\n'));
        (*environment.cast::<Messages>()).push((status, text.to_owned()));
    }
}

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
    /// Without a resource path, there is no logger either.
    pub fn new(f: Functions, kind: Kind, token: &CStr, resources: Option<&CString>) -> Self {
        let mut messages: Box<Messages> = Box::default();
        let environment: *mut c_void = (&raw mut *messages).cast();
        let logger: LogMessageCallback = if resources.is_some() { Some(log) } else { None };
        let path = resources.map_or(null(), |path| path.as_ptr());
        let (name, token) = (c"fuzz".as_ptr(), token.as_ptr());
        let loud = u8::from(resources.is_some());
        let make_me = f.fmi3InstantiateModelExchange.expect("a function");
        let make_cs = f.fmi3InstantiateCoSimulation.expect("a function");
        let (event_mode, early) = match kind {
            Kind::EventMode { early_return } => (1, early_return.into()),
            _ => (0, 0),
        };
        // SAFETY: texts that end with a NUL, a log that lives as long as the instance. The array of intermediate
        // variables dangles, as that of a known importer, and is announced to be empty.
        let instance = unsafe {
            match kind {
                Kind::ModelExchange => make_me(name, token, path, 0, loud, environment, logger),
                _ => {
                    let none = std::ptr::without_provenance(4);
                    make_cs(name, token, path, 0, loud, event_mode, early, none, 0, environment, logger, None)
                }
            }
        };
        assert!(!instance.is_null(), "{messages:?}");
        Self { f, instance, states: [null_mut(); SLOTS], log: messages }
    }

    fn get(&self, access: &Access) -> Option<Answer> {
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

    fn set(&self, access: &Access, values: &Values) -> Option<Answer> {
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

    fn sensitivity(&self, adjoint: bool, with: &Sensitivity) -> Option<Answer> {
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

/// Calls a function that fills an array of floats with as many as announced.
macro_rules! fill {
    ($self:ident, $function:ident, $count:expr) => {{
        let mut values = vec![UNTOUCHED; *$count];
        let (pointer, n) = (array_mut(&mut values, false), values.len());
        let status = ($self.f.$function?)($self.instance, pointer, n);
        (status, values.into_iter().map(f64::to_bits).collect())
    }};
}

impl Host for Instance {
    fn play(&mut self, call: &Call) -> Option<Answer> {
        let i = self.instance;
        let mut bits = Vec::new();
        let mut bytes = Vec::new();
        // SAFETY: `i` is an instance until it is freed in `drop`; all pointers are to locals that live through the
        // call or, where the standard allows it, NULL; states are NULL or were given out and have not been freed.
        let status = unsafe {
            match call {
                Call::SetDebugLogging { on, categories } => {
                    let owned: Vec<_> = categories.iter().map(|c| CString::new(c.as_str()).expect("no NUL")).collect();
                    let names: Vec<_> = owned.iter().map(|c| c.as_ptr()).collect();
                    self.f.fmi3SetDebugLogging?(i, u8::from(*on), names.len(), array(&names, false))
                }
                Call::EnterInitialization(with) => self.f.fmi3EnterInitializationMode?(
                    i,
                    with.tolerance.is_some().into(),
                    with.tolerance.unwrap_or(f64::NAN),
                    with.start,
                    with.stop.is_some().into(),
                    with.stop.unwrap_or(f64::NAN),
                ),
                Call::ExitInitialization => self.f.fmi3ExitInitializationMode?(i),
                Call::Terminate => self.f.fmi3Terminate?(i),
                Call::Reset => self.f.fmi3Reset?(i),
                Call::Get(access) => return self.get(access),
                Call::Set(access, values) => return self.set(access, values),
                Call::DoStep { time, size } => {
                    let (mut event, mut terminate, mut early, mut last) = (9, 9, 9, UNTOUCHED);
                    let status =
                        self.f.fmi3DoStep?(i, *time, *size, 0, &mut event, &mut terminate, &mut early, &mut last);
                    if status < ERROR {
                        assert!(event <= 1 && terminate == 0 && early <= 1, "{event} {terminate} {early}");
                    }
                    bits = vec![last.to_bits(), event.into(), early.into()];
                    status
                }
                Call::EnterEvent => self.f.fmi3EnterEventMode?(i),
                Call::Update => {
                    let (mut more, mut end, mut nominals, mut states, mut defined) = (9, 9, 9, 9, 9);
                    let mut next = UNTOUCHED;
                    let status = self.f.fmi3UpdateDiscreteStates?(
                        i,
                        &mut more,
                        &mut end,
                        &mut nominals,
                        &mut states,
                        &mut defined,
                        &mut next,
                    );
                    if status < DISCARD {
                        assert!(more <= 1 && end <= 1 && nominals <= 1 && states <= 1 && defined <= 1);
                    }
                    bits = vec![more.into(), states.into(), defined.into()];
                    if defined == 1 {
                        bits.push(next.to_bits());
                    }
                    status
                }
                Call::EnterContinuousTime => self.f.fmi3EnterContinuousTimeMode?(i),
                Call::EnterStep => self.f.fmi3EnterStepMode?(i),
                Call::CompletedStep => {
                    let (mut enter, mut terminate) = (9, 9);
                    self.f.fmi3CompletedIntegratorStep?(i, 0, &mut enter, &mut terminate)
                }
                Call::SetTime(time) => self.f.fmi3SetTime?(i, *time),
                Call::SetStates(x) => self.f.fmi3SetContinuousStates?(i, array(x, false), x.len()),
                Call::GetStates(n) => {
                    let status;
                    (status, bits) = fill!(self, fmi3GetContinuousStates, n);
                    status
                }
                Call::GetDerivatives(n) => {
                    let status;
                    (status, bits) = fill!(self, fmi3GetContinuousStateDerivatives, n);
                    status
                }
                Call::GetIndicators(n) => {
                    let status;
                    (status, bits) = fill!(self, fmi3GetEventIndicators, n);
                    status
                }
                Call::GetNominals(n) => {
                    let status;
                    (status, bits) = fill!(self, fmi3GetNominalsOfContinuousStates, n);
                    status
                }
                Call::GetCounts => {
                    let (mut states, mut indicators) = (usize::MAX, usize::MAX);
                    let status = self.f.fmi3GetNumberOfContinuousStates?(i, &mut states);
                    if status == OK {
                        assert_eq!(self.f.fmi3GetNumberOfEventIndicators?(i, &mut indicators), OK);
                    }
                    bits = vec![states as u64, indicators as u64];
                    status
                }
                Call::Directional(with) => return self.sensitivity(false, with),
                Call::Adjoint(with) => return self.sensitivity(true, with),
                Call::OutputDerivatives(access, orders) => {
                    let mut values = vec![UNTOUCHED; access.count];
                    let references = array(&access.references, false);
                    let (place, room) = (array_mut(&mut values, access.null), access.count);
                    let n = access.references.len();
                    let status = self.f.fmi3GetOutputDerivatives?(i, references, n, array(orders, false), place, room);
                    bits = values.into_iter().map(f64::to_bits).collect();
                    status
                }
                Call::GetState(slot) => self.f.fmi3GetFMUState?(i, &mut self.states[*slot]),
                Call::SetState(slot) => self.f.fmi3SetFMUState?(i, self.states[*slot]),
                Call::FreeState(slot) => self.f.fmi3FreeFMUState?(i, &mut self.states[*slot]),
                Call::Serialize(slot) => {
                    let mut size = 0;
                    let mut status = self.f.fmi3SerializedFMUStateSize?(i, self.states[*slot], &mut size);
                    if status == OK {
                        bytes = vec![0; size];
                        let state = self.states[*slot];
                        status = self.f.fmi3SerializeFMUState?(i, state, bytes.as_mut_ptr(), size);
                    }
                    status
                }
                Call::Deserialize(slot, bytes) => {
                    let pointer = array(bytes, false);
                    self.f.fmi3DeserializeFMUState?(i, pointer, bytes.len(), &mut self.states[*slot])
                }
                Call::EnterConfiguration => self.f.fmi3EnterConfigurationMode?(i),
                Call::ExitConfiguration => self.f.fmi3ExitConfigurationMode?(i),
                Call::EvaluateDiscrete => self.f.fmi3EvaluateDiscreteStates?(i),
                Call::Activate(clock, time) => self.f.fmi3ActivateModelPartition?(i, *clock, *time),
                Call::Dependencies(variable) => {
                    let mut n = 0;
                    let status = self.f.fmi3GetNumberOfVariableDependencies?(i, *variable, &mut n);
                    if status == OK {
                        let (mut of, mut on) = (vec![0_usize; n], vec![0_usize; n]);
                        let (mut references, mut kinds) = (vec![0_u32; n], vec![0; n]);
                        let status = self.f.fmi3GetVariableDependencies?(
                            i,
                            *variable,
                            of.as_mut_ptr(),
                            references.as_mut_ptr(),
                            on.as_mut_ptr(),
                            kinds.as_mut_ptr(),
                            n,
                        );
                        bits = references.into_iter().map(Into::into).collect();
                        return Some(Answer { status, bits, bytes });
                    }
                    status
                }
                Call::SetupExperiment(_) | Call::InputDerivatives(..) | Call::Status(_) | Call::CancelStep => {
                    return None;
                }
            }
        };
        Some(Answer { status, bits, bytes })
    }

    fn messages(&mut self) -> Messages {
        std::mem::take(&mut self.log)
    }
}

impl Drop for Instance {
    fn drop(&mut self) {
        let f = &self.f;
        // SAFETY: an instance and its states, none of which is used again.
        unsafe {
            for state in &mut self.states {
                f.fmi3FreeFMUState.expect("a function")(self.instance, state);
            }
            f.fmi3FreeInstance.expect("a function")(self.instance);
        }
    }
}
