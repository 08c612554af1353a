"""What the libraries themselves answer to calls that the harness would never make."""

import ctypes

import pytest
from fmpy.fmi1 import FMICallException
from host import FLOATS, STEP, Instance, sequence
from test_versions import assert_same

DISCARD, ERROR = 2, 3
OUT_OF_RANGE = [float("nan"), float("inf"), -float("inf")]


def status(call, *arguments):
    """The status that a call of FMPy's bindings ends with."""
    try:
        call(*arguments)
    except FMICallException as failure:
        return failure.status
    return 0


def texts(instance):
    """All messages so far, as one text."""
    return "\n".join(text.decode() if isinstance(text, bytes) else str(text) for _, text in instance.messages)


def test_no_step_after_terminate(fmu):
    """Error with a message; values can still be read, and a reset gives a fresh instance."""
    with Instance(fmu, "CoSimulation") as instance:
        instance.initialize(fmu.with_files({}), {})
        instance.api.doStep(0.0, 0.1)
        instance.api.terminate()
        before = instance.get(fmu.observed())
        assert status(instance.api.doStep, 0.1, 0.1) == ERROR
        assert "DoStep" in texts(instance)
        assert instance.get(fmu.observed()) == before
        instance.api.reset()
        instance.initialize(fmu.with_files({}), {})
        instance.api.doStep(0.0, 0.1)


@pytest.mark.parametrize("bad", OUT_OF_RANGE)
def test_a_step_with_an_infinite_input_is_discarded_and_can_be_repeated(fmu, bad):
    """Discard, a message that names the input, and an instance as if nothing had happened."""
    # FMPy keeps one logger for all instances of FMI 2.0, so there is one instance at a time.
    with Instance(fmu, "CoSimulation") as unharmed:
        unharmed.initialize(fmu.with_files({}), {})
        unharmed.api.doStep(0.0, 0.5)
        unharmed.api.doStep(0.5, 0.5)
        wanted = unharmed.get(fmu.observed())
    for v in (v for v in fmu.inputs if v.type in FLOATS and not v.shape):
        with Instance(fmu, "CoSimulation", logging=True) as instance:
            instance.initialize(fmu.with_files({}), {})
            instance.api.doStep(0.0, 0.5)
            instance.set({v.name: bad})
            assert status(instance.api.doStep, 0.5, 0.5) == DISCARD
            assert v.name in texts(instance)
            if fmu.is_fmi2:
                time = ctypes.c_double()
                instance.api.fmi2GetRealStatus(instance.api.component, 2, ctypes.byref(time))
                assert time.value == 0.5
            instance.set({v.name: float(v.start or 0.0)})
            instance.api.doStep(0.5, 0.5)
            assert instance.get(fmu.observed()) == wanted, v.name


def test_derivatives_with_an_infinite_input_are_discarded(fmu):
    """In model exchange the derivatives return Discard and name the input."""
    n = fmu.description.numberOfContinuousStates
    for v in (v for v in fmu.inputs if v.type in FLOATS and not v.shape and v.variability == "continuous" and n):
        with Instance(fmu, "ModelExchange", logging=True) as instance:
            instance.initialize(fmu.with_files({}), {})
            instance.update()
            instance.set({v.name: float("nan")})
            api = instance.api
            derivatives = api.getDerivatives if fmu.is_fmi2 else api.getContinuousStateDerivatives
            assert status(derivatives, (ctypes.c_double * n)(), n) == DISCARD
            assert v.name in texts(instance)


def test_parameters_out_of_range_are_refused_by_name(fmu):
    """Every float parameter with a bound, beyond it; initialization says which."""
    for v in fmu.variables.values():
        if v.causality != "parameter" or v.type not in FLOATS or v.shape:
            continue
        beyond = [float("nan")]
        beyond += [float(v.min) - 1.0] if v.min is not None else []
        beyond += [float(v.max) + 1.0] if v.max is not None else []
        for value in beyond:
            with Instance(fmu, "CoSimulation") as instance:
                assert status(instance.initialize, {**fmu.with_files({}), v.name: value}, {}) >= DISCARD, v.name
                assert v.name in texts(instance), f"{v.name} = {value}: {texts(instance)}"


def test_fixed_parameters_do_not_change_after_initialization(fmu):
    """Error, and the value stays."""
    for v in fmu.variables.values():
        if v.causality == "parameter" and v.variability == "fixed" and v.type in FLOATS and not v.shape:
            with Instance(fmu, "CoSimulation") as instance:
                instance.initialize(fmu.with_files({}), {})
                before = instance.get([v])
                assert status(instance.set, {v.name: before[v.name] + 1.0}) == ERROR
                assert instance.get([v]) == before


def test_instances_are_independent(fmu):
    """Two instances, stepped in turns with different inputs, do not know each other."""
    def run(shifts, instances):
        rows = [[] for _ in instances]
        for k in range(40):
            for i, instance in enumerate(instances):
                if k % 10 == 0:
                    instance.set(sequence(fmu, k // 10 + shifts[i]))
                instance.api.doStep(k * STEP, (k + 1) * STEP - k * STEP)
                rows[i].append(instance.get(fmu.observed()))
        return rows

    alone = []
    for shift in (0, 3):
        with Instance(fmu, "CoSimulation") as instance:
            instance.initialize(fmu.with_files({}), {})
            alone += run([shift], [instance])
    with Instance(fmu, "CoSimulation") as a, Instance(fmu, "CoSimulation") as b:
        a.initialize(fmu.with_files({}), {})
        b.initialize(fmu.with_files({}), {})
        together = run([0, 3], [a, b])
    assert_same(alone[0], together[0])
    assert_same(alone[1], together[1])
