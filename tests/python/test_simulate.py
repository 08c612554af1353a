"""FMPy simulates every FMU as its users do, by co-simulation and by model exchange."""

import fmpy
import numpy as np
import pytest
from host import HOLD, STEP, sequence


def signals(fmu, stop):
    """The inputs' sequences as FMPy wants them: two rows at each instant where values jump."""
    # FMPy cannot give arrays together with scalars; they stay as they are.
    inputs = [v for v in fmu.inputs if not v.shape]
    if not inputs:
        return None
    columns = [("time", float)] + [(v.name, float) for v in inputs]
    rows = []
    for k in range(round(stop / (STEP * HOLD))):
        values = tuple(sequence(fmu, k)[v.name] for v in inputs)
        rows += [(k * STEP * HOLD, *values), ((k + 1) * STEP * HOLD, *values)]
    return np.array(rows, dtype=columns)


@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
def test_fmpy_simulates(case, kind):
    """Every output stays finite, and no message is worse than OK."""
    fmu, parameters = case
    messages = []
    if fmu.is_fmi2:
        logger = lambda _env, _name, status, _category, text: messages.append((status, text))
    else:
        logger = lambda _env, status, _category, text: messages.append((status, text))
    outputs = [v.name for v in fmu.variables.values() if v.causality == "output"]
    result = fmpy.simulate_fmu(
        str(fmu.path),
        validate=True,
        fmi_type=kind,
        solver="CVode",
        stop_time=5.0,
        start_values=fmu.with_files(parameters),
        input=signals(fmu, 5.0),
        output=outputs,
        logger=logger,
    )
    assert result["time"][-1] == pytest.approx(5.0)
    for name in outputs:
        assert np.isfinite(np.asarray(result[name], dtype=float)).all(), name
    assert [text for status, text in messages if status != 0] == []
