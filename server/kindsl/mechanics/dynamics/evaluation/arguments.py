"""Checks what callers pass in."""

from collections.abc import Iterable, Mapping, Sequence
from difflib import get_close_matches
from types import MappingProxyType

import numpy as np
import numpy.typing as npt

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.dynamics.quantities import STANDARD_GRAVITY
from kindsl.mechanics.spatial.arrays import Array, real_array
from kindsl.mechanics.spatial.transforms import homogeneous

# Values of all joints in their order, or of some by their names.
JointVector = npt.ArrayLike | Mapping[str, npt.ArrayLike]
NOTHING: Mapping[str, None] = MappingProxyType({})


def vectors(quantity: str, values: npt.ArrayLike, components: int) -> Array:
    """Return values as an array whose last dimension has that many components.

    Raises:
        ValueError: If they are not real, finite numbers, or of another length.
    """
    return real_array(quantity, values, (components,))


def joint_vector(quantity: str, values: JointVector, joints: Sequence[str]) -> Array:
    """Return values of joints as an array (..., n); those that a mapping lacks are zero.

    Raises:
        ValueError: A name is no joint's; besides, what `vectors` raises.
    """
    if not isinstance(values, Mapping):
        return vectors(quantity, values, len(joints))
    for name in values:
        if name not in joints:
            raise unknown_name("joint", name, joints)
    try:
        each = np.broadcast_arrays(*(np.asarray(values.get(name, 0.0)) for name in joints))
    except ValueError:
        raise ValueError(f"values in '{quantity}' have batch shapes that do not fit") from None
    return vectors(quantity, np.stack(each, axis=-1), len(joints))


def checked(
    bodies: Bodies,
    joints: Mapping[str, JointVector],
    base: Mapping[str, npt.ArrayLike | None] = NOTHING,
    gravity: npt.ArrayLike = STANDARD_GRAVITY,
    external_forces: npt.ArrayLike | None = None,
) -> dict[str, Array]:
    """Return what is given, by names: all joint vectors, and of the rest what is not standard.

    Args:
        joints: Joint vectors (..., n) by their names.
        base: The base's velocity and acceleration (..., 6) by their names, None for rest.
        gravity: Shape (..., 3).
        external_forces: All bodies' wrenches (..., n + 1, 6), returned in rows (..., 6 (n + 1)).

    Raises:
        ValueError: If a fixed base is given a motion, or an array is not right.
    """
    arrays = {name: joint_vector(name, x, bodies.joint_names) for name, x in joints.items()}
    for name, values in base.items():
        if values is not None:
            if not bodies.is_floating:
                raise ValueError(f"'{name}' is given, but the base is fixed")
            arrays[name] = vectors(name, values, 6)
    if gravity is not STANDARD_GRAVITY:
        arrays["gravity"] = vectors("gravity", gravity, 3)
    if external_forces is not None:
        wrenches, n = vectors("external_forces", external_forces, 6), bodies.n_links + 1
        if wrenches.ndim < 2 or wrenches.shape[-2] != n:
            raise ValueError(
                f"'external_forces' has shape {wrenches.shape}, expected (..., {n}, 6)"
            )
        arrays["external_forces"] = wrenches.reshape((*wrenches.shape[:-2], 6 * n))
    return arrays


def common_batch_shape(arrays: dict[str, Array]) -> tuple[int, ...]:
    """Return what the leading dimensions of named arrays broadcast to.

    Raises:
        ValueError: If they do not.
    """
    shape, *others = {array.shape[:-1] for array in arrays.values()}
    try:
        return np.broadcast_shapes(shape, *others) if others else shape
    except ValueError:
        listed = ", ".join(f"'{name}' {array.shape}" for name, array in arrays.items())
        raise ValueError(f"the batch dimensions cannot be broadcast: {listed}") from None


def placed_frame(bodies: Bodies, name: str) -> tuple[int, Array]:
    """Return the body that carries a link or frame, and its pose (4, 4) in that body.

    Raises:
        ValueError: If there is no such link or frame.
    """
    for frame in bodies.frames:
        if frame.name == name:
            return frame.body, homogeneous(frame.body_R_frame, frame.body_r_frame)
    names = (bodies.base_name, *bodies.link_names)
    if name not in names:
        raise unknown_name("link or frame", name, (*(f.name for f in bodies.frames), *names))
    return names.index(name), np.eye(4)


def check_mass(bodies: Bodies) -> None:
    """Check that there is a centre of mass.

    Raises:
        ValueError: If the total mass is zero.
    """
    if float(np.sum(bodies.masses)) == 0.0:
        raise ValueError("the centre of mass is not defined: the total mass is zero")


def unknown_name(kind: str, name: str, known: Iterable[str]) -> ValueError:
    """Return the error for a name that is not there, with the nearest one that is."""
    near = get_close_matches(name, known, n=1)
    hint = f", did you mean '{near[0]}'?" if near else ""
    return ValueError(f"there is no {kind} '{name}'{hint}")
