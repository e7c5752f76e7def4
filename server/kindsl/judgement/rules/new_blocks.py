"""Fixes that write a new block behind the blocks of its kind."""

from bisect import bisect_right
from collections.abc import Sequence

from kindsl.judgement.rules.base import Fix, Replacement
from kindsl.language.semantics.declarations import Joint, Link
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.places import Place
from kindsl.language.text.facts import kept

_LINK = "\n\nlink {name} {{\n    id = {number}\n    children {{}}\n}}"
_JOINT = """

r_joint {name} {{
    ref_frame {{
        translation = (0.0, 0.0, 0.0)
        rotation = (0.0, 0.0, 0.0)
    }}
}}"""


def new_link(model: Model, name: str, *, parent_id: int = 0) -> Fix | None:
    """Return the fix that adds a link, None where no block is before it.

    It gets the least number that is missing, if its parent's is less, else the next number.
    """
    free = _free_ids(model)
    text = _LINK.format(name=name, number=free[bisect_right(free, parent_id)])
    return _new_block(model.links or model.bases, "link", name, text)


def new_joint(model: Model, name: str) -> Fix | None:
    """Return the fix that adds a revolute joint, None where no block is before it."""
    blocks = model.joints or model.links or model.bases
    return _new_block(blocks, "joint", name, _JOINT.format(name=name))


def _new_block(blocks: Sequence[Link | Joint], kind: str, name: str, text: str) -> Fix | None:
    if not blocks or not name.isidentifier():
        return None
    behind = Place(blocks[-1].island, blocks[-1].end, blocks[-1].end)
    return Fix(f"Create {kind} '{name}'", (Replacement(behind, text),))


@kept
def _free_ids(model: Model) -> list[int]:
    taken = {link.id or 0 for link in model.links}
    missing = (number for number in range(1, len(taken) + 1) if number not in taken)
    return [*missing, 1 + max(taken, default=0)]
