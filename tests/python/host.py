"""A small importer for tests: one interface over FMPy's bindings of FMI 2.0 and FMI 3.0.

FMPy's own `simulate_fmu` interpolates continuous inputs; here inputs are piecewise constant, change at known instants
only, and every event of model exchange is reported.
"""

import math
import xml.etree.ElementTree as xml
from pathlib import Path

import fmpy
import numpy as np
from fmpy.sundials import CVodeSolver

FLOATS = ("Real", "Float32", "Float64")
STEP = 0.05
"""Communication step (s)."""
COMMAND = str(Path(__file__).parent.parent / "data" / "command.csv")
"""A recorded command for FMUs that play one back."""
SAME = 1e-12
"""How far two instants are apart, relative to them, that mean the same."""
HOLD = 10
"""Steps for which inputs hold their values."""


class Fmu:
    """An unpacked FMU."""

    def __init__(self, path, folder):
        self.path = Path(path)
        self.description = fmpy.read_model_description(path)
        self.folder = fmpy.extract(path, folder)
        self.is_fmi2 = self.description.fmiVersion == "2.0"
        self.variables = {v.name: v for v in self.description.modelVariables}
        self.clocks = [v for v in self.variables.values() if v.type == "Clock"]
        self._complete()
        self.inputs = [v for v in self.variables.values() if v.causality == "input" and v.type != "Clock"]

    def _complete(self):
        """What FMPy leaves out of the description of clocks and structural parameters."""
        described = xml.parse(self.folder_path() / "modelDescription.xml")
        for element in described.iter("Clock"):
            variable = self.variables[element.get("name")]
            variable.priority, variable.intervalDecimal = element.get("priority"), element.get("intervalDecimal")
        for element in described.iter("UInt64"):
            variable = self.variables[element.get("name")]
            variable.min, variable.max = element.get("min"), element.get("max")

    def folder_path(self):
        """Where it is unpacked."""
        return Path(self.folder)

    def with_files(self, parameters):
        """The parameters, with a recorded command where the FMU reads one."""
        files = {v.name: COMMAND for v in self.variables.values() if v.name == "file" and v.type == "String"}
        return {**files, **parameters}

    def observed(self):
        """What an instance computes: outputs and local variables."""
        causalities = ("output", "local", "calculatedParameter")
        return [v for v in self.variables.values() if v.causality in causalities and v.type != "Clock"]

    def variants(self):
        """Parameters to run the FMU with: as it comes, with each item of each enumeration, with each switch turned."""
        yield {}
        for v in self.variables.values():
            if v.causality != "parameter":
                continue
            if v.declaredType is not None and getattr(v.declaredType, "items", None):
                of = (lambda value: [value] * math.prod(v.shape)) if v.shape else lambda value: value
                yield from ({v.name: of(int(item.value))} for item in v.declaredType.items if item.value != v.start)
            elif v.type == "Boolean":
                yield {v.name: v.start != "true"}


def elements(variable):
    """The names that FMI 2.0 gives the elements of a variable: `name[1]`, `name[2]`, …; `der(name[1])`, …"""
    if not variable.shape:
        return [variable.name]
    inner = variable.name.removeprefix("der(").removesuffix(")")
    numbers = range(1, math.prod(variable.shape) + 1)
    return [variable.name.replace(inner, f"{inner}[{i}]") for i in numbers]


class Instance:
    """An instance of an FMU; `kind` is "CoSimulation" or "ModelExchange"."""

    def __init__(self, fmu, kind, logging=False, event_mode=False):
        self.fmu = fmu
        self.messages = []
        self.api = fmpy.instantiate_fmu(
            fmu.folder,
            fmu.description,
            kind,
            debug_logging=logging,
            logger=self._log(),
            event_mode_used=event_mode,
            early_return_allowed=event_mode,
        )
        self.next_event = None

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.api.freeInstance()

    def _log(self):
        if self.fmu.is_fmi2:
            return lambda _env, _name, status, _category, text: self.messages.append((status, text))
        return lambda _env, status, _category, text: self.messages.append((status, text))

    def initialize(self, parameters, inputs, tolerance=None):
        """From instantiated to the end of initialization, with start values and the inputs' first values."""
        if self.fmu.is_fmi2:
            self.api.setupExperiment(tolerance=tolerance, startTime=0.0)
            self.set(parameters)
            self.api.enterInitializationMode()
        else:
            self.set(parameters)
            self.api.enterInitializationMode(tolerance=tolerance, startTime=0.0)
        self.set(inputs)
        self.api.exitInitializationMode()

    def set(self, values):
        """Sets variables by name; arrays take all their elements, which in FMI 2.0 are variables."""
        for name, value in values.items():
            variable = self.fmu.variables.get(name) or self.fmu.variables[f"{name}[1]"]
            if variable.name != name:
                self.set({f"{name}[{i}]": element for i, element in enumerate(value, 1)})
                continue
            values = list(value) if isinstance(value, (list, tuple)) else [value]
            getattr(self.api, "set" + self._type(variable))([variable.valueReference], values)

    def get(self, variables):
        """Values by name; an array of FMI 3.0 gives `name[1]`, `name[2]`, … as FMI 2.0 has it."""
        found = {}
        for v in variables:
            count = math.prod(v.shape or ())
            read = getattr(self.api, "get" + self._type(v))
            values = read([v.valueReference]) if self.fmu.is_fmi2 else read([v.valueReference], count)
            found.update(zip(elements(v), values))
        return found

    def _type(self, variable):
        if variable.type == "Enumeration":
            return "Integer" if self.fmu.is_fmi2 else "Int64"
        return variable.type

    def update(self):
        """Event iteration: from event mode to continuous-time mode."""
        again = True
        rounds = 0
        while again:
            update = self.api.newDiscreteStates if self.fmu.is_fmi2 else self.api.updateDiscreteStates
            again, terminate, _, _, defined, due = update()
            assert not terminate, "the FMU ends the simulation"
            rounds += 1
            assert rounds < 100, "the event iteration does not end"
        self.next_event = due if defined else None
        self.api.enterContinuousTimeMode()


class _NoInput:
    """What FMPy's solver asks for its input."""

    @staticmethod
    def apply(_time):
        pass


def solver(instance, tolerance):
    """CVode with rtol = tolerance and atol = tolerance · nominal."""
    api, description = instance.api, instance.fmu.description
    return CVodeSolver(
        nx=description.numberOfContinuousStates,
        nz=description.numberOfEventIndicators,
        get_x=api.getContinuousStates,
        set_x=api.setContinuousStates,
        get_dx=api.getDerivatives if instance.fmu.is_fmi2 else api.getContinuousStateDerivatives,
        get_z=api.getEventIndicators,
        get_nominals=api.getNominalsOfContinuousStates,
        set_time=api.setTime,
        input=_NoInput,
        startTime=0.0,
        relativeTolerance=tolerance,
        maxNumSteps=1_000_000,
    )


def exchange(instance, until, cvode, time):
    """Integrates from `time` to `until` by model exchange and handles the time and state events on the way.

    Returns the instants of those events; an event at `until` is handled."""
    events = []
    while time < until:
        due = instance.next_event
        target = min(until, due) if due is not None and due > time else until
        if target - time <= SAME * max(1.0, time):
            # Sums that mean the same and differ by rounding: an integrator cannot go there.
            time = target
            instance.api.setTime(time)
            if due is not None and time >= due:
                events.append(time)
                instance.api.enterEventMode()
                instance.update()
                cvode.reset(time)
            continue
        crossed, _, time = cvode.step(time, target)
        reached = not crossed or time >= target
        if reached:
            time = target
        instance.api.setTime(time)
        step_event = False
        if instance.fmu.description.modelExchange.needsCompletedIntegratorStep:
            step_event, terminate = instance.api.completedIntegratorStep()
            assert not terminate
        if crossed or step_event or (reached and due is not None and time >= due):
            events.append(time)
            instance.api.enterEventMode()
            instance.update()
            cvode.reset(time)
    return events


def scale(variable, start):
    """How far a sequence moves an input, or an element of one, from its start value."""
    if start != 0.0:
        return 0.1 * abs(start)
    return {"N": 100.0, "m/s": 0.3, "rad/s": 0.05, None: 0.5}.get(variable.unit, 0.1)


def sequence(fmu, k):
    """The values of all inputs in the k-th interval: deterministic, different for each, in range, without drift.

    An element counts for itself, so that it has the same value in both versions.
    """
    values, i = {}, 0
    for v in fmu.inputs:
        count = math.prod(v.shape or ())
        starts = (v.start or "").split() if v.shape else [v.start]
        found = [in_sequence(v, start, k, i + j) for j, start in enumerate(starts or [None] * count)]
        assert len(found) == count, v.name
        values[v.name] = found if v.shape else found[0]
        i += count
    return values


def in_sequence(v, start, k, i):
    """The value of the i-th input, or element of one, in the k-th interval."""
    level = (0.0, 1.0, 1.0, 0.0, -1.0, -1.0, 0.0, 0.5, -0.5, 0.0)[(k + 3 * i) % 10]
    if v.type in FLOATS:
        start = float(start or 0.0)
        low = -math.inf if v.min is None else float(v.min)
        high = math.inf if v.max is None else float(v.max)
        return min(max(start + level * scale(v, start), low), high)
    if v.type == "Boolean":
        return level > 0.0
    if v.type == "Enumeration":
        return int(v.declaredType.items[(k + i) % len(v.declaredType.items)].value)
    if v.type == "String":
        return start or ""
    return int(start or 0) + round(level)


def co_simulate(instance, parameters, tolerance=None, stop=20.0):
    """Values at every communication point; inputs change every `HOLD` steps."""
    observed = instance.fmu.observed()
    instance.initialize(parameters, sequence(instance.fmu, 0), tolerance)
    rows = [instance.get(observed)]
    for k in range(round(stop / STEP)):
        if k % HOLD == 0 and k > 0:
            instance.set(sequence(instance.fmu, k // HOLD))
        instance.api.doStep(k * STEP, (k + 1) * STEP - k * STEP)
        rows.append(instance.get(observed))
    instance.api.terminate()
    return rows


def model_exchange(instance, parameters, tolerance, stop=20.0):
    """The same by model exchange: inputs change at events. Also returns the instants of all events."""
    observed = instance.fmu.observed()
    instance.initialize(parameters, sequence(instance.fmu, 0))
    instance.update()
    cvode = solver(instance, tolerance)
    rows, events = [instance.get(observed)], [0.0]
    for k in range(round(stop / STEP)):
        time = k * STEP
        if k % HOLD == 0 and k > 0:
            instance.api.enterEventMode()
            instance.set(sequence(instance.fmu, k // HOLD))
            instance.update()
            cvode.reset(time)
            events.append(time)
        events += exchange(instance, (k + 1) * STEP, cvode, time)
        rows.append(instance.get(observed))
    instance.api.terminate()
    return rows, np.array(events)
