"""What any host may do to an FMU: many instances, threads, odd locations, calls out of order, inputs without measure."""

import ctypes
import gc
import sys
import threading

import fmpy
import pytest
from host import FLOATS, STEP, Instance, co_simulate, sequence

KINDS = ("CoSimulation", "ModelExchange")
ERROR = 3


def memory():
    """Memory that the process holds (bytes), without the rings of Python objects that nobody has collected yet."""
    gc.collect()
    with open("/proc/self/statm", encoding="ascii") as statm:
        return int(statm.read().split()[1]) * 4096


def one_life(fmu):
    """From instantiation over some steps to its end."""
    with Instance(fmu, "CoSimulation") as instance:
        instance.initialize(fmu.with_files({}), sequence(fmu, 0))
        for k in range(5):
            instance.api.doStep(k * STEP, STEP)
        instance.api.terminate()


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="memory is read from /proc")
def test_a_thousand_instances_leave_nothing_behind(fmu):
    """An instance of ours is some kilobytes: a thousand leaked ones would be megabytes."""
    for _ in range(100):
        one_life(fmu)
    grown = []
    while not grown or min(grown) >= 500_000 and len(grown) < 3:
        # The allocator may grow once for reasons of its own; a leak grows every time.
        before = memory()
        for _ in range(1000):
            one_life(fmu)
        grown.append(memory() - before)
    assert min(grown) < 500_000, grown


def test_instances_on_threads_equal_one_alone(fmu):
    """The same bits, whoever else steps at the same time."""
    runs = {}

    def run(key):
        with Instance(fmu, "CoSimulation") as instance:
            runs[key] = co_simulate(instance, fmu.with_files({}), stop=3.0)

    run("alone")
    threads = [threading.Thread(target=run, args=(i,)) for i in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(runs) == 5 and all(rows == runs["alone"] for rows in runs.values())


def test_both_interfaces_live_side_by_side(fmu):
    """Co-simulation is not moved by model exchange beside it, nor by instances that come and go."""
    with Instance(fmu, "CoSimulation") as instance:
        expected = co_simulate(instance, fmu.with_files({}), stop=1.0)
    with Instance(fmu, "ModelExchange") as other, Instance(fmu, "CoSimulation") as instance:
        other.initialize(fmu.with_files({}), sequence(fmu, 3))
        other.update()
        assert co_simulate(instance, fmu.with_files({}), stop=1.0) == expected


@pytest.mark.parametrize("location", [None, "", "file:/nowhere", "file:////no%20where/resources", "/nowhere", "/nowhere/"])
def test_any_location_of_resources_will_do(fmu, location):
    """The FMUs have no resources of their own, so that nothing can be missing there."""
    text = None if location is None else location.encode()
    library = fmpy.simulation.instantiate_fmu(fmu.folder, fmu.description, "CoSimulation")
    token = fmu.description.guid if fmu.is_fmi2 else fmu.description.instantiationToken
    name = ctypes.create_string_buffer(b"made")
    if fmu.is_fmi2:
        callbacks = fmpy.fmi2.fmi2CallbackFunctions()
        instance = library.fmi2Instantiate(name, 1, token.encode(), text, ctypes.byref(callbacks), 0, 0)
    else:
        none = [fmpy.fmi3.fmi3LogMessageCallback(), fmpy.fmi3.fmi3IntermediateUpdateCallback()]
        instance = library.fmi3InstantiateCoSimulation(
            name, token.encode(), text, False, False, False, False, None, 0, None, *none
        )
    assert instance
    # The name was copied.
    name.value = b"gone"
    free = library.dll.fmi2FreeInstance if fmu.is_fmi2 else library.dll.fmi3FreeInstance
    free.argtypes, free.restype = [ctypes.c_void_p], None
    free(instance)
    free(None)
    # FMPy unloads the library with this.
    library.freeInstance()


def statuses(instance):
    """The functions of FMPy without its exceptions: what they return."""
    version = "fmi2" if instance.fmu.is_fmi2 else "fmi3"
    component = ctypes.c_void_p(instance.api.component)

    def call(name, *arguments):
        function = getattr(instance.api.dll, version + name)
        function.restype = ctypes.c_int
        return function(component, *arguments)

    return call


def out_of_order(fmu, kind):
    """Calls that are wrong right after instantiation, and those that are wrong after initialization."""
    d = ctypes.c_double
    if fmu.is_fmi2:
        step = ("DoStep", d(0.0), d(STEP), 1)
        enter = ("EnterInitializationMode",)
    else:
        flags = [ctypes.byref(ctypes.c_bool()) for _ in range(3)]
        step = ("DoStep", d(0.0), d(STEP), True, *flags, ctypes.byref(d()))
        enter = ("EnterInitializationMode", False, d(0.0), d(0.0), False, d(0.0))
    early = [("ExitInitializationMode",), ("Terminate",), ("EnterEventMode",), ("EnterContinuousTimeMode",), step]
    late = [enter, ("ExitInitializationMode",)]
    late += [("EnterEventMode",), ("EnterContinuousTimeMode",)] if kind == "CoSimulation" else [step]
    return early, late


@pytest.mark.parametrize("kind", KINDS)
def test_calls_out_of_order_are_errors_and_reset_mends_them(fmu, kind):
    """Refused with Error, logged, and nothing but the reset goes on."""
    early, late = out_of_order(fmu, kind)
    for wrong, initialized in [(call, False) for call in early] + [(call, True) for call in late]:
        if kind == "ModelExchange" and initialized and wrong[0] in ("EnterContinuousTimeMode",):
            continue
        with Instance(fmu, kind) as instance:
            if initialized:
                instance.initialize(fmu.with_files({}), sequence(fmu, 0))
            assert statuses(instance)(*wrong) == ERROR, wrong[0]
            assert instance.messages and wrong[0] in str(instance.messages[-1][1]), wrong[0]
            assert statuses(instance)("Terminate") == ERROR
            instance.api.reset()
            instance.initialize(fmu.with_files({}), sequence(fmu, 0))


def test_an_unknown_variable_is_an_error(fmu):
    """Read and written, far behind the last and at the end of the numbers."""
    for reference in (100_000, 2**32 - 1):
        for verb in ("Get", "Set"):
            with Instance(fmu, "CoSimulation") as instance:
                instance.initialize(fmu.with_files({}), sequence(fmu, 0))
                with pytest.raises(Exception):
                    values = [0.0] if verb == "Set" else []
                    name = "Real" if fmu.is_fmi2 else "Float64"
                    getattr(instance.api, verb.lower() + name)([reference], *([values] if values else []))
                assert str(reference) in str(instance.messages[-1][1])


@pytest.mark.parametrize("size", [1e308, -1e308, 1e12, 5e-324, -0.0])
def test_any_finite_input_is_survived(fmu, size):
    """A step of finite inputs never fails, and what comes out is finite."""
    inputs = [v for v in fmu.inputs if v.type in FLOATS and not v.shape]
    for v in inputs:
        with Instance(fmu, "CoSimulation") as instance:
            instance.initialize(fmu.with_files({}), sequence(fmu, 0))
            for k in range(4):
                instance.set({v.name: size if k < 2 else 0.0})
                instance.api.doStep(k * STEP, (k + 1) * STEP - k * STEP)
            values = instance.get([o for o in fmu.observed() if o.type in FLOATS])
            assert all(abs(value) < float("inf") for value in values.values()), v.name
