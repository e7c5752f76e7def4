"""The kind of the block at a token, also where its keyword is lost, misspelt or wrong."""

from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from kindsl.language.syntax.recovery.costs import COSTS
from kindsl.language.syntax.scanner import word_kind
from kindsl.language.syntax.tables import HOLDS
from kindsl.language.syntax.token_names import (
    BLOCK_KINDS,
    BLOCK_STARTS,
    SPELLINGS,
    called,
    shown,
    supplied,
    unknown_keyword,
)
from kindsl.language.syntax.tree import Edit, Problem, Repair, Token
from kindsl.language.syntax.vocabulary import BLOCK_WORDS, NAMES, POSE, token_kind, token_kinds
from kindsl.language.text.nearest import nearest_words

LONGEST_FIRST = sorted(BLOCK_WORDS, key=len, reverse=True)
_TURNING = ("revolute", "rotational", "rotary", "continuous", "hinge")
_SLIDING = ("prismatic", "translational", "linear", "sliding", "slider")
_JOINT_KINDS = {**dict.fromkeys(_TURNING, "r_joint"), **dict.fromkeys(_SLIDING, "p_joint")}
_BODY = frozenset({"{", "FLOATING"})
_LINK_SECTIONS = token_kinds({*HOLDS["link"]} - {*HOLDS["joint"]})
_POSE = token_kinds(POSE)
_REACH = 200


class Opening(NamedTuple):
    """The opening of a block.

    Attributes:
        replaces: The tokens that stand there and are not as they should be.
        tokens: Tokens read in their place.
    """

    start: str
    replaces: tuple[Token, ...] = ()
    tokens: tuple[Token, ...] = ()
    problem: Problem | None = None


def opening(tokens: Sequence[Token], index: int, previous: str = "") -> Opening | None:
    """Return how a block begins at a token, None where none does."""
    token = tokens[index]
    start = BLOCK_STARTS.get(token.kind)
    if start is not None:
        return _checked(tokens, index, start)
    if not token.text[:1].isidentifier():
        return _in_place_of_junk(tokens, index, previous)
    following = tokens[index + 1] if index + 1 < len(tokens) else None
    if following is None:
        return None
    if following.kind in _BODY and token.kind in NAMES:
        return _unglued(token) or _without_keyword(tokens, index, previous)
    behind = tokens[index + 2] if index + 2 < len(tokens) else None
    if following.kind in NAMES and behind is not None and behind.kind in _BODY:
        return _misspelt(tokens, index, previous)
    return None


def _checked(tokens: Sequence[Token], index: int, start: str) -> Opening:
    """Return the opening for a keyword, corrected if the block's content contradicts it."""
    if start in ("head", "end"):
        return Opening(start)
    written = "joint" if start == "joint" else "link"
    content = kind_by_content(tokens, index, written)
    if content in (None, written):
        return Opening(start)
    return _replaced(tokens[index], content, "KD001")


def _replaced(token: Token, start: str, code: str, meant: tuple[str, ...] = ()) -> Opening:
    kind = BLOCK_KINDS[start]
    message = f"expected {called(kind)} instead of '{shown(token.text)}'"
    if meant:
        message = unknown_keyword(token.text, meant)
    words, problem = meant or _spellings(kind), Problem(code, message, token.start, token.end)
    problem = _with_repairs(problem, f"Replace '{shown(token.text)}' with", words, token.end)
    read = Token(kind, words[0], token.lead, token.start, token.end)
    return Opening(start, (token,), (read,), problem)


def _spellings(kind: str) -> tuple[str, ...]:
    return tuple(sorted(SPELLINGS.get(kind, (kind,)), reverse=True))


def _with_repairs(
    problem: Problem, what: str, words: tuple[str, ...], end: int, behind: str = ""
) -> Problem:
    """Return a problem with the repair of writing a keyword, or with the choice between several."""
    repairs = tuple(
        Repair(f"{what} '{word}'", (Edit(problem.start, end, word + behind),), False)
        for word in words
    )
    return problem.repaired_by(repairs)


def _unglued(token: Token) -> Opening | None:
    """Return the opening of `linkl1 {`, which robcogen2 reads as `link l1 {`."""
    pair = next(unglued(token, LONGEST_FIRST), None)
    return None if pair is None else Opening(BLOCK_STARTS[pair[0].kind], (token,), pair)


def unglued(token: Token, words: Iterable[str]) -> Iterator[tuple[Token, Token]]:
    """Yield each of some keywords that a token begins with, and the name glued to it."""
    for word in words:
        rest, middle = token.text.removeprefix(word), token.start + len(word)
        if rest != token.text and rest.isidentifier():
            yield (
                Token(word_kind(word), word, token.lead, token.start, middle),
                Token(word_kind(rest), rest, middle, middle, token.end),
            )


def _without_keyword(tokens: Sequence[Token], index: int, previous: str) -> Opening | None:
    start = _guess(tokens, index, previous)
    if start is None:
        return None
    name = tokens[index]
    kind = BLOCK_KINDS[start]
    message = f"expected {called(kind)} before '{shown(name.text)}'"
    problem = Problem("KD001", message, name.start, name.start)
    problem = _with_repairs(problem, "Insert", _spellings(kind), name.start, " ")
    keyword = supplied(kind, name.lead)
    return Opening(start, (name,), (keyword, name), problem)


def _misspelt(tokens: Sequence[Token], index: int, previous: str) -> Opening | None:
    token = tokens[index]
    meant = block_words(token.text)
    start = BLOCK_STARTS[word_kind(meant[0])] if meant else _guess(tokens, index, previous)
    if start is None:
        return None
    content = kind_by_content(tokens, index)
    if content is not None and (content == "joint") != (start == "joint"):
        start, meant = content, ()
    return _replaced(token, start, "KD010", meant)


def block_words(word: str) -> tuple[str, ...]:
    """Return the keywords that begin a block and may be meant by a word; r_joint before p_joint."""
    known = _JOINT_KINDS.get(word.casefold().partition("_")[0])
    found = (known,) if known else nearest_words(word, BLOCK_WORDS)
    kinds = {word_kind(each) for each in found}
    return tuple(sorted(found, reverse=True)) if len(kinds) == 1 else found[:1]


def _in_place_of_junk(tokens: Sequence[Token], index: int, previous: str) -> Opening | None:
    """Return the opening of a block whose keyword is a number or a sign."""
    behind = tokens[index + 1 : index + 3]
    if len(behind) < 2 or behind[0].kind not in NAMES or behind[1].kind not in _BODY:
        return None
    start = _guess(tokens, index + 1, previous)
    return None if start is None else _replaced(tokens[index], start, "KD001")


def _guess(tokens: Sequence[Token], index: int, previous: str) -> str | None:
    """Return the construct of a block without a keyword, by its content."""
    content = kind_by_content(tokens, index)
    if content == "link":
        kinds = [token.kind for token in tokens[index : index + 6]]
        if "FLOATING" in kinds or (previous == "head" and "id" not in kinds):
            return "base"
    if content is None and index <= 1 and tokens[-1].kind == "{" and len(tokens) <= 3:
        return "head"
    return content


def kind_by_content(tokens: Sequence[Token], index: int, written: str = "") -> str | None:
    """Return `link` or `joint` for the block named at `index`, None if that is unclear.

    Whichever the sections up to the next block speak for, and what is written, if any is.
    """
    scores = {"link": 0.0, "joint": 0.0}
    if written:
        scores[written] += COSTS["believe a keyword"]
    previous = ""
    for token in tokens[index + 1 : index + _REACH]:
        if token.kind in BLOCK_STARTS and token.kind != "}":
            break
        if token.kind in _LINK_SECTIONS:
            is_frames = token.kind == token_kind("frames")
            scores["link"] += COSTS["believe frames" if is_frames else "believe a section"]
        elif previous == "ref_frame" and (token.kind == "{" or token.kind in _POSE):
            scores["joint"] += COSTS["believe a section"]
        previous = token.kind
    if scores["link"] == scores["joint"]:
        return None
    return max(scores, key=lambda kind: scores[kind])
