"""Fixes that write a new block behind the blocks of its kind."""

from kindsl.rules.base import Fix, Replacement
from kindsl.semantics.model import Model
from kindsl.semantics.places import Place
from kindsl.syntax.tree import Island
from kindsl.text.facts import Fact

_NEXT_ID = Fact[int]("next id")
_LINK = "\n\nlink {name} {{\n    id = {number}\n    children {{}}\n}}"
_JOINT = """

r_joint {name} {{
    ref_frame {{
        translation = (0.0, 0.0, 0.0)
        rotation = (0.0, 0.0, 0.0)
    }}
}}"""


def new_link(model: Model, name: str) -> Fix | None:
    """Return the fix that adds a link with the next number, None where no block is before it."""
    blocks = model.links or model.bases
    if not blocks or not name.isidentifier():
        return None
    text = _LINK.format(name=name, number=_next_id(model))
    return Fix(f"Add a link '{name}'", (_behind(blocks[-1].island, blocks[-1].end, text),))


def new_joint(model: Model, name: str) -> Fix | None:
    """Return the fix that adds a revolute joint, None where no block is before it."""
    blocks = model.joints or model.links or model.bases
    if not blocks or not name.isidentifier():
        return None
    text = _JOINT.format(name=name)
    return Fix(f"Add a joint '{name}'", (_behind(blocks[-1].island, blocks[-1].end, text),))


def _next_id(model: Model) -> int:
    known = model.facts.get(_NEXT_ID)
    if known is None:
        highest = max((link.id or 0 for link in model.links), default=0)
        known = model.facts.keep(_NEXT_ID, 1 + highest)
    return known


def _behind(island: Island, end: int, text: str) -> Replacement:
    return Replacement(Place(island, end, end), text)
