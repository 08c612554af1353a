"""Whatever moves an output or an initial unknown is declared as a dependency of it, whether it is a number or a switch."""

import math

from host import STEP, sequence
from raw import OK, Library, Raw


def others(variable):
    """Values of a variable other than the one it starts with, within its bounds."""
    start = variable.start
    if variable.type in ("Real", "Float64", "Float32"):
        numbers = [float(word) for word in str(start or 0.0).split()]
        count = math.prod(variable.shape or ())
        numbers = numbers if len(numbers) == count else numbers * count
        for part in (1e-3, -1e-3, 0.3):
            moved = [number + part * max(abs(number), 1.0) for number in numbers]
            low = -math.inf if variable.min is None else float(variable.min)
            high = math.inf if variable.max is None else float(variable.max)
            yield [min(max(number, low), high) for number in moved]
    elif variable.type == "Boolean":
        turned = [word != "true" for word in (start or "false").split()]
        yield turned if variable.shape else turned[0]
    elif variable.type == "Enumeration":
        yield from (int(item.value) for item in variable.declaredType.items if str(item.value) != str(start))
    elif variable.type in ("Integer", "Int32"):
        yield int(start or 0) + 1


def declared(unknowns):
    """The names of what each unknown depends on; None is all."""
    return {u.variable.name: u.dependencies and {v.name for v in u.dependencies} for u in unknowns if u.dependencies != []} | {
        u.variable.name: set() for u in unknowns if u.dependencies == []
    }


def check(moved, known, before, after):
    """Collects the unknowns that a known has moved without being declared."""
    for name, names in moved.items():
        if after[name] != before[name] and names is not None and known not in names:
            yield f"{name} by {known}"


def test_initial_unknowns_depend_on_what_is_declared(case):
    """Every value that can be set before initialization ends, one at a time."""
    fmu, parameters = case
    unknowns = declared(fmu.description.initialUnknowns)
    read = [fmu.variables[name] for name in unknowns]
    settable = [
        v
        for v in fmu.variables.values()
        if v.causality == "input" or v.initial in ("exact", "approx") and v.variability != "constant"
    ]
    tried, undeclared = 0, set()
    with Library(fmu) as library:
        for v in settable:
            for value in others(v):
                with Raw(library, "ModelExchange") as instance:
                    assert instance.set(fmu.with_files(parameters)) == OK
                    assert instance.enter_initialization() == OK
                    assert instance.set(sequence(fmu, 1)) == OK
                    before = instance.get(read)
                    if v.name in parameters or instance.set({v.name: value}) != OK:
                        continue
                    # Values that do not go together are refused when initialization is attempted.
                    place = [instance.access("Get", r, (instance.ctype(r)[1] * math.prod(r.shape or ()))()) for r in read]
                    if any(place):
                        continue
                    tried += 1
                    undeclared |= set(check(unknowns, v.name, before, instance.get(read)))
    assert not undeclared, sorted(undeclared)
    assert tried >= len(settable) // 2


def test_outputs_depend_on_what_is_declared(case):
    """Every input, one at a time: at once in co-simulation, and after the event that it is in model exchange."""
    fmu, parameters = case
    outputs = declared(fmu.description.outputs)
    read = [fmu.variables[name] for name in outputs]
    undeclared = set()
    with Library(fmu) as library:
        for kind in ("CoSimulation", "ModelExchange"):
            with Raw(library, kind) as instance:
                assert instance.initialize(parameters, sequence(fmu, 1)) == OK
                if kind == "CoSimulation":
                    assert [instance.step(k * STEP) for k in range(7)] == [OK] * 7
                status, state = instance.take()
                assert status == OK
                for v in fmu.inputs:
                    for value in others(v):
                        seen = []
                        for change in ({}, {v.name: value}):
                            assert instance.restore(state) == OK
                            assert instance.set(change) == OK
                            if kind == "ModelExchange":
                                assert instance.update() == OK
                            seen.append(instance.get(read))
                        undeclared |= set(check(outputs, v.name, *seen))
                assert instance.release(state) == OK
    assert not undeclared, sorted(undeclared)
