"""Blocks whose beginning is lost with the end of the block before: `upper {` for `} link upper {`.

Asked before a token is read, since the sections of the lost block fit into the one before.
"""

from collections.abc import Sequence

from kindsl.syntax.block_kinds import Opening, kind_by_content
from kindsl.syntax.tree import Problem, Token
from kindsl.syntax.words import BLOCK_KINDS, called, shown, supplied

_LAST_SECTION = {"base": "children", "link": "children", "joint": "ref_frame"}
_REACH = 400
_BODY = frozenset({"id", "INERTIA", "children"})
_HEADS = frozenset({"Robot", "RobotBase", "link", "JOINT_KIND", "FLOATING"})


def lost_head(
    start: str, read: Sequence[Token], tokens: Sequence[Token], index: int
) -> Opening | None:
    """Return the opening of a block that lacks at least its keyword, None where none begins.

    Args:
        start: The construct being read, empty behind its end.
        read: What is read of it.
        tokens: All tokens of the island.
        index: The token that comes next.
    """
    if len(read) < 3 or read[-1].kind in _HEADS or read[-2].kind in _HEADS:
        return None
    kinds = [token.kind for token in tokens[index : index + 4]]
    n_head = 2 if kinds[:2] == ["NAME", "{"] else int(kinds[:1] == ["{"])
    if not _begins_body(kinds[n_head:], n_head) and not _repeats_block(start, read, kinds):
        return None
    kind = kind_by_content(tokens, index + n_head - 1)
    if kind is None:
        return None
    return _opening(kind, tokens, index, n_head)


def _begins_body(kinds: Sequence[str], n_head: int) -> bool:
    """Return whether sections of a block come, which stand behind `{` there alone."""
    if n_head == 0 or not kinds:
        return False
    return kinds[0] in _BODY or kinds[:2] == ["ref_frame", "{"]


def _repeats_block(start: str, read: Sequence[Token], kinds: Sequence[str]) -> bool:
    """Return whether a section comes that the block has, behind the one that ends it."""
    is_id = kinds[:3] == ["id", "=", "INT"]
    if not is_id and kinds[:2] != ["ref_frame", "{"]:
        return False
    if not start:
        return True
    seen = {token.kind for token in read[-_REACH:]}
    if _LAST_SECTION.get(start) not in seen:
        return False
    if not is_id:
        return start == "joint"
    if start == "joint":
        return kinds[3:] == ["ref_frame"]
    return kinds[3:] != ["}"] and (start == "base" or "id" in seen)


def _opening(start: str, tokens: Sequence[Token], index: int, n_head: int) -> Opening:
    keyword = BLOCK_KINDS[start]
    place = tokens[index].start
    written = list(tokens[index : index + n_head])
    message = f"expected {called(keyword)} before '{shown(tokens[index].text)}'"
    problem = Problem("KD001", message, place, place)
    lead = tokens[index].lead
    head = [supplied(keyword, lead)]
    if n_head < 2:
        head.append(supplied("NAME", lead))
    if n_head == 0:
        head.append(supplied("{", lead))
    return Opening(start, tuple(written), (*head, *written), problem)
