"""With derivatives of its inputs (FMI 2.0) a step of co-simulation is exact for inputs on a line, however long it is."""

import numpy as np
import pytest
from host import FLOATS, STEP, Instance, scale

STOP = 6.0
AGREEMENT = 1e-8
"""Largest difference between long and short steps, for a tolerance of 1e-10."""
SHORTER = 5
"""How many short steps are a long one."""


class Lines:
    """A straight line for each continuous input."""

    def __init__(self, instance, steepness):
        self.instance = instance
        self.inputs = [v for v in instance.fmu.inputs if v.type in FLOATS and v.variability == "continuous"]
        self.references = [v.valueReference for v in self.inputs]
        self.slopes = [steepness * scale(v, float(v.start or 0.0)) * (-1.0) ** i / STOP for i, v in enumerate(self.inputs)]
        self.orders = [1] * len(self.inputs)

    def apply(self, time):
        """Sets the inputs to where they are at a time."""
        starts = [float(v.start or 0.0) for v in self.inputs]
        values = [start + slope * time for start, slope in zip(starts, self.slopes)]
        self.instance.api.setReal(self.references, values)


def stepped(fmu, observed, parts, moving, steepness=1.0):
    """Co-simulation with held inputs, or with their derivatives; values at every communication point of long steps."""
    with Instance(fmu, "CoSimulation") as instance:
        lines = Lines(instance, steepness)
        instance.initialize(fmu.with_files({}), {}, tolerance=1e-10)
        rows = [instance.get(observed)]
        step = STEP / parts
        for k in range(round(STOP / step)):
            lines.apply(k * step)
            if moving:
                instance.api.setRealInputDerivatives(lines.references, lines.orders, lines.slopes)
            instance.api.doStep(k * step, (k + 1) * step - k * step)
            if (k + 1) % parts == 0:
                rows.append(instance.get(observed))
        return np.array([list(row.values()) for row in rows], dtype=float)


def test_inputs_move_within_a_step(fmu):
    """With their derivatives the steps follow the lines; without them they lag behind."""
    if not fmu.is_fmi2:
        pytest.skip("FMI 3.0 has no such function")
    moving = [v for v in fmu.inputs if v.type in FLOATS and v.variability == "continuous"]
    if not moving or not fmu.description.numberOfContinuousStates:
        pytest.skip("no continuous input that moves a state")
    observed = [unknown.variable.derivative for unknown in fmu.description.derivatives]
    held = stepped(fmu, observed, 1, False)
    if np.array_equal(held, stepped(fmu, observed, 1, False, steepness=0.0)):
        # Such as the load of a drive that is strong enough for any: outputs tell of it.
        observed = [v for v in fmu.observed() if v.causality == "output" and v.variability == "continuous"]
        held = stepped(fmu, observed, 1, False)
    expected = stepped(fmu, observed, SHORTER, True)
    assert np.abs(stepped(fmu, observed, 1, True) - expected).max() <= AGREEMENT
    assert np.abs(held - expected).max() > 1e-4, "the test tells nothing"
