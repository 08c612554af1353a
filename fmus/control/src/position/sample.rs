//! One sample of a position controller.

use super::designed::Designed;
use super::now::Now;
use super::{Form, Goal, Measured, Settings, Shown};
use crate::crane::{BOUND, State};
use crate::observer::Observer;
use crate::poles::Feedback;
use crate::shaped::Shaped;

/// Time constant with which a plan forgets a swing that nothing in it explains (s).
const FORGETTING: f64 = 2.0;

/// An acceleration that makes no swing (m/s²): of 0.2 mm at 8 m.
const STEADY: f64 = 2e-4;

/// A sample as it is taken.
pub struct Sample<'a> {
    pub interval: f64,
    pub settings: &'a Settings,
    pub designed: &'a Designed,
    pub now: &'a mut Now,
    pub shaped: &'a mut Shaped,
}

impl Sample<'_> {
    /// Where the crane is, by what is known of it and by what the sensors show.
    pub fn observe(&mut self, measured: Measured) {
        let Self { interval, settings, designed: Designed { modes, .. }, .. } = *self;
        let (pendulum, uncertainty) = (&settings.crane.pendulum, &settings.uncertainty);
        let now = &mut *self.now;
        now.time = (now.time + interval).min(BOUND);
        now.estimate = settings.crane.after(modes, now.estimate, now.command, interval);
        let unknown = Observer::new(pendulum, modes, uncertainty);
        let mut observer =
            now.observer.unwrap_or(unknown).after(pendulum, &modes.transition(interval), uncertainty, interval);
        if let Some(hook) = measured.hook {
            let seen = (hook, settings.hook_latency);
            (observer, now.estimate) = observer.correct((pendulum, modes), now.estimate, seen, uncertainty);
        }
        now.observer = Some(observer.bounded(&unknown));
        if let Some(position) = measured.position {
            let motion = &mut now.estimate.motion;
            let seen = (position + settings.position_latency * motion.velocity).clamp(-BOUND, BOUND);
            let share = if now.located { share(interval, settings.position_filter) } else { 1.0 };
            if !now.located {
                // Until now the plan was nowhere.
                (now.located, now.place, now.planned.motion.position) = (true, seen, seen);
            }
            motion.position += share * (seen - motion.position);
        }
        let step = if settings.fade_time > 0.0 { interval / settings.fade_time } else { 1.0 };
        for (trust, seen) in now.trust.iter_mut().zip([measured.hook.is_some(), measured.position.is_some()]) {
            *trust = (*trust + if seen { step } else { -step }).clamp(0.0, 1.0);
        }
    }

    /// Whether the position is known.
    fn is_located(&self) -> bool {
        self.now.trust[1] > 0.0
    }

    /// Nothing to do: the plan is to stay where it is. Returns the correction, which is none.
    pub fn rest(&mut self) -> f64 {
        let now = &mut *self.now;
        now.planned = State::at(now.estimate.motion.position);
        (now.planned_command, now.velocity, now.held, now.off) = (0.0, 0.0, None, true);
        now.place = now.planned.motion.position;
        0.0
    }

    /// Follows a goal: what is planned, and the correction to it (m/s).
    pub fn follow(&mut self, goal: Goal) -> f64 {
        if self.now.off {
            self.shaped.rest(self.now.time - self.interval);
            self.now.off = false;
        }
        if goal != Goal::Hold {
            self.now.held = None;
        }
        self.now.velocity = match self.settings.form {
            Form::Planned => self.plan(goal),
            Form::InLoop | Form::PlainLoop => self.steer(goal),
        };
        self.now.place = (self.now.place + self.now.velocity * self.interval).clamp(-BOUND, BOUND);
        let shaper = &self.designed.shaper;
        self.shaped.push(self.now.time, self.now.velocity, shaper.duration());
        self.now.planned_command = self.shaped.value(self.now.time, shaper);
        self.correction(goal)
    }

    /// The unshaped velocity of a plan, and the plan after the model.
    fn plan(&mut self, goal: Goal) -> f64 {
        let Self { interval, settings, designed, .. } = *self;
        let now = &mut *self.now;
        now.planned = settings.crane.after(&designed.modes, now.planned, now.planned_command, interval);
        let is_steady = self.shaped.is_steady(now.time, designed.shaper.duration());
        if is_steady && now.planned.motion.acceleration.abs() < STEADY {
            // Whatever swing there is in the plan by now was not meant, and is nothing to follow.
            let rest = settings.crane.pendulum.rest(now.planned.motion.acceleration);
            let share = share(interval, FORGETTING);
            now.planned.swing.place += (rest - now.planned.swing.place) * share;
            now.planned.swing.rate *= 1.0 - share;
        }
        let follows = !matches!(goal, Goal::Velocity(_)) && now.trust[1] > 0.0;
        if !follows {
            let off = now.estimate.motion.position - now.planned.motion.position;
            now.planned.motion.position += off;
            now.place += off;
        }
        let limits = settings.limits;
        match goal {
            Goal::Velocity(wanted) => limits.towards(wanted, now.velocity, interval),
            Goal::Position(target) if follows => {
                // A shaper that changed on the way has left the plan beside its target: the rest is a move of its own.
                const BESIDE: f64 = 1e-4;
                let beside = now.planned.motion.position - now.place;
                if is_steady
                    && now.velocity == 0.0
                    && beside.abs() > BESIDE
                    && now.planned.motion.velocity.abs() < BESIDE
                {
                    now.place += beside;
                }
                limits.to_rest_after(target - now.place, now.velocity, interval)
            }
            Goal::Position(_) | Goal::Hold | Goal::Off => limits.towards(0.0, now.velocity, interval),
        }
    }

    /// Where the trolley comes to rest (m) if it is to stop now: what is under way in shaper, drive and swing still gets there.
    fn end(&self) -> f64 {
        let Self { interval, settings, designed, .. } = *self;
        let Now { estimate, trust, time, .. } = &*self.now;
        let sway = Feedback { sway_gain: trust[0] * settings.feedback.sway_gain, ..settings.feedback };
        // A command is held for an interval: it is as old as its middle.
        let pending = self.shaped.pending(time - 0.5 * interval, &designed.shaper);
        (settings.crane.comes_to_rest_at(*estimate, sway) + pending).clamp(-BOUND, BOUND)
    }

    /// The unshaped velocity of the position loop.
    fn steer(&mut self, goal: Goal) -> f64 {
        let Self { interval, settings: Settings { form, limits, feedback, .. }, designed, .. } = *self;
        let stops = self.now.velocity == 0.0;
        let (place, stays) = if *form == Form::InLoop {
            (self.end(), stops)
        } else {
            let is_steady = stops && self.shaped.is_steady(self.now.time, designed.shaper.duration());
            (self.now.estimate.motion.position, is_steady)
        };
        let now = &mut *self.now;
        now.planned = now.estimate;
        if goal == Goal::Hold && now.held.is_none() && stays && now.trust[1] > 0.0 {
            now.held = Some(place);
        }
        let away = match goal {
            Goal::Velocity(wanted) => return limits.towards(wanted, now.velocity, interval),
            Goal::Position(target) => target - place,
            Goal::Hold => now.held.unwrap_or(place) - place,
            Goal::Off => 0.0,
        };
        let wanted = feedback.position_gain * now.trust[1] * away;
        let fastest = if *form == Form::InLoop { limits.braking(away.abs(), interval) } else { limits.velocity };
        limits.towards(wanted.clamp(-fastest, fastest), now.velocity, interval)
    }

    /// What feedback adds (m/s).
    fn correction(&self, goal: Goal) -> f64 {
        let Settings { crane, form, feedback, correction_limit, .. } = self.settings;
        let Now { estimate, planned, trust, .. } = &*self.now;
        let expected = match form {
            Form::Planned => planned.hook(),
            Form::InLoop | Form::PlainLoop => [0.0; 2],
        };
        let [place, rate] = estimate.hook();
        let swing = (place - expected[0] + feedback.lead_time * (rate - expected[1])) / crane.pendulum.hoist;
        let behind = match (form, goal) {
            (Form::Planned, Goal::Position(_) | Goal::Hold) => planned.motion.position - estimate.motion.position,
            _ => 0.0,
        };
        let correction = trust[0] * feedback.sway_gain * swing + trust[1] * feedback.position_gain * behind;
        correction.clamp(-correction_limit, *correction_limit)
    }

    /// What there is to show.
    pub fn shown(&self, goal: Goal, measured: Measured, correction: f64) -> Shown {
        let Self { settings, designed: Designed { modes, is_stable, .. }, .. } = *self;
        let Now { estimate, planned, command, place, held, .. } = *self.now;
        let goal_place = match (goal, settings.form) {
            (Goal::Position(target), _) => Some(target),
            (Goal::Hold, Form::Planned) => Some(place),
            (Goal::Hold, Form::InLoop | Form::PlainLoop) => held,
            (Goal::Velocity(_) | Goal::Off, _) => None,
        };
        let position_error = goal_place.map_or(0.0, |goal| goal - estimate.motion.position);
        let is_goal = matches!(goal, Goal::Position(_)) && self.is_located() && measured.position.is_some();
        let slowest = settings.crane.pendulum.seen(modes)[0].unwrap_or(modes.frequency[0]);
        // A trolley that stopped now would leave the hook swinging by its speed over the frequency.
        let swinging = modes.hook_amplitude(estimate.swing) + estimate.motion.velocity.abs() / slowest;
        Shown {
            velocity: command,
            correction,
            at_target: is_goal && position_error.abs() <= settings.position_tolerance,
            settled: measured.hook.is_some() && swinging <= settings.swing_tolerance,
            position_error,
            planned,
            estimated: estimate,
            is_stable: *is_stable,
        }
    }
}

/// How much of a difference is made up for in an interval (s) with a time constant (s).
fn share(interval: f64, time_constant: f64) -> f64 {
    if time_constant > 0.0 { -(-interval / time_constant).exp_m1() } else { 1.0 }
}
