//! An instance of FMI 3.0.

mod clocks;
mod sensitivity;
mod values;

use std::ffi::{CStr, CString, c_void};
use std::ptr::{null, null_mut};

use swayless_abi::fmi3::*;

use super::call::{Answer, Call};
use super::library::{Host, Kind, SLOTS, UNTOUCHED, array, array_mut};

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
        let make_se = f.fmi3InstantiateScheduledExecution.expect("a function");
        let (event_mode, early) = match kind {
            Kind::EventMode { early_return } => (1, early_return.into()),
            _ => (0, 0),
        };
        // SAFETY: texts that end with a NUL, a log that lives as long as the instance. The array of intermediate
        // variables dangles, as that of a known importer, and is announced to be empty.
        let instance = unsafe {
            match kind {
                Kind::ModelExchange => make_me(name, token, path, 0, loud, environment, logger),
                Kind::ScheduledExecution => make_se(name, token, path, 0, loud, environment, logger, None, None, None),
                _ => {
                    let none = std::ptr::without_provenance(4);
                    make_cs(name, token, path, 0, loud, event_mode, early, none, 0, environment, logger, None)
                }
            }
        };
        assert!(!instance.is_null(), "{messages:?}");
        Self { f, instance, states: [null_mut(); SLOTS], log: messages }
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
                Call::GetTiming(of, clocks) => return self.get_timing(*of, clocks),
                Call::SetTiming(of, clocks, times) => return self.set_timing(*of, clocks, times),
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
                Call::SetupExperiment(_) | Call::InputDerivatives(..) | Call::Status(..) | Call::CancelStep => {
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
