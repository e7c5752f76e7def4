"""Documents in which KD308 finds nothing, and in which it finds something."""

from tests.support.examples import Example, inertia, joint, link, robot

_LINK = robot(
    link("motor", 1, "arm via shaft", inertia("0.5", "0.0", "%s", "%s", "%s")),
    link("arm", 2),
    *(joint("mount"), joint("shaft", 0.1)),
    base="motor via mount",
)

_MOMENTS = ("0.0003", "0.0003", "0.00018")

GOOD = (_LINK % _MOMENTS,)
BAD = (Example(_LINK % ("300000.0", "300000.0", "180000.0"), fixed=_LINK % _MOMENTS),)
