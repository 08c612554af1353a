"""What holds the boom crane together: luff and hoist stop at their limits, and the cable keeps its length."""

import pytest
from host import Instance, exchange, solver

LIMITS = {"luff.angle_max": 0.9, "hoist.length_max": 10.75, "hoist.length_min": 8.0}
OBSERVED = ("luff.angle", "hoist.length", "at_limit")


def values(instance):
    """What is looked at."""
    return tuple(instance.get([instance.fmu.variables[name] for name in OBSERVED]).values())


@pytest.mark.parametrize("version", ["fmi2", "fmi3"])
@pytest.mark.parametrize("step", [0.01, 0.25, 1.0])
def test_joints_stop_inside_steps(named, version, step):
    """The length reaches 10.75 m after 0.375 s, the luff angle 0.9 rad after about 1.15 s, wherever steps end."""
    with Instance(named(version, "BoomCrane"), "CoSimulation") as instance:
        instance.initialize(LIMITS, {"hoist.rate": 2.0, "luff.rate": 0.1}, tolerance=1e-10)
        for k in range(round(2.0 / step)):
            instance.api.doStep(k * step, step)
            time = (k + 1) * step
            luff, length, at_limit = values(instance)
            assert length == pytest.approx(min(10.0 + 2.0 * time, 10.75), abs=1e-12)
            assert luff == pytest.approx(min(0.7853981633974483 + 0.1 * time, 0.9), abs=1e-12)
            assert bool(at_limit) == (time >= 0.375)
        # Back from one stop and down to the other; the boom stays at its own while its rate points there.
        instance.set({"hoist.rate": -1.0})
        for k in range(round(4.0 / step)):
            instance.api.doStep(2.0 + k * step, step)
            luff, length, at_limit = values(instance)
            assert length == pytest.approx(max(10.75 - (k + 1) * step, 8.0), abs=1e-12)
            assert luff == 0.9 and at_limit
        instance.set({"hoist.rate": 0.5, "luff.rate": -0.05})
        instance.api.doStep(6.0, step)
        luff, length, at_limit = values(instance)
        assert (luff, length) == pytest.approx((0.9 - 0.05 * step, 8.0 + 0.5 * step), abs=1e-12)
        assert not at_limit


@pytest.mark.parametrize("version", ["fmi2", "fmi3"])
def test_joints_stop_in_model_exchange(named, version):
    """Each stop is a state event."""
    with Instance(named(version, "BoomCrane"), "ModelExchange") as instance:
        instance.initialize(LIMITS, {"hoist.rate": 2.0, "luff.rate": 0.1})
        instance.update()
        events = exchange(instance, 2.0, solver(instance, 1e-12), 0.0)
        assert events == pytest.approx([0.375, (0.9 - 0.7853981633974483) / 0.1], abs=1e-9)
        luff, length, at_limit = values(instance)
        assert (luff, length) == (0.9, 10.75) and at_limit


@pytest.mark.parametrize("version", ["fmi2", "fmi3"])
def test_a_start_beyond_a_limit_is_refused_by_name(named, version):
    """At the end of initialization."""
    with Instance(named(version, "BoomCrane"), "CoSimulation") as instance:
        with pytest.raises(Exception):
            instance.initialize({**LIMITS, "luff.angle": 1.0}, {})
        assert "luff.angle is 1" in str(instance.messages[-1][1]), instance.messages


@pytest.mark.parametrize("rate", [0.7, 2.0, 30.0])
def test_the_cable_stays_a_cable(named, rate):
    """Two minutes of slewing, gently or beyond all measure: the direction to the payload stays a unit vector."""
    crane = named("fmi3", "BoomCrane")
    with Instance(crane, "CoSimulation") as instance:
        instance.initialize({}, {"slew.rate": rate})
        for k in range(1200):
            instance.api.doStep(k * 0.1, 0.1)
        direction = instance.get([crane.variables["cable.direction"]]).values()
        assert sum(component**2 for component in direction) == pytest.approx(1.0, abs=1e-5)
