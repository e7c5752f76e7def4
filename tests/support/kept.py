"""What fixes must leave as it is, read off the model and the text, not as the engine reads it."""

import re
from collections import Counter
from collections.abc import Iterator, Mapping
from typing import NamedTuple, TypeAlias

from kindsl.judgement.analysis.analysis import Analysis
from kindsl.judgement.rules.base import Severity
from kindsl.language.semantics.declarations import Inertia, Link, Pose
from kindsl.language.semantics.expressions import Expression
from kindsl.language.syntax.scanner import comments
from kindsl.language.syntax.vocabulary import MOMENTS

Place: TypeAlias = tuple[object, ...]

_NO_VALUES: Mapping[str, float] = {}
_LETTERS = re.compile(r"\w+")
_DIRECTIVE = re.compile(r"kindsl: *ignore")


class Written(NamedTuple):
    """A number: its value, None where it is none, and how far a unit of its last digit goes."""

    value: float | None
    unit: float


class _StandIns(dict[str, float]):
    """Values by name; a name without one has a value of its own."""

    def get(self, name: str, default: object = None) -> float:  # type: ignore[override]
        return self[name] if name in self else 2.0 + sum(map(ord, name)) / 7919.0


def numbers(analysis: Analysis, values: Mapping[str, float] = _NO_VALUES) -> dict[Place, Written]:
    """Return each number of the document by owner, the how-manieth of its name, and component.

    Args:
        analysis: The document.
        values: Values of parameters; each of the others has one of its own, whatever its default.
    """
    found: dict[Place, Written] = {}
    seen: Counter[tuple[str, str]] = Counter()
    model, values = analysis.model, _StandIns(values)
    for body in model.bodies:
        seen["body", str(body.name)] += 1
        owner = ("body", str(body.name), seen["body", str(body.name)])
        found.update({(*owner, *place): number for place, number in _of_body(body, values)})
    for joint in model.joints:
        seen["joint", str(joint.name)] += 1
        owner = ("joint", str(joint.name), seen["joint", str(joint.name)])
        if joint.id_place is not None:
            found[*owner, "id"] = Written(joint.id, 0.0)
        found.update({(*owner, *place): number for place, number in _of_pose(joint.pose, values)})
    return found


def _of_body(body: Link, values: _StandIns) -> Iterator[tuple[Place, Written]]:
    if body.id_place is not None:
        yield ("id",), Written(body.id, 0.0)
    if body.inertia is not None:
        yield from _of_inertia(body.inertia, values)
    for number, frame in enumerate(body.frames):
        for place, written in _of_pose(frame.pose, values):
            yield ("frame", str(frame.name), number, *place), written


def _of_inertia(
    inertia: Inertia, values: _StandIns
) -> Iterator[tuple[tuple[object, ...], Written]]:
    if inertia.mass is not None:
        yield ("mass",), _written(inertia.mass, values)
    if inertia.com is not None:
        for axis, component in zip("xyz", inertia.com.components, strict=True):
            yield ("com", axis), _written(component, values)
    for name in MOMENTS:
        if name in inertia.moments:
            yield (name,), _written(inertia.moments[name], values)


def _of_pose(pose: Pose, values: _StandIns) -> Iterator[tuple[Place, Written]]:
    for kind, vector in (("translation", pose.translation), ("rotation", pose.rotation)):
        if vector is not None:
            for axis, component in zip("xyz", vector.components, strict=True):
                yield (kind, axis), _written(component, values)


def _written(expression: Expression, values: _StandIns) -> Written:
    return Written(expression.value(values), 2.0 * expression.rounding(values))


def changed_numbers(before: Analysis, after: Analysis) -> list[str]:
    """Return what became of numbers, but for those that stay within a unit of their last digit."""
    return _changes(numbers(before), numbers(after))


def changed_at_their_values(before: Analysis, after: Analysis) -> list[str]:
    """Return the same where parameters have the values that the documents give them."""
    old, new = (numbers(each, each.context.values) for each in (before, after))
    return _changes(old, new)


def _changes(old: dict[Place, Written], new: dict[Place, Written]) -> list[str]:
    told = [f"lost: {place}" for place in old.keys() - new.keys()]
    told += [f"gained: {place}" for place in new.keys() - old.keys()]
    for place in old.keys() & new.keys():
        was, now = old[place].value, new[place].value
        if was is None or now is None:
            told += [f"{place}: {was} became {now}"] if was is not now else []
        elif was != now and abs(was - now) > old[place].unit + 4e-16 * abs(was):
            told.append(f"{place}: {was} became {now}")
    return told


def lost_remarks(before: str, after: str) -> list[str]:
    """Return the words of comments that are no longer in the text; directives are no comments."""
    kept = Counter(_LETTERS.findall(after))
    remarks = Counter(word for text in _remarks(before) for word in _LETTERS.findall(text))
    return sorted((remarks - kept).elements())


def _remarks(text: str) -> Iterator[str]:
    """Yield the comments; of one without an end its line, what follows is code."""
    for start, end in comments(text):
        remark = text[start:end]
        if remark.startswith("/*") and not remark.endswith("*/"):
            remark = remark.splitlines()[0]
        if not _DIRECTIVE.search(remark):
            yield remark


def lost_blocks(before: Analysis, after: Analysis) -> list[str]:
    """Return the kinds of the blocks that there are fewer of."""
    return sorted((_blocks(before) - _blocks(after)).elements())


def _blocks(analysis: Analysis) -> Counter[str]:
    model = analysis.model
    return Counter(
        base=len(model.bases),
        link=len(model.links),
        joint=len(model.joints),
        frame=len(model.frames),
        inertia=sum(body.inertia is not None for body in model.bodies),
    )


def errors(analysis: Analysis) -> Counter[str]:
    """Return how often each error is told, by code."""
    return Counter(f.code for f in analysis.findings if f.severity is Severity.ERROR)


def remarks(analysis: Analysis) -> list[str]:
    """Return the comments, sorted."""
    return sorted(i.text[s:e] for i in analysis.syntax.islands for s, e in i.comments)
