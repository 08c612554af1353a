"""The reference run that an archive carries (FMI-LS-REF), replayed by FMPy as an importer would to check itself."""

import io
import math
import posixpath
import xml.etree.ElementTree as xml
import zipfile

import numpy as np
import pytest
from fmpy import simulate_fmu

FOLDER = "extra/org.fmi-standard.fmi-ls-ref"
MANIFEST = f"{FOLDER}/fmi-ls-manifest.xml"
SPACE = "{http://fmi-standard.org/fmi-ls-manifest}"

# The same library takes the same steps with the same tolerance, so results agree to the last bits that FMPy's clock,
# which adds steps up, may cost: 20 s in steps of 0.01 s sum up to 1e-13 relative errors of time.
CLOSE = {"rtol": 1e-9, "atol": 1e-10}


def table(archive, name):
    """A CSV file."""
    return np.genfromtxt(io.BytesIO(archive.read(name)), delimiter=",", names=True, deletechars="", dtype=float)


def experiment(path):
    """Checks the manifest and returns the experiment, its input or None, and its results."""
    with zipfile.ZipFile(path) as archive:
        if MANIFEST not in archive.namelist():
            return None
        root = xml.fromstring(archive.read(MANIFEST))
        assert root.tag == "fmiReferences"
        assert root.get(f"{SPACE}fmi-ls-name") == "org.fmi-standard.fmi-ls-ref"
        assert root.get(f"{SPACE}fmi-ls-version") == "1.0.0-alpha.1"
        assert root.get(f"{SPACE}fmi-ls-description")
        related = {item.get("role"): item for item in root.findall("Related")}
        sources = {posixpath.join(FOLDER, item.get("source")) for item in root.findall("Related")}
        others = {name for name in archive.namelist() if name.startswith(FOLDER)} - {MANIFEST}
        assert sources == others, "the manifest lists what there is"
        assert all(archive.getinfo(name).file_size <= 30_000 for name in others)
        item = related["experiment/smoke-test"]
        assert item.get("type") == "application/x-ma-hs-experiments"
        (run,) = xml.fromstring(archive.read(posixpath.join(FOLDER, item.get("source")))).findall("Experiment")
        stimuli = run.find("Stimuli")
        given = None if stimuli is None else table(archive, posixpath.join(FOLDER, stimuli.get("source")))
        return run, given, table(archive, posixpath.join(FOLDER, run.find("References").get("source")))


def test_fmpy_gets_the_reference_results(fmu):
    """Every archive with co-simulation and scalar outputs carries a run, and FMPy agrees with it."""
    found = experiment(fmu.path)
    if found is None:
        md = fmu.description
        outputs = [v for v in md.modelVariables if v.causality == "output" and v.type in ("Real", "Float64")]
        # In FMI 2.0 the elements of arrays.
        scalars = [v for v in outputs if not v.dimensions and not v.name.endswith("]")]
        offers = md.coSimulation is not None and any(not v.clocks for v in scalars)
        if offers and not fmu.path.stem.endswith("Clocked"):
            pytest.fail("no reference run")
        return
    run, given, reference = found
    step, stop = float(run.get("stepSize")), float(run.get("stopTime"))
    times = reference["time"]
    assert times[0] == float(run.get("startTime")) and times[-1] <= stop and 10 <= len(times) <= 51
    names = [name for name in reference.dtype.names if name != "time"]
    # FMPy makes linear what stands between two points, as the manifest wants it.
    result = simulate_fmu(
        fmu.path, fmi_type="CoSimulation", stop_time=stop, step_size=step, relative_tolerance=float(run.get("tolerance")),
        output_interval=step, input=given, output=names,
    )
    rows = [round(time / step) for time in times]
    assert math.isclose(result["time"][rows[-1]], times[-1], rel_tol=1e-9)
    for name in names:
        np.testing.assert_allclose(result[name][rows], reference[name], **CLOSE, err_msg=name)
    if given is not None:
        moved = [name for name in names if np.ptp(reference[name]) > 0.0]
        assert moved, "the input moves nothing, so the run shows nothing"
