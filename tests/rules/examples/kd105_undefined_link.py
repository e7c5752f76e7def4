"""Documents in which KD105 finds nothing, and in which it finds something."""

from tests.support.examples import Example, link, robot

_JOINTS = "shoulder elbow"

_WITH_CAMERA = "upper via shoulder camera via pan"

_CAMERA = "\nlink camera {\n    id = 3\n    children {}\n}\n"


def _arm(base: str, more: str = "", joints: str = _JOINTS) -> str:
    links = link("upper", 1, "forearm via elbow"), link("forearm", 2)
    return robot(*links, more, base=base, joints=joints)


GOOD = (_arm("upper via shoulder"),)
BAD = (
    Example(_arm("uper via shoulder"), fixed=_arm("upper via shoulder")),
    Example(_arm("shoulder via upper"), fixed=_arm("upper via shoulder")),
    Example(
        _arm(_WITH_CAMERA, joints=_JOINTS + " pan"),
        fixed=_arm(_WITH_CAMERA, _CAMERA, joints=_JOINTS + " pan"),
    ),
)
