"""Lagrange's equations of what hangs from a crane, derived symbolically and evaluated numerically.

Everything follows from the positions of the masses as functions of the swing angles and of what the crane moves.
Nothing is simplified on the way, so that the numbers are those of the derivation."""

import numpy as np
import sympy as sp


class Pendulum:
    """Point masses that hang from prescribed motions; `angles` and `joints` are the names of their coordinates."""

    def __init__(self, angles, joints):
        self.q, self.q1, self.q2 = (sp.symbols([name + dots for name in angles], real=True) for dots in ("", "'", "''"))
        self.s, self.s1, self.s2 = (sp.symbols([name + dots for name in joints], real=True) for dots in ("", "'", "''"))
        self.arguments = [self.q, self.q1, self.q2, self.s, self.s1, self.s2]

    def rate(self, expression):
        """The time derivative of an expression in coordinates and their rates."""
        values = [*self.q, *self.q1, *self.s, *self.s1]
        changes = [*self.q1, *self.q2, *self.s1, *self.s2]
        terms = [sp.diff(expression, value) * change for value, change in zip(values, changes)]
        return sum(terms[1:], terms[0])

    def equations(self, coordinates, masses, gravity, dissipation):
        """What each coordinate's generalized force is short of: d/dt ∂T/∂q̇ − ∂T/∂q + ∂V/∂q + ∂D/∂q̇ − Σ F·∂r/∂q.

        `masses` are triples of a mass, its position and the force on it; `coordinates` are pairs of q and q̇."""
        velocities = [self.rate(position) for _, position, _ in masses]
        kinetic = sum(m * v.dot(v) for (m, _, _), v in zip(masses, velocities)) / 2
        potential = sum(m * gravity * position[2] for m, position, _ in masses)
        for q, q1 in coordinates:
            work = sum(force.dot(position.diff(q)) for _, position, force in masses)
            inertia = self.rate(sp.diff(kinetic, q1)) - sp.diff(kinetic - potential, q)
            yield inertia + sp.diff(dissipation, q1) - work

    def accelerations(self, masses, gravity, dissipation):
        """A function of all coordinates and rates and of the joints' accelerations: q̈ for which the equations hold."""
        equations = list(self.equations(zip(self.q, self.q1), masses, gravity, dissipation))
        # They are linear in q̈.
        matrix = [[sp.diff(equation, q2) for q2 in self.q2] for equation in equations]
        rest = dict.fromkeys(self.q2, 0)
        right = [-equation.xreplace(rest) for equation in equations]
        evaluate = self.function([sp.Matrix(matrix), sp.Matrix(right)])

        def solve(q, q1, s, s1, s2):
            left, right = evaluate(q, q1, [0.0] * len(q), s, s1, s2)
            return np.linalg.solve(left, right).ravel()

        return solve

    def function(self, expressions):
        """The expressions as a function of angles and joints with their rates and accelerations."""
        return sp.lambdify(self.arguments, expressions, modules="numpy", cse=True)


def direction(phi, beta, yaw=0):
    """From pivot to mass, in the thesis's order of the angles, β, then φ (2.8–2.9), in a frame that is yawed."""
    n = sp.Matrix([sp.sin(phi), sp.cos(phi) * sp.sin(beta), -sp.cos(phi) * sp.cos(beta)])
    cos, sin = sp.cos(yaw), sp.sin(yaw)
    return sp.Matrix([cos * n[0] - sin * n[1], sin * n[0] + cos * n[1], n[2]])


def across(u, n):
    """The part of u across the unit vector n."""
    return u - n * n.dot(u)
