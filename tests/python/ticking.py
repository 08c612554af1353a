"""A scheduler for FMUs with clocks: it asks for intervals, activates clocks, and steps between the ticks."""

import ctypes
import math
from ctypes import c_bool, c_double, c_int, c_size_t, c_uint32

from host import HOLD, STEP, sequence
from raw import OK, Raw

NOT_YET_KNOWN, UNCHANGED, CHANGED = range(3)
PERIODIC = ("constant", "fixed", "tunable")
KINDS = ("CoSimulation", "ModelExchange", "ScheduledExecution")
SAME = 1e-9
"""How far apart two instants are that mean the same (s)."""


class Clocked(Raw):
    """An instance of an FMU with clocks, in whose hands they are."""

    def __init__(self, library, kind, **arguments):
        arguments.setdefault("event_mode", True)
        super().__init__(library, kind, token=library.fmu.description.instantiationToken.encode(), **arguments)

    def interval(self, clock):
        """A status, the interval of a clock and its qualifier."""
        value, qualifier = c_double(), c_int()
        status = self.call("GetIntervalDecimal", *one(clock), ctypes.byref(value), ctypes.byref(qualifier))
        return status, value.value, qualifier.value

    def set_interval(self, clock, interval):
        """The status of setting an interval."""
        return self.call("SetIntervalDecimal", *one(clock), ctypes.byref(c_double(interval)))

    def shift(self, clock):
        """A status and the shift of a clock."""
        value = c_double()
        return self.call("GetShiftDecimal", *one(clock), ctypes.byref(value)), value.value

    def tick(self, clock, active=True):
        """The status of activating a clock."""
        return self.call("SetClock", *one(clock), ctypes.byref(c_bool(active)))

    def ticks(self, clock):
        """A status and whether a clock is active."""
        value = c_bool()
        return self.call("GetClock", *one(clock), ctypes.byref(value)), value.value

    def activate(self, clock, time):
        """The status of computing a model partition."""
        return self.call("ActivateModelPartition", c_uint32(clock.valueReference), c_double(time))


def one(variable):
    """The arguments for one value reference."""
    return (c_uint32 * 1)(variable.valueReference), c_size_t(1)


class Scheduler:
    """When each clock ticks next, as the FMU tells it."""

    def __init__(self, instance):
        self.instance = instance
        inputs = [clock for clock in instance.fmu.clocks if clock.causality == "input"]
        self.order = sorted(inputs, key=lambda clock: int(clock.priority))
        self.base = {clock.name: 0.0 for clock in inputs}
        self.count = {clock.name: 0 for clock in inputs}
        self.every = {}
        self.due = {clock.name: math.inf for clock in inputs}
        for clock in inputs:
            if clock.intervalVariability in PERIODIC:
                status, self.base[clock.name] = instance.shift(clock)
                assert status == OK
            self.ask(clock, 0.0)
            if clock.intervalVariability in PERIODIC:
                self.count[clock.name] = 0
                self.due[clock.name] = self.base[clock.name]

    def ask(self, clock, time):
        """Takes what the FMU says of a clock's interval."""
        status, interval, qualifier = self.instance.interval(clock)
        assert status == OK, self.instance.texts()
        if clock.intervalVariability not in PERIODIC:
            if qualifier == CHANGED:
                self.due[clock.name] = time + interval
        elif clock.name not in self.every:
            self.every[clock.name] = interval
        elif qualifier == CHANGED:
            self.every[clock.name] = interval
            self.base[clock.name], self.count[clock.name] = time, 1
            self.due[clock.name] = time + interval

    def now(self, time):
        """The clocks that tick, in the order of their priorities; when they tick next is counted on."""
        found = [clock for clock in self.order if self.due[clock.name] <= time + SAME]
        for clock in found:
            name = clock.name
            self.due[name] = math.inf
            if clock.intervalVariability in PERIODIC:
                self.count[name] += 1
                self.due[name] = self.base[name] + self.count[name] * self.every[name]
        return found

    def heed(self, time):
        """Asks after an event for all intervals that may have changed."""
        for clock in self.order:
            self.ask(clock, time)

    def next(self):
        """The next tick."""
        return min(self.due.values())


def run(instance, parameters, stop, change=None):
    """Values at every communication point, and how often each output clock has ticked.

    Inputs change every `HOLD` steps; `change(instance, time)` may set more then."""
    fmu, kind = instance.fmu, instance.kind
    outputs = [clock for clock in fmu.clocks if clock.causality == "output"]
    fired = {clock.name: 0 for clock in outputs}
    assert instance.set(fmu.with_files(parameters)) == OK, instance.texts()
    assert instance.enter_initialization() == OK
    assert instance.set(sequence(fmu, 0)) == OK
    scheduler = Scheduler(instance)
    assert instance.call("ExitInitializationMode") == OK, instance.texts()

    def listen():
        for clock in outputs:
            status, active = instance.ticks(clock)
            assert status == OK
            fired[clock.name] += active

    def event(time, ticking):
        if kind == "ScheduledExecution":
            for clock in ticking:
                assert instance.activate(clock, time) == OK, instance.texts()
                listen()
        else:
            for clock in ticking:
                assert instance.tick(clock) == OK, instance.texts()
            listen()
            assert instance.update() == OK, instance.texts()
        scheduler.heed(time)

    def enter(time):
        if kind != "ScheduledExecution":
            assert instance.call("EnterEventMode") == OK
        if kind == "ModelExchange":
            assert instance.call("SetTime", c_double(time)) == OK

    def leave():
        if kind != "ScheduledExecution":
            name = "EnterContinuousTimeMode" if kind == "ModelExchange" else "EnterStepMode"
            assert instance.call(name) == OK

    def advance(time, target):
        if kind == "CoSimulation" and target > time:
            assert instance.step(time, target - time) == OK, instance.texts()
        if kind == "ModelExchange":
            assert instance.call("SetTime", c_double(target)) == OK

    event(0.0, scheduler.now(0.0))
    leave()
    rows, time = [instance.get()], 0.0
    for k in range(1, round(stop / STEP) + 1):
        until = k * STEP
        while True:
            target = min(until, scheduler.next())
            if until - target <= SAME:
                target = until
            advance(time, target)
            time = target
            ticking = scheduler.now(time)
            if ticking:
                enter(time)
                event(time, ticking)
                leave()
            elif time == until:
                break
        rows.append(instance.get())
        if k % HOLD == 0:
            enter(time)
            assert instance.set(sequence(fmu, k // HOLD)) == OK
            if change:
                change(instance, time)
            event(time, [])
            leave()
    return rows, fired
