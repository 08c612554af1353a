"""Finds the packaged FMUs: the folders `fmi2` and `fmi3` below the folder that SWAYLESS_FMUS names.

A test that asks for `fmu` runs for every archive; one that asks for `case` runs for every archive and every variant of
its parameters; one that asks for `both` runs for every name and variant, with the archives of both versions. An FMU
with clocks does nothing unless it is told how time goes: a module takes such archives as well if it says `CLOCKS = True`,
and one that asks for `clocked` runs for each of them, with the FMU of the same model that ticks its clocks itself.
"""

import os
import tempfile
from pathlib import Path

import pytest
from host import Fmu

FOLDER = Path(os.environ["SWAYLESS_FMUS"])
PATHS = sorted(FOLDER.glob("fmi[23]/*.fmu"))
UNPACKED = tempfile.TemporaryDirectory(prefix="swayless-fmus-")
FMUS = {(path.parent.name, path.stem): Fmu(path, Path(UNPACKED.name, path.parent.name, path.stem)) for path in PATHS}


def label(variant):
    """A variant in a test's name."""
    return ",".join(f"{name}={value}" for name, value in variant.items()) or "default"


def pytest_generate_tests(metafunc):
    """Parametrizes by fixture name."""
    wanted = {key: fmu for key, fmu in FMUS.items() if not fmu.clocks or getattr(metafunc.module, "CLOCKS", False)}
    if "fmu" in metafunc.fixturenames:
        metafunc.parametrize("fmu", wanted.values(), ids=["/".join(key) for key in wanted])
    if "clocked" in metafunc.fixturenames:
        keys = [key for key, fmu in FMUS.items() if fmu.clocks]
        twins = [FMUS[version, name.removesuffix("Clocked")] for version, name in keys]
        metafunc.parametrize("clocked", [(FMUS[key], twin) for key, twin in zip(keys, twins)], ids=["/".join(k) for k in keys])
    if "case" in metafunc.fixturenames:
        cases = [(key, fmu, variant) for key, fmu in wanted.items() for variant in fmu.variants()]
        ids = ["/".join(key) + "-" + label(variant) for key, _, variant in cases]
        metafunc.parametrize("case", [(fmu, variant) for _, fmu, variant in cases], ids=ids)
    if "both" in metafunc.fixturenames:
        # An FMU with clocks has no archive for FMI 2.0.
        names = sorted(name for version, name in FMUS if version == "fmi2")
        cases = [(name, variant) for name in names for variant in FMUS["fmi3", name].variants()]
        pairs = [(FMUS["fmi2", name], FMUS["fmi3", name], variant) for name, variant in cases]
        metafunc.parametrize("both", pairs, ids=[f"{name}-{label(variant)}" for name, variant in cases])


@pytest.fixture(scope="session")
def named():
    """The FMU of a version's folder and a name."""
    return lambda version, name: FMUS[version, name]
