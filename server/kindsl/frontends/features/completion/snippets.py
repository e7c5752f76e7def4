"""Whole blocks with placeholders, in the formatter's style."""

from collections.abc import Iterator
from itertools import count

from kindsl.language.syntax.sections import ORDER
from kindsl.language.syntax.tables import KINDS, WORDS
from kindsl.language.syntax.vocabulary import MOMENTS, POSE

MOMENT_DEFAULTS = dict(zip(MOMENTS, (*("0.01",) * 3, *("0.0",) * 3), strict=True))
_DEFAULTS = {**MOMENT_DEFAULTS, "mass": "1.0", "ref_frame": "frame"}
_SIZES = {
    "box": ("0.1", "0.1", "0.1"),
    "cylinder": ("0.05", "0.2"),
    "hollow_cylinder": ("0.05", "0.04", "0.2"),
    "sphere": ("0.05",),
    "capsule": ("0.05", "0.2"),
}
_USUAL = {"scalar": "0.0", "moments": "0.0", "whole": "1", "name": "name"}


def link(name: str, number: int) -> str:
    """Return a link with inertia."""
    body = f"id = ${{2:{number}}}\n{section('inertia', 3)}\nchildren {{$0}}"
    return _in_braces(f"link ${{1:{name}}}", body)


def joint(keyword: str, name: str) -> str:
    """Return a joint that begins with a keyword."""
    return _in_braces(f"{keyword} ${{1:{name}}}", _in_braces("ref_frame", pose(2)))


def base(keyword_behind_name: str) -> str:
    """Return a base, with `floating` or nothing after its name."""
    head = f"RobotBase ${{1:base}} {keyword_behind_name}".rstrip()
    children = _in_braces("children", "${12:link1} via ${13:joint1}")
    return _in_braces(head, f"{section('inertia', 2)}\n{children}")


def robot() -> str:
    """Return a document with one link and one joint, which nothing is wrong with."""
    children = _in_braces("children", "${3:link1} via ${4:joint1}")
    joint_frame = "translation = (0.0, 0.0, 0.2)\nrotation = (0.0, 0.0, 0.0)"
    blocks = (
        "Robot ${1:Name} {",
        _in_braces("RobotBase ${2:base}", f"{_BASE_INERTIA}\n{children}"),
        _in_braces("link ${3:link1}", f"id = 1\n{_LINK_INERTIA}\nchildren {{$0}}"),
        _in_braces("r_joint ${4:joint1}", _in_braces("ref_frame", joint_frame)) + "\n}\n",
    )
    return "\n\n".join(blocks)


def pose(first: int = 1) -> str:
    """Return translation and rotation, their placeholders counted from `first`."""
    numbers = count(first)
    return "\n".join(line for part in POSE for line in _lines(part, numbers))


def section(kind: str, first: int = 1) -> str:
    """Return a section with all that it must have, its placeholders counted from `first`."""
    return "\n".join(_lines(kind, count(first)))


def _lines(kind: str, numbers: Iterator[int]) -> Iterator[str]:
    what, words = KINDS[kind], WORDS[kind]
    if what == "groups":
        yield _in_braces(words[0], frame())
    elif what == "vector":
        yield f"{words[0]} = {vector(next(numbers))}"
        next(numbers), next(numbers)
    elif what in _USUAL:
        for word in words:
            yield f"{word} = ${{{next(numbers)}:{_DEFAULTS.get(word, _USUAL[what])}}}"
    else:
        needed = [part for part, place in ORDER.get(kind, {}).items() if place.is_needed]
        lines = "\n".join(line for part in needed for line in _lines(part, numbers))
        yield _in_braces(words[0], lines)


def shape(name: str, heavy: str) -> str:
    """Return a shape whose inertia a fix writes, with its mass or its density."""
    sizes = (f"${{{number}:{size}}}" for number, size in enumerate(_SIZES[name], 1))
    value = {"mass": "1.0", "density": "2700.0"}[heavy]
    return f"{name}({', '.join(sizes)}, {heavy} = ${{{len(_SIZES[name]) + 1}:{value}}})"


def vector(first: int = 1) -> str:
    """Return a vector of three zeros, its placeholders counted from `first`."""
    return f"({', '.join(f'${{{number}:0.0}}' for number in range(first, first + 3))})"


def frame(name: str = "name") -> str:
    """Return an optional frame."""
    return _in_braces(f"${{1:{name}}}", pose(2))


def children(link: str, joint: str) -> str:
    """Return a section with one child."""
    return _in_braces("children", f"${{1:{link}}} via ${{2:{joint}}}")


def _in_braces(head: str, body: str) -> str:
    lines = "\n".join(f"    {line}" for line in body.split("\n"))
    return f"{head} {{\n{lines}\n}}"


def _inertia_of(mass: str, com: str, *moments: str) -> str:
    pairs = zip(MOMENT_DEFAULTS, moments, strict=True)
    lines = [f"mass = {mass}", f"CoM = ({com})", *(f"{name} = {text}" for name, text in pairs)]
    return _in_braces("inertia_params", "\n".join(lines))


_BASE_INERTIA = _inertia_of("1.0", "0.0, 0.0, 0.0", *MOMENT_DEFAULTS.values())
_LINK_INERTIA = _inertia_of("1.0", "0.0, 0.0, 0.1", "0.02", "0.02", "0.01", "0.0", "0.0", "0.0")
