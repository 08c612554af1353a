//! What a specification is answered with, and a memory for designs that are dear.

use serde::{Deserialize, Serialize};

use crate::{Shaper, Specification, SpecificationError};

/// A design: the trains that changes of a command spawn. It lives on the stack.
///
/// Most designs have one train for all changes, and as their trains add up linearly, they may overlap. Those made for what a
/// certain drive makes of a train are exact only while no other train is under way.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
pub struct Design {
    shaper: Shaper,
    braking: Option<Shaper>,
    /// Whether trains may overlap without harm.
    adds_up: bool,
}

impl Clone for Design {
    fn clone(&self) -> Self {
        Self { shaper: self.shaper.clone(), braking: self.braking.clone(), adds_up: self.adds_up }
    }

    fn clone_from(&mut self, source: &Self) {
        self.shaper.clone_from(&source.shaper);
        self.braking.clone_from(&source.braking);
        self.adds_up = source.adds_up;
    }
}

impl From<Shaper> for Design {
    /// One train for all changes; trains may overlap.
    fn from(shaper: Shaper) -> Self {
        Self { shaper, braking: None, adds_up: true }
    }
}

impl Design {
    /// No shaping at all.
    #[must_use]
    pub fn unshaped() -> Self {
        Shaper::unshaped().into()
    }

    /// One train for all changes, exact as long as no other is under way.
    #[must_use]
    pub fn alone(shaper: Shaper) -> Self {
        Self { shaper, braking: None, adds_up: false }
    }

    /// Of one train for growing commands and another for shrinking ones, exact as long as no other is under way.
    #[must_use]
    pub fn of_both(accelerating: Shaper, braking: Shaper) -> Self {
        Self { shaper: accelerating, braking: Some(braking), adds_up: false }
    }

    /// The train of a change; where there is one for [braking](Self::braking), of a change that makes the command grow.
    #[must_use]
    pub fn shaper(&self) -> &Shaper {
        &self.shaper
    }

    /// The train of a change that makes the command shrink in magnitude, where that is another one.
    #[must_use]
    pub fn braking(&self) -> Option<&Shaper> {
        self.braking.as_ref()
    }

    /// Whether trains may overlap without harm.
    #[must_use]
    pub fn adds_up(&self) -> bool {
        self.adds_up
    }

    /// The longest delay that shaping adds, in seconds.
    #[must_use]
    pub fn duration(&self) -> f64 {
        self.braking.as_ref().map_or(0.0, Shaper::duration).max(self.shaper.duration())
    }

    /// A design for a unit frequency, at another one (rad/s).
    pub(crate) fn at_frequency(self, frequency: f64) -> Self {
        let Self { shaper, braking, adds_up } = self;
        let scaled = |shaper: Shaper| shaper.at_frequency(frequency);
        Self { shaper: scaled(shaper), braking: braking.map(scaled), adds_up }
    }
}

/// Designs, and remembers the last design, so that the same again costs next to nothing; of one that is dear, also the same at
/// another frequency. What it gives does not depend on what it remembers.
#[derive(Debug, Default)]
pub struct Designer {
    last: Option<(Specification, Result<Design, SpecificationError>)>,
}

/// What is remembered is not copied, for nothing depends on it: a clone remembers nothing, and what is cloned into goes on
/// remembering its own.
impl Clone for Designer {
    fn clone(&self) -> Self {
        Self::default()
    }

    fn clone_from(&mut self, _: &Self) {}
}

impl Designer {
    /// The same as [`Specification::design`], to the bit.
    ///
    /// # Errors
    /// Those of [`Specification::design`].
    pub fn design(&mut self, wanted: &Specification) -> Result<Design, SpecificationError> {
        let scaled = wanted.at_unit_frequency();
        let key = scaled.map_or(*wanted, |(unit, _)| unit);
        let known = self.last.take().filter(|(specification, _)| *specification == key);
        let (_, design) = self.last.insert(known.unwrap_or_else(|| (key, key.design_directly())));
        let design = design.clone();
        match scaled {
            Some((_, frequency)) => design.map(|design| design.at_frequency(frequency)),
            None => design,
        }
    }
}
