"""From a model to a linkage, with one way to read its numbers and two to take those that lack.

A document that is whole is read strictly: the first number that is missing is said. One that is not
is read as far as it is known: what is missing is zero, what is lost is left out.
"""

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from math import isfinite
from types import MappingProxyType
from typing import NamedTuple, NoReturn

from kindsl.language.semantics.declarations import Frame, Inertia, Joint, Link, Pose, Vector
from kindsl.language.semantics.expressions import ConstantUse, Expression, is_undecided, symbols
from kindsl.language.semantics.kinematic_tree import Edge
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.numbers import written_pose
from kindsl.language.semantics.places import Located
from kindsl.language.semantics.unknown import Unknown
from kindsl.language.syntax.vocabulary import MOMENTS
from kindsl.mechanics.rigid.body import MassDistribution
from kindsl.mechanics.rigid.pose import RigidPose, Vector3, pose_from
from kindsl.robots.mechanism.errors import ModelError, UnboundParameterError, UndecidedValueError
from kindsl.robots.mechanism.link_inertia import link_inertia, written_inertia
from kindsl.robots.mechanism.linkage import BodyPart, Linkage, RigidBody, checked
from kindsl.robots.mechanism.numbering import numbered_by_id, numbered_by_tree, require_base

# Nothing is known of earlier versions.
NOTHING: Mapping[str, RigidPose] = MappingProxyType({})


def whole_linkage(model: Model, values: Mapping[str, float]) -> Linkage:
    """Return the bodies of a complete document in the order of the links' ids.

    Nothing is known of a fixed base's mass, so that total mass and centre of mass are those of what
    moves.

    Args:
        model: A model without defects in its tree.
        values: Of parameters by name, and of constants by `<name>`.

    Raises:
        UnboundParameterError: A parameter has no value; names all of them.
        ModelError: The model is no kinematic tree with regular numbering.
    """
    edges = numbered_by_id(model)
    try:
        return _built(model, edges, _Strict(values)).without_mass_at_rest()
    except UnboundParameterError as error:
        names = (str(parameter.name) for parameter in model.parameters)
        unbound = tuple(name for name in names if name not in values)
        raise UnboundParameterError(unbound or error.names, error.at) from None


def reachable_linkage(model: Model, values: Mapping[str, float]) -> Linkage:
    """Return the bodies that the base carries, parents first, whatever the ids.

    Args:
        values: Of parameters by name, and of constants by `<name>`.

    Raises:
        UnboundParameterError: A parameter has no value.
        ModelError: There is no base, a value is missing, or a name stands for two things.
    """
    return _built(model, numbered_by_tree(model), _Strict(values))


def partial_linkage(
    model: Model, values: Mapping[str, float], earlier: Mapping[str, RigidPose] = NOTHING
) -> Linkage | None:
    """Return the bodies that the base carries as far as known, None if there is no tree of them.

    Args:
        model: A document's model, however broken.
        values: Of parameters by name, and of constants by `<name>`.
        earlier: Where joints were, by name: it stands for a pose that is not whole.
    """
    try:
        return _built(model, numbered_by_tree(model), _Lenient(values, earlier))
    except ModelError:
        return None


def named_frames(bodies: Collection[Link]) -> Iterator[tuple[str, Link, Frame]]:
    """Yield the optional frames of bodies by the names under which they are drawn.

    One whose name is taken is called `link.frame`; one without a name is left out.
    """
    taken = {str(body.name) for body in bodies}
    for body in bodies:
        for frame in body.frames:
            name = str(frame.name) if frame.name not in taken else f"{body.name}.{frame.name}"
            if name and name not in taken:
                taken.add(name)
                yield name, body, frame


def _built(model: Model, edges: Sequence[Edge], reader: "_Lenient | _Strict") -> Linkage:
    """Return the numbered bodies.

    Args:
        edges: The supporting edge of each link, in the order of the bodies 1 to n.
        reader: Makes numbers of what is written.
    """
    base = require_base(model)
    index = {base: 0} | {edge.link: i for i, edge in enumerate(edges, 1) if edge.link is not None}
    parts = {link: [BodyPart(str(link.name), mass=reader.mass(link))] for link in index}
    for name, body, frame in named_frames(index):
        parts[body].append(BodyPart(name, reader.pose(frame), is_link=False))
    bodies = [RigidBody(tuple(parts[base]))]
    for edge in edges:
        link, joint = edge.link, edge.joint
        if link is not None and joint is not None:
            where = index[edge.predecessor], str(joint.name), joint.kind, reader.pose(joint)
            bodies.append(RigidBody(tuple(parts[link]), *where))
    try:
        return checked(Linkage(tuple(bodies), base.is_floating, model.name))
    except ValueError as error:
        raise ModelError(str(error), base) from error


class _Lenient(NamedTuple):
    """Reads the numbers that exist; one that is missing or infinite is zero."""

    values: Mapping[str, float]
    earlier: Mapping[str, RigidPose]

    def pose(self, thing: Joint | Frame) -> RigidPose:
        known = written_pose(thing.pose, self.values)
        if known is None and isinstance(thing, Joint):
            known = self.earlier.get(thing.name)
        return known or pose_from(*map(self._vector, thing.pose))

    def mass(self, link: Link) -> MassDistribution | None:
        known = link_inertia(link, self.values)
        return None if isinstance(known, Unknown) else known

    def _vector(self, vector: Vector | None) -> Vector3:
        if vector is None:
            return 0.0, 0.0, 0.0
        numbers = (component.value(self.values) or 0.0 for component in vector.components)
        x, y, z = (number if isfinite(number) else 0.0 for number in numbers)
        return x, y, z


class _Strict(NamedTuple):
    """Reads every number; raises an error that names the first one missing."""

    values: Mapping[str, float]

    def pose(self, thing: Joint | Frame) -> RigidPose:
        known = written_pose(thing.pose, self.values)
        if known is None:
            owner = f"{'joint' if isinstance(thing, Joint) else 'frame'} '{thing.name}'"
            raise self._refusal(owner, f"pose of {owner}", thing, _pose_numbers(thing.pose))
        return known

    def mass(self, link: Link) -> MassDistribution | None:
        """Return a link's mass distribution; a fixed base's may hang on unbound parameters."""
        known, inertia = link_inertia(link, self.values), link.inertia
        if not isinstance(known, Unknown):
            return known
        if inertia is None:
            return None
        try:
            self._refuse(link, inertia)
        except (UnboundParameterError, UndecidedValueError):
            if link.is_base and not link.is_floating:
                return None
            raise

    def _refuse(self, link: Link, inertia: Inertia) -> NoReturn:
        if not isinstance(written_inertia(inertia, self.values), Unknown):
            frame = next((f for f in link.frames if f.name == inertia.frame), None)
            if frame is None:
                raise ModelError(f"'{link.name}' has no frame '{inertia.frame}'", inertia.frame)
            self.pose(frame)
        owner = f"inertia of '{link.name}'"
        raise self._refusal(owner, owner, inertia, _inertia_numbers(inertia))

    def _refusal(
        self,
        owner: str,
        quantity: str,
        at: Located,
        numbers: Iterable[tuple[str, Expression | None]],
    ) -> ModelError:
        """Return the error of the first number that is missing."""
        for what, value in numbers:
            if value is None:
                return ModelError(f"{owner}: '{what}' is missing", at)
            if value.value(self.values) is None:
                return self._undefined(owner, what, value)
        return ModelError(f"{quantity} holds a value that is not finite", at)

    def _undefined(self, owner: str, what: str, value: Expression) -> ModelError:
        used = [s.name for s in symbols(value) if not isinstance(s, ConstantUse)]
        missing = [name for name in used if name not in self.values]
        if missing:
            return UnboundParameterError(tuple(str(name) for name in missing), missing[0])
        if is_undecided(value):
            return UndecidedValueError(owner, what, value.text, value)
        return ModelError(f"{owner}: '{what}' has no value: {value.text}", value)


def _pose_numbers(pose: Pose) -> Iterator[tuple[str, Expression | None]]:
    yield from _vector_numbers("translation", pose.translation)
    yield from _vector_numbers("rotation", pose.rotation)


def _inertia_numbers(inertia: Inertia) -> Iterator[tuple[str, Expression | None]]:
    yield "mass", inertia.mass
    yield from _vector_numbers("CoM", inertia.com)
    for name in MOMENTS:
        yield name, inertia.moments.get(name)


def _vector_numbers(what: str, vector: Vector | None) -> Iterator[tuple[str, Expression | None]]:
    for component in (None,) if vector is None else vector.components:
        yield what, component
