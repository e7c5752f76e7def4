"""A value as a document has it: where a joint is along x."""

from kindsl.language.semantics.expressions import Expression
from kindsl.language.semantics.lowering import declarations
from kindsl.language.syntax.document import parse

POSE = "r_joint j {{ ref_frame {{ translation = ({0}, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) }} }}"


def expression(text: str) -> Expression:
    """Return what a value means that is written as a coordinate."""
    (joint,) = (j for i in parse(POSE.format(text)).islands for j in declarations(i).joints)
    assert joint.pose.translation is not None
    return joint.pose.translation.components[0]
