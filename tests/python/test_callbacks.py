"""What an FMU hands to its host: messages as they are, the host's own environment, and nothing where there is no callback."""

import ctypes
from ctypes import c_char_p, c_int, c_size_t, c_void_p

import pytest
from host import STEP
from raw import ERROR, OK, Callbacks2, Library, Raw

KINDS = ("CoSimulation", "ModelExchange")
NASTY = "%n%s%d%% #1# \\ ü"
"""What would be an instruction to `printf`, the beginning of a variable's reference, and no ASCII."""


def provoke(instance):
    """An error whose message holds a text of the host's."""
    names = (c_char_p * 1)(NASTY.encode())
    assert instance.call("SetDebugLogging", c_int(1), c_size_t(1), names) == ERROR


@pytest.mark.parametrize("kind", KINDS)
def test_messages_come_through_as_they_are(fmu, kind):
    """In FMI 2.0 through the format `%s`; `#` is doubled, since one begins a reference to a variable there."""
    environment = 0x5157
    with Library(fmu) as library:
        with Raw(library, kind, name=NASTY.encode(), environment=environment) as instance:
            provoke(instance)
            [(given, name, status, category, text, form)] = instance.messages
            assert NASTY.replace("#", "##") in text.decode()
            assert (given, status, category) == (environment, ERROR, b"logStatusError")
            if fmu.is_fmi2:
                assert (name.decode(), form) == (NASTY, b"%s")


@pytest.mark.parametrize("kind", KINDS)
def test_each_instance_keeps_its_own_host(fmu, kind):
    """The environment of the one that errs; its name was copied when it was made."""
    with Library(fmu) as library:
        name = ctypes.create_string_buffer(b"first")
        with Raw(library, kind, name=name, environment=1) as first, Raw(library, kind, environment=2) as second:
            name.value = b"gone!"
            provoke(first)
            assert [message[0] for message in first.messages] == [1] and second.messages == []
            provoke(second)
            assert [message[0] for message in second.messages] == [2] and len(first.messages) == 1
            if fmu.is_fmi2:
                assert first.messages[0][1] == b"first"


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("missing", ["logger", "callbacks"])
def test_nobody_has_to_listen(fmu, kind, missing):
    """Without a logger, or in FMI 2.0 without any callbacks, errors are told by their status only."""
    if missing == "callbacks" and not fmu.is_fmi2:
        pytest.skip("FMI 3.0 has no structure of callbacks")
    with Library(fmu) as library:
        with Raw(library, kind, logging=True, **{missing: None}) as instance:
            provoke(instance)
            assert (instance.call("Reset"), instance.initialize()) == (OK, OK)
            if kind == "CoSimulation":
                assert instance.step(0.0) == OK
            assert instance.call("ExitInitializationMode") == ERROR
        assert Raw(library, kind, token=b"another", logging=True, **{missing: None}).pointer is None


@pytest.mark.parametrize("kind", KINDS)
def test_what_makes_no_instance(fmu, kind):
    """NULL and a message: without a name, with the token of another FMU, without one."""
    with Library(fmu) as library:
        for wrong in ({"name": None}, {"name": b""}, {"token": b"{0}"}, {"token": b""}):
            refused = Raw(library, kind, environment=7, **wrong)
            assert refused.pointer is None
            [(given, _, status, category, text, _)] = refused.messages
            assert (given, status, category) == (7, ERROR, b"logStatusError") and text, wrong


def test_memory_of_the_host_is_not_used(fmu):
    """`canNotUseMemoryManagementFunctions`: a host may count, or offer functions that fail."""
    if not fmu.is_fmi2:
        pytest.skip("FMI 3.0 has no functions for memory")
    used = []
    allocate = ctypes.CFUNCTYPE(c_void_p, c_size_t, c_size_t)(lambda count, size: used.append((count, size)))
    free = ctypes.CFUNCTYPE(None, c_void_p)(used.append)
    finished = ctypes.CFUNCTYPE(None, c_void_p, c_int)(lambda environment, status: used.append(status))
    callbacks = Callbacks2(*[ctypes.cast(callback, c_void_p) for callback in (allocate, allocate, free, finished)])
    callbacks.logger = None
    with Library(fmu) as library:
        made = library.dll.fmi2Instantiate
        made.restype = c_void_p
        token = fmu.description.guid.encode()
        pointer = c_void_p(made(b"a", 1, token, None, ctypes.byref(callbacks), 0, 1))
        assert pointer
        calls = library.dll
        zero = ctypes.c_double(0.0)
        assert calls.fmi2SetupExperiment(pointer, 0, zero, zero, 0, zero) == OK
        assert calls.fmi2EnterInitializationMode(pointer) == OK
        assert calls.fmi2ExitInitializationMode(pointer) == OK
        assert calls.fmi2DoStep(pointer, zero, ctypes.c_double(STEP), 1) == OK
        state = c_void_p()
        assert calls.fmi2GetFMUstate(pointer, ctypes.byref(state)) == OK
        assert calls.fmi2FreeFMUstate(pointer, ctypes.byref(state)) == OK
        calls.fmi2FreeInstance.restype = None
        calls.fmi2FreeInstance(pointer)
    assert used == []


def test_the_library_says_what_it_is(fmu):
    """Its version and platform, before there is an instance."""
    with Library(fmu) as library:
        def text(name):
            function = getattr(library.dll, name)
            function.restype = c_char_p
            return function()

        assert (text("fmi2GetVersion"), text("fmi2GetTypesPlatform"), text("fmi3GetVersion")) == (b"2.0", b"default", b"3.0")
