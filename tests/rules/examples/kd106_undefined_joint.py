"""Documents in which KD106 finds nothing, and in which it finds something."""

from tests.support.examples import Example, link, robot


def _arm(joint: str, joints: str) -> str:
    links = link("upper", 1, f"forearm via {joint}"), link("forearm", 2)
    return robot(*links, base="upper via shoulder", joints=joints)


_ELBOW = """

r_joint elbow {
    ref_frame {
        translation = (0.0, 0.0, 0.0)
        rotation = (0.0, 0.0, 0.0)
    }
}
}
"""

GOOD = (_arm("elbow", "shoulder elbow"),)
BAD = (
    Example(_arm("elbow", "shoulder elbwo"), fixed=_arm("elbwo", "shoulder elbwo")),
    Example(
        _arm("elbow", "shoulder"), fixed=_arm("elbow", "shoulder").removesuffix("\n}\n") + _ELBOW
    ),
)
