"""What a link carries: how much it weighs, how many joints it has."""

from typing import NamedTuple
from weakref import WeakKeyDictionary

from kindsl.analysis.analysis import Analysis
from kindsl.features.wording import code
from kindsl.semantics.declarations import Link
from kindsl.semantics.unknown import Unknown, why_unknown


class Subtree(NamedTuple):
    """A link with all that it carries.

    Attributes:
        mass: Of all of it, kilograms, or why it is not known.
        dof: Joints in it, the supporting joint of the link left out.
    """

    mass: float | Unknown
    dof: int


_NO_TREE = Subtree(Unknown("the links below it are no tree"), 0)
_subtrees: "WeakKeyDictionary[Analysis, dict[Link, Subtree]]" = WeakKeyDictionary()


def subtree_of(analysis: Analysis, body: Link) -> Subtree:
    """Return what a body carries, itself included; every body is weighed once an analysis."""
    if analysis not in _subtrees:
        _subtrees[analysis] = _all(analysis)
    return _subtrees[analysis].get(body, _NO_TREE)


def own_mass(analysis: Analysis, body: Link) -> float | Unknown:
    """Return a body's mass in kilograms, or why it is not known."""
    if body.inertia is None or body.inertia.mass is None:
        return Unknown(f"{code(body.name)} has no mass")
    mass = body.inertia.mass.value(analysis.context.values)
    return why_unknown((body.inertia.mass,), analysis.context.values) if mass is None else mass


def _all(analysis: Analysis) -> dict[Link, Subtree]:
    """Return what each body carries, those left out that only loops lead to."""
    tree = analysis.model.tree
    found: dict[Link, Subtree] = {}
    for root in (body for body in analysis.model.bodies if body not in tree.above):
        for link in reversed([root, *tree.in_topological_order(root)]):
            found[link] = _sum(analysis, link, found)
    return found


def _sum(analysis: Analysis, body: Link, known: dict[Link, Subtree]) -> Subtree:
    mass = own_mass(analysis, body)
    dof = 0
    for edge in analysis.model.tree.successor_edges(body):
        if edge.link is None:
            continue
        below = known.get(edge.link, _NO_TREE)
        mass = _added(mass, below.mass)
        dof += 1 + below.dof
    return Subtree(mass, dof)


def _added(a: float | Unknown, b: float | Unknown) -> float | Unknown:
    if isinstance(a, Unknown):
        return a
    return b if isinstance(b, Unknown) else a + b
