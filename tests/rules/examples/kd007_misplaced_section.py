"""Documents in which KD007 finds nothing, and in which it finds something."""

from tests.support.examples import Example, link

_SECTIONS = {"mass": "\n        mass = 4.1", "CoM": "\n        CoM = (0.0, 0.0, 0.0)"}


def _link(first: str, second: str) -> str:
    usual, written = _SECTIONS["mass"] + _SECTIONS["CoM"], _SECTIONS[first] + _SECTIONS[second]
    return link("upper", 1).replace(usual, written)


GOOD = (_link("mass", "CoM"),)
BAD = (Example(_link("CoM", "mass"), fixed=_link("mass", "CoM")),)
