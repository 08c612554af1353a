//! What the shaper remembers between events.

use serde::{Deserialize, Serialize};
use swayless_shaping::{Design, Designer, Specification, Trains};

use crate::variables::Parameters;
use crate::wanted::{wanted, wanted_for};

/// Room for impulses on their way: a ramp seen every 10 ms through a shaper of four impulses, 40 s long.
const PENDING: usize = 16_384;

/// Commands beyond all measure are cut, so that a change of them is a number.
pub fn cut(command: f64) -> f64 {
    command.clamp(-1e300, 1e300)
}

/// What the shaper remembers between events.
#[derive(Serialize, Deserialize)]
#[serde(try_from = "Parts")]
pub struct Memory {
    pub trains: Trains,
    /// The design of the last change that had one.
    pub design: Design,
    /// When sampling began (s), and how many samples have been taken.
    pub begin: f64,
    pub samples: f64,
    /// What the last change was to be shaped with, and whether that could be designed: what need not be done again. What
    /// follows from it is the same without it.
    #[serde(skip)]
    last: Option<(Specification, bool)>,
    #[serde(skip)]
    designer: Designer,
    /// For the kinds that are designed for each change.
    #[serde(skip)]
    changes: Designer,
}

/// What a memory is serialized as.
#[derive(Deserialize)]
struct Parts {
    trains: Trains,
    design: Design,
    begin: f64,
    samples: f64,
}

impl TryFrom<Parts> for Memory {
    type Error = &'static str;

    fn try_from(Parts { trains, design, begin, samples }: Parts) -> Result<Self, Self::Error> {
        if !(begin.is_finite() && samples.is_finite() && samples >= 0.0) {
            return Err("samples are counted by finite numbers");
        }
        Ok(Self { trains, design, begin, samples, ..Self::default() })
    }
}

/// Of no shaper at all, until the parameters are known.
impl Default for Memory {
    fn default() -> Self {
        Self {
            trains: Trains::new(0.0, 0),
            design: Design::unshaped(),
            begin: 0.0,
            samples: 0.0,
            last: None,
            designer: Designer::default(),
            changes: Designer::default(),
        }
    }
}

/// Copying into a memory uses its room again: it happens in every step that has an event.
impl Clone for Memory {
    fn clone(&self) -> Self {
        Self {
            trains: self.trains.clone(),
            design: self.design.clone(),
            designer: self.designer.clone(),
            changes: self.changes.clone(),
            ..*self
        }
    }

    fn clone_from(&mut self, source: &Self) {
        self.trains.clone_from(&source.trains);
        self.design.clone_from(&source.design);
        self.designer.clone_from(&source.designer);
        self.changes.clone_from(&source.changes);
        (self.begin, self.samples, self.last) = (source.begin, source.samples, source.last);
    }
}

impl Memory {
    /// Before the first command.
    pub fn new(p: &Parameters<f64>) -> Self {
        Self { trains: Trains::new(cut(p.command_start), PENDING), ..Self::default() }
    }

    /// Shapes a new command, with the modes as they are at a suspension length. Tells each new design. Returns the shaped command,
    /// and whether there was a design; without one the last is used.
    pub fn set_command(
        &mut self,
        (time, command): (f64, f64),
        p: &Parameters<f64>,
        length: f64,
        tell: impl FnMut(&Design),
    ) -> (f64, bool) {
        let wanted = wanted(p, length).ok();
        let found = wanted.is_some_and(|wanted| self.renew(wanted, tell));
        let change = command - self.trains.command();
        let own = wanted.filter(|_| found && p.enabled).and_then(|wanted| wanted_for(p, &wanted, change));
        let own = own.map(|own| self.changes.design(&own));
        let found = found && !matches!(own, Some(Err(_)));
        let shaped = match own {
            _ if !p.enabled => self.trains.set_command(time, command, &Design::unshaped()),
            Some(Ok(own)) => self.trains.set_command(time, command, &own),
            _ => self.trains.set_command(time, command, &self.design),
        };
        (shaped, found)
    }

    /// Designs, unless the last design was for the same; whether there is a design. Without one the last stays.
    fn renew(&mut self, wanted: Specification, mut tell: impl FnMut(&Design)) -> bool {
        match self.last {
            Some((last, found)) if last == wanted => found,
            _ => {
                let design = self.designer.design(&wanted);
                let found = design.is_ok();
                self.last = Some((wanted, found));
                if let Ok(design) = design {
                    tell(&design);
                    self.design = design;
                }
                found
            }
        }
    }
}
