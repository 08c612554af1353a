"""What users' files depend on, as one line for each variable: the golden copies in `tests/data/golden`.

Run as a program, this writes them anew, for a change that is meant:

    cargo run --release -- build --test-fmus -o out/fmus
    SWAYLESS_FMUS=out/fmus python tests/python/golden.py
"""

import os
from pathlib import Path

import fmpy

FOLDER = Path(__file__).parent.parent / "data" / "golden"


def place(path):
    """Where the golden copy of an archive lies."""
    return FOLDER / path.parent.name / f"{path.stem}.txt"


def lines(description):
    """Name and identifiers of an FMU, its types, and its variables in the order of their value references."""
    yield f"model {description.modelName}"
    for interface in ("modelExchange", "coSimulation", "scheduledExecution"):
        found = getattr(description, interface, None)
        if found is not None:
            yield f"{interface} {found.modelIdentifier}"
    for definition in sorted(description.typeDefinitions, key=lambda definition: definition.name):
        if getattr(definition, "items", None):
            items = ", ".join(f"{item.value} {item.name}" for item in definition.items)
            yield f"enumeration {definition.name}: {items}"
    for v in sorted(description.modelVariables, key=lambda v: v.valueReference):
        kind = v.declaredType.name if v.type == "Enumeration" else v.type
        dimensions = "".join(f"[{length}]" for length in v.shape or ())
        words = [f"{v.valueReference:5} {v.name}: {kind}{dimensions}", v.causality, v.variability, v.initial]
        words += [v.unit, v.start if v.start is None else f"= {v.start}"]
        yield " ".join(str(word) for word in words if word is not None)


def text(path):
    """The golden copy as an archive would have it."""
    return "\n".join(lines(fmpy.read_model_description(path))) + "\n"


def renew():
    """Writes the copies of all archives, and removes those of FMUs that are gone."""
    copies = {place(path): text(path) for path in Path(os.environ["SWAYLESS_FMUS"]).glob("fmi[23]/*.fmu")}
    for old in FOLDER.glob("*/*.txt"):
        if old not in copies:
            old.unlink()
    for copy, content in copies.items():
        copy.parent.mkdir(parents=True, exist_ok=True)
        copy.write_text(content, encoding="utf-8")


if __name__ == "__main__":
    renew()
