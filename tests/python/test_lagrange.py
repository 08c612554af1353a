"""Lagrange's equations, derived by a computer algebra system, against the cranes' own at random states.

The cranes move by the rates of their joints and know no accelerations; Lagrange's equations need both. They have to agree
for whatever accelerations."""

import functools

import numpy as np
import pytest
import sympy as sp
from host import Instance, elements
from lagrange import Pendulum, across, direction

AGREEMENT = 1e-10
"""Largest difference, relative to what is compared: what rounding leaves of some thousand operations."""
STATES = 100


class Crane:
    """A crane in continuous-time mode whose states and inputs are set and whose derivatives are read by name."""

    def __init__(self, instance, parameters):
        self.instance = instance
        instance.initialize(parameters, {})
        instance.update()
        derivatives = [unknown.variable for unknown in instance.fmu.description.derivatives]
        self.names = [name for variable in derivatives for name in elements(variable.derivative)]

    def derivatives(self, states, inputs):
        """The states' time derivatives by the states' names."""
        states = {name: value for key, given in states.items() for name, value in numbered(key, given)}
        assert sorted(states) == sorted(self.names)
        n = len(self.names)
        buffer = np.ctypeslib.ctypes.c_double * n
        self.instance.api.setContinuousStates(buffer(*(states[name] for name in self.names)), n)
        self.instance.set(inputs)
        found = buffer()
        api = self.instance.api
        (api.getDerivatives if self.instance.fmu.is_fmi2 else api.getContinuousStateDerivatives)(found, n)
        return dict(zip(self.names, found))


def numbered(name, value):
    """A number by its name, or an array's elements by theirs."""
    if np.ndim(value) == 0:
        return [(name, float(value))]
    return [(f"{name}[{i + 1}]", float(element)) for i, element in enumerate(np.ravel(value))]


def agree(found, name, wanted):
    """Whether an array of derivatives is as it should be."""
    found = np.array([found[f"{name}[{i}]"] for i in (1, 2, 3)])
    error = np.linalg.norm(found - np.ravel(wanted))
    assert error <= AGREEMENT * (1.0 + np.linalg.norm(wanted)), f"{name}: {found} and {np.ravel(wanted)}"


BOOM = {"boom.offset": 0.8, "boom.height": 1.5, "boom.length": 9.0, "payload.mass": 2.0, "swing.damping": 0.3}
BRIDGE = {"rail.height": 12.0, "hook.mass": 1.3, "payload.mass": 2.0, "rigging.length": 2.5, "swing.damping": 0.3}
WIND = {"wind.x": 1.7, "wind.y": -2.3, "wind.z": 0.9}
GRAVITY = 9.81


@functools.cache
def boom_crane():
    """A payload at the tip of a telescoping boom on a base that drives and turns.

    Functions for n, ṅ, w and ẇ, for q̈, and for the cable's tension."""
    pendulum = Pendulum(["φ", "β"], ["x", "y", "ψ", "θ", "γ", "r", "ℓ"])
    phi, beta = pendulum.q
    x, y, psi, theta, gamma, extension, length = pendulum.s
    offset, height, boom, mass, damping = BOOM.values()
    yaw, r = psi + theta, boom + extension
    reach = r * sp.cos(gamma)
    tip = sp.Matrix([
        x + offset * sp.cos(psi) + reach * sp.cos(yaw),
        y + offset * sp.sin(psi) + reach * sp.sin(yaw),
        height + r * sp.sin(gamma),
    ])
    n = direction(phi, beta, yaw)
    n1 = pendulum.rate(n)
    w = length * n1 + across(pendulum.rate(tip), n)
    dissipation = mass * damping * (length * n1).dot(length * n1) / 2
    masses = [(mass, tip + length * n, sp.Matrix(list(WIND.values())))]
    motion = pendulum.function([n, n1, w, pendulum.rate(w)])
    # The cable's tension is the force that keeps its length: the multiplier of the coordinate ℓ.
    (excess,) = pendulum.equations([(length, pendulum.s1[-1])], masses, GRAVITY, dissipation)
    return motion, pendulum.accelerations(masses, GRAVITY, dissipation), pendulum.function(-excess)


@pytest.mark.parametrize("version", ["fmi2", "fmi3"])
def test_the_payload_of_a_boom_crane_obeys_lagrange(named, version):
    """Base, slew, luff, telescope and hoist all move, with any accelerations. So does the tension, which needs them."""
    motion, accelerations, tension = boom_crane()
    positions = ["base.x", "base.y", "base.yaw", "slew.angle", "luff.angle", "boom.extension", "hoist.length"]
    rates = ["base.velocity.x", "base.velocity.y", "base.yaw_rate", "slew.rate", "luff.rate", "boom.rate", "hoist.rate"]
    inputs = [name.replace("velocity", "acceleration").replace("rate", "acceleration") for name in rates]
    random = np.random.default_rng(1)
    with Instance(named(version, "BoomCrane"), "ModelExchange") as instance:
        crane = Crane(instance, BOOM)
        for _ in range(STATES):
            q, q1 = random.uniform(-1.4, 1.4, 2), random.normal(size=2)
            s = [*random.normal(size=4), random.uniform(0.1, 1.4), random.uniform(0, 5), random.uniform(1, 20)]
            s1 = random.normal(size=7)
            n, _, w, _ = motion(q, q1, [0.0] * 2, s, s1, [0.0] * 7)
            states = dict(zip(positions, s)) | {"cable.direction": n, "payload.velocity_across": w}
            for s2 in ([0.0] * 7, random.normal(size=7)):
                found = crane.derivatives(states, WIND | dict(zip(rates, s1)) | dict(zip(inputs, s2)))
                q2 = accelerations(q, q1, s, s1, s2)
                _, n1, _, w1 = motion(q, q1, q2, s, s1, s2)
                agree(found, "cable.direction", n1)
                agree(found, "payload.velocity_across", w1)
                (force,) = instance.get([instance.fmu.variables["tension"]]).values()
                assert force == pytest.approx(tension(q, q1, q2, s, s1, s2), rel=AGREEMENT, abs=AGREEMENT)


@functools.cache
def bridge_crane():
    """Hook and payload below a trolley that moves both ways: functions for n, ṅ, w and ẇ of both, and for q̈."""
    pendulum = Pendulum(["φ₁", "β₁", "φ₂", "β₂"], ["x", "y", "ℓ"])
    x, y, length = pendulum.s
    height, hook, payload, rigging, damping = BRIDGE.values()
    directions = [direction(*pendulum.q[:2]), direction(*pendulum.q[2:])]
    rates = [pendulum.rate(n) for n in directions]
    upper = sp.Matrix([x, y, height]) + length * directions[0]
    lower = upper + rigging * directions[1]
    velocities = [pendulum.rate(upper), pendulum.rate(lower)]
    mean = (hook * velocities[0] + payload * velocities[1]) / (hook + payload)
    momenta = [across(mean, directions[0]), across(velocities[1], directions[1])]
    swings = [(hook + payload, length * rates[0]), (payload, rigging * rates[1])]
    dissipation = sum(mass * damping * across.dot(across) for mass, across in swings) / 2
    masses = [(hook, upper, sp.zeros(3, 1)), (payload, lower, sp.Matrix(list(WIND.values())))]
    motion = pendulum.function([directions, rates, momenta, [pendulum.rate(w) for w in momenta]])
    return motion, pendulum.accelerations(masses, GRAVITY, dissipation)


@pytest.mark.parametrize("version", ["fmi2", "fmi3"])
def test_hook_and_payload_of_a_bridge_crane_obey_lagrange(named, version):
    """Trolley, bridge and hoist move, with any accelerations."""
    motion, accelerations = bridge_crane()
    random = np.random.default_rng(2)
    with Instance(named(version, "BridgeCrane"), "ModelExchange") as instance:
        crane = Crane(instance, BRIDGE)
        for _ in range(STATES):
            q, q1 = random.uniform(-1.4, 1.4, 4), random.normal(size=4)
            s, s1 = [*random.normal(size=2), random.uniform(1, 20)], random.normal(size=3)
            n, _, w, _ = motion(q, q1, [0.0] * 4, s, s1, [0.0] * 3)
            states = dict(zip(["trolley.x", "bridge.y", "hoist.length"], s))
            states |= {"cable.direction": n[0], "cable.velocity_across": w[0]}
            states |= {"rigging.direction": n[1], "rigging.velocity_across": w[1]}
            found = crane.derivatives(states, WIND | dict(zip(["trolley.rate", "bridge.rate", "hoist.rate"], s1)))
            for s2 in ([0.0] * 3, random.normal(size=3)):
                q2 = accelerations(q, q1, s, s1, s2)
                _, n1, _, w1 = motion(q, q1, q2, s, s1, s2)
                for k, rope in enumerate(["cable", "rigging"]):
                    agree(found, f"{rope}.direction", n1[k])
                    agree(found, f"{rope}.velocity_across", w1[k])


@functools.cache
def hook_alone():
    """A hook in the angles of (2.17)–(2.18), φ, then β: a function for n, ṅ, w and ẇ."""
    pendulum = Pendulum(["φ", "β"], ["x", "y", "ℓ"])
    (phi, beta), (x, y, length) = pendulum.q, pendulum.s
    n = sp.Matrix([sp.cos(beta) * sp.sin(phi), sp.sin(beta), -sp.cos(beta) * sp.cos(phi)])
    n1 = pendulum.rate(n)
    w = length * n1 + across(pendulum.rate(sp.Matrix([x, y, 0])), n)
    return pendulum.function([n, n1, w, pendulum.rate(w)])


def thesis(q, q1, s, s1, s2):
    """φ̈ and β̈ of (2.17) and (2.18), with the terms in ℓ̇ that a constant length hides."""
    (phi, beta), (phi1, beta1), length, length1, (x2, y2, _) = q, q1, s[2], s1[2], s2
    sin, cos, sin_b, cos_b = np.sin(phi), np.cos(phi), np.sin(beta), np.cos(beta)
    return (
        -(GRAVITY * sin + x2 * cos - 2 * length * sin_b * beta1 * phi1 + 2 * length1 * cos_b * phi1) / (length * cos_b),
        -(GRAVITY * sin_b * cos + y2 * cos_b + length * sin_b * cos_b * phi1**2 - x2 * sin_b * sin + 2 * length1 * beta1)
        / length,
    )


@pytest.mark.parametrize("version", ["fmi2", "fmi3"])
def test_a_hook_alone_obeys_the_thesis(named, version):
    """(2.17)–(2.18), whose angles are the other order's: sin φ = cos β′ sin φ′, tan β = tan β′ / cos φ′."""
    motion = hook_alone()
    random = np.random.default_rng(3)
    with Instance(named(version, "BridgeCrane"), "ModelExchange") as instance:
        crane = Crane(instance, {"payload.mass": 0.0})
        angles = [instance.fmu.variables[f"{mass}.swing.{axis}"] for mass in ("hook", "payload") for axis in ("radial", "tangential")]
        for _ in range(STATES):
            q, q1 = random.uniform(-1.4, 1.4, 2), random.normal(size=2)
            s, s1 = [*random.normal(size=2), random.uniform(1, 20)], random.normal(size=3)
            n, _, w, _ = motion(q, q1, [0.0] * 2, s, s1, [0.0] * 3)
            states = dict(zip(["trolley.x", "bridge.y", "hoist.length"], s))
            states |= {"cable.direction": n, "cable.velocity_across": w}
            states |= {"rigging.direction": [0.0, 0.6, -0.8], "rigging.velocity_across": [1.0, 0.0, 0.0]}
            found = crane.derivatives(states, dict(zip(["trolley.rate", "bridge.rate", "hoist.rate"], s1)))
            for s2 in ([0.0] * 3, random.normal(size=3)):
                _, n1, _, w1 = motion(q, q1, thesis(q, q1, s, s1, s2), s, s1, s2)
                agree(found, "cable.direction", n1)
                agree(found, "cable.velocity_across", w1)
            agree(found, "rigging.direction", [0.0] * 3)
            agree(found, "rigging.velocity_across", [0.0] * 3)
            radial, tangential = np.arcsin(np.cos(q[1]) * np.sin(q[0])), np.arctan(np.tan(q[1]) / np.cos(q[0]))
            assert list(instance.get(angles).values()) == pytest.approx([radial, tangential] * 2, abs=AGREEMENT)
