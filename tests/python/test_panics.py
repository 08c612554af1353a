"""A panic inside a model comes out as Fatal with a message; the host, its other instances and its console live on.

`Faulty` panics where its parameter says.
"""

import pytest
from raw import ERROR, FATAL, OK, Library, Raw

CALLS = {
    "check": ("ExitInitializationMode",) * 2,
    "memory": ("ExitInitializationMode",) * 2,
    "start": ("ExitInitializationMode",) * 2,
    "event": ("ExitInitializationMode",) * 2,
    "outputs": ("Get",) * 2,
    "derivatives": ("DoStep", "Derivatives"),
    "indicators": ("DoStep", "GetEventIndicators"),
    "clone": ("ExitInitializationMode",) * 2,
    "serialize": ("SerializedFMU",) * 2,
    "drop": ("", ""),
}
"""Where the model panics, and the function in which that happens in co-simulation and in model exchange; when a memory is
freed is the runtime's affair."""
KINDS = ("CoSimulation", "ModelExchange")
both = pytest.mark.parametrize("version", ["fmi2", "fmi3"])


def life(instance, fault):
    """Calls that come to every fault, until one is not OK: its status."""
    api, outputs = instance, instance.fmu.observed()
    yield api.set({"fault": fault})
    yield api.enter_initialization()
    yield api.call("ExitInitializationMode")
    if api.kind == "CoSimulation":
        yield api.step(0.0)
    else:
        yield api.update()
        yield api.call("EnterContinuousTimeMode")
        yield api.derivatives()
        yield api.indicators()
    for v in outputs:
        yield api.access("Get", v, (api.ctype(v)[1] * 1)())
    status, state = api.take()
    yield status
    yield api.size(state)[0]
    yield api.release(state)
    yield api.call("Reset")


def first_failure(statuses):
    """The first status that is not OK."""
    return next((status for status in statuses if status != OK), OK)


def alone(library, kind, count):
    """What an instance sees that nobody disturbs."""
    with Raw(library, kind) as instance:
        assert instance.initialize() == OK
        return [seen for k in range(count) for seen in on(instance, k)]


def on(instance, k):
    """One step further, or one evaluation."""
    if instance.kind == "CoSimulation":
        assert instance.step(0.05 * k) == OK
    else:
        assert instance.update() == OK
    yield instance.get()


@both
@pytest.mark.parametrize("kind", KINDS)
def test_a_model_without_fault_lives_through_all_of_it(named, version, kind):
    """So that what follows fails for no other reason."""
    with Library(named(version, "Faulty")) as library, Raw(library, kind) as instance:
        assert first_failure(life(instance, "")) == OK, instance.messages


@both
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("place", CALLS)
def test_a_panic_is_fatal_for_its_instance_only(named, version, kind, place, capfd):
    """Fatal, logged though logging is off, then refusals until the instance is freed; the one beside it goes on."""
    with Library(named(version, "Faulty")) as library:
        expected = alone(library, kind, 4)
        with Raw(library, kind) as neighbour, Raw(library, kind) as instance:
            assert neighbour.initialize() == OK
            seen = [row for k in range(2) for row in on(neighbour, k)]

            assert first_failure(life(instance, place)) == FATAL
            assert len(instance.messages) == 1
            _, _, status, category, text, _ = instance.messages[0]
            assert (status, category) == (FATAL, b"logStatusFatal")
            # The function, what the panic said, and where it was.
            function = CALLS[place][KINDS.index(kind)]
            assert function in text.decode() and f"a fault in {place}" in text.decode() and ".rs:" in text.decode()
            for refused in (instance.call("Terminate"), instance.call("Reset"), instance.take()[0], instance.step(0.0)):
                assert refused == ERROR
            assert all(message[2] == ERROR for message in instance.messages[1:])
            instance.free()

            seen += [row for k in range(2, 4) for row in on(neighbour, k)]
            assert seen == expected and neighbour.messages == []
        assert alone(library, kind, 4) == expected, "new instances can be made"
        assert capfd.readouterr() == ("", "")


@both
def test_a_panic_while_an_instance_is_freed_ends_there(named, version, capfd):
    """Freeing returns nothing, so that there is nothing to say."""
    with Library(named(version, "Faulty")) as library, Raw(library, "CoSimulation") as instance:
        assert instance.initialize({"fault": "drop"}) == OK
        instance.free()
    assert capfd.readouterr() == ("", "")


@both
@pytest.mark.parametrize("place", ["event", "derivatives", "indicators"])
def test_a_panic_under_way(named, version, place):
    """A tunable parameter turns the fault on after some steps."""
    with Library(named(version, "Faulty")) as library, Raw(library, "CoSimulation") as instance:
        assert instance.initialize() == OK
        assert [instance.step(0.05 * k) for k in range(3)] == [OK] * 3
        assert instance.set({"fault": place}) == OK
        assert instance.step(0.15) == FATAL
        assert instance.step(0.15) == ERROR
