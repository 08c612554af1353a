"""The phases of an instance's life, the way from one to the next, and what is seen on it.

Written from the state machines of FMI 2.0.5 (3.2.3, 4.2.4) and FMI 3.0.2 (2.3.1, 3.3, 4.3).
"""

import ctypes
from ctypes import c_bool, c_double, c_int, c_size_t

from host import STEP, sequence
from raw import OK, Raw

LIVES = {
    "CoSimulation": ("Instantiated", "Initialization", "Step", "Terminated"),
    "CoSimulation with events": ("Instantiated", "Initialization", "Event", "Step", "Terminated"),
    "ModelExchange": ("Instantiated", "Initialization", "Event", "Continuous", "Terminated"),
}
"""The phases of each way to live, in order."""


def lives(fmu):
    """The ways to live that an FMU offers: FMI 2.0 knows no event mode in co-simulation."""
    return [life for life in LIVES if life != "CoSimulation with events" or not fmu.is_fmi2]


def made(library, life, **options):
    """A new instance for a way to live."""
    return Raw(library, life.split()[0], event_mode=life == "CoSimulation with events", **options)


def observed(instance, phase):
    """The bits of all that can be read in a phase."""
    return {} if phase == "Instantiated" else instance.get()


def leave(instance, life, phase):
    """Uses a phase, and goes on to the next. Returns what was seen."""
    fmu, seen = instance.fmu, []
    if phase == "Instantiated":
        assert instance.set(fmu.with_files({})) == OK
        assert instance.enter_initialization(tolerance=1e-8) == OK
    elif phase == "Initialization":
        assert instance.set(sequence(fmu, 1)) == OK
        assert instance.call("ExitInitializationMode") == OK
    elif phase == "Event":
        assert instance.set(sequence(fmu, 2)) == OK
        assert instance.update() == OK
        seen.append(instance.get())
        assert instance.call("EnterContinuousTimeMode" if life == "ModelExchange" else "EnterStepMode") == OK
    elif phase == "Step":
        for k in range(6):
            if k == 3 and life == "CoSimulation":
                assert instance.set(sequence(fmu, 3)) == OK
            step_to(instance, k * STEP, (k + 1) * STEP)
            seen.append(instance.get())
        assert instance.call("Terminate") == OK
    elif phase == "Continuous":
        n, m = fmu.description.numberOfContinuousStates, fmu.description.numberOfEventIndicators
        for k in range(3):
            assert instance.call("SetTime", c_double(k * STEP)) == OK
            x = (c_double * n)()
            assert instance.call("GetContinuousStates", x, c_size_t(n)) == OK
            x = (c_double * n)(*[value + 1e-3 for value in x])
            assert instance.call("SetContinuousStates", x, c_size_t(n)) == OK
            dx, z = (c_double * n)(), (c_double * m)()
            name = "GetDerivatives" if fmu.is_fmi2 else "GetContinuousStateDerivatives"
            assert instance.call(name, dx, c_size_t(n)) == OK
            assert instance.call("GetEventIndicators", z, c_size_t(m)) == OK
            assert completed(instance) == OK
            seen += [bytes(dx), bytes(z), instance.get()]
        assert instance.call("Terminate") == OK
    return seen


def step_to(instance, time, until):
    """Steps from a communication point to the next; where the host handles events, it does so on the way."""
    while time < until:
        assert instance.step(time, until - time) == OK, instance.messages
        if instance.fmu.is_fmi2:
            return
        time = instance.reached.value
        if instance.flags[0]:
            assert instance.call("EnterEventMode") == OK
            assert instance.update() == OK
            assert instance.call("EnterStepMode") == OK


def reach(instance, life, wanted):
    """From instantiated to a phase."""
    for phase in LIVES[life]:
        if phase == wanted:
            return
        leave(instance, life, phase)


def onward(instance, life, begin):
    """From a phase to the end. Returns what was seen."""
    phases = LIVES[life]
    seen = []
    for phase in phases[phases.index(begin) :]:
        seen.append(observed(instance, phase))
        seen += leave(instance, life, phase)
    return seen


def completed(instance):
    """The status of `CompletedIntegratorStep`."""
    flag = c_int if instance.fmu.is_fmi2 else c_bool
    return instance.call("CompletedIntegratorStep", flag(True), ctypes.byref(flag()), ctypes.byref(flag()))


def forbidden(instance, phase):
    """Calls that no reading of the standards allows in a phase: names and functions that return the status."""
    fmu, exchange = instance.fmu, instance.kind == "ModelExchange"
    n = fmu.description.numberOfContinuousStates
    doubles = (c_double * max(n, 1))
    calls = {}

    def add(phases, name, call):
        if phase not in phases:
            calls[name] = call

    def plain(phases, name):
        add(phases, name, lambda: instance.call(name))

    frame = [c_int(0), c_double(0.0), c_double(0.0), c_int(0), c_double(0.0)]
    if fmu.is_fmi2:
        plain({"Instantiated"}, "EnterInitializationMode")
        add({"Instantiated"}, "SetupExperiment", lambda: instance.call("SetupExperiment", *frame))
    else:
        add({"Instantiated"}, "EnterInitializationMode", instance.enter_initialization)
    plain({"Initialization"}, "ExitInitializationMode")
    plain({"Event", "Continuous", "Step"}, "Terminate")
    add({"Step"}, "DoStep", lambda: instance.step(0.0))
    add({"Event"}, "NewDiscreteStates" if fmu.is_fmi2 else "UpdateDiscreteStates", instance.update)
    plain({"Event"} if exchange else {}, "EnterContinuousTimeMode")
    # From event mode to event mode is harmless, and some importers go there.
    plain({"Event", "Continuous", "Step"}, "EnterEventMode")
    add({"Continuous"}, "CompletedIntegratorStep", lambda: completed(instance))
    add({"Continuous", "Event"} if exchange else {}, "SetTime", lambda: instance.call("SetTime", c_double(1.0)))
    add({"Continuous", "Event"} if exchange else {}, "SetContinuousStates",
        lambda: instance.call("SetContinuousStates", doubles(), c_size_t(n)))
    if not fmu.is_fmi2:
        plain({"Event"} if not exchange else {}, "EnterStepMode")
    if not exchange:
        add({}, "GetEventIndicators", instance.indicators)
        add({}, "derivatives", instance.derivatives)
    starting = {"Instantiated", "Initialization"}
    for v in fmu.variables.values():
        if v.causality == "parameter" and v.variability == "fixed":
            add(starting, f"{v.name} := …", lambda v=v: set_again(instance, v))
        elif v.causality == "input":
            add(starting | {"Event", "Continuous", "Step"}, f"{v.name} := …", lambda v=v: set_again(instance, v))
        elif v.causality in ("output", "local", "calculatedParameter") and (v.initial == "calculated" or v.start is None):
            add({}, f"{v.name} := …", lambda v=v: set_again(instance, v))
        elif v.causality == "independent":
            add({}, f"{v.name} := …", lambda v=v: set_again(instance, v))
    return calls


def set_again(instance, variable):
    """The status of setting a variable to nothing in particular."""
    kind = instance.ctype(variable)[1]
    count = 1
    for length in variable.shape or ():
        count *= length
    value = b"text" if variable.type == "String" else 1
    return instance.access("Set", variable, (kind * count)(*[value] * count))
