"""A state that was taken goes on to the same bits: in the same instance, in another one, and in another process."""

import json
import subprocess
import sys
from pathlib import Path

import pytest
from host import HOLD, STEP, Instance, sequence

TAKEN = 63
"""The step after which the state is taken: inputs have changed, and trains, limiters and swing are under way."""
MORE = 80
"""The steps that follow."""
RESUME = Path(__file__).parent / "resume.py"


def steps(instance, first, count):
    """Takes steps and returns the bits of everything observed after each."""
    observed = instance.fmu.observed()
    seen = []
    for k in range(first, first + count):
        if k % HOLD == 0:
            instance.set(sequence(instance.fmu, k // HOLD))
        instance.api.doStep(k * STEP, (k + 1) * STEP - k * STEP)
        values = instance.get(observed)
        seen.append({name: v.hex() if isinstance(v, float) else str(v) for name, v in values.items()})
    return seen


def under_way(fmu, parameters):
    """An instance after `TAKEN` steps."""
    instance = Instance(fmu, "CoSimulation")
    instance.initialize(fmu.with_files(parameters), sequence(fmu, 0))
    steps(instance, 0, TAKEN)
    return instance


def test_a_state_goes_on_to_the_same_bits(case):
    """Restored twice, and in a second instance from bytes."""
    fmu, parameters = case
    with under_way(fmu, parameters) as instance:
        state = instance.api.getFMUState()
        expected = steps(instance, TAKEN, MORE)
        for _ in range(2):
            instance.api.setFMUState(state)
            assert steps(instance, TAKEN, MORE) == expected
        instance.api.setFMUState(state)
        data = instance.api.serializeFMUState(state)
        instance.api.freeFMUState(state)
        with Instance(fmu, "CoSimulation") as other:
            copy = other.api.deserializeFMUState(data)
            other.api.setFMUState(copy)
            assert other.api.serializeFMUState(copy) == data
            other.api.freeFMUState(copy)
            assert steps(other, TAKEN, MORE) == expected
        assert steps(instance, TAKEN, MORE) == expected, "the other instance has left this one alone"


def test_a_state_keeps_the_pace_of_the_integrator(fmu):
    """In steps that the error control divides, where the next bits depend on the length it has come to."""
    long, observed = 2.0, fmu.observed()

    def go_on(instance, first):
        seen = []
        for k in range(first, first + 4):
            instance.api.doStep(k * long, long)
            seen.append(instance.get(observed))
        return seen

    with Instance(fmu, "CoSimulation") as instance, Instance(fmu, "CoSimulation") as other:
        instance.initialize(fmu.with_files({}), sequence(fmu, 2), tolerance=1e-9)
        go_on(instance, 0)
        state = instance.api.getFMUState()
        data = instance.api.serializeFMUState(state)
        expected = go_on(instance, 4)
        instance.api.setFMUState(state)
        assert go_on(instance, 4) == expected
        instance.api.freeFMUState(state)
        copy = other.api.deserializeFMUState(data)
        other.api.setFMUState(copy)
        other.api.freeFMUState(copy)
        assert go_on(other, 4) == expected


def test_a_state_goes_on_in_another_process(fmu):
    """The bytes say all there is to know."""
    with under_way(fmu, {}) as instance:
        state = instance.api.getFMUState()
        data = instance.api.serializeFMUState(state)
        instance.api.freeFMUState(state)
        expected = steps(instance, TAKEN, MORE)
    task = json.dumps({"fmu": str(fmu.path), "state": data.hex()})
    answer = subprocess.run([sys.executable, RESUME], input=task, capture_output=True, text=True, check=False)
    assert answer.returncode == 0, answer.stderr
    assert json.loads(answer.stdout) == expected


def test_bytes_of_another_fmu_are_refused(fmu, named):
    """The token inside tells."""
    others = ["BoomCrane", "VectorDrive"]
    name = next(name for name in others if name != fmu.path.stem)
    other = named(fmu.path.parent.name, name)
    with Instance(other, "CoSimulation") as stranger:
        data = stranger.api.serializeFMUState(stranger.api.getFMUState())
    with Instance(fmu, "CoSimulation") as instance:
        with pytest.raises(Exception):
            instance.api.deserializeFMUState(data)
        assert any("token" in str(text) for _, text in instance.messages), instance.messages


def test_model_exchange_has_states_too(fmu):
    """The same derivatives and outputs after going back."""
    with Instance(fmu, "ModelExchange") as instance:
        instance.initialize(fmu.with_files({}), sequence(fmu, 1))
        instance.update()
        state = instance.api.getFMUState()
        before = instance.get(fmu.observed())
        instance.api.enterEventMode()
        instance.set(sequence(fmu, 4))
        instance.api.setTime(3.0)
        instance.update()
        instance.api.setFMUState(state)
        assert instance.get(fmu.observed()) == before
        instance.api.freeFMUState(state)
