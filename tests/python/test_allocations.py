"""Steps allocate nothing, nor do evaluations: counted by an allocator that is preloaded into a process of its own."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
from conftest import PATHS

HERE = Path(__file__).parent
FIRST = 2
"""Steps in which buffers may still grow."""
DESIGNS = "InputShaper {'kind': 16} steps"
"""ALSI is designed anew for each size of a change, by a solver that allocates: its page says so."""


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="preloads over glibc")
def test_steps_and_evaluations_allocate_nothing(tmp_path):
    """In no variant of any FMU, with inputs that change and with events; taking a state does, so that counting works."""
    shim = tmp_path / "allocations.so"
    compiler = os.environ.get("CC", "cc")
    source = HERE / "allocations.c"
    subprocess.run([compiler, "-O1", "-fno-builtin", "-shared", "-fPIC", "-o", shim, source], check=True)
    command = [sys.executable, HERE / "allocations.py", *PATHS]
    environment = {**os.environ, "LD_PRELOAD": str(shim)}
    answer = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    assert answer.returncode == 0, answer.stderr
    found = json.loads(answer.stdout)
    assert len(found) >= 4 * len(PATHS)
    for name, counts in found.items():
        if name.endswith("state"):
            assert counts[0] > 0, name
        elif not name.endswith(DESIGNS):
            allowed = FIRST if name.endswith("steps") else 0
            wrong = [k for k, count in enumerate(counts) if count and k >= allowed]
            assert not wrong, f"{name}: allocates in calls {wrong[:9]}, {[counts[k] for k in wrong[:9]]} times"
