"""The opening of a block whose keyword is lost, maybe with its name, brace and first section."""

from collections.abc import Sequence

from kindsl.language.syntax.recovery.block_kinds import Opening, kind_by_content
from kindsl.language.syntax.scanner import word_kind
from kindsl.language.syntax.tables import HOLDS, ORDERS
from kindsl.language.syntax.token_names import BLOCK_KINDS, called, shown, supplied
from kindsl.language.syntax.tree import Problem, Token
from kindsl.language.syntax.vocabulary import (
    BLOCK_WORDS,
    BLOCKS,
    SECTIONS,
    of_kind,
    token_kind,
    token_kinds,
)

_BRACED = of_kind("block", "pose", "list", "groups")
_LAST_SECTION = {
    name: token_kind([part for part in ORDERS[name] if not part.endswith("?")][-1])
    for name in BLOCKS
}
_FAR_BACK = 4000
_SECTIONS_OF_BLOCKS = token_kinds(HOLDS["link"])
_GOES_ON = {"via": "NAME", **dict.fromkeys(token_kinds(SECTIONS.keys() & _BRACED), "{")}
_HEADS = {*map(word_kind, BLOCK_WORDS), "FLOATING"}


def lost_head(
    start: str, read: Sequence[Token], tokens: Sequence[Token], index: int
) -> Opening | None:
    """Return the opening of a block without its keyword, None where no block begins.

    Args:
        start: The construct being read, empty behind its end.
        read: Its tokens.
    """
    if len(read) < 3 or read[-1].kind in _HEADS or read[-2].kind in _HEADS:
        return None
    if not start and read[-2].kind == "{":
        # The brace that ends an empty block is more likely one too many.
        return None
    kinds = [token.kind for token in tokens[index : index + 4]]
    if kinds[:1] == [_GOES_ON.get(read[-1].kind)]:
        return None
    section = "" if start else _begun_section(kinds)
    if section:
        kind = "joint" if section == "ref_frame" else kind_by_content(tokens, index)
        return _headless(kind, tokens, index, 0, section) if kind else None
    n_head = 2 if kinds[:2] == ["NAME", "{"] else int(kinds[:1] == ["{"])
    if not _begins_body(kinds[n_head:], n_head) and not _repeats_block(start, read, kinds):
        return None
    kind = kind_by_content(tokens, index + n_head - 1)
    if kind is None:
        return None
    return _headless(kind, tokens, index, n_head)


def _begins_body(kinds: Sequence[str], n_head: int) -> bool:
    """Return whether sections of a block follow, which are only possible after `{`."""
    if n_head == 0 or not kinds or (kinds[0] != "id" and kinds[1:2] == ["="]):
        return False
    return kinds[0] in _SECTIONS_OF_BLOCKS or kinds[:2] == ["ref_frame", "{"]


def _repeats_block(start: str, read: Sequence[Token], kinds: Sequence[str]) -> bool:
    """Return whether a section follows that the block already has, after its last one."""
    is_id = kinds[:3] == ["id", "=", "INT"]
    if not is_id and kinds[:2] != ["ref_frame", "{"]:
        return False
    if not start:
        return True
    seen = {token.kind for token in read[-_FAR_BACK:]}
    if _LAST_SECTION.get(start) not in seen:
        return False
    if not is_id:
        return start == "joint"
    if start == "joint":
        return kinds[3:] == ["ref_frame"]
    return kinds[3:] != ["}"] and (start == "base" or "id" in seen)


def _begun_section(kinds: Sequence[str]) -> str:
    """Return the keyword that is lost before the rest of a block's first section."""
    if kinds[:2] == ["=", "INT"] and kinds[2:3] in (["INERTIA"], ["children"], ["ref_frame"]):
        return "id"
    is_pose = kinds[:1] == ["{"] and kinds[1:2] in (["translation"], ["rotation"])
    return "ref_frame" if is_pose and kinds[2:3] == ["="] else ""


def _headless(
    start: str, tokens: Sequence[Token], index: int, n_head: int, section: str = ""
) -> Opening:
    """Return the opening of a block with its missing head and first section supplied."""
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
    if section:
        head.append(supplied(section, lead))
    return Opening(start, tuple(written), (*head, *written), problem)
