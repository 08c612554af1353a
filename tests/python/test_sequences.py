"""What importers are known to do to an FMU, call by call. Each row goes through a run and sees what any other host sees.

The rows were seen by tracing importers; what they have in common – a location of resources that does not exist, no
environment, no stop time – is in most of them.
"""

import ctypes
from ctypes import c_bool, c_double, c_int, c_size_t, c_uint32, c_void_p

import pytest
from host import sequence
from raw import OK, Library, Raw

STEPS, SIZE = 20, 0.1
HOSTS = {
    # name: location in FMI 2.0, location in FMI 3.0, options of the instance, options of the run
    "FMPy": ("file:///some/dir/resources", "/some/dir/resources/", {}, {"stop": True, "early": True}),
    "fmusim 0.0": ("file:///some/dir/resources/", "/some/dir/resources/", {"environment": 8}, {}),
    "fmusim 0.8": (None, None, {"environment": 8}, {"counts": True}),
    "fmi-sim": ("file:///some/dir/resources", "/some/dir/resources", {"logging": True, "visible": True}, {}),
    "OMSimulator": (
        "file:////some/dir/resources",
        "/some/dir/resources",
        {"logging": True, "visible": True},
        {"tolerance": 1e-4, "stop": True, "extra": True},
    ),
    "Ecos": ("file:////some/dir/resources", "/some/dir/resources", {"name": b"/some/dir/A model.fmu"}, {"blind": True}),
    "libcosim": ("file:///some/libcosim_x/00-00/resources", "/some/00-00/resources", {"logging": True}, {}),
    "fmuCheck": ("file:///some/dir/resources", None, {"logging": True, "environment": 8}, {"asks": True, "empty": True}),
    "PyFMI": (
        "file:///some/JModelica.org/x/resources",
        None,
        {"logging": True, "environment": 8},
        {"tolerance": 1e-4, "nominals": True},
    ),
    "cofmupy": ("file:///some/dir/resources", "/some/dir/resources/", {}, {"abandon": True}),
    "odd": ("file:/some%20dir/%7B0%7D/resources", "/some dir/{0}/ü/", {}, {"late": True}),
}
"""The last is no importer: what URIs and paths may hold, and communication points that are sums."""


def opened(library, kind, host):
    """An instance as the host makes it."""
    two, three, options, _ = HOSTS[host]
    location = two if library.fmu.is_fmi2 else three
    location = location if location is None else location.encode()
    return Raw(library, kind, resources=location, **options)


def started(instance, host):
    """From instantiated to the end of initialization."""
    run, n = HOSTS[host][3], c_size_t(0)
    if run.get("empty"):
        for name in ("Real",) if instance.fmu.is_fmi2 else ("Float64",):
            sizes = [] if instance.fmu.is_fmi2 else [n]
            assert instance.call("Set" + name, c_void_p(None), n, c_void_p(None), *sizes) == OK
    if run.get("counts") and not instance.fmu.is_fmi2:
        for name in ("GetNumberOfContinuousStates", "GetNumberOfEventIndicators"):
            assert instance.call(name, ctypes.byref(c_size_t())) == OK
    frame = {"tolerance": run.get("tolerance"), "stop": STEPS * SIZE if run.get("stop") else None}
    assert instance.initialize(inputs=sequence(instance.fmu, 1), **frame) == OK


def by_co_simulation(library, host):
    """What a host sees that reads everything at the end; most read after every step."""
    run = HOSTS[host][3]
    instance = opened(library, "CoSimulation", host)
    assert instance.pointer, instance.messages
    started(instance, host)
    if run.get("early"):
        instance.get()
    time = 0.0
    for k in range(STEPS):
        assert instance.step(time if run.get("late") else k * SIZE, SIZE) == OK, instance.messages
        time += SIZE
        if not run.get("blind"):
            instance.get()
    seen = instance.get()
    if run.get("extra"):
        assert instance.step(STEPS * SIZE, SIZE) == OK, "one step more than the stop time asks for"
    if run.get("asks") and instance.fmu.is_fmi2:
        reached, ended = c_double(), c_int()
        assert instance.call("GetRealStatus", c_int(2), ctypes.byref(reached)) == OK
        assert reached.value == pytest.approx(STEPS * SIZE)
        assert instance.call("GetBooleanStatus", c_int(3), ctypes.byref(ended)) == OK and ended.value == 0
    if not run.get("abandon"):
        assert instance.call("Terminate") == OK
        instance.free()
    assert [message for message in instance.messages if message[2] != OK] == []
    return seen


def by_model_exchange(library, host):
    """What a host sees after the event iteration and at the end of two steps of Euler's method."""
    fmu, run = library.fmu, HOSTS[host][3]
    n, m = fmu.description.numberOfContinuousStates, fmu.description.numberOfEventIndicators
    derivatives = "GetDerivatives" if fmu.is_fmi2 else "GetContinuousStateDerivatives"
    instance = opened(library, "ModelExchange", host)
    assert instance.pointer, instance.messages
    started(instance, host)
    assert instance.update() == OK
    assert instance.call("EnterContinuousTimeMode") == OK
    x, dx, z = (c_double * n)(), (c_double * n)(), (c_double * m)()
    if run.get("nominals"):
        assert instance.call("GetNominalsOfContinuousStates", x, c_size_t(n)) == OK
    assert instance.call("GetEventIndicators", z, c_size_t(m)) == OK
    assert instance.call(derivatives, dx, c_size_t(n)) == OK
    assert instance.call("GetContinuousStates", x, c_size_t(n)) == OK
    for k in range(2):
        assert instance.call("SetTime", c_double((k + 1) * 1e-3)) == OK
        x = (c_double * n)(*[value + 1e-3 * rate for value, rate in zip(x, dx)])
        assert instance.call("SetContinuousStates", x, c_size_t(n)) == OK
        assert instance.call(derivatives, dx, c_size_t(n)) == OK
        assert instance.call("GetEventIndicators", z, c_size_t(m)) == OK
        flag = c_int if fmu.is_fmi2 else c_bool
        assert instance.call("CompletedIntegratorStep", flag(1), ctypes.byref(flag()), ctypes.byref(flag())) == OK
    seen = bytes(x), bytes(dx), bytes(z), instance.get()
    if not run.get("abandon"):
        assert instance.call("Terminate") == OK
        instance.free()
    assert [message for message in instance.messages if message[2] != OK] == []
    return seen


def near(seen, expected, fmu):
    """Values read with other tolerances: near rather than equal."""
    for name, value in expected.items():
        v = fmu.variables[name]
        if v.type in ("Real", "Float64"):
            pairs = zip(memoryview(seen[name]).cast("d"), memoryview(value).cast("d"))
            assert all(a == pytest.approx(b, rel=1e-2, abs=1e-2) for a, b in pairs), name
        else:
            assert seen[name] == value, name


@pytest.mark.parametrize("host", HOSTS)
def test_a_host_steps_an_fmu(fmu, host):
    """Whatever it does beside, the bits are the same; but for its tolerance, and for times that it adds up."""
    with Library(fmu) as library:
        expected, seen = by_co_simulation(library, "fmusim 0.0"), by_co_simulation(library, host)
    if "tolerance" in HOSTS[host][3] or "late" in HOSTS[host][3]:
        near(seen, expected, fmu)
    else:
        assert seen == expected


@pytest.mark.parametrize("host", HOSTS)
def test_a_host_integrates_an_fmu(fmu, host):
    """The bits are the same for every host."""
    with Library(fmu) as library:
        assert by_model_exchange(library, host) == by_model_exchange(library, "fmusim 0.0")


def test_both_interfaces_one_after_the_other_and_at_once(fmu):
    """As fmuCheck does, and PyFMI."""
    with Library(fmu) as library:
        expected = by_model_exchange(library, "fmuCheck"), by_co_simulation(library, "fmuCheck")
        with opened(library, "ModelExchange", "PyFMI") as other:
            assert by_co_simulation(library, "fmuCheck") == expected[1]
            started(other, "PyFMI")
            assert by_model_exchange(library, "fmuCheck") == expected[0]


def test_required_variables_may_dangle_when_there_are_none(fmu):
    """fmusim passes no variables for intermediate updates, FMPy an array of its own with a length of 0."""
    if fmu.is_fmi2:
        pytest.skip("FMI 2.0 has no intermediate updates")
    token, none = fmu.description.instantiationToken.encode(), c_void_p(None)
    with Library(fmu) as library:
        make = library.dll.fmi3InstantiateCoSimulation
        make.restype = c_void_p
        for array in (none, c_void_p(4), (c_uint32 * 1)(2**31)):
            flags = [c_bool(flag) for flag in (False, False, False, False)]
            pointer = make(b"a", token, none, *flags, array, c_size_t(0), none, none, none)
            assert pointer
            library.dll.fmi3FreeInstance(c_void_p(pointer))
