"""FMUs with clocks: whoever ticks them, they compute what the FMU computes that ticks its clocks itself."""

import ctypes
from ctypes import c_double, c_size_t, c_uint32, c_uint64

import fmpy
import pytest
from host import HOLD, STEP, sequence
from raw import DISCARD, ERROR, OK, Library, Raw
from ticking import CHANGED, KINDS, NOT_YET_KNOWN, PERIODIC, UNCHANGED, Clocked, Scheduler, one, run

STOP = 6.0


def alone(twin, parameters, change=None):
    """Values at every communication point of the FMU that ticks its clocks itself."""
    with Library(twin) as library, Raw(library, "CoSimulation") as instance:
        assert instance.initialize(parameters) == OK
        rows = [instance.get()]
        for k in range(1, round(STOP / STEP) + 1):
            assert instance.step((k - 1) * STEP, k * STEP - (k - 1) * STEP) == OK
            rows.append(instance.get())
            if k % HOLD == 0:
                assert instance.set(sequence(twin, k // HOLD)) == OK
                if change:
                    change(instance, k * STEP)
    return rows


def offered(fmu):
    """The interfaces of an FMU."""
    description = fmu.description
    interfaces = (description.coSimulation, description.modelExchange, description.scheduledExecution)
    return [kind for kind, interface in zip(KINDS, interfaces) if interface is not None]


@pytest.mark.parametrize("changed", [False, True])
def test_every_interface_computes_what_the_fmu_without_clocks_does(clocked, changed):
    """The same bits at all communication points, with tunable parameters left alone and changed; and the same ticks."""
    fmu, twin = clocked
    tunable = [v for v in fmu.variables.values() if v.variability == "tunable" and v.type == "Float64" and not v.shape]

    def change(instance, time):
        if time in (1.0, 2.5):
            for variable in tunable:
                value = float(variable.start) * (1.3 if time == 1.0 else 0.7)
                assert instance.set({variable.name: value}) == OK

    change = change if changed else None
    expected = alone(twin, {}, change)
    ticked = []
    for kind in offered(fmu):
        with Library(fmu) as library, Clocked(library, kind) as instance:
            rows, fired = run(instance, {}, STOP, change)
            ticked.append(fired)
        for k, (row, other) in enumerate(zip(rows, expected, strict=True)):
            assert row == other, (kind, k * STEP, [name for name in row if row[name] != other[name]])
    assert all(fired == ticked[0] for fired in ticked)
    assert all(count > 0 for count in ticked[0].values()), ticked[0]


def started(library, kind="CoSimulation", prepare=None, **arguments):
    """An instance at its first event, and its scheduler."""
    instance = Clocked(library, kind, **arguments)
    assert instance.pointer, instance.texts()
    assert instance.enter_initialization() == OK
    assert instance.set(sequence(library.fmu, 0)) == OK
    if prepare:
        prepare(instance)
    scheduler = Scheduler(instance)
    assert instance.call("ExitInitializationMode") == OK
    return instance, scheduler


def qualifiers(instance, clock):
    """What is said of a clock's interval when it is asked for twice."""
    answers = [instance.interval(clock) for _ in range(2)]
    assert [status for status, _, _ in answers] == [OK, OK]
    assert answers[1][2] == NOT_YET_KNOWN or answers[0][1] == answers[1][1]
    return [qualifier for _, _, qualifier in answers]


def test_qualifiers_are_those_of_the_table(clocked):
    """FMI 3.0.2, 2.2.8.4: by the kind of clock, in Initialization Mode and in Event Mode, before and after a tick."""
    fmu, _ = clocked
    kinds = {(clock.intervalVariability, clock.intervalDecimal is not None) for clock in fmu.clocks}
    with Library(fmu) as library, Clocked(library, "CoSimulation") as instance:
        assert instance.enter_initialization() == OK
        for clock in fmu.clocks:
            if clock.causality == "output":
                assert instance.interval(clock)[0] == ERROR
                break
    with Library(fmu) as library, Clocked(library, "CoSimulation") as instance:
        assert instance.enter_initialization() == OK
        inputs = [clock for clock in fmu.clocks if clock.causality == "input"]
        for clock in inputs:
            told = {("countdown", False): [NOT_YET_KNOWN, NOT_YET_KNOWN]}
            known = [UNCHANGED, UNCHANGED] if clock.intervalDecimal is not None else [CHANGED, UNCHANGED]
            kind = (clock.intervalVariability, clock.intervalDecimal is not None)
            assert qualifiers(instance, clock) == told.get(kind, known), clock.name
        assert instance.call("ExitInitializationMode") == OK
        for clock in inputs:
            ticked = {"changing": [CHANGED, UNCHANGED]}
            assert instance.tick(clock) == OK
            assert instance.update() == OK
            if clock.intervalVariability != "countdown":
                found = qualifiers(instance, clock)
                assert found == ticked.get(clock.intervalVariability, [UNCHANGED, UNCHANGED]), clock.name
    assert kinds


def test_the_importer_sets_intervals_where_it_may(clocked):
    """Fixed ones before the start, tunable ones later too, declared ones only; and never to nothing."""
    fmu, _ = clocked
    for clock in [clock for clock in fmu.clocks if clock.causality == "input"]:
        settable = clock.intervalVariability in ("fixed", "tunable") and clock.intervalDecimal is not None
        for running in (False, True):
            for interval in (0.125, 0.0, -1.0, float("nan")):
                with Library(fmu) as library, Clocked(library, "CoSimulation") as instance:
                    assert instance.enter_initialization() == OK
                    if running:
                        assert instance.call("ExitInitializationMode") == OK
                    may = settable and interval > 0 and not (running and clock.intervalVariability == "fixed")
                    assert instance.set_interval(clock, interval) == (OK if may else ERROR), (clock.name, interval)
                    if may:
                        assert instance.interval(clock)[1:] == (interval, UNCHANGED)
                    else:
                        assert clock.name in instance.texts()


def test_what_clocks_cannot_do_is_refused_by_name(clocked):
    """Output clocks are not set, time-based ones tick once, fractions are not offered, shifts are of periodic clocks."""
    fmu, _ = clocked
    no_room = (ctypes.byref(c_uint64()), ctypes.byref(c_uint64()))

    def refused(call, kind="CoSimulation"):
        with Library(fmu) as library:
            instance, _ = started(library, kind)
            with instance:
                assert call(instance) == ERROR
                return instance.texts()

    for clock in fmu.clocks:
        if clock.causality == "output":
            assert clock.name in refused(lambda instance: instance.tick(clock))
            assert clock.name in refused(lambda instance: instance.activate(clock, 0.0), "ScheduledExecution")
            continue
        assert clock.name in refused(lambda i: max(i.tick(clock), i.update(), i.tick(clock)))
        assert refused(lambda instance: instance.tick(clock), "ScheduledExecution")
        assert clock.name in refused(lambda i: max(i.activate(clock, 1.0), i.activate(clock, 1.0)), "ScheduledExecution")
        fraction = refused(lambda i: i.call("GetIntervalFraction", *one(clock), *no_room, ctypes.byref(ctypes.c_int())))
        assert clock.name in fraction and "fraction" in fraction
        if clock.intervalVariability not in PERIODIC:
            with Library(fmu) as library, Clocked(library, "CoSimulation") as instance:
                assert instance.enter_initialization() == OK
                assert instance.shift(clock)[0] == ERROR and clock.name in instance.texts()


def test_clocks_need_event_mode(clocked):
    """Without it nobody could tick them; the message says what to do."""
    fmu, _ = clocked
    with Library(fmu) as library:
        instance = Clocked(library, "CoSimulation", event_mode=False)
        assert not instance.pointer
        assert "eventModeUsed" in instance.texts()


def test_an_fmu_without_clocks_has_none(fmu):
    """Its clock functions take no clocks, and it offers no scheduled execution."""
    if fmu.is_fmi2:
        return
    with Library(fmu) as library, Raw(library, "CoSimulation", event_mode=True) as instance:
        assert instance.initialize() == OK
        assert instance.call("SetClock", None, c_size_t(0), None) == OK
        assert instance.call("GetClock", None, c_size_t(0), None) == OK
        reference = (c_uint32 * 1)(max(v.valueReference for v in fmu.variables.values()) + 1)
        assert instance.call("GetClock", reference, c_size_t(1), ctypes.byref(ctypes.c_bool())) == ERROR
    with Library(fmu) as library:
        instance = Raw(library, "ScheduledExecution")
        assert not instance.pointer and "scheduled execution" in instance.texts()


def test_what_was_computed_for_looking_is_given_back(clocked):
    """A clock that is taken back, or an input that changes, before the event is over: as if it had not been."""
    fmu, _ = clocked
    with Library(fmu) as library:
        for clock in [clock for clock in fmu.clocks if clock.causality == "input"]:
            instance, _ = started(library)
            with instance:
                before = instance.get()
                assert instance.tick(clock) == OK
                looked = instance.get()
                assert instance.tick(clock, active=False) == OK
                assert instance.get() == before
                assert instance.tick(clock) == OK
                assert instance.set(sequence(fmu, 1)) == OK
                instance.get()
                assert instance.set(sequence(fmu, 0)) == OK
                assert instance.get() == looked
                assert instance.update() == OK
                assert instance.get() == looked
                assert instance.ticks(clock) == (OK, False)


@pytest.mark.parametrize("kind", KINDS)
def test_a_state_goes_on_to_the_same_bits(clocked, kind):
    """Taken in the middle of an event, restored from bytes in another instance: every clock goes on."""
    fmu, twin = clocked
    if kind not in offered(fmu):
        return
    with Library(fmu) as library:
        instance, scheduler = started(library, kind)
        with instance:
            first = scheduler.order[0]
            if kind == "ScheduledExecution":
                assert instance.activate(first, 0.0) == OK
            else:
                assert instance.tick(first) == OK
                instance.get()
            data = serialized(instance)

            def onwards(instance):
                seen = []
                if kind != "ScheduledExecution":
                    assert instance.update() == OK
                for clock in scheduler.order:
                    if kind == "ScheduledExecution":
                        assert instance.activate(clock, 5.0) == OK
                    elif clock is not first:
                        assert instance.tick(clock) == OK
                        assert instance.update() == OK
                    seen.append((instance.get(), instance.interval(clock)))
                return seen

            expected = onwards(instance)
        other, _ = started(library, kind)
        with other:
            assert deserialized(other, data) == OK
            assert onwards(other) == expected
    with Library(twin) as library, Raw(library, "CoSimulation", event_mode=True) as instance:
        assert instance.initialize() == OK
        assert deserialized(instance, data) == ERROR


def serialized(instance):
    """The bytes of an instance's state."""
    status, state = instance.take()
    assert status == OK
    status, size = instance.size(state)
    assert status == OK
    data = (ctypes.c_uint8 * size)()
    assert instance.call("SerializeFMUState", state, data, c_size_t(size)) == OK
    assert instance.release(state) == OK
    return bytes(data)


def deserialized(instance, data):
    """The status of going on from bytes."""
    state = ctypes.c_void_p()
    status = instance.call("DeserializeFMUState", data, c_size_t(len(data)), ctypes.byref(state))
    if status == OK:
        status = instance.restore(state)
        assert instance.release(state) == OK or status == ERROR
    return status


def test_scheduled_execution_locks_and_tells(clocked):
    """Every call locks once and unlocks once; news of clocks are told, and an output clock says once that it ticks."""
    fmu, _ = clocked
    outputs = [clock for clock in fmu.clocks if clock.causality == "output"]
    countdowns = [clock for clock in fmu.clocks if clock.intervalVariability == "countdown"]
    depth, most, told = [0], [0], []

    def lock():
        depth[0] += 1
        most[0] = max(most[0], depth[0])

    def unlock():
        depth[0] -= 1

    def news(_):
        assert depth == [0], "locked while the importer is told"
        told.extend(clock.name for clock in outputs if instance.ticks(clock) == (OK, True))
        told.extend(clock.name for clock in countdowns if instance.interval(clock)[2] == CHANGED)
        assert not any(instance.ticks(clock)[1] for clock in outputs)

    with Library(fmu) as library:
        instance, scheduler = started(library, "ScheduledExecution", clock_update=news, lock=lock, unlock=unlock)
        with instance:
            for k in range(200):
                assert instance.set(sequence(fmu, k // HOLD)) == OK
                for clock in scheduler.order:
                    assert instance.activate(clock, k * STEP) == OK, instance.texts()
            assert instance.call("Terminate") == OK
    assert depth == [0] and most == [1]
    assert {clock.name for clock in outputs + countdowns} == set(told)


def test_an_input_that_is_not_finite_stops_no_clock(clocked):
    """The partition is discarded and can be computed again."""
    fmu, _ = clocked
    for v in [v for v in fmu.inputs if v.type == "Float64" and not v.shape]:
        with Library(fmu) as library:
            instance, scheduler = started(library, "ScheduledExecution", logging=True)
            with instance:
                before = instance.get()
                assert instance.set({v.name: float("nan")}) == OK
                assert instance.activate(scheduler.order[0], 0.0) == DISCARD
                assert v.name in instance.texts()
                assert instance.get() == before
                assert instance.set(sequence(fmu, 0)) == OK
                assert instance.activate(scheduler.order[0], 0.0) == OK
                assert instance.activate(scheduler.order[0], float("inf")) == ERROR


def test_fmpy_schedules_it(clocked):
    """FMPy's own binding of scheduled execution computes the partitions that ours does."""
    fmu, _ = clocked
    inputs = [clock for clock in fmu.clocks if clock.causality == "input"]
    outputs = [v for v in fmu.observed() if v.type == "Float64" and not v.shape]
    references = [v.valueReference for v in outputs]
    api = fmpy.instantiate_fmu(fmu.folder, fmu.description, "ScheduledExecution")
    try:
        api.enterInitializationMode()
        api.exitInitializationMode()
        with Library(fmu) as library, Clocked(library, "ScheduledExecution") as instance:
            assert instance.enter_initialization() == OK
            assert instance.call("ExitInitializationMode") == OK
            for k in range(20):
                for clock in inputs:
                    api.activateModelPartition(clock.valueReference, k * STEP)
                    assert instance.activate(clock, k * STEP) == OK
                ours = b"".join(instance.get(outputs).values())
                assert bytes((c_double * len(references))(*api.getFloat64(references))) == ours
        api.terminate()
    finally:
        api.freeInstance()
