"""An `InputShaper` drives a lightly damped mode of its design frequency.

The mode is solved exactly: a jump Δ of the pivot's velocity at t_i answers as Δ·exp(−ζω(t − t_i))·sin(ω_d (t − t_i)), so
that what remains behind the last jump is the sum of phasors Δ_i·exp((ζω + iω_d) t_i) (eq. 5.7, and thesis 1.2).
"""

import numpy as np
import pytest
from host import Instance

MODES = [(0.99, 0.0), (2.3, 0.0), (1.7, 0.08)]
"""Frequencies (rad/s) and damping ratios."""
AT = 0.3
"""When the command steps (s)."""
KINDS = {
    "ZV": (2, 0.0),
    "ZVD": (3, 0.0),
    "ZVDD": (4, 0.0),
    "ZVDDD": (5, 0.0),
    "EI": (3, 0.05),
    "TwoHumpEI": (4, 0.0),
    "ThreeHumpEI": (5, 0.05),
    "UMZV": (3, 0.0),
    "UMZVD": (5, 0.0),
    "UMEI": (5, 0.05),
}
"""How many impulses a kind has, and what it leaves at the design frequency."""


def parameters(fmu, kind, *modes):
    """A shaper of this kind for one or two modes: frequencies and damping ratios."""
    items = fmu.variables["kind"].declaredType.items
    chosen = {"kind": next(int(item.value) for item in items if item.name == kind)}
    values = np.zeros((2, 2))
    values[: len(modes)] = modes
    for name, pair in zip(["mode.frequency", "mode.damping_ratio"], values.T.tolist()):
        if name in fmu.variables:
            chosen[name] = pair
        else:
            chosen |= {f"{name}[{i + 1}]": value for i, value in enumerate(pair)}
    return chosen


def residual(times, values, frequency, ratio):
    """What swing remains of a signal's jumps behind the last, as part of what a jump to its last value leaves there."""
    jumps, at = np.diff(values), np.array(times[1:])
    root = frequency * (ratio + 1j * np.sqrt(1.0 - ratio**2))
    return abs(np.sum(jumps * np.exp(root * (at - at[-1])))) / abs(values[-1])


def by_events(fmu, kind, *modes, height=0.8):
    """The shaped signal of a step by model exchange: its instants and values."""
    shaped = [fmu.variables["shaped"]]
    with Instance(fmu, "ModelExchange") as instance:
        instance.initialize(parameters(fmu, kind, *modes), {"command": 0.0})
        instance.update()
        times, values = [0.0], [instance.get(shaped)["shaped"]]
        time, command = AT, {"command": height}
        while True:
            instance.api.setTime(time)
            instance.api.enterEventMode()
            instance.set(command)
            instance.update()
            times.append(time)
            values.append(instance.get(shaped)["shaped"])
            command = {}
            if instance.next_event is None or instance.next_event > 100.0:
                return times, values
            assert instance.next_event > time
            time = instance.next_event


@pytest.mark.parametrize("version", ["fmi2", "fmi3"])
@pytest.mark.parametrize("frequency, ratio", MODES)
@pytest.mark.parametrize("kind", KINDS)
def test_a_shaped_step_leaves_what_its_kind_says(named, version, kind, frequency, ratio):
    """In model exchange impulses fall at their exact times: what is left is to 1e-9 of the unshaped residual what is meant."""
    times, values = by_events(named(version, "InputShaper"), kind, (frequency, ratio))
    left = residual(times, values, frequency, ratio)
    print(f"{len(times) - 1} impulses, residual {left:.1e} of unshaped", end=" ")
    count, meant = KINDS[kind]
    assert values[0] == 0.0
    assert values[-1] == 0.8
    assert len(times) - 1 == count
    assert left == pytest.approx(meant, abs=1e-9)


@pytest.mark.parametrize("version", ["fmi2", "fmi3"])
@pytest.mark.parametrize("ratio", [0.0, 0.08])
def test_specified_insensitivity_holds_its_limit_over_its_range(named, version, ratio):
    """5 % within 20 % of the design frequency to either side, which are the start values, and not much beyond."""
    times, values = by_events(named(version, "InputShaper"), "SI", (1.7, ratio))
    left = [residual(times, values, 1.7 * share, ratio) for share in np.linspace(0.8, 1.2, 401)]
    assert max(left) == pytest.approx(0.05, abs=1e-6)
    assert residual(times, values, 1.7 * 0.79, ratio) > 0.05


@pytest.mark.parametrize("version", ["fmi2", "fmi3"])
@pytest.mark.parametrize("kind, count", [("Convolved", 4), ("MinimumImpulse", 3)])
@pytest.mark.parametrize("modes", [[(1.0, 0.0), (2.7, 0.0)], [(6.3, 0.02), (1.9, 0.01)]])
def test_two_modes_are_left_without_vibration(named, version, kind, count, modes):
    """Whichever is the slower one, and with a damping ratio each."""
    times, values = by_events(named(version, "InputShaper"), kind, *modes)
    assert len(times) - 1 == count
    for frequency, ratio in modes:
        assert residual(times, values, frequency, ratio) < 1e-9


@pytest.mark.parametrize("version", ["fmi2", "fmi3"])
def test_no_shaping_leaves_all(named, version):
    """The measure measures: an unshaped step leaves 1."""
    times, values = by_events(named(version, "InputShaper"), "None", (1.3, 0.0))
    assert residual(times, values, 1.3, 0.0) == pytest.approx(1.0, abs=1e-12)


@pytest.mark.parametrize("version", ["fmi2", "fmi3"])
def test_co_simulation_shapes_up_to_its_step_size(named, version):
    """In co-simulation an impulse shows at the end of its step; the error of its time is at most the step size."""
    fmu, frequency = named(version, "InputShaper"), 0.99
    shaped = [fmu.variables["shaped"]]
    for step in [0.1, 0.05, 0.02, 0.01, 0.005]:
        with Instance(fmu, "CoSimulation") as instance:
            instance.initialize(parameters(fmu, "ZV", (frequency, 0.0)), {"command": 0.0})
            times, values = [0.0], [instance.get(shaped)["shaped"]]
            for k in range(round(8.0 / step)):
                if k == round(AT / step):
                    instance.set({"command": 0.8})
                instance.api.doStep(k * step, (k + 1) * step - k * step)
                times.append((k + 1) * step)
                values.append(instance.get(shaped)["shaped"])
        left = residual(times, values, frequency, 0.0)
        print(f"\nstep size {step} s: residual {left:.1e} of unshaped", end=" ")
        assert values[-1] == pytest.approx(0.8, abs=1e-15)
        # Each half comes late by at most a step: |1/2 − 1/2·exp(iωh)| < ωh/2.
        assert left <= 0.5 * frequency * step
