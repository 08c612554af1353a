"""All FMUs in one process: each sees what it sees alone, whatever else is loaded, stepped, or unloaded beside it."""

from conftest import FMUS
from host import STEP, sequence
from raw import OK, Library, Raw

STEPS = 40
HOLD = 10


def made(library, kind):
    """An instance that can be stepped or evaluated."""
    clocked = bool(library.fmu.clocks)
    instance = Raw(library, kind, event_mode=clocked)
    assert instance.initialize() == OK, instance.messages
    if clocked and kind == "CoSimulation":
        assert (instance.update(), instance.call("EnterStepMode")) == (OK, OK)
    return instance


def step(instance, k):
    """One step, with inputs that change now and then; the bits that are seen."""
    if k % HOLD == 0:
        assert instance.set(sequence(instance.fmu, k // HOLD)) == OK
    assert instance.step(k * STEP, (k + 1) * STEP - k * STEP) == OK, instance.messages
    return instance.get()


def alone(fmu):
    """All that an instance sees when its library is the only one."""
    with Library(fmu) as library, made(library, "CoSimulation") as instance:
        return [step(instance, k) for k in range(STEPS)]


def test_all_fmus_live_in_one_process():
    """Every archive of both versions at once, stepped in turns; half of them leave on the way."""
    expected = {key: alone(fmu) for key, fmu in FMUS.items()}
    libraries = {key: Library(fmu) for key, fmu in FMUS.items()}
    instances = {key: made(library, "CoSimulation") for key, library in libraries.items()}
    exchanges = [made(library, "ModelExchange") for library in libraries.values()]
    seen = {key: [] for key in FMUS}
    leaving = list(FMUS)[::2]
    for k in range(STEPS):
        if k == STEPS // 2:
            for exchange in exchanges:
                exchange.free()
            for key in leaving:
                instances.pop(key).free()
                libraries.pop(key).close()
        for key, instance in instances.items():
            seen[key].append(step(instance, k))
    for key, rows in seen.items():
        assert rows == expected[key][: len(rows)] and len(rows) in (STEPS, STEPS // 2), key
    for key, instance in instances.items():
        instance.free()
        libraries[key].close()
