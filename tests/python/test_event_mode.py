"""Co-simulation in FMI 3.0 with Event Mode and early return gives what co-simulation without them gives."""

import numpy as np
from host import FLOATS, HOLD, STEP, Instance, co_simulate, elements, sequence

AGREEMENT = 1e-7
"""Largest difference: a step that is cut at an event is not the one that crosses it."""
CLEAR = 1e-6
"""How far a sample must be from every event (s)."""
STOP = 10.0


def step_to(instance, time, until, events):
    """Steps to a communication point, handling every event on the way as the standard says."""
    while time < until:
        event, terminate, early, last = instance.api.doStep(time, until - time)
        assert not terminate and last <= until and early == (last < until)
        if event:
            events.append(last)
            instance.api.enterEventMode()
            update(instance)
        time = last


def update(instance):
    """Event iteration, back to step mode."""
    again = True
    while again:
        again, terminate, _, _, _, _ = instance.api.updateDiscreteStates()
        assert not terminate
    instance.api.enterStepMode()


def with_event_mode(fmu, parameters):
    """Values at every communication point, and the instants of all events."""
    observed = fmu.observed()
    with Instance(fmu, "CoSimulation", event_mode=True) as instance:
        instance.initialize(parameters, sequence(fmu, 0), tolerance=1e-10)
        update(instance)
        rows, events = [instance.get(observed)], [0.0]
        for k in range(round(STOP / STEP)):
            if k % HOLD == 0 and k > 0:
                instance.api.enterEventMode()
                instance.set(sequence(fmu, k // HOLD))
                update(instance)
                events.append(k * STEP)
            step_to(instance, k * STEP, (k + 1) * STEP, events)
            rows.append(instance.get(observed))
    return rows, np.array(events)


def test_event_mode_changes_nothing_but_who_handles_events(case):
    """Every output and local variable, at all communication points away from events."""
    fmu, parameters = case
    if fmu.is_fmi2:
        return
    parameters = fmu.with_files(parameters)
    with Instance(fmu, "CoSimulation") as instance:
        expected = co_simulate(instance, parameters, tolerance=1e-10, stop=STOP)
    found, events = with_event_mode(fmu, parameters)
    types = {name: v.type for v in fmu.observed() for name in elements(v)}
    for k, (a, b) in enumerate(zip(expected, found, strict=True)):
        if np.abs(events - k * STEP).min() <= CLEAR:
            continue
        for name, value in a.items():
            if types[name] in FLOATS:
                assert abs(value - b[name]) <= AGREEMENT, f"{name} at {k * STEP} s"
            else:
                assert value == b[name], f"{name} at {k * STEP} s"
