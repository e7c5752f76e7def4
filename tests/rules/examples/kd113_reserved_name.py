"""Documents in which KD113 finds nothing, and in which it finds something."""

from tests.support.examples import joint, link

_FRAMED = """link head {
    id = 1
    children {}
    frames { %s { translation = (0.1, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } }
}"""

GOOD = (link("gripper", 1), _FRAMED % "fr_eye")
BAD = (
    link("union", 1),
    link("until", 1),
    _FRAMED % "fr_head",
    f"{link('fr_neck', 1)}\n{joint('neck')}",
)
