"""Documents in which KD604 finds nothing, and in which it finds something."""

from tests.support.examples import STEEL_BALL, Example, joint, link, robot


def _arm(height: str, radius: str) -> Example:
    shoulder = joint("shoulder").replace("(0.0, 0.0, 0.3)", f"({radius}, 0.0, {height})")
    text = robot(link("arm", 1), shoulder, base="arm via shoulder")
    text = text.replace("ground {", "ground {\n    " + STEEL_BALL, 1)
    return Example(text, parameters=(("reach", 0.3),))


GOOD = (_arm("2.0*reach", "0.0"), _arm("2.0 reach", "0.0"))
BAD = (_arm("2.0*reach", "2.0 reach"),)
