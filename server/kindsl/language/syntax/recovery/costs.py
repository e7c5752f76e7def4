"""The costs of repairs, tuned by hand: each with a slip that is read well because of it.

Inserting or leaving out a token costs 1.0 unless a row says otherwise.
"""

from typing import NamedTuple


class Cost(NamedTuple):
    """A cost, and the slip that it is for.

    Attributes:
        amount: The cost; what is added to one, or a factor, where the name says so.
        usual: The amount for a case like any other.
        right: Some correct text.
        slip: The same with a mistake.
        message: The message, a different one with the usual amount.
    """

    amount: float
    usual: float
    right: str
    slip: str
    message: str


_HALF_A_LINK = """(l1, 0.0, 0.1)
            rotation = (0.0, -PI/2.0, 0.0)
        }
    }
}
"""
COSTS = {
    "go back by a token": Cost(0.12, 0.0,
        "r_joint elbow {\n    ref_frame {", "r_joint elbow {\n",
        "expected 'ref_frame' after '{'"),
    "insert a value": Cost(1.1, 1.0,
        "CoM = (0.0, 0.0, 0.1)", "CoM = (0.0 0.0, , 0.1)",
        "expected ',' after '0.0'"),
    "insert a word": Cost(1.2, 1.0,
        "Iy = 0.2", "foo = 0.2",
        "expected 'Iy' instead of 'foo'"),
    "insert on, factor": Cost(0.6, 1.0,
        "children { lower via elbow }", "lower via elbow }",
        "expected 'children' after '}'"),
    "insert a present section, more": Cost(0.5, 0.0,
        "Ix = 0.1", "= 0.1",
        "expected 'Ix' after ')'"),
    "insert '(' in a value, more": Cost(1.0, 0.0,
        "rotation = (0.0, -PI/2.0, 0.0)", "rotation = (PI/-PI/2.0)",
        "expected ',' after '2.0'"),
    "close at the end": Cost(0.3, 1.0,
        _HALF_A_LINK, "(",
        "expected a number after '('"),
    "delete an odd character": Cost(0.5, 1.0,
        "via shoulder }", "via shoulder ~ }",
        "unexpected '~'"),
    "delete '='": Cost(1.8, 1.0,
        "Ixy = 0.0", "- = 0.0",
        "expected 'Ixy' instead of '-'"),
    "delete on": Cost(0.35, 1.0,
        "CoM = (", "CoM = 1.0\n        CoM = (",
        "unexpected '1.0'"),
    "delete what is doubled, more": Cost(-0.3, 0.0,
        "translation = (l1", "translation = ((l1",
        "unexpected '('"),
    "delete the only section, more": Cost(0.8, 0.0,
        "Ixz = 0.0", "Ixz / 0.0",
        "expected '=' instead of '/'"),
    "replace": Cost(1.25, 1.0,
        "translation = (l1", "= translation (l1",
        "unexpected '='"),
    "replace an odd character": Cost(0.8, 1.25,
        "upper via shoulder", "# via shoulder",
        "expected a name instead of '#'"),
    "replace '=' by a value": Cost(1.9, 1.25,
        "CoM = (0.0", "= CoM (0.0",
        "unexpected '='"),
    "replace by no value, more": Cost(0.1, 0.0,
        "id = 1\n    inertia_params {", "id =",
        "expected a whole number after '='"),
    "replace by a present section, more": Cost(0.5, 0.0,
        "translation = (l1", "= translation (l1",
        "unexpected '='"),
    "replace by a lacking section, more": Cost(-0.4, 0.0,
        "children {}", "( {}",
        "expected 'children' instead of '('"),
    "replace by a near word, more": Cost(-0.6, 0.0,
        "r_joint shoulder {\n    ref_frame {\n        translation",
        "r_joint {\n    ref_frame {\n        translaIion",
        "expected a name after 'r_joint'"),
    "read further, slack": Cost(0.65, 0.0,
        "-PI/2.0, 0.0)", "=-PI/2.0, 0.0)",
        "unexpected '='"),
    "read to the end, slack": Cost(1.4, 0.65,
        "rotation = (0.0, -PI", "rotation -PI",
        "expected '=' after 'rotation'"),
    "believe a keyword": Cost(1.5, 0.0,
        "elbow {\n    ref_frame {", "elbow {\n    frames {",
        "expected 'ref_frame' instead of 'frames'"),
    "believe a section": Cost(2.0, 1.0,
        "link lower {", "r_joint lower {",
        "expected 'link' instead of 'r_joint'"),
    "believe frames": Cost(1.0, 2.0,
        "elbow {\n    ref_frame {", "elbow {\n    frames {",
        "expected 'ref_frame' instead of 'frames'"),
}  # fmt: skip


def cost(name: str) -> float:
    """Return a cost of the table."""
    return COSTS[name].amount
