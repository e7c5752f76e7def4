"""Reads RobCoGen's transforms documents with Lark, by `grammar/dtdsl.lark`.

Lark's LALR parser asks `_Recovery` at each word that does not fit. A missing word is inserted where
the words behind it fit at least as well as without the word, the rest of a pair where they fit
better; otherwise Lark skips the word.
"""

from collections.abc import Iterator
from copy import copy
from functools import cache
from itertools import islice
from typing import TYPE_CHECKING, Any, NamedTuple

from kindsl.language.syntax.grammars import grammar_text
from kindsl.language.syntax.token_names import shown
from kindsl.language.text.phrases import alternatives

if TYPE_CHECKING:
    from lark import Lark, Token, Tree, UnexpectedInput

SECTIONS = ("Frames", "Transforms", "Jacobians")

_N_AHEAD = 8
# `base`, `=`, a frame, a comma, `target`, `=` and a frame.
_N_IN_PAIR = 7
_WORD_END = r"(?!\w)"


class PlacedName(NamedTuple):
    """A name where it stands; offsets in code points."""

    text: str
    start: int
    end: int


class FramePair(NamedTuple):
    """A transform or Jacobian that is wanted: of `target`, seen from `base`."""

    base: PlacedName
    target: PlacedName

    @property
    def span(self) -> tuple[int, int]:
        """The stretch from one name to the other, in whichever order they stand."""
        return min(self.base.start, self.target.start), max(self.base.end, self.target.end)


class Defect(NamedTuple):
    """A problem at a stretch of a transforms document; offsets in code points."""

    message: str
    start: int
    end: int


class TransformsDocument(NamedTuple):
    """The content of a transforms document, as far as it can be read.

    Attributes:
        transforms: The transforms wanted; pairs that lack a frame are left out.
        jacobians: The Jacobians wanted, likewise.
        defects: The stretches that do not fit, in order.
        expected: The words that may come next where the text ends too early: `'{'`, `a frame`.
    """

    robot: PlacedName | None
    frames: tuple[PlacedName, ...]
    transforms: tuple[FramePair, ...]
    jacobians: tuple[FramePair, ...]
    defects: tuple[Defect, ...]
    expected: tuple[str, ...]


def read_transforms(text: str) -> TransformsDocument:
    """Return the content of a text; never raises."""
    recovery = _Recovery(text)
    tree = _parser().parse(text, on_error=recovery.mend)
    return TransformsDocument(
        next(iter(_names(tree, "A_ROBOT_NAME")), None),
        tuple(word for section in tree.find_data("frames") for word in _names(section, "A_FRAME")),
        tuple(_pairs(tree, "transforms")),
        tuple(_pairs(tree, "jacobians")),
        tuple(sorted((*recovery.defects, *_disorder(tree)), key=lambda defect: defect.start)),
        recovery.expected,
    )


@cache
def _parser() -> "Lark":
    from lark import Lark

    return Lark(grammar_text("dtdsl.lark"), parser="lalr", start="document")


def _pairs(tree: "Tree[Token]", section: str) -> Iterator[FramePair]:
    for found in tree.find_data(section):
        for pair in found.children:
            if isinstance(pair, str):
                continue
            names = _names(pair, "A_FRAME")
            if len(names) == 2:
                base, target = names if pair.data == "pair" else reversed(names)
                yield FramePair(base, target)


def _names(tree: "Tree[Token]", kind: str) -> list[PlacedName]:
    tokens = [child for child in tree.children if isinstance(child, str) and child.type == kind]
    return [PlacedName(str(token), *_ends(token)) for token in tokens if token]


def _ends(token: "Token") -> tuple[int, int]:
    return token.start_pos or 0, token.end_pos or 0


def _disorder(tree: "Tree[Token]") -> Iterator[Defect]:
    """Yield the sections that are repeated or out of order."""
    last = -1
    for keyword in tree.scan_values(lambda token: str(token) in SECTIONS):
        if keyword.type.title() not in SECTIONS:
            continue
        rank = SECTIONS.index(keyword)
        if rank <= last:
            fault = "is repeated" if rank == last else f"must stand before '{SECTIONS[last]}'"
            yield Defect(f"'{keyword}' {fault}", *_ends(keyword))
        last = max(rank, last)


class _Recovery:
    """Mends what does not fit, and notes each stretch that did not.

    Attributes:
        expected: The words that may stand at the end of the text, if it ends too early.
    """

    def __init__(self, text: str) -> None:
        self.text = text
        self.defects: list[Defect] = []
        self.expected: tuple[str, ...] = ()
        self._states: list[object] = []

    def mend(self, error: "UnexpectedInput") -> bool:
        """Let the parser go on behind an error; without an insertion Lark skips the word."""
        from lark import UnexpectedToken

        parser: Any = error.interactive_parser
        accepted = sorted(parser.accepts() - {"$END"})
        if not isinstance(error, UnexpectedToken):
            place = error.pos_in_stream or 0
            self._note(parser, accepted, place, place + 1)
        elif error.token.type == "$END":
            self.expected = tuple(map(_kind_name, accepted))
            self._note(parser, accepted, len(self.text), len(self.text))
            _complete(parser, error.token)
        else:
            token = error.token
            self._note(parser, accepted, token.start_pos, token.end_pos)
            missing = _missing_before(parser, accepted, token)
            for word in (*missing, token) if missing else ():
                parser.feed_token(word)
        return True

    def _note(self, parser: Any, accepted: list[str], start: int, end: int) -> None:
        """Note a stretch, as part of the last one where nothing was read between them."""
        states = list(parser.parser_state.state_stack)
        last = self.defects[-1] if self.defects else None
        if last and states == self._states and not self.text[last.end : start].strip():
            self.defects[-1] = last._replace(end=end)
            return
        self._states = states
        found = f"'{shown(self.text[start:end])}'" if start < end else "the end of the document"
        message = f"expected {alternatives(map(_kind_name, accepted))} instead of {found}"
        self.defects.append(Defect(message, start, end))


def _missing_before(parser: Any, accepted: list[str], token: "Token") -> list["Token"]:
    """Return the words whose absence explains another one, none if the other is one too many."""
    best, missing = _n_fitting(parser), list["Token"]()
    for kind in accepted:
        word = _inserted(kind, token)
        n_fitting = _n_fitting(parser, word, token)
        if n_fitting > best or (n_fitting == best and not missing):
            best, missing = n_fitting, [word]
    for kind in accepted:
        words = _rest_of_pair(parser, kind, token)
        n_fitting = _n_fitting(parser, *words, token)
        if n_fitting > best:
            best, missing = n_fitting, words
    return missing


def _rest_of_pair(parser: Any, kind: str, token: "Token") -> list["Token"]:
    """Return the words that must follow before another one fits, beginning with a kind."""
    trial, words = _trial(parser), [_inserted(kind, token)]
    trial.feed_token(words[0])
    while len(words) < _N_IN_PAIR and token.type not in (accepted := trial.accepts()):
        if "$END" in accepted:
            break
        words.append(_inserted(min(accepted), token))
        trial.feed_token(words[-1])
    return words


def _n_fitting(parser: Any, *first: "Token") -> int:
    """Return how many of the next words fit after some others; -1 if those do not fit."""
    from lark import UnexpectedInput

    trial, count = _trial(parser), -1
    try:
        for token in first:
            trial.feed_token(token)
        count = 0
        for _ in islice(trial.iter_parse(), _N_AHEAD):
            count += 1
    except UnexpectedInput:
        pass
    return count


def _trial(parser: Any) -> Any:
    """Return a parser that can go on from where another stands, which stays there."""
    trial = parser.copy(deepcopy_values=False)
    # Without callbacks no list of the values that both share grows.
    trial.parser_state.parse_conf = copy(trial.parser_state.parse_conf)
    trial.parser_state.parse_conf.callbacks = {}
    return trial


def _complete(parser: Any, end: "Token") -> None:
    while "$END" not in (accepted := parser.accepts()):
        kind = "RBRACE" if "RBRACE" in accepted else min(accepted)
        parser.feed_token(_inserted(kind, end))


def _inserted(kind: str, before: "Token") -> "Token":
    from lark import Token

    return Token.new_borrow_pos(kind, "", before)


def _kind_name(kind: str) -> str:
    """Return how messages name a terminal: `'{'`, `'base'`, `a frame`."""
    if kind.startswith("A_"):
        return kind.lower().replace("_", " ")
    value = _parser().get_terminal(kind).pattern.value
    first, *_ = value.removesuffix(_WORD_END).removeprefix("(?:").split("|")
    return f"'{first}'"
