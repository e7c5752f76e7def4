"""Let the moments of a link move along with its centre of mass, so that its body stays the same.

The moments are written about the origin of the frame that the CoM is written in. A CoM that moves
alone leaves a body of other moments about itself, soon an impossible one.
"""

from kindsl.frontends.features.manipulation.gesture import Refusal
from kindsl.frontends.features.manipulation.set_component import ComponentChange
from kindsl.frontends.features.manipulation.things import LENGTHS
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.judgement.diagnosis.judgements import is_plain
from kindsl.language.semantics.unknown import Unknown
from kindsl.language.syntax.vocabulary import MOMENTS
from kindsl.language.text.decimals import rounded_decimal
from kindsl.language.text.edits import TextEdit
from kindsl.mechanics.rigid.body import shifted
from kindsl.robots.mechanism.link_inertia import written_inertia


def with_moments(
    analysis: Analysis, link: str, component: str, change: ComponentChange
) -> ComponentChange | Refusal:
    """Return the change of a centre of mass with the edits of the moments that move along."""
    if not change.edits:
        return change
    carried = carried_moments(analysis, link, component, change.value)
    if isinstance(carried, Refusal):
        return carried
    edits = tuple(sorted((*change.edits, *carried)))
    return change._replace(edits=edits, label=f"{change.label} with its moments")


def carried_moments(
    analysis: Analysis, link: str, component: str, value: float
) -> tuple[TextEdit, ...] | Refusal:
    """Return the edits of the moments that keep the body the same as its CoM moves.

    Args:
        link: The link's name.
        component: Of its CoM: `x y z`.
        value: The component's new value, metres.
    """
    body = analysis.model.body_named.get(link)
    inertia = body.inertia if body is not None else None
    if inertia is None or len(inertia.moments) < len(MOMENTS) or not is_plain(inertia):
        return Refusal(f"the moments of '{link}' are not six plain numbers")
    written = written_inertia(inertia, {})
    if isinstance(written, Unknown):
        return Refusal(f"the inertia of '{link}' is not known")
    com = list(written.com)
    com[LENGTHS.index(component)] = value
    x, y, z = com
    moved = shifted(shifted(written, -1.0)._replace(com=(x, y, z)))
    length = sum(map(abs, (*written.com, *moved.com)))
    size = sum(map(abs, written.moments)) + abs(written.mass) * length * length
    return tuple(
        analysis.resolver.edit(inertia.moments[name], rounded_decimal(new, size))
        for name, old, new in zip(MOMENTS, written.moments, moved.moments, strict=True)
        if rounded_decimal(new, size) != rounded_decimal(old, size)
    )
