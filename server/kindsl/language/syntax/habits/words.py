"""Words, sections and children as other formats, former years and half done typing have them."""

import re
from collections.abc import Iterator, Sequence
from itertools import pairwise

from kindsl.language.syntax.habits.engine import Rewrite, Sighting
from kindsl.language.syntax.habits.values import VECTOR
from kindsl.language.syntax.insertions import removed
from kindsl.language.syntax.scanner import word_kind
from kindsl.language.syntax.tables import KEYWORDS
from kindsl.language.syntax.token_names import called, shown, supplied, unknown_keyword
from kindsl.language.syntax.tree import Edit, Token
from kindsl.language.syntax.vocabulary import NUMBERS
from kindsl.language.text.lines import is_first_on_line

_MEANT = {
    **{word: word for word in ("id", "mass", "translation", "rotation")},
    **dict.fromkeys(("com", "cog", "centerofmass", "centreofmass"), "CoM"),
    "xyz": "translation",
    "origin": "translation",
    "rpy": "rotation",
}
_MOMENT = re.compile("[ij](?P<axes>[xyz]{1,2}|[123]{2})")
_AXES = str.maketrans("123", "xyz")
_RELATIVES = {"parent": {("L", 1): "link", ("J", 1): "joint"}, "child": {("J", 1): "joint"}}
_CLOSING = {"{": "}", "(": ")"}
_OWNERS = {"V": "F", "D": "LJ"}
_CHILD = ("NAME", "via", "NAME")
_HALF_CHILD = re.compile(r"\n?(?:n\n?v(?=\n?\}|\nn\n?v)|n(?=\n?\}|\nn))")
_ENDED = re.compile(r"(?<=[fiepmqPn)};]);(?=\n?(?:[SDcVRIC};]|n\n?v)|\n|\Z)")
_WHOLE_CHILD = re.compile(r"\n?n\n?v\n?n")


def meant_word(text: str) -> str | None:
    """Return the keyword that a word of another format stands for, None where it is unknown."""
    word = text.replace("_", "").casefold()
    moment = _MOMENT.fullmatch(word)
    if moment is None:
        return _MEANT.get(word)
    return "I" + "".join(sorted(set(moment["axes"].translate(_AXES))))


def relative(found: Sighting) -> Iterator[Rewrite]:
    """Leave out `parent = a`, `parent a`, `parent { ... }` or a part of it."""
    first, behind = found.span()
    word = found.tokens[first]
    owner = _RELATIVES.get(word.text, {}).get(found.block(first))
    if owner is None:
        return
    for value in found.of("value"):
        if value.kind in _CLOSING:
            behind = _closing(found.tokens, behind - 1)
        elif not value.text[:1].isidentifier() and not value.text[:1].isdigit():
            behind -= 1
    end = found.tokens[behind - 1].end
    words = (owner, word.text, shown(found.text[word.start : end]))
    edits = (Edit(word.start, end, ""),)
    yield Rewrite(first, behind, (), (word.start, word.end), words, edits)


def _closing(tokens: Sequence[Token], opening: int) -> int:
    """Return the index after the closing bracket, else the index of the opening one."""
    closing = _CLOSING[tokens[opening].kind]
    depth = 0
    for index in range(opening, len(tokens)):
        depth += (tokens[index].kind == tokens[opening].kind) - (tokens[index].kind == closing)
        if depth == 0:
            return index + 1
    return opening


def foreign_words(found: Sighting) -> Iterator[Rewrite]:
    """Yield the words of a section for ours, each once."""
    taken = _taken(found)
    for index, token, word in _called(found):
        if word not in taken:
            taken.add(word)
            new = Token(word_kind(word), word, token.lead, token.start, token.end)
            message = unknown_keyword(token.text, [word])
            edits = (Edit(token.start, token.end, word),)
            words = (shown(token.text), word)
            yield Rewrite(index, index + 1, [new], (token.start, token.end), words, edits, message)


def repeated_words(found: Sighting) -> Iterator[Rewrite]:
    """Leave out the words of a section that mean one that it has, as `iyx` of a whole matrix."""
    taken = _taken(found)
    for index, token, word in _called(found):
        kinds = [t.kind for t in found.tokens[index + 2 : index + 4]]
        if word not in taken or not NUMBERS.intersection(kinds[:1]):
            continue
        if kinds[1:] and kinds[1] in "*/-":
            continue
        end = found.tokens[index + 2].end
        statement = " ".join(t.text for t in found.tokens[index : index + 3])
        is_lower = token.text[-1:] < token.text[-2:-1]  # in a matrix's lower triangle
        edits = (Edit(token.start, end, ""),) if is_lower else ()
        words = (shown(token.text), word, shown(statement))
        is_same = token.text.casefold() == word.casefold()
        message = f"second '{word}', written '{shown(token.text)}'" if is_same else ""
        yield Rewrite(index, index + 3, (), (token.start, token.end), words, edits, message)


def _taken(found: Sighting) -> set[str]:
    names = (word.text for word, sign in pairwise(found.of()) if sign.kind == "=")
    return {name for name in names if name in KEYWORDS}


def _called(found: Sighting) -> Iterator[tuple[int, Token, str]]:
    """Yield the names where a section's keyword stands, before `=`, with what they mean."""
    first, behind = found.span()
    for index in range(first, behind - 1):
        token = found.tokens[index]
        before = found.tokens[index - 1].kind if index else ""
        if token.kind == "NAME" and found.tokens[index + 1].kind == "=" and before != "<":
            word = meant_word(token.text)
            if word is not None:
                yield index, token, word


def own_frame(found: Sighting) -> Iterator[Rewrite]:
    """Leave out the obsolete `ref_frame` of a link or base after its sections."""
    letters = found.letters()
    has_section = False
    for index, letter in enumerate(letters):
        depth = found.block(index)[1]
        if (letter, depth) == ("}", 0) or (has_section and (letter, depth) == ("D", 1)):
            return  # the latter of a joint whose head is lost
        has_section |= letter in "IC"
        behind = letters.find("}", index) + 1
        if depth == 1 and has_section and behind and letters.startswith("R{V", index):
            first, end = found.tokens[index], found.tokens[behind - 1].end
            owner = "link" if letters[0] == "L" else "base"
            words, edits = (owner, shown(found.tokens[1].text)), (removed(found.text, first, end),)
            yield Rewrite(index, behind, (), (first.start, end), words, edits)
            return


def comment(found: Sighting) -> Iterator[Rewrite]:
    """Leave out a comment that begins with `#`: words, not code, follow on its line."""
    if found.match["words"] is None:
        return  # a value
    first, behind = found.span()
    sign, words = found.tokens[first], found.of("words")
    is_first = is_first_on_line(found.text, sign.start)
    if len(words) == 1:
        is_comment = is_first and words[0].kind == "NAME"
    else:
        is_comment = len(words) > 3 or (is_first and words[0].text[:1].isidentifier())
    if is_comment:
        edit = Edit(sign.start, sign.end, "//")
        yield Rewrite(first, behind, (), (sign.start, sign.end), (), (edit,))


def semicolons(found: Sighting) -> Iterator[Rewrite]:
    """Leave out each `;` after a section or child; the first is reported for all in the block."""
    places = [found.index(match.start()) for match in _ENDED.finditer(found.kinds)]
    edits = tuple(Edit(found.tokens[i].start, found.tokens[i].end, "") for i in places)
    title = "';'" if len(edits) == 1 else "each ';' of this block"
    for place in places:
        at = None if place != places[0] else (edits[0].start, edits[0].end)
        yield Rewrite(place, place + 1, (), at, (title,), edits)


def half_children(found: Sighting) -> Iterator[Rewrite]:
    """Complete half a child: `upper via`, or `upper` alone at the end of its line."""
    position = found.match.end()
    while True:
        half = _HALF_CHILD.match(found.kinds, position)
        match = half or _WHOLE_CHILD.match(found.kinds, position)
        if match is None:
            return
        position = match.end()
        if half is not None:
            behind = found.index(position)
            last = found.tokens[behind - 1]
            lacking = _CHILD[len(half[0].replace("\n", "")) :]
            new = [supplied(kind, last.end) for kind in lacking]
            words = (called(lacking[0]), shown(last.text))
            yield Rewrite(behind, behind, new, (last.end, last.end), words)


def half_section(found: Sighting) -> Iterator[Rewrite]:
    """Supply `=` and a value after a keyword that is alone on its line."""
    first, behind = found.span("word")
    token, letter = found.tokens[first], found.letters("word")
    block, _ = found.block(first)
    if not block or block not in _OWNERS.get(letter, "I"):
        return
    value = VECTOR if letter in "cV" else ("INT",) if letter == "D" else ("FLOAT",)
    new = [token, *(supplied(kind, token.end) for kind in ("=", *value))]
    yield Rewrite(first, behind, new, (token.end, token.end), (shown(token.text),))
