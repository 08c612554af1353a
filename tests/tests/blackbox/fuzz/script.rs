//! Arguments of calls out of raw bytes: mostly what an importer would pass, now and then what none should.

use arbitrary::{Result, Unstructured};
use swayless_modeldesc::types::{Causality, DataType, FmiVersion, ModelDescription, Start, Variable};

use super::call::{Access, Call, Experiment, Sensitivity, Timing, Values};
use super::rules::Name;

/// Those whose functions take any number of values; clocks have calls of their own.
const TYPES: [DataType; 14] = [
    DataType::Float64,
    DataType::Float32,
    DataType::Int8,
    DataType::UInt8,
    DataType::Int16,
    DataType::UInt16,
    DataType::Int32,
    DataType::UInt32,
    DataType::Int64,
    DataType::UInt64,
    DataType::Boolean,
    DataType::String,
    DataType::Binary,
    DataType::Enumeration,
];

/// Makes arguments for an FMU.
pub struct Script<'a> {
    pub description: &'a ModelDescription,
    /// The time that the instance should be at.
    pub time: f64,
    /// Serialized states so far, to be damaged and given back.
    pub states: &'a [Vec<u8>],
}

impl Script<'_> {
    /// The arguments of a call. Few bytes make tame ones: where they are used up, all choices are the first.
    pub fn call(&self, name: Name, u: &mut Unstructured<'_>) -> Result<Call> {
        let slot = |u: &mut Unstructured<'_>| u.int_in_range(0..=1_usize);
        let structure = &self.description.structure;
        let states = structure.derivatives.iter().map(|d| self.extent(&self.description.variables[d.variable])).sum();
        let count = |u: &mut Unstructured<'_>, right: usize| {
            Ok(if rarely(u)? { u.int_in_range(0..=right + 2)? } else { right })
        };
        Ok(match name {
            Name::SetDebugLogging => {
                let known = self.description.log_categories.iter().map(|category| category.name.clone());
                let mut categories: Vec<String> = known.collect();
                categories.truncate(u.int_in_range(0..=categories.len())?);
                if rarely(u)? {
                    categories.push("no such category".to_owned());
                }
                Call::SetDebugLogging { on: u.arbitrary()?, categories }
            }
            Name::SetupExperiment => Call::SetupExperiment(self.experiment(u)?),
            Name::EnterInitialization => Call::EnterInitialization(self.experiment(u)?),
            Name::ExitInitialization => Call::ExitInitialization,
            Name::Terminate => Call::Terminate,
            Name::Reset => Call::Reset,
            Name::Get => Call::Get(self.access(u, |_| true)?),
            Name::Set => {
                let can_be_set = |v: &Variable| v.start.is_some() || v.causality == Causality::Input;
                let access = self.access(u, can_be_set)?;
                let values = self.values(u, &access)?;
                Call::Set(access, values)
            }
            Name::GetClock => Call::Get(self.clocks(u)?),
            Name::SetClock => {
                let access = self.clocks(u)?;
                let values = self.values(u, &access)?;
                Call::Set(access, values)
            }
            Name::GetInterval | Name::GetShift => Call::GetTiming(timing(u, name == Name::GetShift)?, self.clocks(u)?),
            Name::SetInterval | Name::SetShift => {
                let (of, clocks) = (timing(u, name == Name::SetShift)?, self.clocks(u)?);
                let times = (0..clocks.count).map(|_| float(u)).collect::<Result<_>>()?;
                Call::SetTiming(of, clocks, times)
            }
            Name::DoStep => {
                let time = if rarely(u)? { float(u)? } else { self.time };
                Call::DoStep { time, size: step(u)? }
            }
            Name::EnterEvent => Call::EnterEvent,
            Name::Update => Call::Update,
            Name::EnterContinuousTime => Call::EnterContinuousTime,
            Name::EnterStep => Call::EnterStep,
            Name::CompletedStep => Call::CompletedStep,
            Name::SetTime => Call::SetTime(if rarely(u)? { float(u)? } else { self.time + step(u)? }),
            Name::SetStates => {
                let n = count(u, states)?;
                Call::SetStates((0..n).map(|_| float(u)).collect::<Result<_>>()?)
            }
            Name::GetStates => Call::GetStates(count(u, states)?),
            Name::GetDerivatives => Call::GetDerivatives(count(u, states)?),
            Name::GetIndicators => Call::GetIndicators(count(u, self.description.number_of_event_indicators)?),
            Name::GetNominals => Call::GetNominals(count(u, states)?),
            Name::GetCounts => Call::GetCounts,
            Name::Directional => Call::Directional(self.sensitivity(u, false)?),
            Name::Adjoint => Call::Adjoint(self.sensitivity(u, true)?),
            Name::OutputDerivatives => {
                let mut access = self.access(u, |v| v.causality == Causality::Output && v.data_type.is_float())?;
                access.null = false;
                Call::OutputDerivatives(access.clone(), self.orders(u, access.references.len())?)
            }
            Name::InputDerivatives => {
                let mut access = self.access(u, |v| v.causality == Causality::Input && v.data_type.is_float())?;
                access.null = false;
                let orders = self.orders(u, access.references.len())?;
                let values = (0..access.references.len()).map(|_| float(u)).collect::<Result<_>>()?;
                Call::InputDerivatives(access, orders, values)
            }
            Name::GetState => Call::GetState(slot(u)?),
            Name::SetState => Call::SetState(slot(u)?),
            Name::FreeState => Call::FreeState(slot(u)?),
            Name::Serialize => Call::Serialize(slot(u)?),
            Name::Deserialize => {
                let mut bytes = if self.states.is_empty() { Vec::new() } else { u.choose(self.states)?.clone() };
                if !bytes.is_empty() && u.arbitrary()? {
                    let place = u.choose_index(bytes.len())?;
                    match u.int_in_range(0..=2)? {
                        0 => bytes.truncate(place),
                        1 => bytes[place] ^= 1 << u.int_in_range(0..=7)?,
                        _ => bytes.push(u.arbitrary()?),
                    }
                }
                Call::Deserialize(slot(u)?, bytes)
            }
            Name::Status => Call::Status(u.int_in_range(0..=4)?, u.int_in_range(-1..=5)?),
            Name::CancelStep => Call::CancelStep,
            Name::EnterConfiguration => Call::EnterConfiguration,
            Name::ExitConfiguration => Call::ExitConfiguration,
            Name::EvaluateDiscrete => Call::EvaluateDiscrete,
            Name::Activate => {
                let time = if rarely(u)? { float(u)? } else { self.time + step(u)? };
                Call::Activate(self.reference(u, |v| v.data_type == DataType::Clock)?, time)
            }
            Name::Dependencies => Call::Dependencies(self.reference(u, |_| true)?),
        })
    }

    /// How many values a variable has.
    pub fn extent(&self, variable: &Variable) -> usize {
        extent(variable)
    }

    fn experiment(&self, u: &mut Unstructured<'_>) -> Result<Experiment> {
        let start = if rarely(u)? { float(u)? } else { 0.0 };
        let stop = if u.arbitrary()? { Some(start + 1e3) } else { None };
        let stop = if rarely(u)? { Some(float(u)?) } else { stop };
        let tolerance = if u.arbitrary()? { Some(1e-4) } else { None };
        Ok(Experiment { tolerance: if rarely(u)? { Some(float(u)?) } else { tolerance }, start, stop })
    }

    /// The reference of a variable that fits, or, rarely, of any, or of none.
    fn reference(&self, u: &mut Unstructured<'_>, fits: impl Fn(&Variable) -> bool) -> Result<u32> {
        if rarely(u)? {
            return if u.arbitrary()? {
                u.arbitrary()
            } else {
                u.int_in_range(0..=self.description.variables.len() as u32 + 3)
            };
        }
        let fitting: Vec<u32> =
            self.description.variables.iter().filter(|v| fits(v)).map(|v| v.value_reference).collect();
        Ok(if fitting.is_empty() { 0 } else { *u.choose(&fitting)? })
    }

    /// Variables of one type.
    fn access(&self, u: &mut Unstructured<'_>, fits: impl Fn(&Variable) -> bool) -> Result<Access> {
        let variables = &self.description.variables;
        let fits = |v: &Variable| v.data_type != DataType::Clock && fits(v);
        let fitting: Vec<&Variable> = variables.iter().filter(|v| fits(v)).collect();
        let mut data_type = if fitting.is_empty() { DataType::Float64 } else { u.choose(&fitting)?.data_type };
        if rarely(u)? {
            data_type = *u.choose(&TYPES)?;
        }
        let number = u.int_in_range(0..=4)?;
        let references: Vec<u32> =
            (0..number).map(|_| self.reference(u, |v| fits(v) && v.data_type == data_type)).collect::<Result<_>>()?;
        let extent_of =
            |reference: &u32| variables.iter().find(|v| v.value_reference == *reference).map_or(1, |v| self.extent(v));
        let mut count = match self.description.fmi_version {
            FmiVersion::V2 => references.len(),
            FmiVersion::V3 => references.iter().map(extent_of).sum(),
        };
        if self.description.fmi_version == FmiVersion::V3 && rarely(u)? {
            count = u.int_in_range(0..=count + 2)?;
        }
        Ok(Access { data_type, references, count, null: rarely(u)? && rarely(u)? })
    }

    fn clocks(&self, u: &mut Unstructured<'_>) -> Result<Access> {
        let number = u.int_in_range(0..=2)?;
        let is_clock = |v: &Variable| v.data_type == DataType::Clock;
        let references: Vec<u32> = (0..number).map(|_| self.reference(u, is_clock)).collect::<Result<_>>()?;
        Ok(Access { data_type: DataType::Clock, count: references.len(), references, null: rarely(u)? })
    }

    fn values(&self, u: &mut Unstructured<'_>, access: &Access) -> Result<Values> {
        let each = 0..access.count;
        let variable = |at: usize| {
            let reference = access.references.get(at.min(access.references.len().saturating_sub(1)));
            self.description.variables.iter().find(|v| Some(&v.value_reference) == reference)
        };
        Ok(match access.data_type {
            DataType::Float64 | DataType::Float32 => {
                Values::Floats(each.map(|at| float_for(u, variable(at))).collect::<Result<_>>()?)
            }
            DataType::Boolean | DataType::Clock => Values::Booleans(
                each.map(|_| if rarely(u)? { u.arbitrary() } else { u.int_in_range(0..=1) }).collect::<Result<_>>()?,
            ),
            DataType::String => Values::Texts(
                each.map(|_| {
                    Ok(match u.int_in_range(0..=15)? {
                        0 => None,
                        1 => Some("x".repeat(5000)),
                        2 => Some("äöü # %s %n".to_owned()),
                        _ => Some(String::new()),
                    })
                })
                .collect::<Result<_>>()?,
            ),
            _ => Values::Integers(
                each.map(|_| if rarely(u)? { u.arbitrary() } else { u.int_in_range(0..=7) }).collect::<Result<_>>()?,
            ),
        })
    }

    fn orders(&self, u: &mut Unstructured<'_>, n: usize) -> Result<Vec<i32>> {
        (0..n).map(|_| if rarely(u)? { u.arbitrary() } else { u.int_in_range(1..=3) }).collect()
    }

    fn sensitivity(&self, u: &mut Unstructured<'_>, adjoint: bool) -> Result<Sensitivity> {
        let structure = &self.description.structure;
        let variables = &self.description.variables;
        let unknown: Vec<u32> = structure
            .outputs
            .iter()
            .chain(&structure.derivatives)
            .map(|unknown| variables[unknown.variable].value_reference)
            .collect();
        let is_known = |v: &Variable| v.data_type.is_float() && v.causality != Causality::Output;
        let is_unknown = |v: &Variable| v.data_type.is_float() && unknown.contains(&v.value_reference);
        let (n_unknowns, n_knowns) = (u.int_in_range(0..=3)?, u.int_in_range(0..=3)?);
        let unknowns: Vec<u32> = (0..n_unknowns).map(|_| self.reference(u, is_unknown)).collect::<Result<_>>()?;
        let knowns: Vec<u32> = (0..n_knowns).map(|_| self.reference(u, is_known)).collect::<Result<_>>()?;
        let width = |references: &[u32]| -> usize {
            let found = references.iter().filter_map(|r| variables.iter().find(|v| v.value_reference == *r));
            found.map(|v| self.extent(v)).sum()
        };
        let (into, from) = if adjoint { (&knowns, &unknowns) } else { (&unknowns, &knowns) };
        let (mut n_seed, mut count) = (width(from), width(into));
        if rarely(u)? {
            (n_seed, count) = (u.int_in_range(0..=n_seed + 1)?, u.int_in_range(0..=count + 1)?);
        }
        let seed = (0..n_seed).map(|_| float(u)).collect::<Result<_>>()?;
        Ok(Sensitivity { unknowns, knowns, seed, count })
    }
}

/// How many values a variable has.
pub fn extent(variable: &Variable) -> usize {
    variable.start.as_ref().map_or_else(
        || {
            let fixed = variable.dimensions.iter().map(|dimension| match dimension {
                swayless_modeldesc::types::Dimension::Fixed(n) => usize::try_from(*n).expect("a size"),
                swayless_modeldesc::types::Dimension::Variable(_) => 1,
            });
            fixed.product()
        },
        |start| match start {
            Start::Float(values) => values.len(),
            Start::Integer(values) => values.len(),
            Start::Boolean(values) => values.len(),
            Start::String(values) => values.len(),
            Start::Binary(values) => values.len(),
        },
    )
}

/// Of clocks that have no fractions, these are asked for one time in four.
fn timing(u: &mut Unstructured<'_>, shift: bool) -> Result<Timing> {
    Ok(Timing { shift, fraction: u.int_in_range(0..=3_u8)? == 3 })
}

/// One time in twelve.
fn rarely(u: &mut Unstructured<'_>) -> Result<bool> {
    // The first choice of the exhausted is false.
    Ok(u.int_in_range(0..=11_u8)? == 11)
}

/// Any float, the odd ones more often than by chance.
fn float(u: &mut Unstructured<'_>) -> Result<f64> {
    const ODD: [f64; 14] = [
        0.0,
        -0.0,
        f64::NAN,
        f64::INFINITY,
        f64::NEG_INFINITY,
        f64::MAX,
        f64::MIN,
        f64::MIN_POSITIVE,
        5e-324,
        -5e-324,
        f64::EPSILON,
        1e15,
        -1e15,
        1e150,
    ];
    Ok(match u.int_in_range(0..=9_u8)? {
        8 => *u.choose(&ODD)?,
        9 => f64::from_bits(u.arbitrary()?),
        _ => f64::from(u.int_in_range(-2000..=2000_i32)?) / 1000.0,
    })
}

/// A value for a variable: about its start, at its bounds and just beyond, or any.
fn float_for(u: &mut Unstructured<'_>, variable: Option<&Variable>) -> Result<f64> {
    let start = match variable.and_then(|v| v.start.as_ref()) {
        Some(Start::Float(values)) => values[0],
        _ => 0.0,
    };
    let bound = |of: fn(&Variable) -> Option<f64>| variable.and_then(of).unwrap_or(start);
    let (min, max) = (bound(|v| v.attributes.min), bound(|v| v.attributes.max));
    Ok(match u.int_in_range(0..=15_u8)? {
        10 => min,
        11 => max,
        12 => min.next_down(),
        13 => max.next_up(),
        14 => -start,
        15 => float(u)?,
        _ => {
            start * (1.0 + f64::from(u.int_in_range(-50..=50_i8)?) / 100.0)
                + f64::from(u.int_in_range(-5..=5_i8)?) / 10.0
        }
    })
}

/// A step, most often of the size that importers take.
fn step(u: &mut Unstructured<'_>) -> Result<f64> {
    Ok(match u.int_in_range(0..=11_u8)? {
        7 => 1e-9,
        8 => 1.0,
        9 => 30.0,
        10 => f64::from(u.int_in_range(1..=1000_u16)?) / 500.0,
        11 => float(u)?,
        _ => 0.01,
    })
}
