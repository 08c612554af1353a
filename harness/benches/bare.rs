//! What the master is measured against: the same C functions, called with the same arguments in a loop and nothing else.
//!
//! Outside the harness's loader this is the only place that calls C functions, and it is never part of a library.

use std::ffi::{CString, c_void};
use std::ptr;

use libloading::Library;
use swayless::Fmu;
use swayless::importer::platform_folders;
use swayless_abi::fmi3::{Functions, Instance, OK};
use swayless_modeldesc::types::FmiVersion;

/// An instance of an FMI 3.0 FMU, initialized and ready to step.
pub struct Bare {
    instance: Instance,
    functions: Functions,
    _library: Library,
}

impl Bare {
    /// Instantiates an FMU and sets parameters by their value references.
    pub fn new(fmu: &Fmu, parameters: &[(u32, f64)], stop_time: f64) -> Self {
        let identifier = &fmu.description().co_simulation.as_ref().expect("co-simulation").model_identifier;
        let folder = fmu.folder().join("binaries").join(&platform_folders(FmiVersion::V3)[0]);
        let path = folder.join(format!("{identifier}.{}", std::env::consts::DLL_EXTENSION));
        // SAFETY: an FMU of ours or one compiled from this repository.
        let library = unsafe { Library::new(path) }.expect("the library loads");
        // SAFETY: the library is an FMI 3.0 FMU, so its symbols have the standard's types; it is kept beside them.
        let functions = unsafe {
            Functions::find(|name| {
                let symbol = library.get::<*mut c_void>(name).ok();
                symbol.and_then(|symbol| symbol.try_as_raw_ptr()).unwrap_or(ptr::null_mut())
            })
        };
        let token = CString::new(fmu.description().instantiation_token.clone()).expect("no NUL");
        let resources = CString::new("/nowhere/").expect("no NUL");
        // SAFETY: strings that end with a NUL; every other pointer is allowed to be NULL.
        let instance = unsafe {
            functions.fmi3InstantiateCoSimulation.expect("exported")(
                c"bare".as_ptr(),
                token.as_ptr(),
                resources.as_ptr(),
                0,
                0,
                0,
                0,
                ptr::null(),
                0,
                ptr::null_mut(),
                None,
                None,
            )
        };
        assert!(!instance.is_null());
        let mut bare = Self { instance, functions, _library: library };
        for (reference, value) in parameters {
            bare.set(&[*reference], &[*value]);
        }
        // SAFETY: the instance is live and only instantiated, then in initialization mode.
        unsafe {
            let enter = bare.functions.fmi3EnterInitializationMode.expect("exported");
            assert_eq!(enter(instance, 0, 0.0, 0.0, 1, stop_time), OK);
            assert_eq!(bare.functions.fmi3ExitInitializationMode.expect("exported")(instance), OK);
        }
        bare
    }

    /// `fmi3SetFloat64`.
    pub fn set(&mut self, references: &[u32], values: &[f64]) {
        let set = self.functions.fmi3SetFloat64.expect("exported");
        // SAFETY: the instance is live, the pointers are valid for the counts.
        let status =
            unsafe { set(self.instance, references.as_ptr(), references.len(), values.as_ptr(), values.len()) };
        assert_eq!(status, OK);
    }

    /// `fmi3GetFloat64`.
    pub fn get(&mut self, references: &[u32], values: &mut [f64]) {
        let get = self.functions.fmi3GetFloat64.expect("exported");
        // SAFETY: as in `set`.
        let status =
            unsafe { get(self.instance, references.as_ptr(), references.len(), values.as_mut_ptr(), values.len()) };
        assert_eq!(status, OK);
    }

    /// `fmi3DoStep`.
    pub fn step(&mut self, time: f64, step_size: f64) {
        let (mut event, mut terminate, mut early, mut last) = (0, 0, 0, 0.0);
        let step = self.functions.fmi3DoStep.expect("exported");
        // SAFETY: the instance is live and in step mode; the pointers are to locals.
        let status =
            unsafe { step(self.instance, time, step_size, 1, &mut event, &mut terminate, &mut early, &mut last) };
        assert_eq!(status, OK);
    }
}

impl Drop for Bare {
    fn drop(&mut self) {
        // SAFETY: the instance is live and not used again.
        unsafe { self.functions.fmi3FreeInstance.expect("exported")(self.instance) }
    }
}
