"""What a process keeps of itself around an FMU: settings, signals, files, threads, and the library when it is unloaded."""

import ctypes
import gc
import os
import sys

import pytest
from host import STEP, sequence
from raw import OK, Library, Raw, library_path

pytestmark = pytest.mark.skipif(not sys.platform.startswith("linux"), reason="looks into /proc")
libc, libm = ctypes.CDLL(None), ctypes.CDLL("libm.so.6")
FE_UPWARD = {"x86_64": 0x800, "aarch64": 0x400000}
LC_ALL = 6
SIGNALS = range(1, 65)


def life(library, kind):
    """An instance from its making to its end, with steps or evaluations, a state, and an error."""
    with Raw(library, kind, logging=True) as instance:
        assert instance.initialize() == OK
        if kind == "CoSimulation":
            assert [instance.step(k * STEP) for k in range(20)] == [OK] * 20
            instance.set(sequence(library.fmu, 2))
            assert instance.step(20 * STEP) == OK
        else:
            assert (instance.update(), instance.call("EnterContinuousTimeMode")) == (OK, OK)
            assert instance.derivatives() == OK
        status, state = instance.take()
        assert status == OK and instance.release(state) == OK
        assert instance.call("ExitInitializationMode") != OK
        assert instance.call("Reset") == OK


class SignalAction(ctypes.Structure):
    """glibc's `struct sigaction`; of the mask it fills the first word only."""

    _fields_ = [("handler", ctypes.c_void_p), ("mask", ctypes.c_uint64 * 16), ("flags", ctypes.c_int),
                ("restorer", ctypes.c_void_p)]


def actions():
    """What each signal does."""
    found = {}
    for signal in SIGNALS:
        action = SignalAction()
        if libc.sigaction(signal, None, ctypes.byref(action)) == 0:
            found[signal] = action.handler, action.mask[0], action.flags
    return found


def control():
    """Rounding, precision, and which floating-point exceptions trap; not those raised so far."""
    return libm.fegetround(), libm.fegetexcept()


def settings():
    """What of the process is the host's."""
    libc.setlocale.restype = ctypes.c_char_p
    mask = (ctypes.c_byte * 128)()
    libc.pthread_sigmask(0, None, ctypes.byref(mask))
    return {
        "locale": libc.setlocale(LC_ALL, None),
        "signals": actions(),
        "blocked": bytes(mask),
        "floating point": control(),
        "folder": os.getcwd(),
        "mask of files": os.umask(os.umask(0o22)),
        "environment": dict(os.environ),
        "files": sorted(os.readlink(entry.path) for entry in os.scandir("/proc/self/fd") if os.path.exists(entry.path)),
        "threads": sorted(os.listdir("/proc/self/task")),
    }


@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
def test_the_process_stays_as_it_was(fmu, kind):
    """The library loaded, used, and unloaded; looked at before, in between and after."""
    before = settings()
    library = Library(fmu)
    life(library, kind)
    between = settings()
    library.close()
    assert between == before
    assert settings() == before


def test_another_way_of_rounding_is_left_alone(fmu):
    """A host may round as it likes, and finds it as it left it."""
    library, upward = Library(fmu), FE_UPWARD[os.uname().machine]
    try:
        assert libm.fesetround(upward) == 0
        life(library, "CoSimulation")
        assert libm.fegetround() == upward
    finally:
        libm.fesetround(0)
        library.close()


def mapped(fmu):
    """Whether the library is in the process's memory."""
    with open("/proc/self/maps", encoding="utf-8") as maps:
        return str(library_path(fmu)) in maps.read()


def held():
    """Memory of the process that cannot be shared (bytes), without Python objects that nobody has collected yet."""
    gc.collect()
    with open("/proc/self/statm", encoding="ascii") as statm:
        size, resident, shared, *_ = map(int, statm.read().split())
    return (resident - shared) * 4096


def test_the_library_can_be_unloaded_and_loaded_again(fmu):
    """Fifty times: dlclose really unloads it, so no thread or thread-local destructor of it is left, and nothing grows."""
    assert not mapped(fmu)
    begin = 0
    for round_ in range(50):
        if round_ == 10:
            begin = held()
        library = Library(fmu)
        assert mapped(fmu)
        life(library, ("CoSimulation", "ModelExchange")[round_ % 2])
        library.close()
        assert not mapped(fmu)
    assert held() - begin < 400_000, "forty loads leave more than 10 kB each"


def test_a_library_that_panicked_can_be_unloaded(named):
    """What Rust's runtime does at a panic does not tie the library to the thread either."""
    for version in ("fmi2", "fmi3"):
        fmu = named(version, "Faulty")
        library = Library(fmu)
        with Raw(library, "CoSimulation") as instance:
            assert instance.initialize({"fault": "derivatives"}) == OK
            assert instance.step(0.0) != OK
        library.close()
        assert not mapped(fmu)
