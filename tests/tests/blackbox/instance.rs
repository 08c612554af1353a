//! An instance of a packaged FMU by co-simulation, with variables by name.

use swayless::slave::{Experiment, Failure, Model, Slave};
use swayless_modeldesc::types::{DataType, FmiVersion, ModelDescription, Variable};

use crate::packaged;

/// A value to set.
#[derive(Debug, Clone, Copy)]
pub enum Set<'a> {
    /// A float.
    Real(f64),
    /// An integer.
    Integer(i32),
    /// A truth value.
    Switch(bool),
    /// A string, or an item of an enumeration.
    Text(&'a str),
}

impl From<f64> for Set<'_> {
    fn from(value: f64) -> Self {
        Self::Real(value)
    }
}

impl From<i32> for Set<'_> {
    fn from(value: i32) -> Self {
        Self::Integer(value)
    }
}

impl From<bool> for Set<'_> {
    fn from(value: bool) -> Self {
        Self::Switch(value)
    }
}

impl<'a> From<&'a str> for Set<'a> {
    fn from(value: &'a str) -> Self {
        Self::Text(value)
    }
}

/// An instance and the time it is at.
pub struct Instance {
    description: ModelDescription,
    pub slave: Box<dyn Slave>,
    step: u32,
    step_size: f64,
}

impl Instance {
    /// A fresh instance that is stepped by `step_size` (s).
    pub fn new(name: &str, version: FmiVersion, step_size: f64) -> Self {
        let fmu = packaged::open(name, version);
        let slave = fmu.instantiate("instance", false).unwrap_or_else(|error| panic!("{error}"));
        Self { description: fmu.description().clone(), slave, step: 0, step_size }
    }

    /// An instance that is initialized with these values and a tolerance of 1e-10.
    pub fn started(name: &str, step_size: f64, values: &[(&str, Set<'_>)]) -> Self {
        let mut instance = Self::new(name, FmiVersion::V3, step_size);
        values.iter().for_each(|(name, value)| instance.set(name, *value).expect("a value in range"));
        instance.initialize(Some(1e-10)).expect("initialization");
        instance
    }

    /// From instantiated to step mode.
    pub fn initialize(&mut self, tolerance: Option<f64>) -> Result<(), Failure> {
        self.slave.enter_initialization_mode(&Experiment { start_time: 0.0, stop_time: 1e6, tolerance })?;
        self.slave.exit_initialization_mode()
    }

    fn variable(&self, name: &str) -> &Variable {
        self.description.variables.iter().find(|v| v.name == name).unwrap_or_else(|| panic!("no variable {name}"))
    }

    /// The value reference of a variable.
    pub fn reference(&self, name: &str) -> u32 {
        self.variable(name).value_reference
    }

    /// Sets a scalar.
    pub fn set<'a>(&mut self, name: &str, value: impl Into<Set<'a>>) -> Result<(), Failure> {
        let variable = self.variable(name);
        let (reference, data_type) = ([variable.value_reference], variable.data_type);
        match (value.into(), data_type) {
            (Set::Real(value), _) => self.slave.set_float(data_type, &reference, &[value]),
            (Set::Integer(value), _) => self.slave.set_integer(data_type, &reference, &[value.into()]),
            (Set::Switch(value), _) => self.slave.set_boolean(&reference, &[value]),
            (Set::Text(item), DataType::Enumeration) => {
                let types = &self.description.type_definitions;
                let definition = types.iter().find(|t| Some(&t.name) == variable.declared_type.as_ref());
                let item = definition.and_then(|t| t.items.iter().find(|i| i.name == item)).expect("an item");
                self.slave.set_integer(data_type, &reference, &[item.value])
            }
            (Set::Text(text), _) => self.slave.set_string(&reference, &[text.to_owned()]),
        }
    }

    /// Reads a scalar float.
    pub fn get(&mut self, name: &str) -> f64 {
        let variable = self.variable(name);
        let (reference, data_type) = ([variable.value_reference], variable.data_type);
        let mut value = [f64::NAN];
        self.slave.get_float(data_type, &reference, &mut value).expect("a value");
        value[0]
    }

    /// Reads a truth value.
    pub fn get_switch(&mut self, name: &str) -> bool {
        let reference = [self.reference(name)];
        let mut value = [false];
        self.slave.get_boolean(&reference, &mut value).expect("a value");
        value[0]
    }

    /// Reads the floats of an array, which has this many.
    pub fn get_all(&mut self, name: &str, count: usize) -> Vec<f64> {
        let variable = self.variable(name);
        let (reference, data_type) = ([variable.value_reference], variable.data_type);
        let mut values = vec![f64::NAN; count];
        self.slave.get_float(data_type, &reference, &mut values).expect("values");
        values
    }

    /// Sets the floats of an array.
    pub fn set_all(&mut self, name: &str, values: &[f64]) {
        let variable = self.variable(name);
        let (reference, data_type) = ([variable.value_reference], variable.data_type);
        self.slave.set_float(data_type, &reference, values).expect("values in range");
    }

    /// Reads three scalar floats.
    pub fn get3(&mut self, names: [&str; 3]) -> [f64; 3] {
        names.map(|name| self.get(name))
    }

    /// Where it is (s).
    pub fn time(&self) -> f64 {
        f64::from(self.step) * self.step_size
    }

    /// Takes one communication step.
    pub fn try_step(&mut self) -> Result<(), Failure> {
        let next = f64::from(self.step + 1) * self.step_size;
        self.slave.do_step(self.time(), next - self.time())?;
        self.step += 1;
        Ok(())
    }

    /// Takes one communication step that must succeed.
    pub fn step(&mut self) {
        self.try_step().expect("a step");
    }

    /// Steps to the communication point that is next to `time` (s).
    pub fn run_to(&mut self, time: f64) {
        while self.time() + 0.5 * self.step_size < time {
            self.step();
        }
    }
}

/// Numbers in −1 … 1, the same in every run.
pub fn noise() -> impl FnMut() -> f64 {
    let mut state = 1_u64;
    move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}
