"""Changes between two incomplete models, as far as both can be compared.

A parameter without a value gets the same stand-in on both sides, and then another one: a quantity
that the second changes depends on it, and is left out.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

from kindsl.language.semantics.declarations import Frame, Joint, Link
from kindsl.language.semantics.model import Model
from kindsl.language.text.phrases import listed
from kindsl.robots.comparison.difference import Difference, difference
from kindsl.robots.mechanism.fragments import skeleton_as_far_as_known
from kindsl.robots.mechanism.skeleton import Skeleton
from kindsl.robots.mechanism.total_mass import total_mass, unknown_bodies

_STAND_INS = (0.7315, 0.4127)

Document = tuple[Model, Mapping[str, float]]


class PartialDifference(NamedTuple):
    """The known changes.

    Attributes:
        difference: The changes of what both sides know.
        notes: Parts left out, and why.
    """

    difference: Difference
    notes: tuple[str, ...]


def partial_difference(old: Document, new: Document) -> PartialDifference | int:
    """Return what changed, or the number of the document, 0 or 1, that has no tree at all."""
    unbound = _unbound(old) | _unbound(new)
    versions: list[tuple[Skeleton, Skeleton]] = []
    for stand_in in _STAND_INS:
        sides = [_skeleton(document, dict.fromkeys(unbound, stand_in)) for document in (old, new)]
        if sides[0] is None or sides[1] is None:
            return 0 if sides[0] is None else 1
        versions.append((sides[0], sides[1]))
    bound = [(model, {**values, **_stand_ins(unbound, values)}) for model, values in (old, new)]
    if not unbound:
        return _without_unknown(difference(*versions[0]), bound)
    first, second = versions
    depends = [difference(a, b) for a, b in zip(first, second, strict=True)]
    found = _without(difference(*first), depends)
    names = listed(f"'{name}'" for name in sorted(unbound))
    what = "parameter" if len(unbound) == 1 else "parameters"
    verb = "has" if len(unbound) == 1 else "have"
    note = f"{what} {names} {verb} no value: what depends on it is left out"
    known = _without_unknown(found, bound)
    return known._replace(notes=(note, *known.notes))


def added(same: Difference, model: Model) -> Difference:
    """Return the difference of nothing to a model, from that of the model to itself."""
    return replace(
        same,
        added_links=_names(model.links),
        added_joints=_names(model.joints),
        added_frames=_names(model.frames),
        total_mass=(0.0, same.total_mass[1]),
        reach=(0.0, same.reach[1]),
    )


def removed(same: Difference, model: Model) -> Difference:
    """Return the difference of a model to nothing, from that of the model to itself."""
    return replace(
        same,
        removed_links=_names(model.links),
        removed_joints=_names(model.joints),
        removed_frames=_names(model.frames),
        total_mass=(same.total_mass[0], 0.0),
        reach=(same.reach[0], 0.0),
    )


def _stand_ins(unbound: Iterable[str], values: Mapping[str, float]) -> dict[str, float]:
    return {name: _STAND_INS[0] for name in unbound if name not in values}


def _without_unknown(found: Difference, documents: Sequence[Document]) -> PartialDifference:
    """Leave out the inertia and totals that cannot be read on either side, and say so."""
    old_name = {pair.new: pair.old for pair in found.renamed_links}
    before, after = (unknown_bodies(*document) for document in documents)
    links = [change.link for change in found.masses]
    unknown = {n for n in links if n in after or old_name.get(n, n) in before}
    weights = [total_mass(*document) for document in documents]
    left_out = [f"the inertia of '{name}'" for name in sorted(unknown)]
    reasons = [reason.plain for reason in (*before.values(), *after.values())]
    if not all(weight.is_whole for weight in weights):
        left_out = ["the total mass", *left_out]
        reasons = [weight.plain_reason for weight in weights if not weight.is_whole]
        found = replace(found, total_mass=(0.0, 0.0))
    found = replace(found, masses=tuple(m for m in found.masses if m.link not in unknown))
    notes = (f"{listed(left_out)} left out: {reasons[0]}",) if left_out else ()
    return PartialDifference(found, notes)


def _names(things: Iterable[Link | Joint | Frame]) -> tuple[str, ...]:
    return tuple(str(thing.name) for thing in things)


def _unbound(document: Document) -> set[str]:
    model, values = document
    return {str(p.name) for p in model.parameters} - set(values)


def _skeleton(document: Document, stand_ins: Mapping[str, float]) -> Skeleton | None:
    model, values = document
    return skeleton_as_far_as_known(model, {**stand_ins, **values})


def _without(found: Difference, depends: list[Difference]) -> Difference:
    """Return a difference without what depends on a stand-in on either side."""

    def names(*fields: str) -> set[str]:
        moved = (change for d in depends for field in fields for change in getattr(d, field))
        return {getattr(change, "name", None) or change.link for change in moved}

    joints, frames, poses = names("joint_frames"), names("frames"), names("zero_poses")
    masses = names("masses")
    total = any(d.total_mass[0] != d.total_mass[1] for d in depends)
    reach = any(d.reach[0] != d.reach[1] for d in depends)
    return replace(
        found,
        joint_frames=tuple(m for m in found.joint_frames if m.name not in joints),
        frames=tuple(m for m in found.frames if m.name not in frames),
        zero_poses=tuple(m for m in found.zero_poses if m.name not in poses),
        masses=tuple(m for m in found.masses if m.link not in masses),
        total_mass=(0.0, 0.0) if total else found.total_mass,
        reach=(0.0, 0.0) if reach else found.reach,
    )
