"""Names, value references, types and start values stay what users' files depend on."""

import difflib

from conftest import PATHS
from golden import FOLDER, place, text

RENEW = "if the change is meant, write the copy anew: see tests/python/golden.py"


def test_the_description_is_the_golden_one(fmu):
    """Line by line."""
    copy = place(fmu.path)
    assert copy.exists(), f"{copy} is missing; {RENEW}"
    golden, found = copy.read_text(encoding="utf-8").splitlines(), text(fmu.path).splitlines()
    difference = "\n".join(difflib.unified_diff(golden, found, "golden", "found", lineterm="", n=0))
    assert not difference, f"{difference}\n{RENEW}"


def test_no_fmu_is_gone():
    """Each golden copy has its archive."""
    assert sorted(FOLDER.glob("*/*.txt")) == sorted(place(path) for path in PATHS)
