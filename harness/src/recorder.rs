//! Results on their way out: as a CSV file while the run goes on, or as columns in memory.

use std::fs::File;
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};

use swayless_modeldesc::types::DataType;

use crate::error::{Error, Result};

/// A recorded variable, or one element of a recorded array.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    /// `instance.variable`, with `[i]` for an element of an array.
    pub name: String,
    /// The variable's unit.
    pub unit: Option<String>,
    /// The variable's description.
    pub description: Option<String>,
    /// The variable's type.
    pub data_type: DataType,
}

/// A value of any type.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// Of a float of either width.
    Float(f64),
    /// Of an integer of any width (a `UInt64` as its bits) or an enumeration.
    Integer(i64),
    /// Of a Boolean.
    Boolean(bool),
    /// Of a string.
    String(String),
}

impl Value {
    /// The value as a number, Booleans as 0 and 1; strings have none.
    pub fn as_f64(&self) -> Option<f64> {
        match *self {
            Self::Float(value) => Some(value),
            Self::Integer(value) => Some(value as f64),
            Self::Boolean(value) => Some(f64::from(u8::from(value))),
            Self::String(_) => None,
        }
    }
}

/// Follows a run.
pub trait Observer {
    /// Whether samples are wanted at all; if not, nothing is got from the FMUs for the observer's sake.
    fn records(&self) -> bool {
        true
    }

    /// The run begins; each sample will have one value for each column.
    fn begin(&mut self, columns: &[Column]) -> Result<()> {
        let _ = columns;
        Ok(())
    }

    /// The values at a time (s).
    fn sample(&mut self, time: f64, values: &[Value]) -> Result<()> {
        let _ = (time, values);
        Ok(())
    }

    /// This fraction of the run, from 0 to 1, is done.
    fn progress(&mut self, fraction: f64) {
        let _ = fraction;
    }

    /// Whether the run shall stop where it is, which is asked after every step.
    fn stops(&self) -> bool {
        false
    }

    /// The run has ended well.
    fn end(&mut self) -> Result<()> {
        Ok(())
    }
}

/// Follows nothing.
impl Observer for () {
    fn records(&self) -> bool {
        false
    }
}

/// Several observers at once.
impl Observer for Vec<&mut dyn Observer> {
    fn records(&self) -> bool {
        self.iter().any(|observer| observer.records())
    }

    fn begin(&mut self, columns: &[Column]) -> Result<()> {
        self.iter_mut().filter(|observer| observer.records()).try_for_each(|observer| observer.begin(columns))
    }

    fn sample(&mut self, time: f64, values: &[Value]) -> Result<()> {
        self.iter_mut().filter(|observer| observer.records()).try_for_each(|observer| observer.sample(time, values))
    }

    fn progress(&mut self, fraction: f64) {
        self.iter_mut().for_each(|observer| observer.progress(fraction));
    }

    fn stops(&self) -> bool {
        self.iter().any(|observer| observer.stops())
    }

    fn end(&mut self) -> Result<()> {
        self.iter_mut().try_for_each(|observer| observer.end())
    }
}

/// Results in memory. Strings are left out.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Recording {
    /// The columns' names, `instance.variable`.
    pub names: Vec<String>,
    /// Their units.
    pub units: Vec<Option<String>>,
    /// The times (s).
    pub times: Vec<f64>,
    /// For each column its values, one for each time; Booleans are 0 and 1.
    pub columns: Vec<Vec<f64>>,
    /// For each column its place among the values of a sample.
    places: Vec<usize>,
}

impl Recording {
    /// An empty recording.
    pub fn new() -> Self {
        Self::default()
    }

    /// The values of a column by its name.
    pub fn column(&self, name: &str) -> Option<&[f64]> {
        let index = self.names.iter().position(|candidate| candidate == name)?;
        self.columns.get(index).map(Vec::as_slice)
    }
}

impl Observer for Recording {
    fn begin(&mut self, columns: &[Column]) -> Result<()> {
        *self = Self::default();
        for (place, column) in columns.iter().enumerate().filter(|(_, column)| column.data_type != DataType::String) {
            self.names.push(column.name.clone());
            self.units.push(column.unit.clone());
            self.columns.push(Vec::new());
            self.places.push(place);
        }
        Ok(())
    }

    fn sample(&mut self, time: f64, values: &[Value]) -> Result<()> {
        self.times.push(time);
        for (column, &place) in self.columns.iter_mut().zip(&self.places) {
            column.push(values.get(place).and_then(Value::as_f64).unwrap_or(f64::NAN));
        }
        Ok(())
    }
}

/// Streams results to a CSV file: `time` first, then one column for each variable, numbers as short as they can be
/// written without loss, Booleans as 0 and 1.
pub struct CsvWriter<W: Write> {
    path: PathBuf,
    writer: csv::Writer<W>,
    field: Vec<u8>,
}

impl CsvWriter<BufWriter<File>> {
    /// Creates the file, over one that may be there.
    pub fn create(path: impl AsRef<Path>) -> Result<Self> {
        let path = path.as_ref();
        let file = File::create(path).map_err(|source| Error::io("create", path, source))?;
        Ok(Self::new(path, BufWriter::new(file)))
    }
}

impl<W: Write> CsvWriter<W> {
    /// Writes to anything; `path` names it in errors.
    pub fn new(path: impl Into<PathBuf>, writer: W) -> Self {
        Self { path: path.into(), writer: csv::Writer::from_writer(writer), field: Vec::new() }
    }

    /// What was written to, once everything is.
    pub fn into_inner(self) -> Result<W> {
        self.writer.into_inner().map_err(|error| Error::io("write", self.path, error.into_error()))
    }

    fn failed(&self, error: csv::Error) -> Error {
        Error::io("write", &self.path, error.into())
    }
}

impl<W: Write> Observer for CsvWriter<W> {
    fn begin(&mut self, columns: &[Column]) -> Result<()> {
        let names = std::iter::once("time").chain(columns.iter().map(|column| column.name.as_str()));
        self.writer.write_record(names).map_err(|error| self.failed(error))
    }

    fn sample(&mut self, time: f64, values: &[Value]) -> Result<()> {
        let written: Result<(), csv::Error> = (|| {
            write_float(&mut self.writer, &mut self.field, time)?;
            for value in values {
                match value {
                    Value::Float(value) => write_float(&mut self.writer, &mut self.field, *value)?,
                    Value::Integer(value) => write_number(&mut self.writer, &mut self.field, format_args!("{value}"))?,
                    Value::Boolean(value) => self.writer.write_field(if *value { "1" } else { "0" })?,
                    Value::String(value) => self.writer.write_field(value)?,
                }
            }
            self.writer.write_record(None::<&[u8]>)
        })();
        written.map_err(|error| self.failed(error))
    }

    fn end(&mut self) -> Result<()> {
        self.writer.flush().map_err(|source| Error::io("write", &self.path, source))
    }
}

/// The fewest digits that read back to the same bits, with an exponent where it saves zeros.
fn write_float<W: Write>(writer: &mut csv::Writer<W>, field: &mut Vec<u8>, value: f64) -> Result<(), csv::Error> {
    let plain = value == 0.0 || !value.is_finite() || (1e-5..1e16).contains(&value.abs());
    if plain {
        write_number(writer, field, format_args!("{value}"))
    } else {
        write_number(writer, field, format_args!("{value:e}"))
    }
}

fn write_number<W: Write>(
    writer: &mut csv::Writer<W>,
    field: &mut Vec<u8>,
    number: std::fmt::Arguments<'_>,
) -> Result<(), csv::Error> {
    field.clear();
    field.write_fmt(number)?;
    writer.write_field(field)
}
