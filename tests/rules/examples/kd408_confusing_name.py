"""Documents in which KD408 finds nothing, and in which it finds something."""

from tests.support.examples import Example, joint

GOOD = (
    joint("elbow", rotation="PI/2.0, tilt, 0.0"),
    joint("elbow", rotation="2.0 m, 0.5tilt, 0.0"),
    Example(joint("elbow", rotation="1.57rad, 0.0, 0.0"), parameters=(("rad", 1.0),)),
)
BAD = (
    Example(
        joint("elbow", rotation="pi/2.0, 0.0, 0.0"),
        fixed=joint("elbow", rotation="PI/2.0, 0.0, 0.0"),
    ),
    Example(
        joint("elbow", rotation="-π/2.0, 0.0, 0.0"),
        fixed=joint("elbow", rotation="-PI/2.0, 0.0, 0.0"),
    ),
    Example(
        joint("elbow", rotation="90.0 deg, 0.0, 0.0"),
        fixed=joint("elbow", rotation="PI/2.0, 0.0, 0.0"),
    ),
    Example(joint("elbow").replace("0.3", "300.0mm"), fixed=joint("elbow")),
    Example(
        joint("elbow", rotation="0.125rad, 0.0, 0.0"),
        fixed=joint("elbow", rotation="0.125, 0.0, 0.0"),
    ),
    joint("elbow", rotation="elbow, 0.0, 0.0"),
    joint("elbow", rotation="0.0, pitch, 0.0"),
)
