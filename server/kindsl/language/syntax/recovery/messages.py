"""One repair in one sentence."""

from collections.abc import Sequence

from kindsl.language.syntax.indentation import indentation
from kindsl.language.syntax.recovery.repair import RepairStep
from kindsl.language.syntax.recovery.repair_words import Word
from kindsl.language.syntax.tables import KEYWORDS
from kindsl.language.syntax.token_names import (
    SPELLINGS,
    called,
    first_row,
    last_written,
    opened_block,
    shown,
    unknown_keyword,
)
from kindsl.language.syntax.tree import Edit, Problem, Repair, Token
from kindsl.language.text.nearest import nearest_words

_WRITTEN = frozenset("{}()=,]>")
_SEPARATORS = frozenset(";,")


def repair_problem(
    text: str,
    read: Sequence[Token],
    tokens: Sequence[Token],
    changes: Sequence[RepairStep],
    words: Sequence[Word],
    wanted: Sequence[str],
) -> Problem:
    """Return the problem that a group of changes repairs.

    Args:
        read: Tokens of the block up to the first change.
        tokens: All tokens of the island, which the changes count.
        wanted: The keywords that could stand where the first change is made.
    """
    group = _first_group(changes)
    start, end = _span(tokens, group)
    gone = [tokens[c.at] for c in group if c.action != "insert"]
    added = [(c, word) for c, word in zip(group, words, strict=False) if c.action != "delete"]
    code = "KD001"
    meant = _half_keyword(text, tokens, gone, wanted) if gone else ()
    if meant and (not added or added[0][0].kind == "}"):
        return Problem("KD010", unknown_keyword(gone[0].text, meant), start, end)
    if not added and _is_function(tokens, group):
        message = f"function '{shown(gone[0].text)}' where the language has none"
        return Problem("KD006", message, start, end)
    if not added:
        message = _left_out(text, tokens, gone)
    elif gone:
        code, message = _instead(*added[0], gone, first_row(text, gone))
    else:
        code, message = _lost(read, tokens, *added[0])
    choices = [words]
    if len(changes) == 1 and words[0].near:
        choices = [[Word(near)] for near in words[0].near]
    found = (_repair(text, read, tokens, changes, choice) for choice in choices)
    repairs = tuple(repair for repair in found if repair is not None)
    if not added and not _are_separators(gone):
        repairs = _as_one_name(text, tokens, gone) or repairs
    return Problem(code, message, start, end).repaired_by(repairs)


def closing_problem(text: str, read: Sequence[Token], kinds: Sequence[str], place: int) -> Problem:
    """Return the problem of a block that ends too early; `place` is the index in `read`."""
    position = read[place - 1].end if place else 0
    if kinds[0] != "}":
        message = f"expected {called(kinds[0])} after '{last_written(read[:place])}'"
        return Problem("KD001", message, position, position)
    edits = _closing_edit(text, read[:place], position)
    opened = opened_block(read[:place])
    repair = Repair("Insert '}'", (edits,), False) if len(kinds) == 1 else None
    return Problem("KD002", f"expected '}}' to close {opened}", position, position, repair)


def leftover_problem(
    read: Sequence[Token], rest: Sequence[Token], text: str, previous: str
) -> Problem:
    """Return the problem of text that belongs to no block; `previous` is the block before."""
    start, end = rest[0].start, rest[-1].end
    what = shown(first_row(text, rest))
    if previous == "end" or (read and not rest[0].text[:1].isidentifier()):
        return Problem("KD001", f"unexpected '{what}'", start, end)
    message = f"expected a robot, a link or a joint instead of '{what}'"
    return Problem("KD001", message, start, end)


def _first_group(changes: Sequence[RepairStep]) -> list[RepairStep]:
    group = [changes[0]]
    for change in changes[1:]:
        if change.at > group[-1].at + 1:
            break
        group.append(change)
    return group


def _span(tokens: Sequence[Token], group: Sequence[RepairStep]) -> tuple[int, int]:
    gone = [tokens[change.at] for change in group if change.action != "insert"]
    if gone:
        return gone[0].start, gone[-1].end
    index, kind = group[0].at, group[0].kind
    place = tokens[index - 1].end if index > 0 else 0
    if kind in SPELLINGS and index < len(tokens) and tokens[index].kind in ("{", "="):
        place = tokens[index].start  # A keyword belongs before these, all else behind a token.
    return place, place


def _is_function(tokens: Sequence[Token], group: Sequence[RepairStep]) -> bool:
    name, behind = tokens[group[0].at], tokens[group[-1].at + 1 : group[-1].at + 2]
    is_called = bool(behind) and behind[0].text == "(" and behind[0].start == name.end
    return len(group) == 1 and name.kind == "NAME" and is_called


def _left_out(text: str, tokens: Sequence[Token], gone: Sequence[Token]) -> str:
    """Return the message about tokens that are too much; glued to a name they spoil it."""
    if _are_separators(gone):
        return f"unexpected '{gone[0].text}'"
    for token in tokens:
        if token.end == gone[0].start and token.text[:1].isidentifier():
            return f"'{shown(text[token.start : gone[-1].end])}' is not a name"
        is_behind = token.start == gone[-1].end and token.text[:1].isidentifier()
        if is_behind and gone[0].text[:1].isdigit():
            return f"'{shown(text[gone[0].start : token.end])}' is not a name"
    return f"unexpected '{shown(first_row(text, gone))}'"


def _are_separators(gone: Sequence[Token]) -> bool:
    return all(token.text in _SEPARATORS for token in gone)


def _as_one_name(text: str, tokens: Sequence[Token], gone: Sequence[Token]) -> tuple[Repair, ...]:
    """Return the repair of a name with signs in it, `_` in their place; none if it is no name."""
    first = next((token for token in tokens if token.end == gone[0].start), None)
    if first is None or not first.text[:1].isidentifier():
        return ()
    written = text[first.start : gone[-1].end]
    signs = [token for token in gone if not token.text[:1].isalnum()]
    name = "".join("_" if token in signs else token.text for token in (first, *gone))
    if len(name) != len(written) or not name.isidentifier() or gone[-1] in signs:
        return ()
    edits = tuple(Edit(token.start, token.end, "_") for token in signs)
    return (Repair(f"Replace '{shown(written)}' with '{name}'", edits, False),)


def _half_keyword(
    text: str, tokens: Sequence[Token], gone: Sequence[Token], wanted: Sequence[str]
) -> tuple[str, ...]:
    """Return which keywords a word alone on its line may become."""
    index = next(i for i, token in enumerate(tokens) if token is gone[0])
    before, behind = tokens[:index][-1:], tokens[index + 1 :][:1]
    is_first = not before or "\n" in text[before[0].end : gone[0].start]
    is_last = not behind or "\n" in text[gone[0].end : behind[0].start]
    is_word = gone[0].kind == "NAME" and (len(gone) == 1 or gone[1].kind == "}")
    return nearest_words(gone[0].text, wanted) if is_first and is_last and is_word else ()


def _instead(change: RepairStep, word: Word, gone: Sequence[Token], text: str) -> tuple[str, str]:
    written = gone[0].text
    if change.kind == "INT":
        return "KD005", f"id '{shown(written)}' is not a natural number"
    if word.near and written not in KEYWORDS:
        return "KD010", unknown_keyword(written, word.near)
    return "KD001", f"expected {_called(change.kind, word)} instead of '{shown(text)}'"


def _lost(
    read: Sequence[Token], tokens: Sequence[Token], change: RepairStep, word: Word
) -> tuple[str, str]:
    if change.kind == "}":
        return "KD002", f"expected '}}' to close {opened_block(read)}"
    what = _called(change.kind, word)
    if change.at > 0:
        return "KD001", f"expected {what} after '{last_written(tokens[: change.at])}'"
    return "KD001", f"expected {what} before '{shown(tokens[0].text)}'"


def _called(kind: str, word: Word) -> str:
    return f"'{word.text}'" if kind == "MOMENT" else called(kind)


def _repair(
    text: str,
    read: Sequence[Token],
    tokens: Sequence[Token],
    changes: Sequence[RepairStep],
    words: Sequence[Word],
) -> Repair | None:
    edits: list[Edit] = []
    for change, word in zip(changes, words, strict=True):
        edit = _edit(text, read, tokens, change, word.text)
        if edit is None:
            return None
        if edits and _is_removed_on(text, edits[-1], edit):
            edit = Edit(edits.pop().start, edit.end, "")
        edits.append(edit)
    return Repair(_title(text, edits), tuple(edits), False)


def _is_removed_on(text: str, last: Edit, edit: Edit) -> bool:
    """Return whether an edit goes on removing what the last one removes, but for blanks."""
    return not (last.text or edit.text or text[last.end : edit.start].strip())


def _title(text: str, edits: Sequence[Edit]) -> str:
    """Return the title of a repair: what it moves, replaces, inserts or removes."""
    old = _side_by_side([text[e.start : e.end] for e in edits if e.start < e.end])
    new = _side_by_side([e.text.strip() for e in edits if e.text.strip()])
    if old and old == new:
        return f"Move '{shown(old)}'"
    if old and new:
        return f"Replace '{shown(old)}' with '{shown(new)}'"
    return f"Insert '{shown(new)}'" if new else f"Remove '{shown(old)}'"


def _side_by_side(pieces: Sequence[str]) -> str:
    """Return pieces side by side; what is the same everywhere once."""
    return " ".join(pieces if len(set(pieces)) > 1 else pieces[:1])


def _edit(
    text: str, read: Sequence[Token], tokens: Sequence[Token], change: RepairStep, new: str
) -> Edit | None:
    if change.action == "delete":
        token = tokens[change.at]
        return Edit(token.start, token.end, "")
    if not new:
        return None
    if change.action == "replace":
        token = tokens[change.at]
        return Edit(token.start, token.end, new)
    position = tokens[change.at - 1].end if change.at > 0 else 0
    if change.kind == "}":
        return _closing_edit(text, read, position)
    if change.kind in _WRITTEN:
        return Edit(position, position, new if change.kind in "),]>" else " " + new)
    behind = "" if change.at < len(tokens) and tokens[change.at].start > position else " "
    return Edit(position, position, " " + new + behind)


def _closing_edit(text: str, read: Sequence[Token], position: int) -> Edit:
    """Return the insertion of `}`, on its own line where the block has several."""
    depth = 0
    for token in reversed(read):
        depth += (token.kind == "}") - (token.kind == "{")
        if depth < 0:
            if "\n" not in text[token.start : position]:
                break
            return Edit(position, position, "\n" + indentation(text, token.start) + "}")
    return Edit(position, position, " }")
