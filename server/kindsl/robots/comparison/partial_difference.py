"""Changes between two incomplete models, as far as both can be compared.

A parameter without a value gets the same stand-in on both sides, and then another one: a quantity
that the second changes depends on it, and is left out.
"""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from kindsl.language.semantics.model import Model
from kindsl.language.text.phrases import listed
from kindsl.robots.comparison.conventions import rounded_numbers
from kindsl.robots.comparison.difference import Difference, MassChange, Moved, difference
from kindsl.robots.comparison.document_side import described_document
from kindsl.robots.comparison.rounding import unrounded
from kindsl.robots.mechanism.linkage import Linkage
from kindsl.robots.mechanism.reading import partial_linkage
from kindsl.robots.mechanism.total_mass import total_mass, unknown_bodies

_STAND_INS = (0.7315, 0.4127)
_NOTHING = 0.0, 0.0

Document = tuple[Model, Mapping[str, float]]


def partial_difference(
    old: Document | None, new: Document | None
) -> tuple[Difference, tuple[str, ...]] | int:
    """Return the changes of what both sides know, and notes on what is left out, and why.

    If a document has no tree at all, its number, 0 or 1, is returned.

    Args:
        old: Model and values of parameters, None if there was no document.
        new: The same, None if the document is gone.
    """
    sides = [side for side in (old or new, new or old) if side is not None]
    pairs = [(p.name, values) for model, values in sides for p in model.parameters]
    unbound = sorted({str(name) for name, values in pairs if name not in values})
    bound = [
        [(model, {**dict.fromkeys(unbound, stand_in), **values}) for model, values in sides]
        for stand_in in _STAND_INS
    ]
    versions: list[list[Linkage]] = []
    for documents in bound:
        skeletons = [partial_linkage(*document) for document in documents]
        if None in skeletons:
            return 1 if old is None else skeletons.index(None)
        versions.append([skeleton for skeleton in skeletons if skeleton is not None])
    found, notes = document_difference(bound[0], versions[0])
    if unbound:
        depends = [difference(*side) for side in zip(*versions, strict=True)]
        found = _independent(found, depends)
        names = listed(f"'{name}'" for name in unbound)
        parameters = "parameters" if unbound[1:] else "parameter"
        verb = "have" if unbound[1:] else "has"
        notes.append(f"{parameters} {names} {verb} no value: what depends on it is left out")
    found, unknown = _known(found, bound[0])
    if old is None or new is None:
        found = _of_one(found, versions[0][0], "added" if old is None else "removed")
    return found, (*notes, *unknown)


def document_difference(
    documents: Sequence[Document], skeletons: Sequence[Linkage]
) -> tuple[Difference, list[str]]:
    """Return what changed besides digits, and a note on numbers that have more or fewer."""
    found = difference(*skeletons)
    if found.is_empty:
        return found, []
    pairs = zip(documents, skeletons, strict=True)
    ours, theirs = (described_document("", *document, skeleton) for document, skeleton in pairs)
    same, names = unrounded(ours, theirs)
    return difference(same, theirs.skeleton), list(rounded_numbers(names))


def _independent(found: Difference, depends: Sequence[Difference]) -> Difference:
    """Return the changes that no stand-in changes on either side."""
    kept: dict[str, Any] = {}
    for field in ("joint_frames", "frames", "zero_poses", "masses"):
        names = {_name(change) for each in depends for change in getattr(each, field)}
        kept[field] = tuple(c for c in getattr(found, field) if _name(c) not in names)
    for field in ("total_mass", "reach"):
        pairs = (getattr(each, field) for each in depends)
        kept[field] = _NOTHING if any(a != b for a, b in pairs) else getattr(found, field)
    return replace(found, **kept)


def _name(change: Moved | MassChange) -> str:
    return change.link if isinstance(change, MassChange) else change.name


def _known(found: Difference, sides: Sequence[Document]) -> tuple[Difference, list[str]]:
    """Return the changes without inertia and totals that cannot be read, and a note on these."""
    old_name = {pair.new: pair.old for pair in found.renamed_links}
    before, after = (unknown_bodies(*side) for side in sides)
    links = [change.link for change in found.masses]
    unknown = {n for n in links if n in after or old_name.get(n, n) in before}
    left_out = [f"the inertia of '{name}'" for name in sorted(unknown)]
    reasons = [reason.plain for reason in (*before.values(), *after.values())]
    weights = [total_mass(*side) for side in sides]
    if not all(weight.is_whole for weight in weights):
        left_out = ["the total mass", *left_out]
        reasons = [weight.plain_reason for weight in weights if not weight.is_whole]
        found = replace(found, total_mass=_NOTHING)
    found = replace(found, masses=tuple(m for m in found.masses if m.link not in unknown))
    return found, [f"{listed(left_out)} left out: {reasons[0]}"] if left_out else []


def _of_one(same: Difference, skeleton: Linkage, change: str) -> Difference:
    """Return the difference from or to nothing, given the robot's difference from itself."""
    weight, reach = same.total_mass[0], same.reach[0]
    names: dict[str, Any] = {
        f"{change}_links": skeleton.link_names,
        f"{change}_joints": skeleton.joint_names,
        f"{change}_frames": tuple(frame.name for frame in skeleton.frames),
        "total_mass": (0.0, weight) if change == "added" else (weight, 0.0),
        "reach": (0.0, reach) if change == "added" else (reach, 0.0),
    }
    return replace(same, **names)
