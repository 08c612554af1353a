//! A run in a few numbers for each variable.

use serde_json::{Value as Json, json};
use swayless::{Column, Observer, Result, Value};

use super::console;

/// Keeps of each column its first, last, least and greatest value.
#[derive(Debug, Default)]
pub struct Statistics {
    columns: Vec<Numbers>,
}

#[derive(Debug)]
struct Numbers {
    name: String,
    unit: Option<String>,
    start: Option<Value>,
    end: Option<Value>,
    least: f64,
    greatest: f64,
}

impl Observer for Statistics {
    fn begin(&mut self, columns: &[Column]) -> Result<()> {
        let column = |c: &Column| Numbers {
            name: c.name.clone(),
            unit: c.unit.clone(),
            start: None,
            end: None,
            least: f64::INFINITY,
            greatest: f64::NEG_INFINITY,
        };
        self.columns = columns.iter().map(column).collect();
        Ok(())
    }

    fn sample(&mut self, _time: f64, values: &[Value]) -> Result<()> {
        for (column, value) in self.columns.iter_mut().zip(values) {
            column.start.get_or_insert_with(|| value.clone());
            column.end = Some(value.clone());
            if let Some(number) = value.as_f64() {
                column.least = column.least.min(number);
                column.greatest = column.greatest.max(number);
            }
        }
        Ok(())
    }
}

impl Statistics {
    /// As a table.
    pub fn table(&self) -> String {
        let mut table = console::table(["Variable", "Unit", "Start", "End", "Least", "Greatest"], 2..6);
        for column in &self.columns {
            let extreme = |v: f64| if v.is_finite() { console::number(v) } else { String::new() };
            table.add_row([
                column.name.clone(),
                column.unit.clone().unwrap_or_default(),
                text(column.start.as_ref()),
                text(column.end.as_ref()),
                extreme(column.least),
                extreme(column.greatest),
            ]);
        }
        table.trim_fmt()
    }

    /// As JSON, one object for each variable.
    pub fn json(&self) -> Json {
        self.columns
            .iter()
            .map(|c| {
                json!({
                    "name": c.name, "unit": c.unit, "start": value(c.start.as_ref()), "end": value(c.end.as_ref()),
                    "min": c.least.is_finite().then_some(c.least), "max": c.greatest.is_finite().then_some(c.greatest),
                })
            })
            .collect()
    }
}

fn text(value: Option<&Value>) -> String {
    match value {
        None => String::new(),
        Some(Value::Float(value)) => console::number(*value),
        Some(Value::Integer(value)) => value.to_string(),
        Some(Value::Boolean(value)) => value.to_string(),
        Some(Value::String(value)) => value.clone(),
    }
}

fn value(value: Option<&Value>) -> Json {
    match value {
        None => Json::Null,
        Some(Value::Float(value)) => json!(value),
        Some(Value::Integer(value)) => json!(value),
        Some(Value::Boolean(value)) => json!(value),
        Some(Value::String(value)) => json!(value),
    }
}
