"""Links of other formats put together: numbers beyond all measure are refused wherever they are."""

from math import inf, nan

import pytest

from kindsl.mechanics.rigid.body import MassDistribution
from kindsl.mechanics.rigid.pose import IDENTITY
from kindsl.robots.interchange.format import FormatError
from kindsl.robots.interchange.rigid_links import RigidLink, linkage_of_links

MOMENTS = (1.0, 1.0, 1.0, 0.0, 0.0)


@pytest.mark.parametrize("number", [1.5e60, -1.5e60, inf, -inf, nan])
@pytest.mark.parametrize(
    "where", ["axis", "parent_T_joint", "joint_T_link", "frames", "mass", "com", "moments"]
)
def test_a_number_beyond_all_measure_is_refused(where: str, number: float) -> None:
    assert len(linkage_of_links("r", "fixed", robot(where, 0.5e60)).bodies) == 2
    with pytest.raises(FormatError, match=r"^'arm' has a number that is not finite$"):
        linkage_of_links("r", "fixed", robot(where, number))


def robot(where: str, number: float) -> list[RigidLink]:
    """Return two links, the second with a number at one place."""
    pose = IDENTITY._replace(translation=(0.0, number, 0.0))
    given: dict[str, object] = {
        "axis": {"axis": (number, 0.0, 1.0)},
        "parent_T_joint": {"parent_T_joint": pose},
        "joint_T_link": {"joint_T_link": pose},
        "frames": {"frames": (("f", pose),)},
        "mass": {"body": MassDistribution(number, (0.0, 0.0, 0.0), (*MOMENTS, 0.0))},
        "com": {"body": MassDistribution(0.0, (0.0, 0.0, number), (*MOMENTS, 0.0))},
        "moments": {"body": MassDistribution(1.0, (0.0, 0.0, 0.0), (*MOMENTS, number))},
    }[where]
    return [RigidLink("base"), RigidLink("arm", 0, "j", "revolute", **given)]
