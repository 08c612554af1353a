//! A system: instances of FMUs, connections between them, and start values.

mod names;
mod ssp;
mod start;
pub(crate) mod units;
mod wiring;

use std::collections::{BTreeMap, HashMap};
use std::fmt;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use swayless_modeldesc::types::{BaseUnit, DefaultExperiment};

use crate::archive::Unpacked;
use crate::error::{Error, Result};
use crate::importer::Fmu;
use crate::signals::InputSignals;
use crate::slave::Model;

pub(crate) use names::{Kind, Names, Port};
pub(crate) use start::{Start, Values, declared};
pub(crate) use wiring::{Link, Wiring};

/// Instances, connections and start values. It is only a plan: nothing runs before [`simulate`](crate::simulate), which
/// makes its own instances, so one system can be run many times, and a clone of it with other start values.
#[derive(Clone, Default)]
pub struct System {
    /// Its name, for messages and reports.
    pub name: String,
    /// When to start and stop unless the options say otherwise.
    pub default_experiment: DefaultExperiment,
    pub(crate) instances: Vec<Instance>,
    pub(crate) connections: Vec<Connection>,
    pub(crate) start_values: Vec<StartValue>,
    pub(crate) signals: Option<Arc<InputSignals>>,
    pub(crate) break_loops: bool,
    /// The system's own connectors and the variables behind them: the inputs that one feeds, or the output that it shows.
    pub(crate) connectors: BTreeMap<String, Vec<String>>,
    files: HashMap<PathBuf, Arc<Fmu>>,
    /// The archive it came in; parameters may name files there.
    archive: Option<Arc<Unpacked>>,
}

/// An instance of a model.
#[derive(Clone)]
pub struct Instance {
    /// Its name, unique in the system.
    pub name: String,
    /// What it is an instance of.
    pub model: Arc<dyn Model>,
}

/// A connection from an output to an input.
#[derive(Debug, Clone, PartialEq)]
pub struct Connection {
    /// The output, `instance.variable`.
    pub from: String,
    /// The input, `instance.variable`.
    pub to: String,
    /// The linear transformation `to = factor · from + offset`, after any conversion of units.
    pub factor: f64,
    /// See `factor`.
    pub offset: f64,
    /// Whether units are checked and converted.
    pub convert_units: bool,
    /// Where it was declared, for messages.
    pub place: String,
}

/// A start value of a variable.
#[derive(Debug, Clone, PartialEq)]
pub struct StartValue {
    /// The variable, `instance.variable`, or `variable` when the system is a single FMU.
    pub variable: String,
    /// The value as written: a number, `true`, an item of an enumeration, numbers with blanks between for an array.
    pub value: String,
    /// The unit it is given in, if it is not the variable's.
    pub unit: Option<String>,
    /// What that unit means, if not what the FMU says.
    pub unit_definition: Option<BaseUnit>,
    /// The file and line where it was given, if in one, for messages.
    pub place: Option<String>,
}

impl System {
    /// An empty system.
    pub fn new(name: impl Into<String>) -> Self {
        Self { name: name.into(), ..Self::default() }
    }

    /// Opens an `.ssp`, an `.ssd`, an `.fmu` or the folder of an unpacked FMU.
    pub fn open(path: impl AsRef<Path>) -> Result<Self> {
        Self::open_from(path.as_ref(), None)
    }

    /// Like [`open`](Self::open), but takes each FMU of a system description from this folder, by its file name, rather
    /// than from where the description says: so one description serves both FMI versions.
    pub fn open_with_fmus(path: impl AsRef<Path>, folder: &Path) -> Result<Self> {
        Self::open_from(path.as_ref(), Some(folder))
    }

    fn open_from(path: &Path, fmus: Option<&Path>) -> Result<Self> {
        let extension = path.extension().map(|extension| extension.to_ascii_lowercase()).unwrap_or_default();
        match extension.to_str() {
            Some("ssd") => ssp::open(path, false, fmus),
            Some("ssp") => ssp::open(path, true, fmus),
            _ => {
                let fmu = Arc::new(Fmu::open(path)?);
                let name = fmu.description().model_name.clone();
                let mut system = Self::new(name.clone());
                system.add_model(name, fmu);
                Ok(system)
            }
        }
    }

    /// Adds an instance of the FMU in a file; a file that is named twice is opened once.
    pub fn add_fmu(&mut self, instance: impl Into<String>, path: impl AsRef<Path>) -> Result<()> {
        let path = path.as_ref();
        let key = path.canonicalize().map_err(|source| Error::io("read", path, source))?;
        let fmu = match self.files.get(&key) {
            Some(fmu) => fmu.clone(),
            None => {
                let fmu = Arc::new(Fmu::open(path)?);
                self.files.insert(key, fmu.clone());
                fmu
            }
        };
        self.add_model(instance, fmu);
        Ok(())
    }

    /// Adds an instance of a model.
    pub fn add_model(&mut self, instance: impl Into<String>, model: Arc<dyn Model>) {
        self.instances.push(Instance { name: instance.into(), model });
    }

    /// Connects an output to an input, both as `instance.variable`. Whether they exist and fit is checked by
    /// [`check`](Self::check), and before a run.
    pub fn connect(&mut self, from: impl Into<String>, to: impl Into<String>) {
        let (from, to) = (from.into(), to.into());
        let place = format!("connection {from} → {to}");
        self.add_connection(Connection { from, to, factor: 1.0, offset: 0.0, convert_units: true, place });
    }

    /// Adds a connection with all it can have.
    pub fn add_connection(&mut self, connection: Connection) {
        self.connections.push(connection);
    }

    /// Sets a start value; a later one for the same variable replaces an earlier one.
    pub fn set_start_value(&mut self, variable: impl Into<String>, value: impl Into<String>) {
        let (variable, value) = (variable.into(), value.into());
        self.add_start_value(StartValue { variable, value, unit: None, unit_definition: None, place: None });
    }

    /// Sets a start value with all it can have.
    pub fn add_start_value(&mut self, start: StartValue) {
        self.start_values.retain(|other| other.variable != start.variable);
        self.start_values.push(start);
    }

    /// Sets the start values of a parameter set (`.ssv`). Its parameters are named as start values are: in a system
    /// `instance.variable`.
    pub fn add_parameter_set(&mut self, path: impl AsRef<Path>) -> Result<()> {
        ssp::of_file(path.as_ref())?.into_iter().for_each(|start| self.add_start_value(start));
        Ok(())
    }

    /// Sets the signals that drive the inputs named by their columns.
    pub fn set_input_signals(&mut self, signals: InputSignals) {
        self.signals = Some(Arc::new(signals));
    }

    /// Whether algebraic loops are broken rather than refused: the last connection of each loop then passes its values a
    /// step late. It is a way to run FMUs that do not declare what their outputs depend on, and that are taken to feed
    /// everything through.
    pub fn set_break_loops(&mut self, yes: bool) {
        self.break_loops = yes;
    }

    /// The connections that pass their values a step late since loops are broken, each as "output → input".
    pub fn late_connections(&self) -> Result<Vec<String>> {
        let wiring = Wiring::of(self)?;
        let name = |port| wiring.names.name(port);
        Ok(wiring.flow.late.iter().map(|&(from, to)| format!("{} → {}", name(from), name(to))).collect())
    }

    /// The instances, in the order in which they were added.
    pub fn instances(&self) -> &[Instance] {
        &self.instances
    }

    /// The connections, in the order in which they were added.
    pub fn connections(&self) -> &[Connection] {
        &self.connections
    }

    /// The start values that were set.
    pub fn start_values(&self) -> &[StartValue] {
        &self.start_values
    }

    /// The names of the instances in the order of the flow, which is the order in which Gauss–Seidel steps them.
    pub fn order(&self) -> Result<Vec<&str>> {
        let order = Wiring::of(self)?.flow.instances;
        Ok(order.into_iter().map(|index| self.instances[index].name.as_str()).collect())
    }

    /// Checks names, directions, types, units, start values and algebraic loops; returns all problems at once.
    pub fn check(&self) -> Result<()> {
        Wiring::of(self).map(drop)
    }
}

impl fmt::Debug for System {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("System")
            .field("name", &self.name)
            .field("instances", &self.instances.iter().map(|instance| &instance.name).collect::<Vec<_>>())
            .field("connections", &self.connections)
            .field("start_values", &self.start_values)
            .finish_non_exhaustive()
    }
}
