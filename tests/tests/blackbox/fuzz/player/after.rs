//! What follows from an answer: where the instance is now, and what must be true of it.

use swayless_modeldesc::types::{Causality, DataType, FmiVersion, Variable};

use super::{DISCARD, ERROR, Player, Saved, TAME, all, is_about_states};
use crate::fuzz::call::{Access, Answer, Call, Values, floats};
use crate::fuzz::library::Kind;
use crate::fuzz::rules::{Mode, next};

impl Player<'_> {
    /// What follows from an answer.
    pub(super) fn after(&mut self, call: &Call, answer: &Answer) -> Result<(), String> {
        if is_about_states(call) || matches!(call, Call::Reset) {
            self.twin = None;
        }
        if answer.status == ERROR {
            self.mode = Mode::Error;
            return Ok(());
        }
        if answer.status == DISCARD {
            return Ok(());
        }
        let mode = self.mode;
        self.mode = next(call, self.kind, self.mode);
        match call {
            Call::GetTiming(of, Access { references, .. }) | Call::SetTiming(of, Access { references, .. }, _)
                if of.fraction && !references.is_empty() =>
            {
                return Err("no clock has fractions".into());
            }
            Call::Get(Access { data_type: DataType::Binary, references, .. })
            | Call::Set(Access { data_type: DataType::Binary, references, .. }, _)
                if !references.is_empty() =>
            {
                return Err("no variable is binary".into());
            }
            Call::SetupExperiment(with) => self.time = with.start,
            Call::EnterInitialization(with) if self.version() == FmiVersion::V3 => self.time = with.start,
            Call::Reset => {
                (self.time, self.tame, self.lost) = (0.0, true, false);
                self.compare_with_fresh()?;
            }
            Call::Set(_, Values::Floats(values)) => self.tame &= values.iter().all(|v| v.abs() <= TAME),
            Call::InputDerivatives(_, _, values) => self.tame &= values.iter().all(|v| v.abs() <= 1.0),
            Call::SetStates(values) => self.tame &= values.iter().all(|v| v.abs() <= TAME),
            Call::SetTime(time) => {
                self.time = *time;
                self.tame &= time.abs() <= TAME;
            }
            Call::Activate(_, time) => {
                self.time = *time;
                self.tame &= time.abs() <= TAME;
                self.check_outputs()?;
            }
            Call::DoStep { time, size } => {
                self.time = floats(&answer.bits).next().unwrap_or(f64::NAN);
                let end = time + size;
                if !(*time..=end).contains(&self.time) && !self.lost {
                    return Err(format!("a step from {time} to {end} ended at {}", self.time));
                }
                if self.kind != (Kind::EventMode { early_return: true }) && self.time != end && !self.lost {
                    return Err(format!("a step from {time} to {end} ended early, at {}", self.time));
                }
                self.tame &= end.abs() <= TAME;
                self.check_outputs()?;
            }
            Call::GetState(slot) => {
                let saved = self.save(*slot, mode)?;
                self.states.push(saved.bytes.clone());
                self.saved[*slot] = Some(saved);
            }
            Call::FreeState(slot) => self.saved[*slot] = None,
            Call::SetState(slot) => {
                let Some(saved) = self.saved[*slot].clone() else { return Err("there was no state to set".into()) };
                (self.mode, self.time, self.tame) = (saved.mode, saved.time, saved.tame);
                self.lost = saved.lost;
                let now = self.host.serialized();
                if now.as_ref() != Some(&saved.bytes) && !self.lost {
                    let differences = differences(&Some(saved.bytes), &now);
                    return Err(format!("the state set is not the state got: {differences}"));
                }
            }
            Call::Deserialize(slot, bytes) => {
                // The bytes are of an earlier moment of this sequence, if they are unharmed.
                if !self.states.contains(bytes) {
                    return Err("a damaged state was accepted".into());
                }
                let known = self.saved.iter().flatten().find(|saved| saved.bytes == *bytes).cloned();
                match known {
                    Some(saved) => self.saved[*slot] = Some(saved),
                    None => {
                        self.saved[*slot] = None;
                        self.host.play(&Call::FreeState(*slot));
                    }
                }
            }
            _ => {}
        }
        Ok(())
    }

    fn save(&mut self, slot: usize, mode: Mode) -> Result<Saved, String> {
        let answer = self.host.play(&Call::Serialize(slot)).ok_or("no Serialize")?;
        if answer.status != 0 {
            return Err(format!("a state that was got cannot be serialized: {}", answer.status));
        }
        Ok(Saved { mode, time: self.time, tame: self.tame, lost: self.lost, bytes: answer.bytes })
    }

    /// Another instance takes the state over.
    pub(super) fn make_twin(&mut self) -> Result<(), String> {
        let Some(bytes) = self.host.serialized() else { return Ok(()) };
        let mut twin = self.subject.instantiate(self.kind, true);
        for call in [Call::Deserialize(0, bytes), Call::SetState(0)] {
            let answer = twin.play(&call);
            if answer.as_ref().is_none_or(|answer| answer.status != 0) {
                return Err(format!("another instance refuses the state: {answer:?}"));
            }
        }
        self.trace.push("(twin)".to_owned());
        self.twin = Some(twin);
        Ok(())
    }

    /// After Reset, the instance is one that has just been made.
    fn compare_with_fresh(&mut self) -> Result<(), String> {
        let mut fresh = self.subject.instantiate(self.kind, true);
        let (mine, its) = (self.host.serialized(), fresh.serialized());
        if mine != its {
            return Err(format!("a reset instance differs from a fresh one: {}", differences(&mine, &its)));
        }
        Ok(())
    }

    /// After a successful step, outputs are numbers, unless somebody has asked for the absurd.
    fn check_outputs(&mut self) -> Result<(), String> {
        if !self.tame {
            return Ok(());
        }
        let is_output = |v: &&Variable| v.causality == Causality::Output && v.data_type == DataType::Float64;
        let outputs: Vec<&Variable> = self.subject.description.variables.iter().filter(is_output).collect();
        let access = all(&outputs);
        let answer = self.host.play(&Call::Get(access)).ok_or("no getter")?;
        if answer.status != 0 {
            return Err(format!("outputs cannot be read after a step: {}", answer.status));
        }
        if let Some(at) = floats(&answer.bits).position(|value| !value.is_finite()) {
            return Err(format!("output value {at} is {} after a step", f64::from_bits(answer.bits[at])));
        }
        Ok(())
    }
}

fn differences(a: &Option<Vec<u8>>, b: &Option<Vec<u8>>) -> String {
    let (Some(a), Some(b)) = (a, b) else { return "one cannot be serialized".to_owned() };
    let places: Vec<usize> = (0..a.len().min(b.len())).filter(|i| a[*i] != b[*i]).collect();
    format!("{} and {} bytes, different at {places:?}", a.len(), b.len())
}
