"""The component of a vector that is being typed, and its unit."""

from typing import NamedTuple

from kindsl.frontends.features.tree_path import index_after
from kindsl.frontends.features.value_place import component_name
from kindsl.frontends.features.wording import METRES, RADIANS
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.language.syntax.tables import KINDS, VALUES, WORDS, ValueKind
from kindsl.language.syntax.tree import Island
from kindsl.language.syntax.vocabulary import meanings_of

_SECTIONS = {WORDS[section][0]: section for section in VALUES if KINDS[section] == "vector"}
_ABOUT = {
    "translation": "origin of the frame",
    "rotation": "intrinsic angles: about x, then the new y, then the new z",
    "CoM": "centre of mass in the link frame (or in ref_frame)",
}
_UNITS = {METRES: "metres", RADIANS: "radians"}
_FARTHEST = 400
_BEGINS = frozenset((*_SECTIONS, "{", "}"))


class SignatureParameter(NamedTuple):
    """One component; `start` and `end` are its place in the signature's label."""

    start: int
    end: int
    documentation: str


class Signature(NamedTuple):
    """A vector that is being filled in, its label like `translation = (x, y, z)`.

    `active` is the number of the component at the cursor.
    """

    label: str
    documentation: str
    parameters: tuple[SignatureParameter, ...]
    active: int


def signature_help(analysis: Analysis, offset: int) -> Signature | None:
    """Return the signature of the vector around an offset, None outside of one.

    It is read from the signs before the offset, so that it works while the vector is being typed.
    """
    place = analysis.syntax.island_at(offset)
    found = _vector_before(place.island, offset - place.start)
    if found is None:
        return None
    word, active = found
    return _signature(word, min(active, 2))


def _vector_before(island: Island, local: int) -> tuple[str, int] | None:
    """Return the word before an open parenthesis, and the number of commas after it."""
    commas = depth = 0
    tokens = island.tokens[: index_after(island, local)][-_FARTHEST:]
    before = [token for token in tokens if token.end <= local and not token.is_missing]
    signs = [token.text for token in before if token.text != "="]
    while signs:
        sign = signs.pop()
        if sign in _BEGINS:
            return None
        if sign == "(" and not depth and signs and signs[-1] in _SECTIONS:
            return signs[-1], commas
        # A parenthesis that is open at the offset groups a part of a component.
        depth = max(depth + {")": 1, "(": -1}.get(sign, 0), 0)
        commas += sign == "," and depth == 0
    return None


def _signature(word: str, active: int) -> Signature:
    label = f"{word} = ("
    parameters: list[SignatureParameter] = []
    for meaning in meanings_of(_SECTIONS[word], word):
        name, documentation = "xyz"[meaning.component or 0], _UNITS.get(meaning.unit, meaning.unit)
        if meaning.kind is ValueKind.ANGLE:
            name, documentation = f"r{name}", f"{documentation}, {component_name(meaning)}"
        label += ", " if parameters else ""
        parameters.append(SignatureParameter(len(label), len(label) + len(name), documentation))
        label += name
    return Signature(f"{label})", _ABOUT.get(word, ""), tuple(parameters), active)
