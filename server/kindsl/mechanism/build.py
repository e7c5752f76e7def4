"""The way from a model and parameter values to mechanics."""

from collections.abc import Mapping
from dataclasses import replace

from kindsl.dynamics.bodies import Bodies
from kindsl.dynamics.evaluation.mechanics import Mechanics
from kindsl.mechanism.bodies import bodies_of
from kindsl.mechanism.errors import UnboundParameterError
from kindsl.mechanism.numbering import numbered_by_id, numbered_by_tree
from kindsl.semantics.model import Model

Mechanism = Mechanics


def mechanism_of(model: Model, values: Mapping[str, float]) -> Mechanism:
    """Return the mechanics of a model; body index and order are the links' ids.

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
        return Mechanism(_moving(bodies_of(model, edges, values)))
    except UnboundParameterError as error:
        raise UnboundParameterError(_unbound(model, values) or error.names, error.at) from None


def drawable_bodies(model: Model, values: Mapping[str, float]) -> Bodies:
    """Return the bodies that the base carries, numbered parents first, whatever their ids.

    Raises:
        UnboundParameterError: A parameter has no value.
        ModelError: There is no base, or a value is missing.
    """
    return bodies_of(model, numbered_by_tree(model), values)


def _moving(bodies: Bodies) -> Bodies:
    """Return the bodies with nothing known of a fixed base's mass, which does not matter."""
    if bodies.is_floating:
        return bodies
    masses, coms, inertias = (x.copy() for x in (bodies.masses, bodies.coms, bodies.inertias))
    masses[0] = coms[0] = inertias[0] = 0.0
    return replace(bodies, masses=masses, coms=coms, inertias=inertias)


def _unbound(model: Model, values: Mapping[str, float]) -> tuple[str, ...]:
    names = (str(parameter.name) for parameter in model.parameters)
    return tuple(name for name in names if name not in values)
