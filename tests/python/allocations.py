"""Steps every FMU with a counting allocator preloaded; writes what was counted to stdout, for test_allocations.py."""

import ctypes
import json
import sys
import tempfile
from ctypes import c_bool, c_char, c_double, c_long, c_size_t, c_uint32, c_void_p
from pathlib import Path

from host import HOLD, STEP, Fmu, sequence
from raw import OK, Library, Raw

STEPS = 200
shim = ctypes.CDLL(None)


def function(instance, name):
    """The address of a function of the FMU."""
    return ctypes.cast(getattr(instance.dll, instance.prefix + name), c_void_p)


def counted_call(instance, name, *arguments):
    """How often a call allocates or frees; its arguments are pointers and lengths."""
    count = c_long()
    given = [ctypes.cast(a, c_void_p) if not isinstance(a, c_size_t) else c_void_p(a.value) for a in arguments]
    given += [c_void_p()] * (6 - len(given))
    pointer = c_void_p(instance.pointer)
    status = shim.counted_call(function(instance, name), pointer, *given, ctypes.byref(count))
    assert status == OK, (name, instance.messages)
    return count.value


def steps(instance):
    """How often each step allocates or frees; inputs change on the way."""
    flags, last, count = (c_char * 3)(), c_double(), c_long()
    found = []
    for k in range(STEPS):
        if k % HOLD == 0:
            assert instance.set(sequence(instance.fmu, k // HOLD)) == OK
        size = c_double((k + 1) * STEP - k * STEP)
        pointer, time = c_void_p(instance.pointer), c_double(k * STEP)
        step = function(instance, "DoStep")
        status = shim.counted_step(step, pointer, time, size, flags, ctypes.byref(last), ctypes.byref(count))
        assert status == OK, instance.messages
        found.append(count.value)
    return found


def accesses(instance):
    """How often setting and reading all floats allocates or frees."""
    kind = "Real" if instance.fmu.is_fmi2 else "Float64"
    found = []
    for v in instance.fmu.variables.values():
        if v.type != kind or v.shape or v.causality not in ("input", "output", "local"):
            continue
        reference, place, one = (c_uint32 * 1)(v.valueReference), (c_double * 1)(), c_size_t(1)
        sizes = [] if instance.fmu.is_fmi2 else [one]
        found.append(counted_call(instance, "Get" + kind, reference, one, place, *sizes))
        if v.causality == "input":
            place[0] += 1e-3
            found.append(counted_call(instance, "Set" + kind, reference, one, place, *sizes))
    return found


def evaluations(instance):
    """How often derivatives and indicators allocate or free, at states that change."""
    fmu, found = instance.fmu, []
    n, m = fmu.description.numberOfContinuousStates, fmu.description.numberOfEventIndicators
    x, dx, z = (c_double * n)(), (c_double * n)(), (c_double * m)()
    derivatives = "GetDerivatives" if fmu.is_fmi2 else "GetContinuousStateDerivatives"
    for _ in range(10):
        found.append(counted_call(instance, "GetContinuousStates", x, c_size_t(n)))
        for i in range(n):
            x[i] += 1e-3
        found.append(counted_call(instance, "SetContinuousStates", x, c_size_t(n)))
        found.append(counted_call(instance, derivatives, dx, c_size_t(n)))
        found.append(counted_call(instance, "GetEventIndicators", z, c_size_t(m)))
    return found


def ticks(instance):
    """How often the ticks of clocks and the events they belong to allocate or free."""
    found = []
    for k in range(STEPS):
        assert instance.set(sequence(instance.fmu, k // HOLD)) == OK
        for clock in instance.fmu.clocks:
            if clock.causality == "input":
                reference, active = (c_uint32 * 1)(clock.valueReference), ctypes.byref(c_bool(True))
                found.append(counted_call(instance, "SetClock", reference, c_size_t(1), active))
        flags, due = [ctypes.byref(c_bool()) for _ in range(5)], ctypes.byref(c_double())
        found.append(counted_call(instance, "UpdateDiscreteStates", *flags, due))
        assert (instance.call("EnterStepMode"), instance.call("EnterEventMode")) == (OK, OK)
    return found


def measure(fmu, library):
    """What was counted, by the name of the case."""
    label = f"{fmu.path.parent.name}/{fmu.path.stem}"
    if fmu.clocks:
        with Raw(library, "CoSimulation", event_mode=True) as instance:
            assert instance.initialize() == OK
            yield f"{label} steps", ticks(instance)
        return
    for variant in fmu.variants():
        label = f"{fmu.path.parent.name}/{fmu.path.stem} {variant or ''}"
        with Raw(library, "CoSimulation") as instance:
            assert instance.initialize(variant) == OK, instance.messages
            yield f"{label} steps", steps(instance)
            yield f"{label} accesses", accesses(instance)
            # The control: a state that is taken must be put somewhere.
            state = c_void_p()
            name = "GetFMUstate" if fmu.is_fmi2 else "GetFMUState"
            yield f"{label} state", [counted_call(instance, name, ctypes.byref(state))]
            instance.release(state)
        with Raw(library, "ModelExchange") as instance:
            assert (instance.initialize(variant), instance.update()) == (OK, OK)
            assert instance.call("EnterContinuousTimeMode") == OK
            yield f"{label} evaluations", evaluations(instance)


def main():
    """All archives named on the command line."""
    found = {}
    with tempfile.TemporaryDirectory() as folder:
        for i, path in enumerate(sys.argv[1:]):
            fmu = Fmu(path, Path(folder, str(i)))
            with Library(fmu) as library:
                found |= measure(fmu, library)
    json.dump(found, sys.stdout)


if __name__ == "__main__":
    main()
