"""Kinds of dependencies are what derivatives show, and those of single elements are those of the description."""

import math
from ctypes import byref, c_double, c_int, c_size_t, c_uint32

from host import FLOATS, HOLD, STEP, sequence
from raw import ERROR, OK, Library, Raw

CLOCKS = True
KINDS = (None, "constant", "fixed", "tunable", "discrete", "dependent")


def dependencies(instance, variable):
    """The dependencies of single elements: `{(element, value reference, element): kind}`."""
    count = c_size_t()
    reference = c_uint32(variable.valueReference)
    assert instance.call("GetNumberOfVariableDependencies", reference, byref(count)) == OK, instance.texts()
    n = count.value
    own, references, others, kinds = (c_size_t * n)(), (c_uint32 * n)(), (c_size_t * n)(), (c_int * n)()
    assert instance.call("GetVariableDependencies", reference, own, references, others, kinds, c_size_t(n)) == OK
    assert instance.call("GetVariableDependencies", reference, own, references, others, kinds, c_size_t(n + 1)) == ERROR
    found = list(zip(own, references, others))
    assert len(set(found)) == n
    return dict(zip(found, (KINDS[kind] for kind in kinds)))


def fresh(library, **arguments):
    """An initialized instance of the first interface that fits."""
    arguments.setdefault("event_mode", bool(library.fmu.clocks))
    token = (library.fmu.description.guid or "").encode()
    return Raw(library, "CoSimulation", token=token, **arguments)


def test_elements_depend_as_the_description_says(fmu):
    """Over all elements: the same variables, and the most intricate kind; before and after initialization ends."""
    if fmu.is_fmi2:
        return
    description = fmu.description
    sizes = {v.valueReference: math.prod(v.shape or ()) for v in fmu.variables.values()}
    running = description.outputs + description.derivatives
    with Library(fmu) as library:
        for unknowns, initialized in ((description.initialUnknowns, False), (running, True)):
            for unknown in unknowns:
                if unknown.variable.type == "Clock" or unknown.dependencies is None:
                    continue
                with fresh(library) as instance:
                    if initialized:
                        assert instance.initialize() == OK
                    found = dependencies(instance, unknown.variable)
                merged = {}
                for (element, reference, other), kind in found.items():
                    assert element <= sizes[unknown.variable.valueReference] and other <= sizes[reference]
                    assert (element > 0) == (sizes[unknown.variable.valueReference] > 1)
                    assert (other > 0) == (sizes[reference] > 1)
                    merged[reference] = max(merged.get(reference, kind), kind, key=KINDS.index)
                kinds = unknown.dependenciesKind or ["dependent"] * len(unknown.dependencies)
                declared = {v.valueReference: kind for v, kind in zip(unknown.dependencies, kinds, strict=True)}
                if not initialized:
                    # The description leaves out what is an unknown itself.
                    merged = {reference: kind for reference, kind in merged.items() if reference in declared}
                assert merged == declared, unknown.variable.name


def test_what_has_no_dependencies_is_refused(fmu):
    """Parameters, inputs and unknown variables."""
    if fmu.is_fmi2:
        return
    wrong = [v.valueReference for v in fmu.variables.values() if v.causality in ("parameter", "input") and v.type != "Clock"]
    with Library(fmu) as library:
        for reference in wrong[:2] + [2**32 - 1]:
            with fresh(library) as instance:
                count = c_size_t()
                assert instance.call("GetNumberOfVariableDependencies", c_uint32(reference), byref(count)) == ERROR
                assert instance.messages


def derivative(instance, unknown, known):
    """How an unknown changes with a known."""
    references = (c_uint32 * 1)(unknown.valueReference), (c_uint32 * 1)(known.valueReference)
    seed, value, one = (c_double * 1)(1.0), (c_double * 1)(), c_size_t(1)
    sizes = [] if instance.fmu.is_fmi2 else [one]
    arguments = [references[0], one, references[1], one, seed, *sizes, value, *sizes]
    assert instance.call("GetDirectionalDerivative", *arguments) == OK, instance.texts()
    return value[0]


def test_kinds_are_what_derivatives_show(case):
    """Constant: the same for all parameters. Fixed, tunable: the same in a run."""
    fmu, parameters = case
    description = fmu.description
    pairs = []
    if fmu.clocks:
        # Nothing in it is continuous.
        assert not description.derivatives
        return
    for unknown in description.outputs + description.derivatives:
        v = unknown.variable
        if v.type not in FLOATS or v.variability != "continuous" or v.shape or not unknown.dependenciesKind:
            continue
        for known, kind in zip(unknown.dependencies, unknown.dependenciesKind):
            if known.type in FLOATS and known.variability == "continuous" and not known.shape and known is not v:
                pairs.append((v, known, kind))
    others = {
        v.name: float(v.start) * 1.1
        for v in fmu.variables.values()
        if v.causality == "parameter" and v.type == ("Real" if fmu.is_fmi2 else "Float64") and not v.shape
        and (v.max is None or float(v.start) * 1.1 <= float(v.max))
    }
    seen = {}
    with Library(fmu) as library:
        for run, changes in enumerate(({}, others)):
            with fresh(library) as instance:
                assert instance.initialize({**parameters, **changes}) == OK, instance.texts()
                for k in range(4 * HOLD):
                    if k % HOLD == 0 and k > 0:
                        assert instance.set(sequence(fmu, k // HOLD)) == OK
                    assert instance.step(k * STEP, (k + 1) * STEP - k * STEP) == OK
                    if k % 7 == 6:
                        for v, known, _ in pairs:
                            seen.setdefault((v.name, known.name), ([], []))[run].append(derivative(instance, v, known))
    for v, known, kind in pairs:
        first, second = seen[v.name, known.name]
        if kind == "constant":
            assert len(set(first + second)) == 1, (v.name, known.name)
        elif kind in ("fixed", "tunable"):
            assert len(set(first)) == 1 and len(set(second)) == 1, (v.name, known.name)
