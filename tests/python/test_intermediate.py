"""Intermediate updates in FMI 3.0: the importer looks, sets, and ends steps between communication points."""

import ctypes
from ctypes import c_double, c_size_t, c_uint32, c_void_p

from host import FLOATS, HOLD, STEP, sequence
from raw import ERROR, OK, Library, Raw

STEPS = 60
AGREEMENT = 1e-7
"""Two ways to one time: a step that is cut is not the one that runs through."""


def moving(fmu, causality):
    """The continuous variables of a causality, all of which can be had in an intermediate update."""
    found = [v for v in fmu.variables.values() if v.causality == causality and v.variability == "continuous"]
    return [v for v in found if v.type in FLOATS]


def made(library, callback, **arguments):
    """An instance at time 0 that calls back."""
    instance = Raw(library, "CoSimulation", intermediate=callback, **arguments)
    assert instance.initialize() == OK, instance.texts()
    if arguments.get("event_mode"):
        assert instance.update() == OK and instance.call("EnterStepMode") == OK
    return instance


def walk(instance, steps=STEPS):
    """The bits of everything after each step, for the inputs of the sweep."""
    rows = []
    for k in range(steps):
        if k % HOLD == 0 and k > 0:
            assert instance.set(sequence(instance.fmu, k // HOLD)) == OK
        assert instance.step(k * STEP, (k + 1) * STEP - k * STEP) == OK, instance.texts()
        rows.append(instance.get())
    return rows


def test_looking_changes_nothing(fmu):
    """The same bits as without; times go up within the step and end with it; outputs can be read, derivatives too."""
    if fmu.is_fmi2:
        return
    seen = []
    outputs = moving(fmu, "output")
    reference = (c_uint32 * 1)(outputs[0].valueReference) if outputs else None

    def look(environment, time, may_set, may_get, finished, early, wanted, at):
        assert may_set and may_get and finished and not early
        values = [instance.get(outputs)]
        if outputs and not outputs[0].shape:
            order, value = (ctypes.c_int32 * 1)(1), (c_double * 1)()
            assert instance.call("GetOutputDerivatives", reference, c_size_t(1), order, value, c_size_t(1)) == OK
        seen.append((environment, time, values))

    with Library(fmu) as library:
        with Raw(library, "CoSimulation") as instance:
            assert instance.initialize() == OK
            expected = walk(instance)
        required = [v.valueReference for v in outputs]
        with made(library, look, required=required, environment=4711) as instance:
            assert walk(instance) == expected
    times = [time for _, time, _ in seen]
    assert times == sorted(times) and {environment for environment, _, _ in seen} == {4711}
    assert {k * STEP + ((k + 1) * STEP - k * STEP) for k in range(STEPS)} <= set(times)


def test_a_step_ends_where_the_importer_wants(fmu):
    """At the point itself, or at a later one; and it goes on from there."""
    if fmu.is_fmi2:
        return
    asked = []

    def early(_environment, time, _set, _get, _finished, may, wanted, at):
        if may and not asked:
            asked.append(time)
            wanted[0], at[0] = True, 0.9 * STEP

    with Library(fmu) as library, made(library, early, event_mode=True) as instance:
        assert instance.step(0.0, STEP) == OK
        event, _, returned = (flag.value for flag in instance.flags)
        reached = instance.reached.value
        if asked:
            assert (returned and reached == max(asked[0], 0.9 * STEP)) or event
        if event:
            assert instance.call("EnterEventMode") == OK
            assert instance.update() == OK and instance.call("EnterStepMode") == OK
        assert reached == STEP or instance.step(reached, STEP - reached) == OK
    with Library(fmu) as library, made(library, early) as instance:
        # Where early return is not allowed, nobody is asked.
        asked.clear()
        assert instance.step(0.0, STEP) == OK and not asked and instance.reached.value == STEP


def test_an_input_set_between_is_an_input_set_there(fmu):
    """As if the step had ended at that point and gone on with the new input."""
    inputs = [v for v in moving(fmu, "input") if not v.shape] if not fmu.is_fmi2 else []
    for v in inputs:
        values = {v.name: float(v.start or 0.0) + (sequence(fmu, 1)[v.name] or 0.1) * 0.5 + 0.01}
        done = []

        def change(_environment, time, _set, _get, _finished, _may, _wanted, _at):
            if not done and time < STEP:
                done.append(time)
                assert instance.set(values) == OK, instance.texts()

        with Library(fmu) as library:
            with made(library, change, required=[v.valueReference]) as instance:
                assert instance.step(0.0, STEP) == OK
                found = instance.get(moving(fmu, "output"))
            if not done:
                continue
            with Raw(library, "CoSimulation") as instance:
                assert instance.initialize() == OK
                assert instance.step(0.0, done[0]) == OK and instance.set(values) == OK
                assert instance.step(done[0], STEP - done[0]) == OK
                expected = instance.get(moving(fmu, "output"))
        for name, bits in expected.items():
            for a, b in zip(doubles(bits), doubles(found[name])):
                assert abs(a - b) <= AGREEMENT, (v.name, name)


def doubles(bits):
    """The numbers of some bits."""
    return list((c_double * (len(bits) // 8)).from_buffer_copy(bits))


def forbidden(fmu):
    """What may not be done within a callback, and what must go wrong of it."""
    parameters = [v for v in fmu.variables.values() if v.causality == "parameter" and v.type in FLOATS and not v.shape]
    discrete = [v for v in fmu.inputs if v.variability == "discrete" and v.type in FLOATS and not v.shape]
    for v in parameters[:1] + discrete[:1]:
        yield lambda instance, v=v: instance.set({v.name: float(v.start or 0.0) + 1.0})
    yield lambda instance: instance.step(0.0)
    for name in ("Terminate", "Reset", "EnterEventMode", "EnterStepMode", "ExitInitializationMode"):
        yield lambda instance, name=name: instance.call(name)
    yield lambda instance: instance.take()[0]


def test_what_may_not_be_done_within_a_callback_is_refused(fmu):
    """With Error; the step fails, and a reset mends it. Freeing does nothing then."""
    if fmu.is_fmi2:
        return
    for call in forbidden(fmu):
        statuses = []

        def act(*_):
            if not statuses:
                statuses.append(call(instance))
                instance._function("FreeInstance", None)(c_void_p(instance.pointer))

        with Library(fmu) as library, made(library, act) as instance:
            assert instance.step(0.0) == ERROR
            assert statuses == [ERROR]
            assert instance.call("Reset") == OK
            assert instance.initialize() == OK
            assert instance.step(0.0) == OK, instance.texts()


def test_only_what_is_required_can_be_had(fmu):
    """Where the importer has said what it wants, nothing else; and what cannot be had is refused at once."""
    outputs = [] if fmu.is_fmi2 else moving(fmu, "output")
    if len(outputs) > 1:
        statuses = []

        def look(*_):
            first, second = ((c_double * len(doubles(bits)))() for bits in sizes)
            statuses.append((instance.access("Get", outputs[0], first), instance.access("Get", outputs[1], second)))

        with Library(fmu) as library:
            with Raw(library, "CoSimulation") as instance:
                assert instance.initialize() == OK
                sizes = list(instance.get(outputs[:2]).values())
            with made(library, look, required=[outputs[0].valueReference]) as instance:
                assert instance.step(0.0) == ERROR
                assert statuses[0] == (OK, ERROR) and outputs[1].name in instance.texts()
    if not fmu.is_fmi2:
        wrong = [v for v in fmu.variables.values() if v.causality == "parameter"]
        with Library(fmu) as library:
            for reference in [2**32 - 1] + [v.valueReference for v in wrong[:1]]:
                instance = Raw(library, "CoSimulation", required=[reference])
                assert not instance.pointer and instance.messages


def test_an_input_that_is_not_finite_discards_the_step(fmu):
    """The instance is where it was, and the step can be repeated."""
    inputs = [] if fmu.is_fmi2 else [v for v in moving(fmu, "input") if not v.shape]
    for v in inputs[:1]:
        wrong = []

        def poison(_environment, time, *_):
            if not wrong and time < STEP:
                wrong.append(time)
                assert instance.set({v.name: float("nan")}) == OK

        with Library(fmu) as library, made(library, poison, logging=True) as instance:
            before = instance.get()
            status = instance.step(0.0)
            if wrong:
                assert status == 2 and v.name in instance.texts() and instance.reached.value == 0.0
                assert instance.set(sequence(fmu, 0)) == OK
                assert instance.get() == before
                assert instance.step(0.0) == OK
