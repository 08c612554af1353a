//! Plays a sequence of calls on an instance and holds it against the rules and the invariants.

mod after;

use std::time::{Duration, Instant};

use arbitrary::Unstructured;
use swayless_modeldesc::types::{Causality, DataType, Dimension, FmiVersion, Variable};

use super::call::{Access, Call, Values};
use super::library::{Host, Kind, Subject};
use super::rules::{Mode, Name, RULES, Rule, Verdict};
use super::script::{Script, extent};

const DISCARD: i32 = 2;
const ERROR: i32 = 3;

/// Inputs beyond this may overflow what is calculated from them.
const TAME: f64 = 1e9;

/// What an FMU may take to find that it cannot do what it is asked; generous, since other tests run beside.
const LONGEST: Duration = Duration::from_secs(30);

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
            Kind::ScheduledExecution => {
                vec![Call::Set(inputs, ones), Call::Activate(self.subject.input_clock(), time + 0.1)]
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
        (self.time, self.lost, self.tame) = (time, true, false);
        self.mode = match self.kind {
            Kind::ModelExchange => Mode::ContinuousTime,
            Kind::ScheduledExecution => Mode::ClockActivation,
            _ => Mode::Step,
        };
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

/// A call without the length of its bytes.
fn shortened(call: &Call) -> String {
    match call {
        Call::Deserialize(slot, bytes) => format!("Deserialize({slot}, {} bytes)", bytes.len()),
        other => format!("{other:?}"),
    }
}
