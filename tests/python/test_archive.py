"""What lies in the archives, and what the model descriptions say beside what validators check."""

import re
import struct
import xml.etree.ElementTree as xml
import zipfile
from urllib.parse import unquote

import platform

from host import FLOATS, elements

CLOCKS = True

MACHINES = {"x86_64": "x86_64", "amd64": "x86_64", "aarch64": "aarch64", "arm64": "aarch64"}
SUFFIXES = {"Linux": ("linux", ".so"), "Darwin": ("darwin", ".dylib"), "Windows": ("windows", ".dll")}


def binary(fmu):
    """Where the standard wants this platform's library."""
    machine, (system, suffix) = MACHINES[platform.machine().lower()], SUFFIXES[platform.system()]
    short = {"linux": "linux64", "darwin": "darwin64", "windows": "win64"}[system]
    folder = short if fmu.is_fmi2 and machine == "x86_64" else f"{machine}-{system}"
    return f"binaries/{folder}/{fmu.description.modelName}{suffix}"


def test_archive_holds_what_an_fmu_needs(fmu):
    """Description, this platform's library, documentation with its licence, icon; nothing else."""
    with zipfile.ZipFile(fmu.path) as archive:
        entries = {entry.filename: entry for entry in archive.infolist()}
        assert archive.testzip() is None
        icons = ["model.png"] if fmu.is_fmi2 else ["terminalsAndIcons/icon.png", "terminalsAndIcons/icon.svg"]
        wanted = {"modelDescription.xml", binary(fmu), "documentation/index.html", *icons}
        assert wanted <= entries.keys()
        extra = entries.keys() - wanted
        allowed = re.compile(r"(resources|documentation|extra)/.+|terminalsAndIcons/terminal(sAndIcons\.xml|\.png|\.svg)")
        assert all(allowed.fullmatch(name) for name in extra), extra
        assert "documentation/licenses/license.txt" in extra
        for entry in entries.values():
            assert entry.compress_type in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)
            assert not entry.flag_bits & 1, "encrypted"
            assert entry.extract_version <= 20
            assert entry.date_time == (1980, 1, 1, 0, 0, 0), "the day of the build would change the bytes"
        for icon in icons:
            data = archive.read(icon)
            if icon.endswith(".svg"):
                assert xml.fromstring(data).tag == "{http://www.w3.org/2000/svg}svg"
            else:
                assert data[:8] == b"\x89PNG\r\n\x1a\n"
                assert min(struct.unpack(">II", data[16:24])) >= 32


def test_licences_of_what_is_linked_are_there(fmu):
    """Crates that every FMU is made with are named with their licence and its text; tools of the build are not."""
    with zipfile.ZipFile(fmu.path) as archive:
        text = archive.read("documentation/licenses/third-party.txt").decode("utf-8")
        standard_library = archive.read("documentation/licenses/rust-standard-library.html").decode("utf-8")
    listed, *texts = text.split("=" * 80)
    crates = {line.split()[0] for line in listed.splitlines() if line.startswith("  ")}
    assert {"postcard", "quick-xml", "serde"} <= crates
    assert not crates & {"syn", "quote", "serde_derive", "cc"}
    for crate in crates - {"the"}:
        assert any(f" of {crate} " in part for part in texts), crate
    assert any("Permission is hereby granted" in part for part in texts)
    assert any("Apache License" in part for part in texts)
    assert "The Rust Standard Library" in standard_library


def test_documentation_is_a_page_of_its_own(fmu):
    """Names the model, has its icon and text, and loads nothing from elsewhere."""
    with zipfile.ZipFile(fmu.path) as archive:
        page = archive.read("documentation/index.html").decode("utf-8")
        if not fmu.is_fmi2:
            icon = archive.read("terminalsAndIcons/icon.svg").decode("utf-8")
            assert unquote(re.search('src="data:image/svg[+]xml,([^"]*)"', page)[1]) == icon
    assert page.lstrip().lower().startswith("<!doctype html>")
    assert fmu.description.modelName in page
    # FMUs for tests have a short page; a page with equations tells every variable that a user meets.
    if "Equations</h2>" in page:
        met = ("input", "output", "parameter")
        # Elements of arrays are told together.
        names = {re.sub(r"\[[\d,]+\]", "", v.name) for v in fmu.description.modelVariables if v.causality in met}
        assert [name for name in names if name not in page] == []
    assert not re.search(r"(?:src|@import)\s*[=(]?\s*[\"']?https?:", page)


def test_description_is_complete(fmu):
    """Name, interfaces, default experiment, naming convention, log categories."""
    md = fmu.description
    assert md.modelName == fmu.path.stem
    assert md.fmiVersion == ("2.0" if fmu.is_fmi2 else "3.0")
    for interface in (md.coSimulation, md.modelExchange):
        assert interface.modelIdentifier == md.modelName
        assert not interface.needsExecutionTool
        assert not interface.canBeInstantiatedOnlyOncePerProcess
    assert md.variableNamingConvention == "structured"
    experiment = md.defaultExperiment
    assert float(experiment.startTime) == 0.0
    assert 0.0 < float(experiment.stepSize) < float(experiment.stopTime)
    assert 0.0 < float(experiment.tolerance) <= 1e-4
    assert md.logCategories
    assert all(v.description for v in md.modelVariables), [v.name for v in md.modelVariables if not v.description]


def test_units_are_si(fmu):
    """Every unit in use is defined by SI base units with factor 1; angles are shown in degrees."""
    units = {unit.name: unit for unit in fmu.description.unitDefinitions}
    for v in fmu.variables.values():
        unit = v.unit or (v.declaredType.unit if v.declaredType else None)
        if v.type in FLOATS and unit is not None:
            base = units[unit].baseUnit
            assert base is not None, unit
            assert float(base.factor or 1.0) == 1.0 and float(base.offset or 0.0) == 0.0, unit
    if "rad" in units:
        degrees = {d.name: float(d.factor) for d in units["rad"].displayUnits}
        assert abs(degrees["deg"] - 57.29577951308232) < 1e-13


def test_both_versions_declare_the_same_variables(both):
    """Names, causality, variability, start values and units agree."""
    fmi2, fmi3, _ = both
    assert flat(fmi2) == flat(fmi3)


def flat(fmu):
    """Every scalar with what is said of it."""
    kinds = {"Real": "Float64", "Integer": "Int32"}
    scalars = {}
    for v in fmu.variables.values():
        if v.causality == "structuralParameter":
            # FMI 2.0 has arrays of their default length.
            continue
        unit = v.unit or (v.declaredType.unit if v.declaredType else None)
        said = (kinds.get(v.type, v.type), v.causality, v.variability, v.initial, unit, v.description)
        names = elements(v)
        starts = v.start.split() if v.shape and v.start is not None else [v.start]
        for name, start in zip(names, starts * (len(names) if len(starts) == 1 else 1)):
            scalars[name] = (*said, number(start))
    return scalars


def number(start):
    """A start value, compared as a number where it is one."""
    try:
        return float(start)
    except (TypeError, ValueError):
        return start
