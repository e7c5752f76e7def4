"""Documents in which KD104 finds nothing, and in which it finds something."""

_EYES = """link head { id = 1 children {} frames {
    left { translation = (0.1, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) }
    %s { translation = (0.2, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) }
} }"""

GOOD = (_EYES % "right",)
BAD = (_EYES % "left",)
