//! The library of a packaged FMU and the instances that are made of it, called as C calls them.

use std::ffi::{CString, c_void};
use std::path::Path;
use std::ptr::NonNull;

use swayless::Fmu;
use swayless_abi::{fmi2, fmi3};
use swayless_modeldesc::types::{Causality, DataType, FmiVersion, ModelDescription, Variable};

use super::call::{Answer, Call};
use super::{host2, host3};

/// How an instance is made.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    ModelExchange,
    CoSimulation,
    /// FMI 3.0 co-simulation with `eventModeUsed`; with or without `earlyReturnAllowed`.
    EventMode {
        early_return: bool,
    },
    /// FMI 3.0.
    ScheduledExecution,
}

/// An instance under test. It is freed when dropped, in whatever phase it is.
pub trait Host {
    /// Makes the call; `None` if the version has no such function.
    fn play(&mut self, call: &Call) -> Option<Answer>;
    /// Messages with their status since the last call of this; none where the version's logger takes a variable number
    /// of arguments.
    fn messages(&mut self) -> Vec<(i32, String)>;

    /// The state as bytes, by a slot of its own; `None` if the instance refuses.
    fn serialized(&mut self) -> Option<Vec<u8>> {
        let slot = SLOTS - 1;
        self.play(&Call::GetState(slot)).filter(|answer| answer.status == 0)?;
        self.play(&Call::Serialize(slot)).filter(|answer| answer.status == 0).map(|answer| answer.bytes)
    }
}

/// How many saved states an instance's host keeps; the last is for [`Host::serialized`].
pub const SLOTS: usize = 3;

/// The functions of a version.
enum Functions {
    V2(Box<fmi2::Functions>),
    V3(Box<fmi3::Functions>),
}

/// An FMU with its library loaded.
pub struct Subject {
    pub name: String,
    pub description: ModelDescription,
    fmu: Fmu,
    functions: Functions,
    /// Kept so that the functions stay.
    _library: libloading::Library,
}

impl Subject {
    /// Opens an archive and loads its library.
    pub fn load(path: &Path) -> Self {
        let fmu = Fmu::open(path).unwrap_or_else(|error| panic!("{error}"));
        let suffix = format!(".{}", std::env::consts::DLL_EXTENSION);
        let binaries = fmu.binaries();
        let file = binaries.iter().find(|file| file.ends_with(&suffix)).expect("a library for this platform");
        let description = fmu.description().clone();
        // SAFETY: it is our own library, whose initializers do nothing.
        let library = unsafe { libloading::Library::new(fmu.folder().join("binaries").join(file)) }.expect("a library");
        let find = |name: &str| {
            // SAFETY: only its address is taken here.
            let symbol = unsafe { library.get::<unsafe extern "C" fn()>(name) };
            symbol.map_or(std::ptr::null_mut(), |symbol| *symbol as *mut c_void)
        };
        // SAFETY: the addresses are those of the standard's functions, and the library is kept.
        let functions = unsafe {
            match description.fmi_version {
                FmiVersion::V2 => Functions::V2(Box::new(fmi2::Functions::find(find))),
                FmiVersion::V3 => Functions::V3(Box::new(fmi3::Functions::find(find))),
            }
        };
        let version = description.fmi_version;
        let name = format!("{} for FMI {version}", description.model_name);
        Self { name, description, fmu, functions, _library: library }
    }

    /// The FMU as the harness sees it.
    pub fn fmu(&self) -> &Fmu {
        &self.fmu
    }

    /// The functions, if they are those of FMI 3.0.
    pub fn functions3(&self) -> Option<&fmi3::Functions> {
        match &self.functions {
            Functions::V2(_) => None,
            Functions::V3(functions) => Some(functions),
        }
    }

    /// A clock that the importer ticks.
    pub fn input_clock(&self) -> u32 {
        let is_clock = |v: &&Variable| v.data_type == DataType::Clock && v.causality == Causality::Input;
        self.description.variables.iter().find(is_clock).expect("a clock").value_reference
    }

    /// The ways in which instances can be made.
    pub fn kinds(&self) -> Vec<Kind> {
        let mut kinds = Vec::new();
        if self.description.model_exchange.is_some() {
            kinds.push(Kind::ModelExchange);
        }
        if let Some(interface) = &self.description.co_simulation {
            // The importer ticks clocks in Event Mode.
            if self.description.variables.iter().all(|v| v.data_type != DataType::Clock) {
                kinds.push(Kind::CoSimulation);
            }
            if interface.has_event_mode {
                kinds.extend([false, true].map(|early_return| Kind::EventMode { early_return }));
            }
        }
        if self.description.scheduled_execution.is_some() {
            kinds.push(Kind::ScheduledExecution);
        }
        kinds
    }

    /// A new instance, with or without a logger, resources and debug messages.
    pub fn instantiate(&self, kind: Kind, bare: bool) -> Box<dyn Host> {
        let token = CString::new(self.description.instantiation_token.clone()).expect("no NUL");
        let resources = self.fmu.folder().join("resources").join("");
        let resources = resources.to_str().expect("UTF-8");
        match &self.functions {
            Functions::V2(functions) => {
                let location = CString::new(format!("file://{resources}")).expect("no NUL");
                Box::new(host2::Instance::new(**functions, kind, &token, (!bare).then_some(&location)))
            }
            Functions::V3(functions) => {
                let path = CString::new(resources).expect("no NUL");
                Box::new(host3::Instance::new(**functions, kind, &token, (!bare).then_some(&path)))
            }
        }
    }
}

/// A value for `&mut` places of the standard, unlike any that a call leaves.
pub const UNTOUCHED: f64 = -1.234_567_89e-5;

/// The address of an array's values as C gets it: what it points to when there are none must not matter.
pub fn array<T>(values: &[T], null: bool) -> *const T {
    match (null, values.is_empty()) {
        (true, _) => std::ptr::null(),
        (false, true) => NonNull::dangling().as_ptr(),
        (false, false) => values.as_ptr(),
    }
}

/// As [`array`], for writing.
pub fn array_mut<T>(values: &mut [T], null: bool) -> *mut T {
    match (null, values.is_empty()) {
        (true, _) => std::ptr::null_mut(),
        (false, true) => NonNull::dangling().as_ptr(),
        (false, false) => values.as_mut_ptr(),
    }
}

/// A text as a number, to compare.
pub fn hash(text: &[u8]) -> u64 {
    use std::hash::{DefaultHasher, Hasher};
    let mut hasher = DefaultHasher::new();
    hasher.write(text);
    hasher.finish()
}
