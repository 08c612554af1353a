//! FMI 2.0 for co-simulation.

use std::ffi::{CString, c_int};
use std::path::Path;
use std::ptr;
use std::sync::Arc;

use percent_encoding::{AsciiSet, NON_ALPHANUMERIC, utf8_percent_encode};
use swayless_abi::fmi2::{self, Functions};
use swayless_modeldesc::types::DataType;

use super::callbacks::Environment;
use super::library::Library;
use super::scratch::{Plain, Scratch};
use super::{Instantiation, Once, Phase, c_string, check_lengths, present, wrong_type};
use crate::error::{Error, Result};
use crate::slave::{Experiment, Failure, LogMessage, Slave, Step};

/// A loaded binary of FMI 2.0.
pub(crate) struct Binary {
    functions: Functions,
    _library: Library,
}

impl Binary {
    /// Looks up the functions.
    pub(super) fn new(library: Library) -> Result<Self> {
        // SAFETY: the addresses are those of the library's symbols of these names, which its description says are the
        // standard's; the library stays loaded as long as the functions, both being fields of one struct.
        let functions = unsafe { Functions::find(|name| library.address(name)) };
        let required = [
            ("fmi2Instantiate", functions.fmi2Instantiate.is_some()),
            ("fmi2FreeInstance", functions.fmi2FreeInstance.is_some()),
            ("fmi2SetupExperiment", functions.fmi2SetupExperiment.is_some()),
            ("fmi2EnterInitializationMode", functions.fmi2EnterInitializationMode.is_some()),
            ("fmi2ExitInitializationMode", functions.fmi2ExitInitializationMode.is_some()),
            ("fmi2GetReal", functions.fmi2GetReal.is_some()),
            ("fmi2SetReal", functions.fmi2SetReal.is_some()),
            ("fmi2DoStep", functions.fmi2DoStep.is_some()),
            ("fmi2Terminate", functions.fmi2Terminate.is_some()),
        ];
        library.check("2.0", &required, functions.fmi2GetVersion)?;
        Ok(Self { functions, _library: library })
    }
}

/// An instance of FMI 2.0 for co-simulation.
pub(super) struct Instance {
    component: fmi2::Component,
    phase: Phase,
    scratch: Scratch,
    environment: Arc<Environment>,
    /// The FMU may read these at any time.
    _callbacks: Box<fmi2::CallbackFunctions>,
    binary: Arc<Binary>,
    _once: Option<Once>,
}

type Call = unsafe extern "C" fn(fmi2::Component) -> fmi2::Status;
type Get<T> = unsafe extern "C" fn(fmi2::Component, *const u32, usize, *mut T) -> fmi2::Status;
type Set<T> = unsafe extern "C" fn(fmi2::Component, *const u32, usize, *const T) -> fmi2::Status;

impl Instance {
    /// Instantiates for co-simulation.
    pub(super) fn new(binary: Arc<Binary>, with: Instantiation) -> Result<Self> {
        let environment = Environment::new(with.name);
        let callbacks = Box::new(environment.fmi2_callbacks());
        let (name, token, resources) = (c_string(with.name)?, c_string(with.token)?, uri(with.resources)?);
        let component = match binary.functions.fmi2Instantiate {
            // SAFETY: the strings end with a NUL and outlive the call, after which the FMU must not use them; the
            // callbacks and the environment live on the heap as long as the instance.
            Some(instantiate) => unsafe {
                instantiate(
                    name.as_ptr(),
                    fmi2::CO_SIMULATION,
                    token.as_ptr(),
                    resources.as_ptr(),
                    &raw const *callbacks,
                    0,
                    c_int::from(with.logging),
                )
            },
            None => ptr::null_mut(),
        };
        if component.is_null() {
            return Err(Error::Instantiate {
                path: with.fmu.to_owned(),
                instance: with.name.to_owned(),
                token: with.token.to_owned(),
                messages: environment.take_messages(),
            });
        }
        let (phase, scratch) = (Phase::Instantiated, Scratch::default());
        let instance = Self { component, phase, scratch, environment, _callbacks: callbacks, binary, _once: with.once };
        if !with.logging {
            instance.log_problems(with.problems)?;
        }
        Ok(instance)
    }

    /// Asks for messages on problems alone. An FMU that cannot choose stays silent, which is no reason not to run it.
    fn log_problems(&self, categories: &[&str]) -> Result<()> {
        let categories = categories.iter().map(|name| c_string(name)).collect::<Result<Vec<_>>>()?;
        let pointers: Vec<_> = categories.iter().map(|name| name.as_ptr()).collect();
        if let (Some(set), false) = (self.f().fmi2SetDebugLogging, pointers.is_empty()) {
            // SAFETY: the instance is live; the strings end with a NUL, are as many as the count says, and outlive the
            // call.
            unsafe { set(self.component, 1, pointers.len(), pointers.as_ptr()) };
        }
        Ok(())
    }

    fn f(&self) -> &Functions {
        &self.binary.functions
    }

    /// Turns a status into a result and remembers when the instance became unusable.
    #[inline]
    fn answer(&mut self, call: &'static str, status: c_int) -> Result<(), Failure> {
        match status {
            fmi2::OK | fmi2::WARNING => Ok(()),
            _ => Err(self.fail(call, status)),
        }
    }

    #[cold]
    fn fail(&mut self, call: &'static str, status: c_int) -> Failure {
        match status {
            fmi2::DISCARD => {}
            fmi2::FATAL => self.phase = Phase::Broken,
            _ => self.phase = Phase::Failed,
        }
        self.environment.failure(call, status)
    }

    /// Calls a function that takes nothing else.
    fn call(&mut self, name: &'static str, call: Option<Call>) -> Result<(), Failure> {
        let call = present(name, call)?;
        // SAFETY: the instance is live, and the phase allows the call, as the callers have checked.
        let status = unsafe { call(self.component) };
        self.answer(name, status)
    }

    fn get<T>(
        &mut self,
        name: &'static str,
        get: Option<Get<T>>,
        references: &[u32],
        values: &mut [T],
    ) -> Result<(), Failure> {
        self.phase.expect_accessible(name)?;
        check_lengths(name, references.len(), values.len(), true)?;
        let get = present(name, get)?;
        // SAFETY: the instance is live; both pointers are valid for as many items as the count says.
        let status = unsafe { get(self.component, references.as_ptr(), references.len(), values.as_mut_ptr()) };
        self.answer(name, status)
    }

    fn set<T>(
        &mut self,
        name: &'static str,
        set: Option<Set<T>>,
        references: &[u32],
        values: &[T],
    ) -> Result<(), Failure> {
        self.phase.expect_accessible(name)?;
        check_lengths(name, references.len(), values.len(), true)?;
        let set = present(name, set)?;
        // SAFETY: as in `get`; the FMU only reads.
        let status = unsafe { set(self.component, references.as_ptr(), references.len(), values.as_ptr()) };
        self.answer(name, status)
    }

    /// Gets values of a type that is not the slice's.
    fn get_as<T: Plain, V>(
        &mut self,
        name: &'static str,
        get: Option<Get<T>>,
        references: &[u32],
        values: &mut [V],
        convert: impl Fn(T) -> V,
    ) -> Result<(), Failure> {
        let mut scratch = std::mem::take(&mut self.scratch);
        let raw = scratch.of::<T>(values.len());
        let answer = self.get(name, get, references, raw);
        if answer.is_ok() {
            for (value, &raw) in values.iter_mut().zip(&*raw) {
                *value = convert(raw);
            }
        }
        self.scratch = scratch;
        answer
    }

    /// What the instance says of a discarded step: how far it got, and whether it wants the run to end.
    fn discarded(&self) -> (Option<f64>, bool) {
        let (mut last, mut terminated) = (0.0, 0);
        let last = self.f().fmi2GetRealStatus.and_then(|get| {
            // SAFETY: the instance is live, its last step was discarded, and the pointer is to a local.
            let status = unsafe { get(self.component, fmi2::LAST_SUCCESSFUL_TIME, &mut last) };
            (status == fmi2::OK).then_some(last)
        });
        let terminated = self.f().fmi2GetBooleanStatus.is_some_and(|get| {
            // SAFETY: as above.
            let status = unsafe { get(self.component, fmi2::TERMINATED, &mut terminated) };
            status == fmi2::OK && terminated != 0
        });
        (last, terminated)
    }

    /// Waits for the end of a step that the FMU took up asynchronously.
    fn wait(&self) -> c_int {
        let mut status = fmi2::PENDING;
        while status == fmi2::PENDING {
            std::thread::yield_now();
            let asked = match self.f().fmi2GetStatus {
                // SAFETY: the instance is live, a step is pending, and the pointer is to a local.
                Some(get) => unsafe { get(self.component, fmi2::DO_STEP_STATUS, &mut status) },
                None => fmi2::ERROR,
            };
            if asked != fmi2::OK {
                return fmi2::ERROR;
            }
        }
        status
    }
}

/// A folder as a URI. FMUs take it apart in many ways, so everything but the plainest characters is encoded.
fn uri(folder: &Path) -> Result<CString> {
    const ENCODED: &AsciiSet = &NON_ALPHANUMERIC.remove(b'/').remove(b'-').remove(b'_').remove(b'.').remove(b'~');
    let path = folder.to_string_lossy();
    // On Windows: `\\?\C:\folder` becomes `/C:/folder`.
    let path = path.strip_prefix(r"\\?\").unwrap_or(&path).replace('\\', "/");
    let root = if path.starts_with('/') { "" } else { "/" };
    let encoded = utf8_percent_encode(&path, if cfg!(windows) { const { &ENCODED.remove(b':') } } else { ENCODED });
    c_string(&format!("file://{root}{encoded}"))
}

impl Slave for Instance {
    fn enter_initialization_mode(&mut self, experiment: &Experiment) -> Result<(), Failure> {
        let name = "fmi2SetupExperiment";
        self.phase.expect(name, &[Phase::Instantiated])?;
        let set_up = present(name, self.f().fmi2SetupExperiment)?;
        let Experiment { start_time, stop_time, tolerance } = *experiment;
        // SAFETY: the instance is live and only instantiated.
        let status = unsafe {
            let defined = c_int::from(tolerance.is_some());
            set_up(self.component, defined, tolerance.unwrap_or(0.0), start_time, 1, stop_time)
        };
        self.answer(name, status)?;
        self.call("fmi2EnterInitializationMode", self.f().fmi2EnterInitializationMode)?;
        self.phase = Phase::Initialization;
        Ok(())
    }

    fn exit_initialization_mode(&mut self) -> Result<(), Failure> {
        self.phase.expect("fmi2ExitInitializationMode", &[Phase::Initialization])?;
        self.call("fmi2ExitInitializationMode", self.f().fmi2ExitInitializationMode)?;
        self.phase = Phase::Stepping;
        Ok(())
    }

    fn get_float(&mut self, data_type: DataType, references: &[u32], values: &mut [f64]) -> Result<(), Failure> {
        match data_type {
            DataType::Float64 => self.get("fmi2GetReal", self.f().fmi2GetReal, references, values),
            _ => Err(wrong_type("fmi2GetReal", data_type)),
        }
    }

    fn set_float(&mut self, data_type: DataType, references: &[u32], values: &[f64]) -> Result<(), Failure> {
        match data_type {
            DataType::Float64 => self.set("fmi2SetReal", self.f().fmi2SetReal, references, values),
            _ => Err(wrong_type("fmi2SetReal", data_type)),
        }
    }

    fn get_integer(&mut self, data_type: DataType, references: &[u32], values: &mut [i64]) -> Result<(), Failure> {
        let name = "fmi2GetInteger";
        match data_type {
            DataType::Int32 | DataType::Enumeration => {
                self.get_as(name, self.f().fmi2GetInteger, references, values, |value: c_int| i64::from(value))
            }
            _ => Err(wrong_type(name, data_type)),
        }
    }

    fn set_integer(&mut self, data_type: DataType, references: &[u32], values: &[i64]) -> Result<(), Failure> {
        let name = "fmi2SetInteger";
        if !matches!(data_type, DataType::Int32 | DataType::Enumeration) {
            return Err(wrong_type(name, data_type));
        }
        let mut scratch = std::mem::take(&mut self.scratch);
        let answer = scratch
            .fill(name, values, |value| c_int::try_from(value).ok())
            .and_then(|raw| self.set(name, self.f().fmi2SetInteger, references, raw));
        self.scratch = scratch;
        answer
    }

    fn get_boolean(&mut self, references: &[u32], values: &mut [bool]) -> Result<(), Failure> {
        self.get_as("fmi2GetBoolean", self.f().fmi2GetBoolean, references, values, |value: c_int| value != 0)
    }

    fn set_boolean(&mut self, references: &[u32], values: &[bool]) -> Result<(), Failure> {
        let name = "fmi2SetBoolean";
        let mut scratch = std::mem::take(&mut self.scratch);
        let answer = scratch
            .fill(name, values, |value| Some(c_int::from(value)))
            .and_then(|raw| self.set(name, self.f().fmi2SetBoolean, references, raw));
        self.scratch = scratch;
        answer
    }

    fn get_string(&mut self, references: &[u32], values: &mut [String]) -> Result<(), Failure> {
        let mut scratch = std::mem::take(&mut self.scratch);
        let pointers = scratch.pointers(values.len());
        let answer = self.get("fmi2GetString", self.f().fmi2GetString, references, pointers);
        if answer.is_ok() {
            // SAFETY: the FMU has just filled the pointers (those it left out are NULL); its strings stay until the
            // next call.
            unsafe { scratch.copy_strings(values) };
        }
        self.scratch = scratch;
        answer
    }

    fn set_string(&mut self, references: &[u32], values: &[String]) -> Result<(), Failure> {
        let name = "fmi2SetString";
        let mut scratch = std::mem::take(&mut self.scratch);
        let answer = scratch
            .strings(name, values)
            .and_then(|pointers| self.set(name, self.f().fmi2SetString, references, pointers));
        self.scratch = scratch;
        answer
    }

    fn do_step(&mut self, time: f64, step_size: f64) -> Result<Step, Failure> {
        let name = "fmi2DoStep";
        self.phase.expect(name, &[Phase::Stepping])?;
        let do_step = present(name, self.f().fmi2DoStep)?;
        // SAFETY: the instance is live and initialized. Nothing rolls a step back, so the state before it is not
        // needed.
        let mut status = unsafe { do_step(self.component, time, step_size, 1) };
        if status == fmi2::PENDING {
            status = self.wait();
        }
        if matches!(status, fmi2::OK | fmi2::WARNING) {
            return Ok(Step::Completed);
        }
        let (last, terminated) = if status == fmi2::DISCARD { self.discarded() } else { (None, false) };
        // Who says how far it got can go on from there; of who does not, nobody knows where it is.
        if terminated || last.is_none() {
            self.phase = Phase::StepFailed;
        }
        if terminated {
            return Ok(Step::Terminated(last.unwrap_or(time)));
        }
        self.answer(name, status)
            .map(|()| Step::Completed)
            .map_err(|failure| Failure { last_successful_time: last, ..failure })
    }

    fn terminate(&mut self) -> Result<(), Failure> {
        self.phase.expect("fmi2Terminate", &[Phase::Stepping, Phase::StepFailed])?;
        self.call("fmi2Terminate", self.f().fmi2Terminate)?;
        self.phase = Phase::Terminated;
        Ok(())
    }

    fn reset(&mut self) -> Result<(), Failure> {
        if self.phase == Phase::Broken {
            return self.phase.expect("fmi2Reset", &[]);
        }
        self.call("fmi2Reset", self.f().fmi2Reset)?;
        self.phase = Phase::Instantiated;
        Ok(())
    }

    fn take_messages(&mut self) -> Vec<LogMessage> {
        self.environment.take_messages()
    }
}

impl Drop for Instance {
    fn drop(&mut self) {
        if let (Some(free), true) = (self.f().fmi2FreeInstance, self.phase != Phase::Broken) {
            // SAFETY: the instance is live and not used again; after Fatal it must not even be freed.
            unsafe { free(self.component) }
        }
    }
}
