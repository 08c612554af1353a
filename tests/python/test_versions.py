"""FMI 2.0 and FMI 3.0 wrap the same model: co-simulation gives the same bits, and so does an instance after a reset."""

import struct

import pytest
from host import Instance, co_simulate


def bits(value):
    """A value so that equality is equality of bits."""
    return struct.pack("<d", value) if isinstance(value, float) else value


def assert_same(a, b):
    """Both recordings hold the same bits."""
    assert len(a) == len(b) > 1
    for k, (left, right) in enumerate(zip(a, b)):
        assert left.keys() == right.keys()
        for name, value in left.items():
            assert bits(value) == bits(right[name]), f"{name} after {k} steps: {value!r} and {right[name]!r}"


def stepped(fmu, parameters):
    """A recording of a fresh instance."""
    with Instance(fmu, "CoSimulation") as instance:
        return co_simulate(instance, fmu.with_files(parameters))


def test_both_versions_give_the_same_bits(both):
    """The same inputs, the same bits in every output and local variable."""
    fmi2, fmi3, parameters = both
    rows = stepped(fmi2, parameters)
    assert_same(rows, stepped(fmi3, parameters))
    assert any(row != rows[0] for row in rows) or not rows[0] or not fmi2.inputs, "nothing moves"


def test_reset_gives_a_fresh_instance(case):
    """A run, a reset and a second run with other parameters gives what a fresh instance gives."""
    fmu, parameters = case
    fresh = stepped(fmu, parameters)
    with Instance(fmu, "CoSimulation") as instance:
        co_simulate(instance, fmu.with_files({}), stop=2.0)
        instance.api.reset()
        assert_same(fresh, co_simulate(instance, fmu.with_files(parameters)))


@pytest.mark.parametrize("steps", [0, 7])
def test_reset_works_in_the_middle_of_a_run(fmu, steps):
    """Reset is allowed in every state, not only after terminate."""
    fresh = stepped(fmu, {})
    with Instance(fmu, "CoSimulation") as instance:
        instance.initialize(fmu.with_files({}), {})
        for k in range(steps):
            instance.api.doStep(k * 0.1, 0.1)
        instance.api.reset()
        assert_same(fresh, co_simulate(instance, fmu.with_files({})))
