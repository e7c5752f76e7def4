"""Changed written numbers of joints, frames and bodies that are on both sides."""

from collections.abc import Iterable, Iterator, Mapping
from math import isclose, radians
from typing import NamedTuple

from kindsl.judgement.analysis.analysis import Analysis
from kindsl.language.semantics.expressions import Expression
from kindsl.language.semantics.unknown import inertia_expressions, pose_expressions

_ROUNDING = 1e-12
# What a factor between two numbers says, and how near it must be.
_FACTORS = (
    (1000.0, "1000 times: another unit?"),
    (0.001, "a thousandth: another unit?"),
    (1.0 / radians(1.0), "180/PI times: degrees?"),
    (radians(1.0), "PI/180 times: radians?"),
)
_NEAR = 1e-4


class WrittenChange(NamedTuple):
    """A number, such as `"translation x"`, of a joint, frame or link that changed, as written.

    The remark is the likely cause. A text is empty where there is nothing to tell.
    """

    kind: str
    name: str
    number: str
    old: str
    new: str
    remark: str


def written_changes(
    old: Analysis, new: Analysis, links: Mapping[str, str], joints: Mapping[str, str]
) -> Iterator[WrittenChange]:
    """Yield the changes, joints first, then frames, then links."""
    for kind, before, after in (
        ("joint", _joints(old, joints), _joints(new, {})),
        ("frame", _frames(old, links), _frames(new, {})),
        ("link", _bodies(old, links), _bodies(new, {})),
    ):
        for thing, numbers in before.items():
            for number in (
                dict.fromkeys((*numbers, *after.get(thing, {}))) if thing in after else ()
            ):
                here, there = numbers.get(number), after[thing].get(number)
                a = None if here is None else here.value(old.context.values)
                b = None if there is None else there.value(new.context.values)
                texts = [expression.text if expression else "" for expression in (here, there)]
                is_same = texts[0] == texts[1] if a is None or b is None else _same(a, b)
                if here is None or there is None or not is_same:
                    yield WrittenChange(kind, thing, number, texts[0], texts[1], _remark(a, b))


_Numbers = dict[str, dict[str, Expression]]


def _joints(side: Analysis, renamed: Mapping[str, str]) -> _Numbers:
    return {
        renamed.get(str(joint.name), str(joint.name)): _by_label(pose_expressions(joint.pose))
        for joint in side.model.joints
    }


def _frames(side: Analysis, renamed: Mapping[str, str]) -> _Numbers:
    return {
        f"{renamed.get(str(body.name), str(body.name))}.{frame.name}": _by_label(
            pose_expressions(frame.pose)
        )
        for body in side.model.bodies
        for frame in body.frames
    }


def _bodies(side: Analysis, renamed: Mapping[str, str]) -> _Numbers:
    return {
        renamed.get(str(body.name), str(body.name)): _by_label(inertia_expressions(body.inertia))
        for body in side.model.bodies
        if body.inertia is not None
    }


def _by_label(values: Iterable[Expression]) -> dict[str, Expression]:
    found = {}
    for value in values:
        section, component = value.meaning.section, value.meaning.component
        found[section if component is None else f"{section} {'xyz'[component]}"] = value
    return found


def _same(a: float, b: float) -> bool:
    return isclose(a, b, rel_tol=_ROUNDING)


def _remark(a: float | None, b: float | None) -> str:
    if not a or not b:
        return ""
    if _same(a, -b):
        return "sign swapped"
    near = (cause for factor, cause in _FACTORS if isclose(b, a * factor, rel_tol=_NEAR))
    return next(near, "")
