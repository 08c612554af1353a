"""Terminals and icons: valid, about variables that exist, and with names by which they find each other."""

import zipfile
from pathlib import Path

import fmpy
import pytest
from lxml import etree

CLOCKS = True
BASE = ("base.velocity.x", "base.velocity.y", "base.yaw_rate")
BASE += ("base.acceleration.x", "base.acceleration.y", "base.yaw_acceleration")

ENTRY = "terminalsAndIcons/terminalsAndIcons.xml"
SCHEMA = etree.XMLSchema(file=Path(fmpy.__file__).parent / "schema/fmi3/fmi3TerminalsAndIcons.xsd")
GOLDEN = Path(__file__).parents[2] / "modeldesc/tests/golden/terminals.xml"


def document(fmu):
    """The document of an FMU."""
    with zipfile.ZipFile(fmu.path) as archive:
        return etree.fromstring(archive.read(ENTRY))


def members(fmu, name):
    """The variables of a terminal by their member names."""
    found = document(fmu).find(f"Terminals/Terminal[@name='{name}']").iter("TerminalMemberVariable")
    return {member.get("memberName"): fmu.variables[member.get("variableName")] for member in found}


def test_what_the_writer_can_say_is_valid():
    """The writer's golden file holds more than our FMUs use: nested terminals, streams, plugs."""
    SCHEMA.assertValid(etree.parse(GOLDEN))


def test_documents_are_valid_and_about_what_exists(fmu):
    """Against the official schema; names of variables and pictures lead somewhere."""
    with zipfile.ZipFile(fmu.path) as archive:
        entries = set(archive.namelist())
    if fmu.is_fmi2:
        assert ENTRY not in entries
        return
    root = document(fmu)
    SCHEMA.assertValid(root)
    assert root.get("fmiVersion") == fmu.description.fmiVersion
    names = [terminal.get("name") for terminal in root.iter("Terminal")]
    assert len(set(names)) == len(names)
    for terminal in root.iter("Terminal"):
        found = terminal.findall("TerminalMemberVariable")
        assert found, terminal.get("name")
        assert len({member.get("memberName") for member in found}) == len(found)
        for member in found:
            assert fmu.variables[member.get("variableName")].causality in ("input", "output")
        picture = terminal.find("TerminalGraphicalRepresentation")
        assert f"terminalsAndIcons/{picture.get('iconBaseName')}.png" in entries
    # Nothing is drawn over anything else.
    areas = [[float(g.get(k)) for k in ("x1", "y1", "x2", "y2")] for g in root.iter("TerminalGraphicalRepresentation")]
    areas += [[float(root.find("GraphicalRepresentation/Icon").get(k)) for k in ("x1", "y1", "x2", "y2")]]
    for i, (x1, y1, x2, y2) in enumerate(areas):
        assert x1 < x2 and y1 < y2
        assert all(x2 <= u1 or u2 <= x1 or y2 <= v1 or v2 <= y1 for u1, v1, u2, v2 in areas[:i])


@pytest.mark.parametrize(
    ("giver", "gives", "taker", "takes", "joined"),
    [
        ("CommandSource", "command", "InputShaper", "command", {"command": "command"}),
        ("CommandSource", "command", "VectorDrive", "command", {"command": "command"}),
        ("InputShaper", "shaped", "VectorDrive", "command", {"shaped": "command"}),
        ("VectorDrive", "axis", "BoomCrane", "slew", {"velocity": "slew.rate", "acceleration": "slew.acceleration"}),
        ("VectorDrive", "axis", "BoomCrane", "luff", {"velocity": "luff.rate", "acceleration": "luff.acceleration"}),
        ("VectorDrive", "axis", "BoomCrane", "hoist", {"velocity": "hoist.rate", "acceleration": "hoist.acceleration"}),
        ("BoomCrane", "hoist", "InputShaper", "hoist", {"hoist.length": "hoist.length"}),
        ("VectorDrive", "axis", "TowerCrane", "slew", {"velocity": "slew.rate"}),
        ("VectorDrive", "axis", "TowerCrane", "trolley", {"velocity": "trolley.rate"}),
        ("VectorDrive", "axis", "TowerCrane", "hoist", {"velocity": "hoist.rate"}),
        ("TowerCrane", "hoist", "InputShaper", "hoist", {"hoist.length": "hoist.length"}),
        ("VectorDrive", "axis", "BoomLift", "extension", {"velocity": "extension.rate"}),
        ("VectorDrive", "axis", "FlexibleModes", "axis", {"velocity": "base.velocity"}),
        ("MobileBase", "base", "BoomCrane", "base", {name: name for name in BASE}),
        (
            "BoomCrane",
            "swing",
            "VisionSensor",
            "swing",
            {"swing.radial": "swing.radial", "swing.tangential": "swing.tangential"},
        ),
        (
            "BridgeCrane",
            "hook_swing",
            "VisionSensor",
            "swing",
            {"hook.swing.radial": "swing.radial", "hook.swing.tangential": "swing.tangential"},
        ),
        ("BridgeCrane", "trolley", "RangeSensor", "axis", {"trolley.x": "distance"}),
        ("RangeSensor", "measured", "PositionController", "axis", {"measured.distance": "crane.position", "valid": "position.valid"}),
        (
            "VisionSensor",
            "measured",
            "PositionController",
            "swing",
            {"measured.displacement.radial": "hook.displacement", "valid": "hook.valid"},
        ),
        ("PositionController", "command", "VectorDrive", "command", {"velocity": "command"}),
        ("BridgeCrane", "hoist", "PositionController", "hoist", {"hoist.length": "hoist.length"}),
        (
            "VisionSensor",
            "measured",
            "SwayDamper",
            "swing",
            {
                "measured.swing.radial": "swing.radial",
                "measured.swing.tangential": "swing.tangential",
                "valid": "valid",
            },
        ),
        ("BoomCrane", "slew", "SwayDamper", "slew", {"slew.angle": "slew.angle"}),
        ("BoomCrane", "base", "SwayDamper", "base", {"base.yaw": "base.yaw"}),
        ("SwayDamper", "velocity_x", "CartesianController", "velocity_x", {"velocity.x": "velocity.x"}),
        ("SwayDamper", "velocity_y", "CartesianController", "velocity_y", {"velocity.y": "velocity.y"}),
        ("BoomCrane", "hoist", "VisionSensor", "hoist", {"hoist.length": "hoist.length"}),
        ("BoomCrane", "luff", "VisionSensor", "luff", {"luff.angle": "luff.angle"}),
    ],
)
def test_connected_terminals_wire_the_crane(named, giver, gives, taker, takes, joined):
    """Members with the same name are joined as in the example: each output to an input, and nothing else."""
    givers, takers = members(named("fmi3", giver), gives), members(named("fmi3", taker), takes)
    pairs = [(givers[name], takers[name]) for name in givers if name in takers]
    assert {a.name: b.name for a, b in pairs} == joined
    assert all((a.causality, b.causality) == ("output", "input") for a, b in pairs)
    kinds = {
        document(named("fmi3", fmu)).find(f"Terminals/Terminal[@name='{name}']").get("terminalKind")
        for fmu, name in ((giver, gives), (taker, takes))
    }
    assert len(kinds) == 1
