//! Plays a sequence of calls on an instance and holds it against the rules and the invariants.

use std::time::{Duration, Instant};

use arbitrary::Unstructured;
use swayless_modeldesc::types::{Causality, DataType, Dimension, FmiVersion, Variable};

use super::call::{Access, Answer, Call, Values, floats};
use super::library::{Host, Kind, Subject};
use super::rules::{Mode, Name, RULES, Rule, Verdict, next};
use super::script::{Script, extent};

const DISCARD: i32 = 2;
const ERROR: i32 = 3;

/// Inputs beyond this may overflow what is calculated from them.
const TAME: f64 = 1e9;

/// What an FMU may take to find that it cannot do what it is asked; generous, since other tests run beside.
const LONGEST: Duration = Duration::from_secs(10);

/// What is known of a state that was got or deserialized.
#[derive(Clone)]
struct Saved {
    mode: Mode,
    time: f64,
    tame: bool,
    lost: bool,
    bytes: Vec<u8>,
}

/// An instance at play, with what must be true of it.
pub struct Player<'a> {
    subject: &'a Subject,
    kind: Kind,
    host: Box<dyn Host>,
    mode: Mode,
    time: f64,
    /// All inputs and states set so far are within bounds where nothing overflows.
    tame: bool,
    /// The state is a forged one, so that nobody knows what to expect of it; the host must live all the same.
    lost: bool,
    saved: [Option<Saved>; 2],
    states: Vec<Vec<u8>>,
    /// Took over from the instance and must answer alike.
    twin: Option<Box<dyn Host>>,
    /// What has been played, for the message.
    trace: Vec<String>,
}

impl<'a> Player<'a> {
    pub fn new(subject: &'a Subject, kind: Kind, bare: bool) -> Self {
        Self {
            subject,
            kind,
            host: subject.instantiate(kind, bare),
            mode: Mode::Instantiated,
            time: 0.0,
            tame: true,
            lost: false,
            saved: [None, None],
            states: Vec::new(),
            twin: None,
            trace: Vec::new(),
        }
    }

    fn verdict(&self, rule: &Rule) -> Verdict {
        let mut variables = self.subject.description.variables.iter();
        rule.verdict(self.kind, self.mode, variables.any(|v| v.causality == Causality::StructuralParameter))
    }

    fn version(&self) -> FmiVersion {
        self.subject.description.fmi_version
    }

    /// Writes down what has been played, for a call that does not come back.
    fn keep_trace(&self) {
        if let Some(file) = std::env::var_os("SWAYLESS_FUZZ_TRACE") {
            std::fs::write(file, self.trace()).expect("a file to write to");
        }
    }

    /// What has been played.
    pub fn trace(&self) -> String {
        format!("{} {:?}:\n  {}", self.subject.name, self.kind, self.trace.join("\n  "))
    }

    /// Goes on from a serialized state of unknown origin, if the instance takes it; most likely it is at this time.
    pub fn start_from(&mut self, bytes: Vec<u8>, time: f64) -> Result<(), String> {
        let inputs = self.subject.description.variables.iter();
        let inputs = inputs.filter(|v| v.causality == Causality::Input && v.data_type == DataType::Float64);
        let inputs = all(&inputs.collect::<Vec<_>>());
        let ones = Values::Floats(vec![1.0; inputs.count]);
        let mut calls = vec![Call::Deserialize(0, bytes), Call::SetState(0), Call::FreeState(0)];
        // An event, and what follows from it.
        calls.extend(match self.kind {
            Kind::ModelExchange => {
                vec![Call::EnterEvent, Call::Set(inputs, ones), Call::Update, Call::EnterContinuousTime]
            }
            _ => vec![Call::Set(inputs, ones), Call::DoStep { time, size: 0.1 }],
        });
        let time = if self.kind == Kind::ModelExchange { time } else { time + 0.1 };
        for call in calls {
            self.trace.push(shortened(&call));
            self.keep_trace();
            let began = Instant::now();
            let status = self.host.play(&call).ok_or("no function")?.status;
            self.trace.extend(self.host.messages().into_iter().map(|(status, text)| format!("    {status}: {text}")));
            if !(0..=ERROR).contains(&status) || began.elapsed() > LONGEST {
                return Err(format!("status {status} after {:?}", began.elapsed()));
            }
            if status == ERROR {
                self.mode = Mode::Error;
                return Ok(());
            }
        }
        (self.mode, self.time, self.lost, self.tame) = (Mode::Step, time, true, false);
        if self.kind == Kind::ModelExchange {
            self.mode = Mode::ContinuousTime;
        }
        Ok(())
    }

    /// Plays one step made of raw bytes: a call, most often one that is allowed now.
    pub fn step(&mut self, raw: &[u8]) -> Result<(), String> {
        let mut u = Unstructured::new(raw);
        let Ok(call) = self.choose(&mut u) else { return Ok(()) };
        let Some((rule, call)) = call else { return Ok(()) };
        self.play(rule, &call)?;
        // A twin now and then: it takes the state over and must go on alike.
        if self.twin.is_none() && !self.lost && u.int_in_range(0..=5_u8).unwrap_or(0) == 5 {
            self.make_twin()?;
        }
        Ok(())
    }

    fn choose(&self, u: &mut Unstructured<'_>) -> arbitrary::Result<Option<(usize, Call)>> {
        let wild = u.int_in_range(0..=19_u8)? == 19;
        // After an error most importers reset, or go back to a state.
        let wanted = |index: &usize| {
            let rule = &RULES[*index];
            let recovers = matches!(rule.name, Name::Reset | Name::SetState);
            rule.is_of(self.version())
                && (wild
                    || self.verdict(rule) == Verdict::Allowed
                        && (recovers || !matches!(self.mode, Mode::Error | Mode::Terminated)))
        };
        let rules: Vec<usize> = (0..RULES.len()).filter(wanted).collect();
        let total = rules.iter().map(|index| RULES[*index].weight).sum::<u32>();
        if total == 0 {
            return Ok(None);
        }
        let mut ticket = u.int_in_range(0..=total - 1)?;
        let index = rules.into_iter().find(|index| {
            let weight = RULES[*index].weight;
            let here = ticket < weight;
            ticket = ticket.saturating_sub(weight);
            here
        });
        let Some(index) = index else { return Ok(None) };
        let script = Script { description: &self.subject.description, time: self.time, states: &self.states };
        Ok(Some((index, script.call(RULES[index].name, u)?)))
    }

    /// Makes a call and judges the answer.
    fn play(&mut self, rule: usize, call: &Call) -> Result<(), String> {
        let rule = &RULES[rule];
        let verdict = if self.lost { Verdict::Tolerated } else { self.verdict(rule) };
        let before = (matches!(call, Call::DoStep { .. }) && !self.lost).then(|| self.values()).flatten();
        self.trace.push(format!("{:?}: {}", self.mode, shortened(call)));
        self.keep_trace();
        let began = Instant::now();
        let Some(answer) = self.host.play(call) else { return Ok(()) };
        // Under valgrind, everything takes fifty times as long.
        let watched = std::env::var_os(super::memory::ARCHIVES).is_some();
        if began.elapsed() > LONGEST && !watched {
            return Err(format!("a call took {:?}", began.elapsed()));
        }
        let status = answer.status;
        self.trace.push(format!("  → {status}"));
        let messages = self.host.messages();
        self.trace.extend(messages.iter().map(|(status, text)| format!("    {status}: {text}")));
        if !(0..=ERROR).contains(&status) {
            return Err(format!("status {status}"));
        }
        if verdict == Verdict::Refused && status != ERROR {
            return Err(format!("{:?} is forbidden in {:?}, but returned {status}", rule.name, self.mode));
        }
        if verdict == Verdict::Allowed && rule.certain && status != 0 {
            return Err(format!("{:?} is allowed in {:?}, but returned {status}", rule.name, self.mode));
        }
        if verdict == Verdict::Allowed && messages.iter().any(|(_, text)| text.contains("is not allowed")) {
            return Err(format!("{:?} is allowed in {:?}, but refused as not allowed", rule.name, self.mode));
        }
        if let Some(twin) = &mut self.twin {
            let other = twin.play(call);
            // Serialized states of both are the same as well.
            if other.as_ref() != Some(&answer) && !is_about_states(call) {
                return Err(format!("an instance that took the state over answers {other:?}, not {answer:?}"));
            }
        }
        if status == DISCARD && !self.lost && matches!(call, Call::DoStep { .. }) {
            let after = self.values();
            if before != after {
                return Err(format!("a discarded step has changed values from {before:?} to {after:?}"));
            }
        }
        self.after(call, &answer)
    }

    /// All floats, if they can be read now.
    fn values(&mut self) -> Option<Vec<u64>> {
        let floats = self.subject.description.variables.iter().filter(|v| v.data_type == DataType::Float64);
        let access = all(&floats.collect::<Vec<_>>());
        // Reading in a mode where it is forbidden would be an error, and end the play.
        let answer = (self.mode == Mode::Step).then(|| self.host.play(&Call::Get(access))).flatten()?;
        (answer.status == 0).then_some(answer.bits)
    }

    /// What follows from an answer.
    fn after(&mut self, call: &Call, answer: &Answer) -> Result<(), String> {
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
    fn make_twin(&mut self) -> Result<(), String> {
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

/// All values of variables of one type, but for arrays whose lengths change.
fn all(variables: &[&Variable]) -> Access {
    let fixed = |v: &&&Variable| v.dimensions.iter().all(|dimension| matches!(dimension, Dimension::Fixed(_)));
    let variables: Vec<&Variable> = variables.iter().filter(fixed).copied().collect();
    Access {
        data_type: DataType::Float64,
        references: variables.iter().map(|v| v.value_reference).collect(),
        count: variables.iter().map(|v| extent(v)).sum(),
        null: false,
    }
}

fn is_about_states(call: &Call) -> bool {
    matches!(
        call,
        Call::GetState(_) | Call::SetState(_) | Call::FreeState(_) | Call::Serialize(_) | Call::Deserialize(..)
    )
}

fn differences(a: &Option<Vec<u8>>, b: &Option<Vec<u8>>) -> String {
    let (Some(a), Some(b)) = (a, b) else { return "one cannot be serialized".to_owned() };
    let places: Vec<usize> = (0..a.len().min(b.len())).filter(|i| a[*i] != b[*i]).collect();
    format!("{} and {} bytes, different at {places:?}", a.len(), b.len())
}

/// A call without the length of its bytes.
fn shortened(call: &Call) -> String {
    match call {
        Call::Deserialize(slot, bytes) => format!("Deserialize({slot}, {} bytes)", bytes.len()),
        other => format!("{other:?}"),
    }
}
