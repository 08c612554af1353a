//! Slaves in Rust, described by the XML of FMI 3.0. They hold the master to the standard: getting a value after setting
//! one without a step in between panics, as does any call out of order.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::{Arc, Mutex};

use swayless::slave::{Experiment, Failure, Model, Slave, Step};
use swayless_modeldesc::read::read;
use swayless_modeldesc::types::{DataType, ModelDescription};

/// Values by reference; Booleans and integers are numbers too.
pub type Values = BTreeMap<u32, Vec<f64>>;

/// Computes outputs from inputs and states; called before values are got.
pub type Update = fn(&mut Values);
/// Advances the states from a time by a step.
pub type Advance = fn(&mut Values, f64, f64) -> Result<Step, Failure>;

/// What was called, as `instance call`.
pub type Log = Arc<Mutex<Vec<String>>>;

pub struct Mock {
    description: ModelDescription,
    update: Update,
    advance: Advance,
    pub log: Log,
}

/// A model from the variables and the model structure of an FMI 3.0 description.
pub fn mock(name: &str, variables: &str, structure: &str, update: Update, advance: Advance) -> Arc<Mock> {
    let xml = format!(
        r#"<?xml version="1.0" encoding="UTF-8"?>
<fmiModelDescription fmiVersion="3.0" modelName="{name}" instantiationToken="x">
  <CoSimulation modelIdentifier="{name}" canHandleVariableCommunicationStepSize="true"/>
  <UnitDefinitions>
    <Unit name="m"><BaseUnit m="1"/></Unit>
    <Unit name="kg"><BaseUnit kg="1"/></Unit>
    <Unit name="rad"><BaseUnit rad="1"/></Unit>
    <Unit name="deg"><BaseUnit rad="1" factor="0.017453292519943295"/></Unit>
    <Unit name="K"><BaseUnit K="1"/></Unit>
    <Unit name="degC"><BaseUnit K="1" offset="273.15"/></Unit>
    <Unit name="degF"><BaseUnit K="1" factor="0.5555555555555556" offset="255.3722222222222"/></Unit>
    <Unit name="odd"/>
  </UnitDefinitions>
  <TypeDefinitions>
    <EnumerationType name="Kind"><Item name="None" value="1"/><Item name="ZV" value="2"/></EnumerationType>
  </TypeDefinitions>
  <ModelVariables>
    <Float64 name="time" valueReference="999" causality="independent" variability="continuous"/>
    {variables}
  </ModelVariables>
  <ModelStructure>{structure}</ModelStructure>
</fmiModelDescription>"#
    );
    let (description, _) = read(&xml).unwrap();
    Arc::new(Mock { description, update, advance, log: Log::default() })
}

/// Steps that always succeed and do nothing by themselves.
pub fn rest(_: &mut Values, _: f64, _: f64) -> Result<Step, Failure> {
    Ok(Step::Completed)
}

impl Model for Mock {
    fn path(&self) -> &Path {
        Path::new("mock.fmu")
    }

    fn description(&self) -> &ModelDescription {
        &self.description
    }

    fn instantiate(&self, name: &str, _logging: bool) -> swayless::Result<Box<dyn Slave>> {
        use swayless_modeldesc::types::{Dimension, Start};
        let length = |dimension: &Dimension| match *dimension {
            Dimension::Fixed(size) => size,
            Dimension::Variable(reference) => {
                let sized = self.description.variables.iter().find(|v| v.value_reference == reference).unwrap();
                let Some(Start::Integer(values)) = &sized.start else { panic!("{} has no size", sized.name) };
                values[0] as u64
            }
        };
        let start = |variable: &swayless_modeldesc::types::Variable| {
            let size: u64 = variable.dimensions.iter().map(length).product();
            let mut values = match &variable.start {
                Some(Start::Float(values)) => values.clone(),
                Some(Start::Integer(values)) => values.iter().map(|&v| v as f64).collect(),
                Some(Start::Boolean(values)) => values.iter().map(|&v| f64::from(u8::from(v))).collect(),
                _ => vec![0.0],
            };
            let last = values[values.len() - 1];
            values.resize(size as usize, last);
            (variable.value_reference, values)
        };
        Ok(Box::new(Instance {
            name: name.to_owned(),
            values: self.description.variables.iter().map(start).collect(),
            update: self.update,
            advance: self.advance,
            phase: "instantiated",
            set_since_step: false,
            log: self.log.clone(),
        }))
    }
}

struct Instance {
    name: String,
    values: Values,
    update: Update,
    advance: Advance,
    phase: &'static str,
    set_since_step: bool,
    log: Log,
}

impl Instance {
    fn note(&self, call: &str) {
        self.log.lock().unwrap().push(format!("{} {call}", self.name));
    }

    fn get(&mut self, references: &[u32]) -> Vec<f64> {
        assert!(!self.set_since_step || self.phase != "stepping", "{}: get after set without a step", self.name);
        (self.update)(&mut self.values);
        self.note("get");
        references.iter().flat_map(|reference| self.values[reference].clone()).collect()
    }

    fn set(&mut self, references: &[u32], mut values: &[f64]) -> Result<(), Failure> {
        self.set_since_step = true;
        self.note("set");
        for reference in references {
            let place = self.values.get_mut(reference).unwrap();
            let (now, rest) = values.split_at(place.len());
            place.copy_from_slice(now);
            values = rest;
        }
        assert!(values.is_empty());
        Ok(())
    }
}

impl Slave for Instance {
    fn enter_initialization_mode(&mut self, _: &Experiment) -> Result<(), Failure> {
        assert_eq!(std::mem::replace(&mut self.phase, "initializing"), "instantiated");
        Ok(())
    }

    fn exit_initialization_mode(&mut self) -> Result<(), Failure> {
        assert_eq!(std::mem::replace(&mut self.phase, "stepping"), "initializing");
        self.set_since_step = false;
        Ok(())
    }

    fn get_float(&mut self, _: DataType, references: &[u32], values: &mut [f64]) -> Result<(), Failure> {
        values.copy_from_slice(&self.get(references));
        Ok(())
    }

    fn set_float(&mut self, _: DataType, references: &[u32], values: &[f64]) -> Result<(), Failure> {
        self.set(references, values)
    }

    fn get_integer(&mut self, _: DataType, references: &[u32], values: &mut [i64]) -> Result<(), Failure> {
        values.iter_mut().zip(self.get(references)).for_each(|(to, from)| *to = from as i64);
        Ok(())
    }

    fn set_integer(&mut self, _: DataType, references: &[u32], values: &[i64]) -> Result<(), Failure> {
        self.set(references, &values.iter().map(|&value| value as f64).collect::<Vec<_>>())
    }

    fn get_boolean(&mut self, references: &[u32], values: &mut [bool]) -> Result<(), Failure> {
        values.iter_mut().zip(self.get(references)).for_each(|(to, from)| *to = from != 0.0);
        Ok(())
    }

    fn set_boolean(&mut self, references: &[u32], values: &[bool]) -> Result<(), Failure> {
        self.set(references, &values.iter().map(|&value| f64::from(u8::from(value))).collect::<Vec<_>>())
    }

    fn get_string(&mut self, _: &[u32], _: &mut [String]) -> Result<(), Failure> {
        Ok(())
    }

    fn set_string(&mut self, _: &[u32], _: &[String]) -> Result<(), Failure> {
        Ok(())
    }

    fn do_step(&mut self, time: f64, step_size: f64) -> Result<Step, Failure> {
        assert_eq!(self.phase, "stepping");
        self.note("step");
        self.set_since_step = false;
        (self.advance)(&mut self.values, time, step_size)
    }

    fn terminate(&mut self) -> Result<(), Failure> {
        assert_eq!(std::mem::replace(&mut self.phase, "terminated"), "stepping");
        self.note("terminate");
        Ok(())
    }

    fn reset(&mut self) -> Result<(), Failure> {
        Ok(())
    }
}

impl Drop for Instance {
    fn drop(&mut self) {
        self.note("free");
    }
}
