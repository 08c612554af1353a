"""Whoever handles the events, they are the same ones: as many, at the same instants, in every way to live.

Co-simulation without event mode tells of its events in its log; elsewhere the host meets them.
"""

import re

import numpy as np
from host import HOLD, STEP, Instance, co_simulate, model_exchange
from test_event_mode import STOP, with_event_mode

SAME = 1e-6
"""How far apart the instants of an event may lie (s): CVode finds state events by interpolation."""
TOLD = re.compile(r"event at (\S+) s")


def own(instants):
    """The instants of events that no input has made; one event where several rounds or indicators meet."""
    inputs = np.arange(0.0, STOP + STEP, HOLD * STEP)
    found = []
    for t in sorted(instants):
        if np.abs(inputs - t).min() > SAME and t < STOP - SAME and (not found or t - found[-1] > SAME):
            found.append(t)
    return np.array(found)


def told(fmu, parameters):
    """The instants that co-simulation writes into its log."""
    with Instance(fmu, "CoSimulation", logging=True) as instance:
        co_simulate(instance, parameters, tolerance=1e-10, stop=STOP)
        texts = [text.decode() if isinstance(text, bytes) else str(text) for _, text in instance.messages]
    return own([float(match[1]) for match in map(TOLD.match, texts) if match])


def test_events_are_the_same_in_every_interface(case):
    """Time events and state events over ten seconds of changing inputs."""
    fmu, parameters = case
    parameters = fmu.with_files(parameters)
    expected = told(fmu, parameters)
    with Instance(fmu, "ModelExchange") as instance:
        _, events = model_exchange(instance, parameters, tolerance=1e-12, stop=STOP)
    met = {"model exchange": own(events)}
    if not fmu.is_fmi2:
        met["event mode"] = own(with_event_mode(fmu, parameters)[1])
    for interface, events in met.items():
        assert len(events) == len(expected), f"{interface}: {events}, co-simulation: {expected}"
        assert np.abs(events - expected).max(initial=0.0) <= SAME, interface
    print(f"{len(expected)} events", end=" ")


def test_there_are_events_to_compare(named):
    """The drive's limiter and the shaper's impulses."""
    for name in ("VectorDrive", "InputShaper"):
        assert len(told(named("fmi2", name), {})) >= 3
