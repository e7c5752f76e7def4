"""Documents in which KD703 finds nothing, and in which it finds something."""

from tests.support.examples import link

_FRAMED = link("head", 1).removesuffix("}\n") + (
    "    frames { camera { translation = (0.0, 0.0, %s) rotation = (0.0, 0.0, 0.0) } }\n}\n"
)

GOOD = (_FRAMED % "0.1",)
BAD = (_FRAMED % "0.0",)
