//! FMI 3.0 for co-simulation.

use std::ffi::c_int;
use std::ptr;
use std::sync::Arc;

use swayless_abi::fmi3::{self, Functions};
use swayless_modeldesc::types::DataType;

use super::callbacks::Environment;
use super::library::Library;
use super::scratch::{Plain, Scratch};
use super::{Instantiation, Once, Phase, c_string, check_lengths, present, wrong_type};
use crate::error::{Error, Result};
use crate::slave::{Experiment, Failure, LogMessage, Slave, Status, Step};

/// A loaded binary of FMI 3.0.
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
            ("fmi3InstantiateCoSimulation", functions.fmi3InstantiateCoSimulation.is_some()),
            ("fmi3FreeInstance", functions.fmi3FreeInstance.is_some()),
            ("fmi3EnterInitializationMode", functions.fmi3EnterInitializationMode.is_some()),
            ("fmi3ExitInitializationMode", functions.fmi3ExitInitializationMode.is_some()),
            ("fmi3GetFloat64", functions.fmi3GetFloat64.is_some()),
            ("fmi3SetFloat64", functions.fmi3SetFloat64.is_some()),
            ("fmi3DoStep", functions.fmi3DoStep.is_some()),
            ("fmi3Terminate", functions.fmi3Terminate.is_some()),
        ];
        library.check("3.0", &required, functions.fmi3GetVersion)?;
        Ok(Self { functions, _library: library })
    }
}

/// An instance of FMI 3.0 for co-simulation.
pub(super) struct Instance {
    instance: fmi3::Instance,
    phase: Phase,
    scratch: Scratch,
    environment: Arc<Environment>,
    binary: Arc<Binary>,
    _once: Option<Once>,
}

type Call = unsafe extern "C" fn(fmi3::Instance) -> fmi3::Status;
type Get<T> = unsafe extern "C" fn(fmi3::Instance, *const u32, usize, *mut T, usize) -> fmi3::Status;
type Set<T> = unsafe extern "C" fn(fmi3::Instance, *const u32, usize, *const T, usize) -> fmi3::Status;

impl Instance {
    /// Instantiates without event mode, early return and intermediate update: the master wants plain steps.
    pub(super) fn new(binary: Arc<Binary>, with: Instantiation) -> Result<Self> {
        let environment = Environment::new(with.name);
        let (name, token) = (c_string(with.name)?, c_string(with.token)?);
        // The standard wants a separator at the end.
        let resources = c_string(&with.resources.join("").to_string_lossy())?;
        let instance = match binary.functions.fmi3InstantiateCoSimulation {
            // SAFETY: the strings end with a NUL and outlive the call, after which the FMU must not use them; no
            // intermediate variables are asked for, so none are read; the environment lives as long as the instance.
            Some(instantiate) => unsafe {
                instantiate(
                    name.as_ptr(),
                    token.as_ptr(),
                    resources.as_ptr(),
                    0,
                    u8::from(with.logging),
                    0,
                    0,
                    ptr::null(),
                    0,
                    environment.pointer(),
                    Environment::fmi3_logger(),
                    None,
                )
            },
            None => ptr::null_mut(),
        };
        if instance.is_null() {
            return Err(Error::Instantiate {
                path: with.fmu.to_owned(),
                instance: with.name.to_owned(),
                token: with.token.to_owned(),
                messages: environment.take_messages(),
            });
        }
        let instance = Self {
            instance,
            phase: Phase::Instantiated,
            scratch: Scratch::default(),
            environment,
            binary,
            _once: with.once,
        };
        if !with.logging {
            instance.log_problems(with.problems)?;
        }
        Ok(instance)
    }

    /// Asks for messages on problems alone. An FMU that cannot choose stays silent, which is no reason not to run it.
    fn log_problems(&self, categories: &[&str]) -> Result<()> {
        let categories = categories.iter().map(|name| c_string(name)).collect::<Result<Vec<_>>>()?;
        let pointers: Vec<_> = categories.iter().map(|name| name.as_ptr()).collect();
        if let (Some(set), false) = (self.f().fmi3SetDebugLogging, pointers.is_empty()) {
            // SAFETY: the instance is live; the strings end with a NUL, are as many as the count says, and outlive the
            // call.
            unsafe { set(self.instance, 1, pointers.len(), pointers.as_ptr()) };
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
            fmi3::OK | fmi3::WARNING => Ok(()),
            _ => Err(self.fail(call, status)),
        }
    }

    #[cold]
    fn fail(&mut self, call: &'static str, status: c_int) -> Failure {
        match status {
            fmi3::DISCARD => {}
            fmi3::FATAL => self.phase = Phase::Broken,
            _ => self.phase = Phase::Failed,
        }
        self.environment.failure(call, status)
    }

    /// Calls a function that takes nothing else.
    fn call(&mut self, name: &'static str, call: Option<Call>) -> Result<(), Failure> {
        let call = present(name, call)?;
        // SAFETY: the instance is live, and the phase allows the call, as the callers have checked.
        let status = unsafe { call(self.instance) };
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
        check_lengths(name, references.len(), values.len(), false)?;
        let get = present(name, get)?;
        // SAFETY: the instance is live; both pointers are valid for as many items as their counts say, and there is
        // at least one value for each reference even if the FMU does not look at the second count.
        let status =
            unsafe { get(self.instance, references.as_ptr(), references.len(), values.as_mut_ptr(), values.len()) };
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
        check_lengths(name, references.len(), values.len(), false)?;
        let set = present(name, set)?;
        // SAFETY: as in `get`; the FMU only reads.
        let status =
            unsafe { set(self.instance, references.as_ptr(), references.len(), values.as_ptr(), values.len()) };
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

    /// Sets values of a type that is not the slice's; one that does not fit is refused.
    fn set_as<T: Plain, V: Copy + std::fmt::Display>(
        &mut self,
        name: &'static str,
        set: Option<Set<T>>,
        references: &[u32],
        values: &[V],
        convert: impl Fn(V) -> Option<T>,
    ) -> Result<(), Failure> {
        let mut scratch = std::mem::take(&mut self.scratch);
        let answer = scratch.fill(name, values, convert).and_then(|raw| self.set(name, set, references, raw));
        self.scratch = scratch;
        answer
    }
}

impl Slave for Instance {
    fn enter_configuration_mode(&mut self) -> Result<(), Failure> {
        self.phase.expect("fmi3EnterConfigurationMode", &[Phase::Instantiated])?;
        self.call("fmi3EnterConfigurationMode", self.f().fmi3EnterConfigurationMode)?;
        self.phase = Phase::Configuration;
        Ok(())
    }

    fn exit_configuration_mode(&mut self) -> Result<(), Failure> {
        self.phase.expect("fmi3ExitConfigurationMode", &[Phase::Configuration])?;
        self.call("fmi3ExitConfigurationMode", self.f().fmi3ExitConfigurationMode)?;
        self.phase = Phase::Instantiated;
        Ok(())
    }

    fn enter_initialization_mode(&mut self, experiment: &Experiment) -> Result<(), Failure> {
        let name = "fmi3EnterInitializationMode";
        self.phase.expect(name, &[Phase::Instantiated])?;
        let enter = present(name, self.f().fmi3EnterInitializationMode)?;
        let Experiment { start_time, stop_time, tolerance } = *experiment;
        // SAFETY: the instance is live and only instantiated.
        let status = unsafe {
            let defined = u8::from(tolerance.is_some());
            enter(self.instance, defined, tolerance.unwrap_or(0.0), start_time, 1, stop_time)
        };
        self.answer(name, status)?;
        self.phase = Phase::Initialization;
        Ok(())
    }

    fn exit_initialization_mode(&mut self) -> Result<(), Failure> {
        self.phase.expect("fmi3ExitInitializationMode", &[Phase::Initialization])?;
        self.call("fmi3ExitInitializationMode", self.f().fmi3ExitInitializationMode)?;
        self.phase = Phase::Stepping;
        Ok(())
    }

    fn get_float(&mut self, data_type: DataType, references: &[u32], values: &mut [f64]) -> Result<(), Failure> {
        match data_type {
            DataType::Float64 => self.get("fmi3GetFloat64", self.f().fmi3GetFloat64, references, values),
            DataType::Float32 => self.get_as("fmi3GetFloat32", self.f().fmi3GetFloat32, references, values, f64::from),
            _ => Err(wrong_type("fmi3GetFloat64", data_type)),
        }
    }

    fn set_float(&mut self, data_type: DataType, references: &[u32], values: &[f64]) -> Result<(), Failure> {
        match data_type {
            DataType::Float64 => self.set("fmi3SetFloat64", self.f().fmi3SetFloat64, references, values),
            DataType::Float32 => {
                self.set_as("fmi3SetFloat32", self.f().fmi3SetFloat32, references, values, |value: f64| {
                    Some(value as f32)
                })
            }
            _ => Err(wrong_type("fmi3SetFloat64", data_type)),
        }
    }

    fn get_integer(&mut self, data_type: DataType, references: &[u32], values: &mut [i64]) -> Result<(), Failure> {
        use DataType as D;
        let (r, v) = (references, values);
        match data_type {
            D::Int8 => self.get_as("fmi3GetInt8", self.f().fmi3GetInt8, r, v, i64::from),
            D::UInt8 => self.get_as("fmi3GetUInt8", self.f().fmi3GetUInt8, r, v, i64::from),
            D::Int16 => self.get_as("fmi3GetInt16", self.f().fmi3GetInt16, r, v, i64::from),
            D::UInt16 => self.get_as("fmi3GetUInt16", self.f().fmi3GetUInt16, r, v, i64::from),
            D::Int32 => self.get_as("fmi3GetInt32", self.f().fmi3GetInt32, r, v, i64::from),
            D::UInt32 => self.get_as("fmi3GetUInt32", self.f().fmi3GetUInt32, r, v, i64::from),
            D::Int64 | D::Enumeration => self.get("fmi3GetInt64", self.f().fmi3GetInt64, r, v),
            D::UInt64 => self.get_as("fmi3GetUInt64", self.f().fmi3GetUInt64, r, v, u64::cast_signed),
            _ => Err(wrong_type("fmi3GetInt64", data_type)),
        }
    }

    fn set_integer(&mut self, data_type: DataType, references: &[u32], values: &[i64]) -> Result<(), Failure> {
        use DataType as D;
        let (r, v) = (references, values);
        match data_type {
            D::Int8 => self.set_as("fmi3SetInt8", self.f().fmi3SetInt8, r, v, |value: i64| value.try_into().ok()),
            D::UInt8 => self.set_as("fmi3SetUInt8", self.f().fmi3SetUInt8, r, v, |value: i64| value.try_into().ok()),
            D::Int16 => self.set_as("fmi3SetInt16", self.f().fmi3SetInt16, r, v, |value: i64| value.try_into().ok()),
            D::UInt16 => self.set_as("fmi3SetUInt16", self.f().fmi3SetUInt16, r, v, |value: i64| value.try_into().ok()),
            D::Int32 => self.set_as("fmi3SetInt32", self.f().fmi3SetInt32, r, v, |value: i64| value.try_into().ok()),
            D::UInt32 => self.set_as("fmi3SetUInt32", self.f().fmi3SetUInt32, r, v, |value: i64| value.try_into().ok()),
            D::Int64 | D::Enumeration => self.set("fmi3SetInt64", self.f().fmi3SetInt64, r, v),
            D::UInt64 => {
                self.set_as("fmi3SetUInt64", self.f().fmi3SetUInt64, r, v, |value: i64| Some(value.cast_unsigned()))
            }
            _ => Err(wrong_type("fmi3SetInt64", data_type)),
        }
    }

    fn get_boolean(&mut self, references: &[u32], values: &mut [bool]) -> Result<(), Failure> {
        // Bytes, not `bool`s: an FMU may write something other than 0 and 1.
        self.get_as("fmi3GetBoolean", self.f().fmi3GetBoolean, references, values, |byte: u8| byte != 0)
    }

    fn set_boolean(&mut self, references: &[u32], values: &[bool]) -> Result<(), Failure> {
        self.set_as("fmi3SetBoolean", self.f().fmi3SetBoolean, references, values, |value: bool| Some(u8::from(value)))
    }

    fn get_string(&mut self, references: &[u32], values: &mut [String]) -> Result<(), Failure> {
        let get = self.f().fmi3GetString;
        let mut scratch = std::mem::take(&mut self.scratch);
        let answer = self.get("fmi3GetString", get, references, scratch.pointers(values.len()));
        if answer.is_ok() {
            // SAFETY: the FMU has just filled the pointers (those it left out are NULL); its strings stay until the
            // next call.
            unsafe { scratch.copy_strings(values) };
        }
        self.scratch = scratch;
        answer
    }

    fn set_string(&mut self, references: &[u32], values: &[String]) -> Result<(), Failure> {
        let name = "fmi3SetString";
        let mut scratch = std::mem::take(&mut self.scratch);
        let answer = scratch
            .strings(name, values)
            .and_then(|pointers| self.set(name, self.f().fmi3SetString, references, pointers));
        self.scratch = scratch;
        answer
    }

    fn do_step(&mut self, time: f64, step_size: f64) -> Result<Step, Failure> {
        let name = "fmi3DoStep";
        self.phase.expect(name, &[Phase::Stepping])?;
        let do_step = present(name, self.f().fmi3DoStep)?;
        let (mut event, mut terminate, mut early, mut last) = (0, 0, 0, time);
        // SAFETY: the instance is live and in step mode; the pointers are to locals of the declared types. Nothing
        // rolls a step back, so the state before it is not needed.
        let status =
            unsafe { do_step(self.instance, time, step_size, 1, &mut event, &mut terminate, &mut early, &mut last) };
        match status {
            fmi3::OK | fmi3::WARNING if terminate != 0 => Ok(Step::Terminated(last)),
            fmi3::OK | fmi3::WARNING if early == 0 => Ok(Step::Completed),
            fmi3::OK | fmi3::WARNING => {
                self.phase = Phase::StepFailed;
                let text = "the step returned early, which had not been allowed";
                let failure = Failure::new(name, Status::from(status), text);
                Err(Failure { last_successful_time: Some(last), ..failure })
            }
            // The instance is as it was, whatever else it says, and can step again.
            fmi3::DISCARD => Err(Failure { last_successful_time: Some(time), ..self.fail(name, status) }),
            _ => Err(self.fail(name, status)),
        }
    }

    fn terminate(&mut self) -> Result<(), Failure> {
        self.phase.expect("fmi3Terminate", &[Phase::Stepping, Phase::StepFailed])?;
        self.call("fmi3Terminate", self.f().fmi3Terminate)?;
        self.phase = Phase::Terminated;
        Ok(())
    }

    fn reset(&mut self) -> Result<(), Failure> {
        if self.phase == Phase::Broken {
            return self.phase.expect("fmi3Reset", &[]);
        }
        self.call("fmi3Reset", self.f().fmi3Reset)?;
        self.phase = Phase::Instantiated;
        Ok(())
    }

    fn take_messages(&mut self) -> Vec<LogMessage> {
        self.environment.take_messages()
    }
}

impl Drop for Instance {
    fn drop(&mut self) {
        if let (Some(free), true) = (self.f().fmi3FreeInstance, self.phase != Phase::Broken) {
            // SAFETY: the instance is live and not used again; after Fatal it must not even be freed.
            unsafe { free(self.instance) }
        }
    }
}
