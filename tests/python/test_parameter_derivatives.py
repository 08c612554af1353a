"""Derivatives by parameters and start values, in Initialization Mode: those of differences, and the adjoint transposed."""

import math
from ctypes import c_double, c_size_t, c_uint32

import numpy as np
from host import FLOATS, sequence
from raw import OK, Library, Raw

SPREAD = 1e-3
"""Distance of the points that differences are taken over, relative to a value's magnitude."""
AGREEMENT = 1e-8
"""Largest difference from the sixth-order difference, relative to the magnitude of the column."""
ROUNDING = 1e-15
"""What is lost of a number where two that are almost the same are subtracted, relative to it."""


def settable(fmu):
    """Real parameters, continuous inputs and start values, one number each, with room around their values."""
    for v in fmu.variables.values():
        start = v.causality == "parameter" or v.initial == "exact" and v.variability == "continuous"
        if v.type in FLOATS and not v.shape and start and v.causality != "independent":
            yield v


def unknowns(fmu):
    """The real initial unknowns that are continuous, one number each."""
    found = [u.variable for u in fmu.description.initialUnknowns]
    return [v for v in found if v.type in FLOATS and v.variability == "continuous" and not v.shape]


def initializing(library, values):
    """An instance in Initialization Mode with these values."""
    instance = Raw(library, "ModelExchange")
    assert instance.set(library.fmu.with_files({})) == OK
    assert instance.enter_initialization() == OK
    assert instance.set({**sequence(library.fmu, 1), **values}) == OK
    return instance


def read(instance, variables):
    """The numbers of some variables."""
    return np.array([np.frombuffer(bits)[0] for bits in instance.get(variables).values()])


def sensitivity(instance, name, rows, columns, seed, count):
    """One directional or adjoint derivative."""
    references = [(c_uint32 * len(of))(*[v.valueReference for v in of]) for of in (rows, columns)]
    values, seeds = (c_double * count)(), (c_double * len(seed))(*seed)
    sizes = [[], []] if instance.fmu.is_fmi2 else [[c_size_t(len(seed))], [c_size_t(count)]]
    arguments = [references[0], c_size_t(len(rows)), references[1], c_size_t(len(columns)), seeds, *sizes[0], values]
    assert instance.call(name, *arguments, *sizes[1]) == OK, instance.texts()
    return np.array(values)


def test_derivatives_by_what_is_set_before_the_start(fmu):
    """Every real parameter, continuous input and start value, away from where a bound would bend a function."""
    rows, columns = unknowns(fmu), []
    values = {v.name: float(v.start) * 1.01 + 0.011 for v in settable(fmu)}
    if not rows:
        return
    with Library(fmu) as library:
        for v in settable(fmu):
            low = -math.inf if v.min is None else float(v.min)
            high = math.inf if v.max is None else float(v.max)
            if not low < values[v.name] - 0.01 < values[v.name] + 0.01 < high:
                values[v.name] = float(v.start)
            else:
                columns.append(v)
        with initializing(library, values) as instance:
            exact = np.array(
                [sensitivity(instance, "GetDirectionalDerivative", rows, [v], [1.0], len(rows)) for v in columns]
            )
            if not fmu.is_fmi2:
                seeds = np.eye(len(rows))
                adjoint = [
                    sensitivity(instance, "GetAdjointDerivative", rows, columns, seed, len(columns)) for seed in seeds
                ]
                assert (np.array(adjoint).T == exact).all()
        for v, column in zip(columns, exact):
            h = SPREAD * max(abs(values[v.name]), 0.1)

            def at(n, v=v, h=h):
                with initializing(library, {**values, v.name: values[v.name] + n * h}) as instance:
                    return read(instance, rows)

            expected = (45 * (at(1) - at(-1)) - 9 * (at(2) - at(-2)) + (at(3) - at(-3))) / (60 * h)
            lost = ROUNDING / h * np.abs(at(0)).max()
            worst = np.abs(column - expected).max()
            assert worst <= AGREEMENT * (1.0 + np.abs(expected).max()) + lost, (v.name, worst)
    assert columns
