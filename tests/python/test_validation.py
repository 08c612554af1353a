"""The validators that others check FMUs with find nothing."""

import logging

from fmpy.validation import validate_fmu
from fmu_manipulation_toolbox.checker import get_checkers
from fmu_manipulation_toolbox.operations import FMU


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
