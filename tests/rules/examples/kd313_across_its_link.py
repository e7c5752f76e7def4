"""Documents in which KD313 finds nothing, and in which it finds something."""

from tests.support.examples import Example, inertia, joint, link, placed_joint, robot


def _arm(*moments: str) -> str:
    upper = link("upper", 1, "lower via elbow", inertia("2.0", "0.2", *moments))
    joints = joint("shoulder"), joint("elbow", 0.4)
    return robot(upper, link("lower", 2), *joints, base="upper via shoulder")


def _along_x(com: str, *moments: str) -> str:
    text = _arm(*moments).replace("0.0, 0.0, 0.2", com)
    elbow = placed_joint("elbow", "0.4, 0.0, 0.0", "PI/2.0, 0.0, 0.0")
    return text.replace(joint("elbow", 0.4), elbow)


GOOD = (_arm("0.107", "0.107", "0.001"), _arm("0.10", "0.11", "0.02"))
BAD = (
    _arm("0.081", "0.107", "0.027"),
    Example(
        _along_x("0.0, 0.0, 0.2", "0.107", "0.106", "0.001"),
        fixed=_along_x("0.2, 0.0, 0.0", "0.001", "0.107", "0.106"),
    ),
)
