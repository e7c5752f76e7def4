"""Documents in which KD601 finds nothing, and in which it finds something."""

from tests.support.examples import STEEL_BALL, Example, joint, link, robot

from kindsl.judgement.rules.context import ROBCOGEN


def _arm(height: str, fixed: str | None = None) -> Example:
    shoulder = joint("shoulder").replace("0.3", height)
    text = robot(link("arm", 1), shoulder, base="arm via shoulder")
    text = text.replace("ground {", "ground {\n    " + STEEL_BALL, 1)
    example = Example(text, (ROBCOGEN,), (("reach", 0.3),))
    return example._replace(fixed=text.replace(height, fixed)) if fixed else example


GOOD = (_arm("0.003"), _arm("reach/2.0"))
BAD = (_arm("3.0e-3", "0.003"), _arm("2.0*reach", "reach/0.5"), _arm("reach[0.3]"))
