"""The validators that others check FMUs with find nothing."""

import logging
from pathlib import Path

import fmpy
import pytest
from fmpy.validation import validate_fmu
from fmu_manipulation_toolbox.checker import get_checkers
from fmu_manipulation_toolbox.operations import FMU
from lxml import etree

CLOCKS = True

GOLDEN = Path(__file__).parents[2] / "modeldesc/tests/golden"
SCHEMAS = Path(fmpy.__file__).parent / "schema"


@pytest.mark.parametrize("golden", ["fmi2", "fmi3", "fmi3_clocks"])
def test_what_the_writer_can_say_is_valid(golden):
    """The writer's golden files hold more than our FMUs use: clocks, arrays, aliases, every type."""
    version = golden[:4]
    schema = etree.XMLSchema(file=SCHEMAS / version / f"{version}ModelDescription.xsd")
    schema.assertValid(etree.parse(GOLDEN / f"{golden}.xml"))


def test_fmpy_finds_no_problem(fmu):
    """Schema, variable names, model structure, start values, units."""
    assert validate_fmu(str(fmu.path)) == []


def test_fmu_manipulation_toolbox_finds_no_problem(fmu, caplog):
    """Its generic (XSD) and semantic checks; they report through the log."""
    checkers = [checker() for checker in get_checkers()]
    assert len(checkers) >= 2
    with caplog.at_level(logging.WARNING), FMU(str(fmu.path)) as archive:
        for checker in checkers:
            archive.apply_operation(checker)
    assert [record.getMessage() for record in caplog.records] == []
