"""Give a body's inertia in another frame; the body stays the same.

Offered only where all numbers are written out: with parameters in it the result would hold for
their present values alone.
"""

import re
from collections.abc import Iterable, Iterator, Sequence
from math import ceil, log10
from typing import NamedTuple

from kindsl.frontends.features.actions.action import REWRITE, CodeAction
from kindsl.frontends.features.manipulation.new_blocks import new_frame
from kindsl.frontends.features.names_taken import names_taken
from kindsl.frontends.features.tree_path import path_at
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.diagnosis.judgements import IMPOSSIBLE, Verdict, is_plain, judgements
from kindsl.judgement.rules.base import Severity
from kindsl.judgement.rules.context import ROBCOGEN2
from kindsl.language.semantics.declarations import Frame, Inertia, Link
from kindsl.language.semantics.expressions import Values, half_unit, symbols
from kindsl.language.semantics.lowering import declarations
from kindsl.language.semantics.numbers import written_pose
from kindsl.language.semantics.unknown import Unknown, pose_expressions
from kindsl.language.syntax.insertions import inserted_section
from kindsl.language.syntax.sections import ORDER
from kindsl.language.syntax.tables import WORDS
from kindsl.language.syntax.vocabulary import MOMENTS
from kindsl.language.text.decimals import fixed_decimal, rounded_decimal
from kindsl.language.text.distinct import free_name
from kindsl.language.text.edits import TextEdit
from kindsl.language.text.facts import Fact
from kindsl.mechanics.rigid.body import MassDistribution, seen_from
from kindsl.mechanics.rigid.pose import IDENTITY, RigidPose
from kindsl.robots.mechanism.link_inertia import link_inertia

_BY_DIGITS = IMPOSSIBLE | {Verdict.WITHIN_ROUNDING}
_SOUND = Fact[tuple[object, tuple[CodeAction, ...]]]("moves of an inertia that add no error")
_BLANKS_BEFORE = re.compile(r"(?:\r\n?|\n)?[ \t]*\Z")


def move_inertia(analysis: Analysis, start: int, _end: int) -> Iterator[CodeAction]:
    """Offer the link's own frames, the link frame, and a new frame at the CoM."""
    place = analysis.syntax.island_at(start)
    path = path_at(place.island, start - place.start)
    bodies = declarations(place.island).bodies()
    link = next((b for b in bodies if b.inertia is not None and b.inertia.node in path), None)
    if link is None or link.inertia is None or not _is_movable(link.inertia) or not link.name:
        return
    body = link_inertia(link, {})
    if isinstance(body, Unknown):
        return
    moving = _Moving(link, link.inertia, body, place.start)
    # An editor asks again wherever the cursor goes in the inertia.
    yield from analysis.facts.made_of(
        _SOUND, moving.inertia.node, lambda: tuple(_sound_actions(analysis, moving))
    )


class _Moving(NamedTuple):
    """An inertia that is moved, of a link whose island starts at `origin`.

    The body is in the link's frame. Moments have `decimals`, None for as many as are computed.
    """

    link: Link
    inertia: Inertia
    body: MassDistribution
    origin: int
    decimals: int | None = None


def _sound_actions(analysis: Analysis, moving: _Moving) -> Iterator[CodeAction]:
    """Yield the actions that add no error.

    A body that only its last digits make possible would be none if it were written as computed: its
    moments get no more decimals than they had.
    """
    judged = judgements(declarations(moving.link.island), analysis.context.values)
    found = next((each for each in judged if each.link is moving.link), None)
    if found is None or found.is_proved or found.verdict not in _BY_DIGITS:
        yield from _actions(analysis, moving)
        return
    sound: dict[str, CodeAction] = {}
    for decimals in _decimals(moving.inertia, sum(found.moments)):
        for action in _actions(analysis, moving._replace(decimals=decimals)):
            if action.title not in sound:
                after = analysis.edited(action.edits).check_without_twins()
                if _n_errors(after) <= _n_errors(analysis.check_without_twins()):
                    sound[action.title] = action
    yield from sound.values()


def _decimals(inertia: Inertia, trace: float) -> Iterable[int]:
    """Return with how many decimals moments may be written, the greatest not becoming zero."""
    if trace <= 0.0:
        return ()
    finest = min(half_unit(moment.text) for moment in inertia.moments.values())
    fewest = max(1, ceil(-log10(2.0 / 3.0 * trace)))
    return range(round(-log10(2.0 * finest)), fewest - 1, -1)


def _actions(analysis: Analysis, moving: _Moving) -> Iterator[CodeAction]:
    link, inertia, com = moving.link, moving.inertia, moving.body.com
    title = f"Give the inertia of '{link.name}'"
    if inertia.frame is not None:
        yield from _action(f"{title} in its link frame", moving, IDENTITY, _without_frame(inertia))
    if ROBCOGEN2 in analysis.settings.targets:
        return
    names = [str(frame.name) for frame in link.frames]
    for frame in link.frames:
        pose = _literal_pose(frame, {})
        if pose is not None and frame.name != inertia.frame and names.count(str(frame.name)) == 1:
            reference = _with_frame(inertia, str(frame.name))
            yield from _action(f"{title} in '{frame.name}'", moving, pose, reference)
    if any(com):
        name = free_name(f"{link.name}_com", names_taken(analysis.model))
        both = _with_frame(inertia, name), new_frame(link, name, com)
        title += f" about its CoM, in a new frame '{name}'"
        yield from _action(title, moving, IDENTITY._replace(translation=com), *both)


def _action(
    title: str, moving: _Moving, pose: RigidPose, *others: TextEdit | None
) -> Iterator[CodeAction]:
    edits = [*_numbers(moving, pose), *others]
    by = moving.origin
    moved = [TextEdit(by + e.start, by + e.end, e.text) for e in edits if e is not None]
    if len(moved) == len(edits):
        yield CodeAction(title, REWRITE, tuple(sorted(moved)))


def _n_errors(findings: Sequence[Diagnostic]) -> int:
    return sum(finding.severity is Severity.ERROR for finding in findings)


def _is_movable(inertia: Inertia) -> bool:
    """Return whether every number is given once, as a literal."""
    kinds = [child.kind for child in inertia.node.children]
    wanted = [kind for kind, place in ORDER["inertia"].items() if place.is_needed]
    is_once = all(kinds.count(kind) == len(WORDS[kind]) for kind in wanted)
    return is_once and is_plain(inertia)


def _literal_pose(frame: Frame, values: Values) -> RigidPose | None:
    if any(True for expression in pose_expressions(frame.pose) for _ in symbols(expression)):
        return None
    return written_pose(frame.pose, values)


def _numbers(moving: _Moving, pose: RigidPose) -> Iterator[TextEdit]:
    """Yield the edits of CoM and moments, `pose` being the pose of the new frame in the link's."""
    inertia, body, decimals = moving.inertia, moving.body, moving.decimals
    moved = seen_from(body, pose.inverse())
    length = sum(map(abs, (*body.com, *pose.translation)))
    size = sum(map(abs, body.moments)) + body.mass * length * length
    assert inertia.com is not None
    for component, value in zip(inertia.com.components, moved.com, strict=True):
        yield TextEdit(component.start, component.end, rounded_decimal(value, length))
    for name, value in zip(MOMENTS, moved.moments, strict=True):
        moment = inertia.moments[name]
        exact = rounded_decimal(value, size)
        text = exact if decimals is None else fixed_decimal(value, decimals)
        yield TextEdit(moment.start, moment.end, text)


def _with_frame(inertia: Inertia, name: str) -> TextEdit | None:
    if inertia.frame is not None:
        return TextEdit(inertia.frame.start, inertia.frame.end, name)
    node, text = inertia.node, inertia.island.text
    return inserted_section(text, node, node.parts[-1], (f"ref_frame = {name}",))


def _without_frame(inertia: Inertia) -> TextEdit:
    node = next(inertia.node.nodes("inertia_frame"))
    before = _BLANKS_BEFORE.sub("", inertia.island.text[: node.start])
    return TextEdit(len(before), node.end, "")
