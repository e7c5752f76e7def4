"""Documents in which KD112 finds nothing, and in which it finds something."""

from tests.support.examples import link, robot


def _arm(joint: str) -> str:
    return robot(link("wrist", 1), base=f"wrist via {joint}", joints=joint)


GOOD = (_arm("wrist_roll"),)
BAD = (_arm("wrist"), _arm("Wrist"), _arm("arm"))
