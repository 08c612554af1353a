"""Goes on from a serialized state in a process of its own: reads a task from stdin, writes what it saw to stdout."""

import json
import sys
import tempfile

from host import Fmu, Instance
from test_states import MORE, TAKEN, steps

task = json.load(sys.stdin)
with tempfile.TemporaryDirectory() as folder:
    with Instance(Fmu(task["fmu"], folder), "CoSimulation") as instance:
        state = instance.api.deserializeFMUState(bytes.fromhex(task["state"]))
        instance.api.setFMUState(state)
        instance.api.freeFMUState(state)
        json.dump(steps(instance, TAKEN, MORE), sys.stdout)
