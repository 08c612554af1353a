"""The boom lift's derivatives and the map from Cartesian to joint rates, (3.23) of the thesis, which is printed wrong."""

import numpy as np
import pytest
from host import Instance

LENGTH = 12.0
JOINTS = ("extension.length", "slew.angle", "luff.angle")
TIP = ("tip.x", "tip.y", "tip.z")
POSES = [(0.0, 0.3, 0.7), (2.5, -2.0, 0.2), (7.9, 1.1, 1.4), (0.4, 2.4, 0.05)]


def corrected(extension, slew, luff):
    """T with rows ρ̇, θ̇, γ̇."""
    reach = LENGTH + extension
    sin_t, cos_t, sin_g, cos_g = np.sin(slew), np.cos(slew), np.sin(luff), np.cos(luff)
    return np.array(
        [
            [cos_g * cos_t, cos_g * sin_t, sin_g],
            [-sin_t / (reach * cos_g), cos_t / (reach * cos_g), 0.0],
            [-sin_g * cos_t / reach, -sin_g * sin_t / reach, cos_g / reach],
        ]
    )


def printed(extension, slew, luff):
    """T as printed: the inverse of a Jacobian in which the boom rises with sin θ, not sin γ, when it gets longer."""
    mistaken = np.linalg.inv(corrected(extension, slew, luff))
    mistaken[2, 0] = np.sin(slew)
    return np.linalg.inv(mistaken)


def jacobian(fmu, pose):
    """Of the tip by the joints: the FMU's own derivatives."""
    with Instance(fmu, "ModelExchange") as instance:
        instance.initialize(dict(zip(JOINTS, pose)), {})
        instance.update()
        references = [[fmu.variables[name].valueReference for name in names] for names in (TIP, JOINTS)]
        more = () if fmu.is_fmi2 else (3,)
        columns = [instance.api.getDirectionalDerivative(*references, seed, *more) for seed in np.eye(3).tolist()]
        return np.array(columns).T


@pytest.mark.parametrize("version", ["fmi2", "fmi3"])
@pytest.mark.parametrize("pose", POSES)
def test_the_corrected_map_inverts_the_derivatives_and_the_printed_one_does_not(named, version, pose):
    """T J = 1 to rounding; as printed it is wrong by centimetres per metre and more wherever θ ≠ γ."""
    found = jacobian(named(version, "BoomLift"), pose)
    assert corrected(*pose) @ found == pytest.approx(np.eye(3), abs=1e-13)
    assert np.abs(printed(*pose) @ found - np.eye(3)).max() > 0.01
    # det T⁻¹ = (r + ρ)² cos γ (up to the order of the joints): singular for an upright boom only.
    assert abs(np.linalg.det(found)) == pytest.approx((LENGTH + pose[0]) ** 2 * np.cos(pose[2]), rel=1e-13)
