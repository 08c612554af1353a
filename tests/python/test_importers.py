"""Importers that others wrote take every FMU through its default experiment and see what FMPy sees.

libcosim (C++, on FMI Library) reads FMI 2.0, Ecos (C++, on fmi4c) FMI 2.0 and FMI 3.0; neither knows model exchange.
Ecos adds step sizes up and libcosim counts nanoseconds, so that their times differ from `k·h` in the last bits.
"""

import ctypes
import math
import platform
import sys
import sysconfig
from pathlib import Path

import pytest
from host import Instance, sequence

if sys.platform != "linux" or platform.machine() != "x86_64" or sys.version_info < (3, 11):
    pytest.skip("there are no wheels of libcosim for this platform", allow_module_level=True)

# Ecos needs a library that lies in another wheel, where the loader does not look.
ctypes.CDLL(str(Path(sysconfig.get_path("data"), "lib", "libtbb.so.12")), mode=ctypes.RTLD_GLOBAL)

# pylint: disable=wrong-import-position
from ecospy import EcosLib, EcosSimulation, EcosSimulationStructure
from libcosimpy.CosimEnums import CosimErrorCode
from libcosimpy.CosimExecution import CosimExecution
from libcosimpy.CosimLogging import CosimLogLevel, log_output_level
from libcosimpy.CosimManipulator import CosimManipulator
from libcosimpy.CosimObserver import CosimObserver
from libcosimpy.CosimSlave import CosimLocalSlave

KINDS = {"Real": "real", "Float64": "real", "Integer": "integer", "Int32": "integer", "Boolean": "boolean"}
"""What both importers call the types they know; they know no arrays, and their own enumerations only."""
LOOKS = 20
"""How often values are compared."""
TOLERANCE = 1e-9
"""Times that differ by 1e-14 s move a trajectory by less; an event on the other side of a sample moves it by much more."""

EcosLib.set_log_level("err")
log_output_level(CosimLogLevel.FATAL)


def known(variables):
    """The variables that the importers can read; FMPy lists aliases, which Ecos does not know."""
    first = {v.valueReference: v for v in reversed(variables)}
    return [v for v in variables if v.type in KINDS and not v.shape and first[v.valueReference] is v]


def experiment(fmu):
    """The step size of the default experiment and the steps after which is looked."""
    default = fmu.description.defaultExperiment
    size, count = float(default.stepSize), round(float(default.stopTime) / float(default.stepSize))
    return size, [count * i // LOOKS for i in range(LOOKS + 1)]


def inputs(fmu, i):
    """The inputs between two looks, for importers that set what they know."""
    names = {v.name for v in known(fmu.inputs)}
    return {name: value for name, value in sequence(fmu, i).items() if name in names}


def by_fmpy(fmu):
    """What an instance shows by FMPy."""
    size, looks = experiment(fmu)
    with Instance(fmu, "CoSimulation") as instance:
        instance.initialize({}, {})
        for i, (k, until) in enumerate(zip(looks, looks[1:])):
            instance.set(inputs(fmu, i))
            for n in range(k, until):
                instance.api.doStep(n * size, size)
            yield instance.get(known(fmu.observed()))


def by_ecos(fmu):
    """The same by Ecos."""
    size, looks = experiment(fmu)
    verbs = {"real": "real", "integer": "integer", "boolean": "bool"}
    with EcosSimulationStructure() as structure:
        structure.add_model("a", str(fmu.path))
        with EcosSimulation(step_size=size, structure=structure) as simulation:
            assert simulation.init(), EcosLib.get_last_error()
            for i, (k, until) in enumerate(zip(looks, looks[1:])):
                for name, value in inputs(fmu, i).items():
                    verb = verbs[KINDS[fmu.variables[name].type]]
                    getattr(simulation, "set_" + verb)("a::" + name, value)
                simulation.step(until - k)
                yield {
                    v.name: getattr(simulation, "get_" + verbs[KINDS[v.type]])("a::" + v.name)
                    for v in known(fmu.observed())
                }
            assert simulation.get_time() == pytest.approx(looks[-1] * size)
            simulation.terminate()


def by_libcosim(fmu):
    """The same by libcosim."""
    size, looks = experiment(fmu)
    execution = CosimExecution.from_step_size(round(size * 1e9))
    slave = CosimLocalSlave(str(fmu.path), "a")
    index = execution.add_local_slave(slave)
    manipulator, observer = CosimManipulator.create_override(), CosimObserver.create_last_value()
    assert execution.add_manipulator(manipulator) and execution.add_observer(observer)
    for i, (k, until) in enumerate(zip(looks, looks[1:])):
        for name, value in inputs(fmu, i).items():
            v = fmu.variables[name]
            set_values = getattr(manipulator, f"slave_{KINDS[v.type]}_values")
            assert set_values(index, [v.valueReference], [value])
        assert execution.step(until - k)
        assert execution.status().error_code == CosimErrorCode.SUCCESS.value, execution.status()
        yield {
            v.name: getattr(observer, f"last_{KINDS[v.type]}_values")(index, [v.valueReference])[0]
            for v in known(fmu.observed())
        }


@pytest.mark.parametrize("importer", [by_ecos, by_libcosim])
def test_another_importer_sees_what_fmpy_sees(fmu, importer):
    """All outputs and local variables that it can read, twenty times."""
    if importer is by_libcosim and not fmu.is_fmi2:
        pytest.skip("libcosim reads FMI 2.0")
    expected, seen = list(by_fmpy(fmu)), list(importer(fmu))
    assert len(seen) == len(expected) == LOOKS and seen[0]
    worst = 0.0
    for i, (row, other) in enumerate(zip(expected, seen)):
        for name, value in row.items():
            apart = abs(float(value) - float(other[name]))
            worst = max(worst, apart)
            assert math.isclose(value, other[name], rel_tol=TOLERANCE, abs_tol=TOLERANCE), f"{name}, look {i}"
    assert any(row != expected[0] for row in expected) or not fmu.inputs, "nothing moves"
    print(f"{len(expected[0])} variables, largest difference {worst:.1e}", end=" ")
