//! Units as people read them.

use std::f64::consts::PI;

/// How values of a unit are shown: angles in degrees, all else as it is.
#[derive(Debug, Clone, PartialEq)]
pub struct Shown {
    /// The unit's sign, empty for none.
    pub unit: String,
    /// What values are multiplied by.
    pub factor: f64,
}

impl Shown {
    /// For a unit of a model description.
    pub fn of(unit: Option<&str>) -> Self {
        let (unit, factor) = match unit.unwrap_or_default() {
            "rad" => ("°", 180.0 / PI),
            "rad/s" => ("°/s", 180.0 / PI),
            "rad/s2" => ("°/s²", 180.0 / PI),
            "m/s2" => ("m/s²", 1.0),
            "1" => ("", 1.0),
            other => (other, 1.0),
        };
        Self { unit: unit.to_owned(), factor }
    }

    /// A label with the unit, if there is one.
    pub fn label(&self, text: &str) -> String {
        if self.unit.is_empty() { text.to_owned() } else { format!("{text} ({})", self.unit) }
    }

    /// The values as they are shown.
    pub fn values(&self, values: &[f64]) -> Vec<f64> {
        values.iter().map(|v| v * self.factor).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angles_are_shown_in_degrees() {
        let shown = Shown::of(Some("rad"));
        assert_eq!(shown.label("swing"), "swing (°)");
        assert!((shown.values(&[PI])[0] - 180.0).abs() < 1e-12);
        assert_eq!(Shown::of(None).label("command"), "command");
        assert_eq!(Shown::of(Some("m")).label("length"), "length (m)");
    }
}
