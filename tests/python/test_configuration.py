"""Structural parameters of FMI 3.0: arrays of another length, before and while the simulation runs."""

from ctypes import c_int64, c_size_t, c_uint32, c_uint64

import pytest
from host import FLOATS, STEP
from raw import DISCARD, ERROR, OK, Library, Raw


def structural(fmu):
    """The structural parameters."""
    return [v for v in fmu.variables.values() if v.causality == "structuralParameter"]


def sized(fmu, parameter):
    """The arrays whose length a structural parameter sets."""
    return [v for v in fmu.variables.values() if any(d.variable is parameter for d in v.dimensions)]


def resize(instance, parameter, length):
    """The status of setting a length."""
    reference = (c_uint32 * 1)(parameter.valueReference)
    return instance.call("SetUInt64", reference, c_size_t(1), (c_uint64 * 1)(length), c_size_t(1))


def length(instance, parameter):
    """A length as the instance has it."""
    value = (c_uint64 * 1)()
    reference = (c_uint32 * 1)(parameter.valueReference)
    assert instance.call("GetUInt64", reference, c_size_t(1), value, c_size_t(1)) == OK
    return value[0]


def read(instance, variable, count):
    """A status, and the elements of an array of numbers."""
    values = (instance.ctype(variable)[1] * count)()
    return instance.access("Get", variable, values), list(values)


def configured(library, parameter, wanted, kind="CoSimulation"):
    """An instance with arrays of this length."""
    instance = Raw(library, kind)
    assert instance.call("EnterConfigurationMode") == OK
    assert resize(instance, parameter, wanted) == OK, instance.texts()
    assert instance.call("ExitConfigurationMode") == OK
    assert instance.initialize() == OK, instance.texts()
    assert length(instance, parameter) == wanted
    return instance


def test_without_structural_parameters_there_is_no_configuration(fmu):
    """The mode is refused, before and after initialization."""
    if fmu.is_fmi2 or structural(fmu):
        return
    with Library(fmu) as library:
        for initialized in (False, True):
            with Raw(library, "CoSimulation") as instance:
                assert not initialized or instance.initialize() == OK
                assert instance.call("EnterConfigurationMode") == ERROR
                assert "structural parameter" in instance.texts()


@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
def test_arrays_have_the_length_that_was_set(fmu, kind):
    """Every length from the least to the greatest: as many elements, no more and no less; reset gives the default."""
    for parameter in structural(fmu):
        least, most, default = int(parameter.min), int(parameter.max), int(parameter.start)
        assert sized(fmu, parameter)
        for wanted in {least, default, most}:
            with Library(fmu) as library, configured(library, parameter, wanted, kind) as instance:
                for v in sized(fmu, parameter):
                    assert read(instance, v, wanted)[0] == OK
                if kind == "CoSimulation":
                    for k in range(20):
                        assert instance.step(k * STEP) == OK, instance.texts()
                for v in sized(fmu, parameter):
                    assert read(instance, v, wanted)[0] == OK
                wrong = wanted + 1 if wanted < most else wanted - 1
                assert read(instance, v, wrong)[0] == ERROR and "values" in instance.texts()
                assert instance.call("Reset") == OK
                assert instance.initialize() == OK and length(instance, parameter) == default


def test_lengths_out_of_range_are_refused_by_name(fmu):
    """Discarded; the length is what it was."""
    for parameter in structural(fmu):
        for wrong in (int(parameter.min) - 1, int(parameter.max) + 1, 2**40):
            with Library(fmu) as library, Raw(library, "CoSimulation", logging=True) as instance:
                assert instance.call("EnterConfigurationMode") == OK
                assert resize(instance, parameter, wrong) == DISCARD
                assert parameter.name in instance.texts()
                assert instance.call("ExitConfigurationMode") == OK
                assert instance.initialize() == OK and length(instance, parameter) == int(parameter.start)


def test_everything_has_its_mode(fmu):
    """Structural parameters are set in Configuration Mode, and nothing else is."""
    for parameter in structural(fmu):
        others = [v for v in fmu.variables.values() if v.causality == "parameter" and v.type in FLOATS]
        with Library(fmu) as library:
            with Raw(library, "CoSimulation") as instance:
                assert resize(instance, parameter, int(parameter.min)) == ERROR and parameter.name in instance.texts()
            with Raw(library, "CoSimulation") as instance:
                assert instance.call("EnterConfigurationMode") == OK
                assert instance.set({others[0].name: [float(start) for start in str(others[0].start).split()]}) == ERROR
            with Raw(library, "CoSimulation") as instance:
                assert instance.call("EnterConfigurationMode") == OK
                assert instance.call("EnterInitializationMode") == ERROR
            with Raw(library, "CoSimulation") as instance:
                assert instance.initialize() == OK
                reference = (c_uint32 * 1)(parameter.valueReference)
                assert instance.call("GetInt64", reference, c_size_t(1), (c_int64 * 1)(), c_size_t(1)) == ERROR


@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
def test_tunable_lengths_change_while_the_simulation_runs(fmu, kind):
    """From step mode or event mode and back; a state of another length is taken and restored."""
    for parameter in [v for v in structural(fmu) if v.variability == "tunable"]:
        least, most = int(parameter.min), int(parameter.max)
        with Library(fmu) as library, configured(library, parameter, least, kind) as instance:
            if kind == "CoSimulation":
                assert instance.step(0.0) == OK
            status, state = instance.take()
            assert status == OK
            for wanted in (most, least, most):
                assert instance.call("EnterConfigurationMode") == OK, instance.texts()
                assert resize(instance, parameter, wanted) == OK
                assert instance.call("ExitConfigurationMode") == OK
                for v in sized(fmu, parameter):
                    assert read(instance, v, wanted)[0] == OK
                if kind == "ModelExchange":
                    assert instance.update() == OK
            if kind == "CoSimulation":
                assert instance.step(STEP) == OK
            assert instance.restore(state) == OK and instance.release(state) == OK
            for v in sized(fmu, parameter):
                assert read(instance, v, least)[0] == OK
                assert read(instance, v, most)[0] == ERROR



def test_a_window_of_one_sample_holds_the_last_one(named):
    """The one FMU that has such an array, for what it means: the mean of one sample is that sample."""
    fmu = named("fmi3", "SampledMean")
    parameter = fmu.variables["window"]
    with Library(fmu) as library, configured(library, parameter, 1) as instance:
        for k in range(30):
            assert instance.set({"signal": float(k)}) == OK
            assert instance.step(k * STEP) == OK
            mean, last = read(instance, fmu.variables["mean"], 1), read(instance, fmu.variables["history"], 1)
            assert mean == last and abs(mean[1][0] - k) < 2.0
        assert mean[1][0] > 20.0
