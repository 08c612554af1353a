"""Arguments as bad as C allows: NULL, no elements behind dangling pointers, sizes that do not fit, no instance at all."""

import ctypes
from ctypes import c_bool, c_double, c_int, c_int32, c_size_t, c_uint32, c_void_p

import pytest
from host import STEP, sequence
from raw import ERROR, OK, TYPES2, TYPES3, Library, Raw

DANGLING = c_void_p(4)
NAMES = "../data/fmi_functions.txt"
MADE = ("GetTypesPlatform", "GetVersion", "Instantiate", "FreeInstance")
"""Functions that need no instance."""


def functions(fmu):
    """The names of a version's functions on instances, without their prefix."""
    prefix = "fmi2" if fmu.is_fmi2 else "fmi3"
    with open(NAMES, encoding="ascii") as lines:
        names = [line.strip().removeprefix(prefix) for line in lines if line.startswith(prefix)]
    return [name for name in names if not name.startswith(MADE)]


def test_no_function_needs_an_instance_to_say_no(fmu):
    """Every function of the standard with NULL for all it takes: Error, and the host lives."""
    with Library(fmu) as library:
        prefix = "fmi2" if fmu.is_fmi2 else "fmi3"
        names = functions(fmu)
        assert len(names) == (40 if fmu.is_fmi2 else 70)
        for name in names:
            assert getattr(library.dll, prefix + name)(*[c_void_p(None)] * 10) == ERROR, name
        free = getattr(library.dll, prefix + "FreeInstance")
        free.restype = None
        free(c_void_p(None))


def ready(fmu, kind, library):
    """An instance where values are read and written, and its types of variables."""
    instance = Raw(library, kind)
    assert instance.initialize() == OK
    return instance, (TYPES2 if fmu.is_fmi2 else TYPES3)


def sizes(fmu, n):
    """The last argument of getters and setters of FMI 3.0."""
    return [] if fmu.is_fmi2 else [c_size_t(n)]


@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
def test_arrays_of_no_elements_may_lie_anywhere(fmu, kind):
    """NULL and dangling pointers with a length of 0 are OK in every getter and setter."""
    none = c_size_t(0)
    with Library(fmu) as library:
        instance, types = ready(fmu, kind, library)
        with instance:
            for nowhere in (c_void_p(None), DANGLING):
                for name in types:
                    for verb in ("Get", "Set"):
                        status = instance.call(verb + name, nowhere, none, nowhere, *sizes(fmu, 0))
                        assert status == OK, (verb, name, instance.messages)
                if not fmu.is_fmi2:
                    assert instance.call("GetBinary", nowhere, none, nowhere, nowhere, none) == OK
                    assert instance.call("SetBinary", nowhere, none, nowhere, nowhere, none) == OK
                assert instance.call("SetDebugLogging", c_int(0), none, nowhere) == OK
                derivative = [nowhere, none, nowhere, none, nowhere]
                tail = [nowhere] if fmu.is_fmi2 else [none, nowhere, none]
                assert instance.call("GetDirectionalDerivative", *derivative, *tail) == OK
                if fmu.is_fmi2 and kind == "CoSimulation":
                    assert instance.call("SetRealInputDerivatives", nowhere, none, nowhere, nowhere) == OK
            assert instance.messages == []


def bad_accesses(fmu, instance, types):
    """Getters and setters of one element with an array that is not there, or with sizes that do not fit."""
    one, null = c_size_t(1), c_void_p(None)
    reference = (c_uint32 * 1)(0)
    for name, kind in types.items():
        place = (kind * 4)()
        for verb in ("Get", "Set"):
            yield verb + name, lambda v=verb + name, p=place: instance.call(v, null, one, p, *sizes(fmu, 1))
            yield verb + name, lambda v=verb + name: instance.call(v, reference, one, null, *sizes(fmu, 1))
    if fmu.is_fmi2:
        return
    place = (c_double * 4)()
    for n in (0, 2, 2**60):
        yield f"n = {n}", lambda n=n: instance.call("GetFloat64", reference, one, place, c_size_t(n))


def test_missing_arrays_are_errors(fmu):
    """Error with a message; a reset mends it."""
    with Library(fmu) as library:
        instance, types = ready(fmu, "CoSimulation", library)
        with instance:
            for name, call in list(bad_accesses(fmu, instance, types)):
                del instance.messages[:]
                assert call() == ERROR, name
                assert [message[2] for message in instance.messages] == [ERROR], name
                assert instance.call("Reset") == OK and instance.initialize() == OK


def test_states_that_are_not_there(fmu):
    """NULL where a state, its place, its bytes or its size should be."""
    null = c_void_p(None)
    name = "FMUstate" if fmu.is_fmi2 else "FMUState"
    deserialize = "DeSerialize" if fmu.is_fmi2 else "Deserialize"
    with Library(fmu) as library:
        instance, _ = ready(fmu, "CoSimulation", library)
        with instance:
            _, state = instance.take()
            assert instance.release(c_void_p(None)) == OK
            bad = [
                ("Get" + name, null),
                ("Set" + name, null),
                ("Serialized" + name + "Size", null, ctypes.byref(c_size_t())),
                ("Serialized" + name + "Size", state, null),
                ("Serialize" + name, state, null, c_size_t(instance.size(state)[1])),
                ("Serialize" + name, state, (ctypes.c_byte * 4)(), c_size_t(4)),
                ("Serialize" + name, null, (ctypes.c_byte * 4)(), c_size_t(4)),
                (deserialize + name, null, c_size_t(100), ctypes.byref(c_void_p())),
                (deserialize + name, null, c_size_t(0), ctypes.byref(c_void_p())),
                (deserialize + name, b"not a state at all", c_size_t(18), ctypes.byref(c_void_p())),
                (deserialize + name, DANGLING, c_size_t(0), ctypes.byref(c_void_p())),
            ]
            for call in bad:
                assert instance.call(*call) == ERROR, call[0]
                assert instance.restore(state) == OK
                assert instance.step(0.0) == OK
                assert instance.restore(state) == OK
            assert instance.release(state) == OK


def test_numbers_that_do_not_fit(fmu):
    """Counts of states and indicators that are not the FMU's, times that are none."""
    inf, nan = float("inf"), float("nan")
    n, m = fmu.description.numberOfContinuousStates, fmu.description.numberOfEventIndicators
    place = (c_double * 100)()
    derivatives = "GetDerivatives" if fmu.is_fmi2 else "GetContinuousStateDerivatives"
    names = [(name, n) for name in ("GetContinuousStates", "SetContinuousStates", "GetNominalsOfContinuousStates")]
    names += [(derivatives, n), ("GetEventIndicators", m)]
    with Library(fmu) as library:
        with Raw(library, "ModelExchange") as instance:
            def begin():
                assert (instance.call("Reset"), instance.initialize(), instance.update()) == (OK, OK, OK)
                assert instance.call("EnterContinuousTimeMode") == OK

            for name, count in names:
                for wrong in {count + 1, max(count - 1, 0), 2**60} - {count}:
                    begin()
                    assert instance.call(name, place, c_size_t(wrong)) == ERROR, (name, wrong)
                if count:
                    begin()
                    assert instance.call(name, c_void_p(None), c_size_t(count)) == ERROR, name
            for time in (nan, inf, -inf):
                begin()
                assert instance.call("SetTime", c_double(time)) == ERROR, time
        with Raw(library, "CoSimulation") as instance:
            for time, size in [(0.0, 0.0), (0.0, -STEP), (0.0, nan), (0.0, inf), (nan, STEP), (inf, STEP), (1.0, STEP)]:
                assert (instance.call("Reset"), instance.initialize()) == (OK, OK)
                assert instance.step(time, size) == ERROR, (time, size)
            for frame in ({"start": nan}, {"start": inf}, {"stop": nan}, {"start": 1.0, "stop": 0.5}):
                assert instance.call("Reset") == OK
                assert instance.enter_initialization(**frame) == ERROR, frame


def test_a_host_that_wants_no_answers(fmu):
    """NULL for what FMI 3.0 returns beside the status: the step is taken."""
    if fmu.is_fmi2:
        pytest.skip("FMI 2.0 returns the status only")
    null = c_void_p(None)
    with Library(fmu) as library, Raw(library, "CoSimulation") as instance, Raw(library, "CoSimulation") as other:
        for each in (instance, other):
            assert each.initialize() == OK
        assert instance.call("DoStep", c_double(0.0), c_double(STEP), c_bool(True), null, null, null, null) == OK
        assert other.step(0.0) == OK
        assert instance.get() == other.get()


def test_texts_that_are_not_there(fmu):
    """A NULL among texts is an error; a NULL or unknown category of messages too."""
    texts = [v for v in fmu.variables.values() if v.type == "String" and v.causality == "parameter"]
    with Library(fmu) as library, Raw(library, "CoSimulation") as instance:
        for v in texts:
            assert instance.access("Set", v, (ctypes.c_char_p * 1)(None)) == ERROR
            assert instance.call("Reset") == OK
        for category in (None, b"unknown"):
            assert instance.call("SetDebugLogging", c_int(1), c_size_t(1), (ctypes.c_char_p * 1)(category)) == ERROR
            assert instance.call("Reset") == OK
        assert instance.call("SetDebugLogging", c_int32(1), c_size_t(1), c_void_p(None)) == ERROR
        assert instance.call("Reset") == OK
        assert instance.initialize(inputs=sequence(fmu, 1)) == OK
