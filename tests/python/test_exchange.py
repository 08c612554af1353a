"""Model exchange and co-simulation are the same model: CVode at 1e-12 against the FMU's own integrator at 1e-10."""

import numpy as np
from host import FLOATS, STEP, Instance, co_simulate, elements, model_exchange

AGREEMENT = 1e-7
"""Largest difference, relative to the variable's magnitude where that is above 1: forces are some thousand newtons."""
CLEAR = 1e-6
"""How far a sample must be from every event, so that both are on the same side of it (s)."""


def test_model_exchange_agrees_with_co_simulation(case):
    """Every output and local variable, over 20 s, for the same discrete inputs, away from event instants."""
    fmu, parameters = case
    with Instance(fmu, "CoSimulation") as instance:
        stepped = co_simulate(instance, fmu.with_files(parameters), tolerance=1e-10)
    with Instance(fmu, "ModelExchange") as instance:
        integrated, events = model_exchange(instance, fmu.with_files(parameters), tolerance=1e-12)

    times = np.arange(len(stepped)) * STEP
    clear = np.array([np.abs(events - t).min() > CLEAR for t in times])
    assert clear.sum() > len(times) // 4, "events leave too few samples"
    types = {name: v.type for v in fmu.observed() for name in elements(v)}
    worst = 0.0
    for name in stepped[0]:
        a = [row[name] for row, use in zip(stepped, clear) if use]
        b = [row[name] for row, use in zip(integrated, clear) if use]
        if types[name] in FLOATS:
            difference = np.abs(np.subtract(a, b))
            at = int(difference.argmax())
            t = times[clear][at]
            scale = max(1.0, np.abs(a).max())
            assert difference[at] <= AGREEMENT * scale, f"{name} at t = {t:.2f} s: {a[at]!r} stepped, {b[at]!r} integrated"
            worst = max(worst, float(difference[at]) / scale)
        else:
            assert a == b, name
    print(f"{len(events)} events, largest difference {worst:.1e}", end=" ")
