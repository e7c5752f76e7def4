"""Numbers of a complete document, where none may be missing."""

from collections.abc import Mapping
from dataclasses import replace
from typing import NamedTuple

from kindsl.language.semantics.declarations import Frame, Inertia, Joint, Link, Pose, Vector
from kindsl.language.semantics.expressions import ConstantUse, Expression, is_undecided, symbols
from kindsl.language.semantics.model import Model
from kindsl.language.semantics.places import Located
from kindsl.language.syntax.vocabulary import MOMENTS
from kindsl.mechanics.rigid.body import NO_BODY, MassDistribution, seen_from
from kindsl.mechanics.rigid.pose import RigidPose, Vector3, pose_from
from kindsl.robots.mechanism.errors import ModelError, UnboundParameterError, UndecidedValueError
from kindsl.robots.mechanism.numbering import numbered_by_id, require_base
from kindsl.robots.mechanism.skeleton import Skeleton, skeleton_of


def strict_skeleton(model: Model, values: Mapping[str, float]) -> Skeleton:
    """Return the numbered bodies; body index and order are the links' ids.

    A fixed base's mass and inertia do not matter: they are zero here, so that total mass and centre
    of mass are those of what moves.

    Args:
        model: A model without defects in its tree.
        values: Of parameters by name, and of constants by `<name>`.

    Raises:
        UnboundParameterError: A parameter has no value; names all of them.
        ModelError: The model is no kinematic tree with regular numbering.
    """
    edges = numbered_by_id(model)
    try:
        return _moving(skeleton_of(model, edges, StrictReader(values)))
    except UnboundParameterError as error:
        raise UnboundParameterError(_unbound(model, values) or error.names, error.at) from None
    except ModelError:
        raise
    except ValueError as error:
        raise ModelError(str(error), require_base(model)) from error


def _moving(skeleton: Skeleton) -> Skeleton:
    """Return the skeleton with nothing known of a fixed base's mass, which does not matter."""
    if skeleton.is_floating:
        return skeleton
    return replace(skeleton, masses=(NO_BODY, *skeleton.masses[1:]))


def _unbound(model: Model, values: Mapping[str, float]) -> tuple[str, ...]:
    names = (str(parameter.name) for parameter in model.parameters)
    return tuple(name for name in names if name not in values)


class StrictReader(NamedTuple):
    """Reads every number, or says which is missing.

    Attributes:
        values: Of parameters by name, and of constants by `<name>`.

    Its methods raise:
        UnboundParameterError: A value needs a parameter that has none.
        ModelError: A value is missing or not defined.
    """

    values: Mapping[str, float]

    def joint_pose(self, joint: Joint) -> RigidPose:
        """Return a joint's frame in its predecessor's."""
        return self._pose(f"joint '{joint.name}'", joint, joint.pose)

    def frame_pose(self, frame: Frame) -> RigidPose:
        """Return an optional frame in its link's."""
        return self._pose(f"frame '{frame.name}'", frame, frame.pose)

    def body(self, link: Link) -> MassDistribution:
        """Return a link's mass distribution about its frame; nothing where none is given.

        A fixed base's inertia does not matter, so it may hang on unbound parameters.
        """
        if link.inertia is None:
            return NO_BODY
        try:
            return self._given(link, link.inertia)
        except (UnboundParameterError, UndecidedValueError):
            if link.is_base and not link.is_floating:
                return NO_BODY
            raise

    def _given(self, link: Link, inertia: Inertia) -> MassDistribution:
        owner = f"inertia of '{link.name}'"
        mass = self._number(owner, "mass", inertia.mass, inertia)
        com = self._vector(owner, "CoM", inertia.com, inertia)
        ix, iy, iz, ixy, ixz, iyz = (
            self._number(owner, name, inertia.moments.get(name), inertia) for name in MOMENTS
        )
        given = MassDistribution(mass, com, (ix, iy, iz, ixy, ixz, iyz))
        if inertia.frame is None:
            return given
        frame = next((f for f in link.frames if f.name == inertia.frame), None)
        if frame is None:
            raise ModelError(f"'{link.name}' has no frame '{inertia.frame}'", inertia.frame)
        return seen_from(given, self.frame_pose(frame))

    def _pose(self, owner: str, at: Located, pose: Pose) -> RigidPose:
        translation = self._vector(owner, "translation", pose.translation, at)
        return pose_from(translation, self._vector(owner, "rotation", pose.rotation, at))

    def _vector(self, owner: str, what: str, vector: Vector | None, at: Located) -> Vector3:
        if vector is None:
            raise ModelError(f"{owner}: '{what}' is missing", at)
        x, y, z = (self._number(owner, what, component, at) for component in vector.components)
        return x, y, z

    def _number(self, owner: str, what: str, value: Expression | None, at: Located) -> float:
        if value is None:
            raise ModelError(f"{owner}: '{what}' is missing", at)
        number = value.value(self.values)
        if number is not None:
            return number
        unbound = [s.name for s in symbols(value) if not isinstance(s, ConstantUse)]
        missing = [name for name in unbound if name not in self.values]
        if missing:
            raise UnboundParameterError(tuple(str(name) for name in missing), missing[0])
        if is_undecided(value):
            raise UndecidedValueError(owner, what, value.text, value)
        raise ModelError(f"{owner}: '{what}' has no value: {value.text}", value)
