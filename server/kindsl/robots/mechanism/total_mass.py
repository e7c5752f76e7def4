"""The mass of a robot, whether it is complete, and what is missing from it."""

from collections.abc import Iterator
from math import isfinite
from typing import NamedTuple

from kindsl.language.semantics.declarations import Link
from kindsl.language.semantics.expressions import Values, is_undecided, symbols
from kindsl.language.semantics.kinematic_tree import Edge
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.unknown import Unknown, why_unknown
from kindsl.robots.mechanism.link_inertia import link_inertia

UNKNOWN = "unknown"


class Weight(NamedTuple):
    """The mass of some bodies, as far as it is known.

    Attributes:
        known: The sum of the masses that can be read, kg.
        n_missing: How many cannot.
        reason: Why the first of these cannot.
    """

    known: float
    n_missing: int = 0
    reason: Unknown = Unknown("")

    @property
    def is_whole(self) -> bool:
        """True if the sum is the mass of all."""
        return not self.n_missing

    @property
    def reason_text(self) -> str:
        """The missing parts in Markdown, empty if complete."""
        if self.n_missing < 2:
            return self.reason.reason
        return f"{self.reason.reason}; {self.n_missing - 1} more missing"

    @property
    def plain_reason(self) -> str:
        """The missing parts in plain text, empty if complete."""
        return Unknown(self.reason_text).plain

    def in_words(self, known: str) -> str:
        """Return the words for a total whose known part reads `known`: never like the whole."""
        if self.is_whole:
            return known
        return f"at least {known}" if self.known > 0.0 else UNKNOWN

    def explained(self, known: str) -> str:
        """Return the same with what is missing behind it, in plain text."""
        words = self.in_words(known)
        return words if self.is_whole else f"{words} ({self.plain_reason})"


NO_MASS = Weight(0.0)


def total_mass(model: Model, values: Values) -> Weight:
    """Return the mass of all that moves: of a fixed base nothing, unless it is all there is.

    Args:
        model: A document's model, whole or broken.
        values: Of parameters by name, and of constants by `<name>`.
    """
    total = NO_MASS
    for _, weight in _parts(model, values):
        total = added(total, weight)
    return total


def missing_masses(model: Model, values: Values) -> list[tuple[str, Unknown]]:
    """Return the bodies by name whose masses `total_mass` lacks, and why."""
    parts = _parts(model, values)
    return [(name, weight.reason) for name, weight in parts if not weight.is_whole]


def unknown_bodies(model: Model, values: Values) -> dict[str, Unknown]:
    """Return the moving bodies by name whose mass, CoM or moments are not known, and why."""
    found: dict[str, Unknown] = {}
    for body in model.bodies:
        inertia = link_inertia(body, values)
        if isinstance(inertia, Unknown) and (body.is_floating or not body.is_base):
            found[str(body.name)] = inertia
    return found


def _parts(model: Model, values: Values) -> Iterator[tuple[str, Weight]]:
    """Yield what each body adds, and what is named but not there."""
    if model.base is None:
        yield "", Weight(0.0, 1, Unknown("there is no base"))
    weight = body_mass if model.links or model.tree.edges else _whole_mass
    for body in model.bodies:
        yield str(body.name), weight(body, values)
    for edge in model.tree.edges:
        yield str(edge.child.link), edge_mass(edge)


def body_mass(body: Link, values: Values) -> Weight:
    """Return what a body adds to a total: a fixed base nothing, a negative mass a gap."""
    return NO_MASS if body.is_base and not body.is_floating else _whole_mass(body, values)


def _whole_mass(body: Link, values: Values) -> Weight:
    known = link_inertia(body, values)
    mass = own_mass(body, values) if isinstance(known, Unknown) else known.mass
    if isinstance(mass, Unknown):
        return Weight(0.0, 1, mass)
    if mass < 0.0:
        return Weight(0.0, 1, Unknown(f"mass of `{body.name}` is negative"))
    return Weight(mass)


def fixed_base_mass(model: Model, values: Values) -> float:
    """Return the mass that is written for a fixed base, which moves nothing; kg, zero if none."""
    base = model.base
    mass = 0.0 if base is None or base.is_floating else own_mass(base, values)
    return 0.0 if isinstance(mass, Unknown) else mass


def edge_mass(edge: Edge) -> Weight:
    """Return the missing mass of children that no block defines."""
    if edge.link is not None:
        return NO_MASS
    link, joint = edge.child
    reason = f"there is no link `{link}`" if link else f"joint `{joint}` has no link"
    return Weight(0.0, 1, Unknown(reason))


def added(a: Weight, b: Weight) -> Weight:
    """Return the mass of both."""
    reason = b.reason if a.is_whole else a.reason
    return Weight(a.known + b.known, a.n_missing + b.n_missing, reason)


def own_mass(body: Link, values: Values) -> float | Unknown:
    """Return the mass that is written for a body, kg, or why it is not known."""
    written = body.inertia.mass if body.inertia is not None else None
    if written is None or not written.text:
        return Unknown(f"{'base' if body.is_base else 'link'} `{body.name}` has no mass")
    mass = written.value(values)
    if mass is not None and isfinite(mass):
        return mass
    if is_undecided(written) or any(True for _ in symbols(written)):
        return why_unknown((written,), values)
    return Unknown(f"mass of `{body.name}` is not a number")
