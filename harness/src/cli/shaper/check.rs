//! What is wrong with arguments: all of it, by the names of the options.

use swayless::Error;

/// Less residual vibration than this is none.
const LEAST_SHARE: f64 = 0.001;

/// All that is wrong with the arguments, by the names of the options.
#[derive(Default)]
pub struct Check(Vec<Error>);

impl Check {
    /// Something is wrong with an option.
    pub fn problem(&mut self, option: &str, text: &str) {
        self.0.push(Error::Option(format!("`{option}` {text}")));
    }

    /// An option has a wrong value.
    pub fn wrong(&mut self, option: &str, value: impl std::fmt::Display, text: &str) {
        self.0.push(Error::Option(format!("`{option} {value}`: {text}")));
    }

    /// Wants a number greater than 0.
    pub fn positive(&mut self, option: &str, value: f64, unit: &str) {
        if !(value > 0.0 && value.is_finite()) {
            self.wrong(option, value, &format!("must be finite and greater than 0 ({unit})"));
        }
    }

    /// Wants a time.
    pub fn time(&mut self, option: &str, value: f64) {
        if !(value >= 0.0 && value.is_finite()) {
            self.wrong(option, value, "must be finite and at least 0 (s)");
        }
    }

    /// Wants a share of vibration.
    pub fn share(&mut self, option: &str, value: f64) {
        if !(LEAST_SHARE..1.0).contains(&value) {
            self.wrong(option, value, &format!("must be at least {LEAST_SHARE} and less than 1; 0.05 is 5 %"));
        }
    }

    /// Ends with all that has been found.
    pub fn all(&mut self) -> Result<(), Error> {
        match self.0.len() {
            0 => Ok(()),
            1 => Err(self.0.remove(0)),
            _ => Err(Error::Several(std::mem::take(&mut self.0))),
        }
    }
}
