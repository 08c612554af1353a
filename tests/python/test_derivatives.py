"""Directional derivatives are those of differences, adjoint ones their transpose, and declared dependencies cover them."""

import math

import numpy as np
from host import FLOATS, STEP, Instance, exchange, sequence, solver

SPREAD = 1e-3
"""Distance of the points that differences are taken over, relative to a variable's magnitude."""
AGREEMENT = 1e-8
"""Largest difference from the sixth-order difference, relative to the magnitude of the column."""


def count(variable):
    """How many numbers a variable is."""
    return math.prod(variable.shape) if variable.shape else 1


class Point:
    """An instance in continuous-time mode at a state with nothing at rest."""

    def __init__(self, instance, fmu, parameters):
        self.instance, self.fmu = instance, fmu
        instance.initialize(fmu.with_files(parameters), sequence(fmu, 2))
        instance.update()
        cvode = solver(instance, 1e-8)
        for k in range(31):
            exchange(instance, (k + 1) * STEP, cvode, k * STEP)
        description = fmu.description
        self.derivatives = [unknown.variable for unknown in description.derivatives]
        self.states = [variable.derivative for variable in self.derivatives]
        outputs = [v for v in fmu.variables.values() if v.causality == "output" and v.type in FLOATS]
        self.outputs = [v for v in outputs if v.variability == "continuous" and v not in self.states]
        self.unknowns = self.derivatives + self.outputs
        inputs = [v for v in fmu.inputs if v.type in FLOATS and v.variability == "continuous"]
        self.knowns = self.states + inputs
        self.at = self.read(self.knowns)

    def read(self, variables):
        """All their numbers in a row."""
        values = self.instance.get(variables)
        return np.array(list(values.values()), dtype=float)

    def evaluate(self, known):
        """The unknowns for values of the knowns."""
        n = sum(count(v) for v in self.states)
        x = (np.ctypeslib.ctypes.c_double * n)(*known[:n])
        self.instance.api.setContinuousStates(x, n)
        rest = known[n:]
        self.instance.set({v.name: value for v, value in zip(self.knowns[len(self.states) :], rest)})
        return self.read(self.unknowns)

    def jacobian_of_differences(self):
        """Sixth-order central differences, a column for each known."""
        columns = []
        for i, value in enumerate(self.at):
            h = SPREAD * max(abs(value), 0.1)

            def pair(n, i=i, h=h):
                ahead, behind = self.at.copy(), self.at.copy()
                ahead[i] += n * h
                behind[i] -= n * h
                return self.evaluate(ahead) - self.evaluate(behind)

            columns.append((45 * pair(1) - 9 * pair(2) + pair(3)) / (60 * h))
        self.evaluate(self.at)
        return np.array(columns).T

    def columns(self, function, seeded, others):
        """A derivative function for each unit seed."""
        n = sum(count(v) for v in seeded)
        m = sum(count(v) for v in others)
        references = [v.valueReference for v in self.unknowns], [v.valueReference for v in self.knowns]
        found = []
        for i in range(n):
            seed = [0.0] * n
            seed[i] = 1.0
            arguments = (*references, seed) if self.fmu.is_fmi2 else (*references, seed, m)
            found.append(function(*arguments))
        return np.array(found)


def test_derivatives_agree_with_differences_and_declared_dependencies(case):
    """Every output and state derivative by every state and continuous input."""
    fmu, parameters = case
    with Instance(fmu, "ModelExchange") as instance:
        point = Point(instance, fmu, parameters)
        if not point.unknowns or not point.knowns:
            assert not fmu.description.numberOfContinuousStates
            return
        exact = point.columns(instance.api.getDirectionalDerivative, point.knowns, point.unknowns).T
        expected = point.jacobian_of_differences()
        scale = 1.0 + np.abs(expected).max(axis=0)
        assert np.abs(exact - expected).max(where=np.isfinite(expected), initial=0.0) <= AGREEMENT * scale.max()
        if not fmu.is_fmi2:
            adjoint = point.columns(instance.api.getAdjointDerivative, point.unknowns, point.knowns)
            assert (adjoint == exact).all()

        declared = {u.variable.name: u.dependencies for u in fmu.description.outputs + fmu.description.derivatives}
        row = 0
        for unknown in point.unknowns:
            allowed = {v.name for v in declared[unknown.name] or point.knowns}
            for _ in range(count(unknown)):
                column = 0
                for known in point.knowns:
                    for _ in range(count(known)):
                        assert exact[row, column] == 0.0 or known.name in allowed, f"{unknown.name} by {known.name}"
                        column += 1
                row += 1
