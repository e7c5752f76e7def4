"""Documents in which KD209 finds nothing, and in which it finds something."""

from tests.support.examples import Example, four_legs, joint, link, robot

_CROSSED = (four_legs().replace("via RF_HFE", "via X").replace("via RF_KFE", "via RF_HFE")).replace(
    "via X", "via RF_KFE"
)


def _arm(second: str, third: str) -> str:
    chain = (f"link2 via {second}", f"link3 via {third}", "link4 via joint4", "")
    links = [link(f"link{number}", number, below) for number, below in enumerate(chain, 1)]
    joints = [joint(f"joint{number}") for number in range(1, 5)]
    return robot(*links, *joints, base="link1 via joint1")


GOOD = (four_legs(), _arm("joint2", "joint3"))
BAD = (
    Example(_CROSSED, fixed=four_legs()),
    Example(_arm("joint3", "joint2"), fixed=_arm("joint2", "joint3")),
)
