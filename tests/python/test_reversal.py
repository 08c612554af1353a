"""Where `BrakingDrive` turns back is a time event that an importer of model exchange is told of."""

import math

import pytest
from host import Instance, exchange, solver


@pytest.mark.parametrize("version", ["fmi2", "fmi3"])
def test_a_reversal_is_a_time_event(named, version):
    """At τ_b ln((v_c − v₀)/v_c) after the command; there the velocity is 0, whatever the importer has integrated to."""
    drive = named(version, "BrakingDrive")
    with Instance(drive, "ModelExchange") as instance:
        assert drive.description.numberOfEventIndicators == 0
        instance.initialize({"velocity": 0.8}, {"command": -0.25})
        instance.update()
        due = 0.065 * math.log(1.05 / 0.25)
        assert instance.next_event == pytest.approx(due, abs=1e-15)
        # Told that the command has not changed, it does not plan anew.
        instance.api.setTime(0.01)
        instance.api.enterEventMode()
        instance.update()
        assert instance.next_event == pytest.approx(due, abs=1e-15)
        assert exchange(instance, due, solver(instance, 1e-4), 0.01) == pytest.approx([due], abs=1e-15)
        assert instance.get([drive.variables["velocity"]])["velocity"] == 0.0
        assert instance.next_event is None
