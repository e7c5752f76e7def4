"""Documents in which KD207 finds nothing, and in which it finds something."""

from tests.support.examples import Example, link, robot


def _arm(children: str) -> str:
    return robot(link("arm", 1), base=f"arm via shoulder{children}", joints="shoulder")


GOOD = (_arm(""),)
BAD = (
    Example(_arm(" arm via shoulder"), fixed=_arm("")),
    Example(_arm("\n        arm via shoulder\n"), fixed=_arm("\n")),
    Example(_arm(" arm via shoulder  \n"), fixed=_arm(" \n")),
    _arm(" arm via elbow"),
)
