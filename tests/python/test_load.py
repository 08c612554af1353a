"""A load on `VectorDrive` that moves within a step: the axis breaks away at the instant at which the motor can."""

import pytest
from host import Instance

LIMIT, MASS, START, FALL, WANTED = 5.0, 2.5, 8.0, 1.7, 0.63
FREE = (START - LIMIT) / FALL
"""When the load has fallen to the limit (s)."""
FULL = FREE + WANTED * MASS / FALL
"""When the motor has enough force for what is wanted (s)."""


def expected(time):
    """Velocity and position: the acceleration grows with FALL/MASS from when the load can be held, up to WANTED."""
    lag, full = min(max(time - FREE, 0.0), FULL - FREE), max(time - FULL, 0.0)
    jerk = FALL / MASS
    velocity = jerk * lag**2 / 2
    return velocity + WANTED * full, jerk * lag**3 / 6 + velocity * full + WANTED * full**2 / 2


@pytest.mark.parametrize("step", [0.05, 0.7, 2.8])
def test_the_axis_breaks_away_when_the_motor_can(named, step):
    """A load that falls linearly by its derivative (FMI 2.0), wherever steps end."""
    drive = named("fmi2", "VectorDrive")
    observed = [drive.variables[name] for name in ("velocity", "position", "overloaded", "limited", "brake.closed")]
    load = drive.variables["load.force"].valueReference
    with Instance(drive, "CoSimulation") as instance:
        parameters = {"smoothing": False, "motor.mass": MASS, "force_limit": LIMIT}
        instance.initialize(parameters, {"command": 9.0, "load.force": START}, tolerance=1e-10)
        for k in range(round(2.8 / step)):
            instance.set({"load.force": START - FALL * k * step})
            instance.api.setRealInputDerivatives([load], [1], [-FALL])
            instance.api.doStep(k * step, (k + 1) * step - k * step)
            time = (k + 1) * step
            velocity, position, overloaded, limited, closed = instance.get(observed).values()
            if time < FREE:
                assert (velocity, position) == (0.0, 0.0)
            assert (velocity, position) == pytest.approx(expected(time), abs=1e-11)
            assert (bool(overloaded), bool(limited), bool(closed)) == (time < FREE, FREE < time < FULL, time < FREE)
