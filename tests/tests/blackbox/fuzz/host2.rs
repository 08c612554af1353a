//! An instance of FMI 2.0. Its logger takes a variable number of arguments, which Rust cannot define: it is NULL here, and
//! the messages are looked at elsewhere.

use std::ffi::{CStr, CString, c_void};
use std::ptr::{null, null_mut};

use swayless_abi::fmi2::*;
use swayless_modeldesc::types::DataType;

use super::call::{Access, Answer, Call, Values};
use super::library::{Host, Kind, SLOTS, UNTOUCHED, array, array_mut, hash};

pub struct Instance {
    f: Functions,
    instance: *mut c_void,
    states: [FMUstate; SLOTS],
    /// What the instance was made with; it must not be touched by the FMU, but lives as long as it.
    _callbacks: Box<CallbackFunctions>,
}

macro_rules! get {
    ($self:ident, $function:ident, $access:ident, $of:expr) => {{
        let mut values = vec![Default::default(); $access.references.len()];
        let (references, place) = (&$access.references, array_mut(&mut values, $access.null));
        // SAFETY: an instance; as many references and places as announced, or NULL.
        let status = unsafe { ($self.f.$function?)($self.instance, array(references, false), references.len(), place) };
        Answer { status, bits: values.into_iter().map($of).collect(), ..Answer::default() }
    }};
}

macro_rules! set {
    ($self:ident, $function:ident, $access:ident, $values:expr) => {{
        let values = $values;
        let references = &$access.references;
        assert_eq!(values.len(), references.len());
        let place = array(&values, $access.null);
        // SAFETY: an instance; as many references and values as announced, or NULL.
        let status = unsafe { ($self.f.$function?)($self.instance, array(references, false), references.len(), place) };
        Answer { status, ..Answer::default() }
    }};
}

impl Instance {
    /// Without a resource location, there are no callbacks for memory either.
    pub fn new(f: Functions, kind: Kind, token: &CStr, resources: Option<&CString>) -> Self {
        let callbacks = Box::new(CallbackFunctions {
            logger: None,
            allocate_memory: None,
            free_memory: None,
            step_finished: None,
            component_environment: null_mut(),
        });
        let location = resources.map_or(null(), |location| location.as_ptr());
        let interface = if kind == Kind::ModelExchange { MODEL_EXCHANGE } else { CO_SIMULATION };
        let instantiate = f.fmi2Instantiate.expect("a function");
        // SAFETY: texts that end with a NUL, and callbacks that live as long as the instance.
        let instance = unsafe { instantiate(c"fuzz".as_ptr(), interface, token.as_ptr(), location, &*callbacks, 0, 1) };
        assert!(!instance.is_null());
        Self { f, instance, states: [null_mut(); SLOTS], _callbacks: callbacks }
    }

    fn get(&self, access: &Access) -> Option<Answer> {
        Some(match access.data_type {
            DataType::Float64 => get!(self, fmi2GetReal, access, f64::to_bits),
            DataType::Int32 | DataType::Enumeration => get!(self, fmi2GetInteger, access, |v: i32| v as u64),
            DataType::Boolean => get!(self, fmi2GetBoolean, access, |v: i32| v as u64),
            DataType::String => {
                let mut texts = vec![null(); access.references.len()];
                let (references, place) = (&access.references, array_mut(&mut texts, access.null));
                // SAFETY: an instance; as many references and places as announced, or NULL.
                let status = unsafe {
                    (self.f.fmi2GetString?)(self.instance, array(references, false), references.len(), place)
                };
                // SAFETY: NULL is left out; what an instance returns ends with a NUL and stays until the next call.
                let read =
                    |text: &*const i8| (!text.is_null()).then(|| hash(unsafe { CStr::from_ptr(*text) }.to_bytes()));
                Answer { status, bits: texts.iter().filter_map(read).collect(), ..Answer::default() }
            }
            _ => return None,
        })
    }

    fn set(&self, access: &Access, values: &Values) -> Option<Answer> {
        Some(match (access.data_type, values) {
            (DataType::Float64, Values::Floats(v)) => set!(self, fmi2SetReal, access, v.clone()),
            (DataType::Int32 | DataType::Enumeration, Values::Integers(v)) => {
                set!(self, fmi2SetInteger, access, v.iter().map(|v| *v as i32).collect::<Vec<_>>())
            }
            (DataType::Boolean, Values::Booleans(v)) => {
                set!(self, fmi2SetBoolean, access, v.iter().map(|v| i32::from(*v)).collect::<Vec<_>>())
            }
            (DataType::String, Values::Texts(texts)) => {
                let owned: Vec<_> =
                    texts.iter().map(|text| text.clone().map(|t| CString::new(t).expect("no NUL"))).collect();
                let pointers = owned.iter().map(|text| text.as_ref().map_or(null(), |text| text.as_ptr()));
                set!(self, fmi2SetString, access, pointers.collect::<Vec<_>>())
            }
            _ => return None,
        })
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
                    self.f.fmi2SetDebugLogging?(i, i32::from(*on), names.len(), array(&names, false))
                }
                Call::SetupExperiment(with) => self.f.fmi2SetupExperiment?(
                    i,
                    with.tolerance.is_some().into(),
                    with.tolerance.unwrap_or(f64::NAN),
                    with.start,
                    with.stop.is_some().into(),
                    with.stop.unwrap_or(f64::NAN),
                ),
                Call::EnterInitialization(_) => self.f.fmi2EnterInitializationMode?(i),
                Call::ExitInitialization => self.f.fmi2ExitInitializationMode?(i),
                Call::Terminate => self.f.fmi2Terminate?(i),
                Call::Reset => self.f.fmi2Reset?(i),
                Call::Get(access) => return self.get(access),
                Call::Set(access, values) => return self.set(access, values),
                Call::DoStep { time, size } => {
                    let status = self.f.fmi2DoStep?(i, *time, *size, 0);
                    bits = vec![(time + size).to_bits(), 0, 0];
                    status
                }
                Call::EnterEvent => self.f.fmi2EnterEventMode?(i),
                Call::Update => {
                    let mut info = EventInfo { next_event_time: UNTOUCHED, ..EventInfo::default() };
                    let status = self.f.fmi2NewDiscreteStates?(i, &mut info);
                    bits = vec![
                        info.new_discrete_states_needed as u64,
                        info.values_of_continuous_states_changed as u64,
                        info.next_event_time_defined as u64,
                    ];
                    if info.next_event_time_defined != 0 {
                        bits.push(info.next_event_time.to_bits());
                    }
                    status
                }
                Call::EnterContinuousTime => self.f.fmi2EnterContinuousTimeMode?(i),
                Call::CompletedStep => {
                    let (mut enter, mut terminate) = (9, 9);
                    self.f.fmi2CompletedIntegratorStep?(i, 0, &mut enter, &mut terminate)
                }
                Call::SetTime(time) => self.f.fmi2SetTime?(i, *time),
                Call::SetStates(x) => self.f.fmi2SetContinuousStates?(i, array(x, false), x.len()),
                Call::GetStates(n) => {
                    let status;
                    (status, bits) = fill!(self, fmi2GetContinuousStates, n);
                    status
                }
                Call::GetDerivatives(n) => {
                    let status;
                    (status, bits) = fill!(self, fmi2GetDerivatives, n);
                    status
                }
                Call::GetIndicators(n) => {
                    let status;
                    (status, bits) = fill!(self, fmi2GetEventIndicators, n);
                    status
                }
                Call::GetNominals(n) => {
                    let status;
                    (status, bits) = fill!(self, fmi2GetNominalsOfContinuousStates, n);
                    status
                }
                Call::Directional(with) => {
                    // The arrays are as long as the lists of variables, without a count of their own.
                    let mut seed = with.seed.clone();
                    seed.resize(with.knowns.len(), 1.0);
                    let mut places = vec![UNTOUCHED; with.unknowns.len()];
                    let (unknowns, n_unknowns) = (array(&with.unknowns, false), with.unknowns.len());
                    let (knowns, n_knowns) = (array(&with.knowns, false), with.knowns.len());
                    let (dv, place) = (array(&seed, false), array_mut(&mut places, false));
                    let status =
                        self.f.fmi2GetDirectionalDerivative?(i, unknowns, n_unknowns, knowns, n_knowns, dv, place);
                    bits = places.into_iter().map(f64::to_bits).collect();
                    status
                }
                Call::OutputDerivatives(access, orders) => {
                    let mut values = vec![UNTOUCHED; access.references.len()];
                    let (references, n) = (array(&access.references, false), access.references.len());
                    let place = array_mut(&mut values, access.null);
                    let status = self.f.fmi2GetRealOutputDerivatives?(i, references, n, array(orders, false), place);
                    bits = values.into_iter().map(f64::to_bits).collect();
                    status
                }
                Call::InputDerivatives(access, orders, values) => {
                    let (references, n) = (array(&access.references, false), access.references.len());
                    let (orders, values) = (array(orders, false), array(values, access.null));
                    self.f.fmi2SetRealInputDerivatives?(i, references, n, orders, values)
                }
                Call::GetState(slot) => self.f.fmi2GetFMUstate?(i, &mut self.states[*slot]),
                Call::SetState(slot) => self.f.fmi2SetFMUstate?(i, self.states[*slot]),
                Call::FreeState(slot) => self.f.fmi2FreeFMUstate?(i, &mut self.states[*slot]),
                Call::Serialize(slot) => {
                    let mut size = 0;
                    let mut status = self.f.fmi2SerializedFMUstateSize?(i, self.states[*slot], &mut size);
                    if status == OK {
                        bytes = vec![0; size];
                        let state = self.states[*slot];
                        status = self.f.fmi2SerializeFMUstate?(i, state, bytes.as_mut_ptr().cast(), size);
                    }
                    status
                }
                Call::Deserialize(slot, bytes) => {
                    let pointer = array(bytes, false).cast();
                    self.f.fmi2DeSerializeFMUstate?(i, pointer, bytes.len(), &mut self.states[*slot])
                }
                Call::Status(function, kind) => {
                    let (mut time, mut number, mut flag, mut text, mut of) = (UNTOUCHED, -1, -1, null(), -1);
                    let status = match function {
                        0 => self.f.fmi2GetRealStatus?(i, *kind, &mut time),
                        1 => self.f.fmi2GetIntegerStatus?(i, *kind, &mut number),
                        2 => self.f.fmi2GetBooleanStatus?(i, *kind, &mut flag),
                        3 => self.f.fmi2GetStringStatus?(i, *kind, &mut text),
                        _ => self.f.fmi2GetStatus?(i, *kind, &mut of),
                    };
                    bits = vec![time.to_bits(), number as u64, flag as u64, of as u64];
                    status
                }
                Call::CancelStep => self.f.fmi2CancelStep?(i),
                Call::EnterStep
                | Call::GetCounts
                | Call::Adjoint(_)
                | Call::EnterConfiguration
                | Call::ExitConfiguration
                | Call::EvaluateDiscrete
                | Call::Activate(..)
                | Call::GetTiming(..)
                | Call::SetTiming(..)
                | Call::Dependencies(_) => return None,
            }
        };
        Some(Answer { status, bits, bytes })
    }

    fn messages(&mut self) -> Vec<(i32, std::string::String)> {
        Vec::new()
    }
}

impl Drop for Instance {
    fn drop(&mut self) {
        let f = &self.f;
        // SAFETY: an instance and its states, none of which is used again.
        unsafe {
            for state in &mut self.states {
                f.fmi2FreeFMUstate.expect("a function")(self.instance, state);
            }
            f.fmi2FreeInstance.expect("a function")(self.instance);
        }
    }
}
