"""The way from a model and parameter values to mechanics."""

from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING

from kindsl.dynamics.evaluation.mechanics import Mechanics
from kindsl.mechanism.bodies import bodies_of
from kindsl.mechanism.errors import ModelError, UnboundParameterError
from kindsl.mechanism.numbering import numbered_by_id, require_base
from kindsl.mechanism.skeleton import Skeleton, skeleton_of
from kindsl.mechanism.strict_reading import StrictReader
from kindsl.rigid.body import NO_BODY
from kindsl.semantics.model import Model
from kindsl.text.display import html_of

if TYPE_CHECKING:
    from kindsl.dynamics.evaluation.compiled import CompiledMechanics


class Mechanism(Mechanics):
    """The mechanics of a document."""

    __slots__ = ()

    def __repr__(self) -> str:
        base = "floating" if self.bodies.is_floating else "fixed"
        joints = "1 joint" if self.n_joints == 1 else f"{self.n_joints} joints"
        return f"<kindsl.Mechanism: {base} base '{self.bodies.base_name}', {joints}>"

    def _repr_html_(self) -> str | None:
        """Return what a notebook shows."""
        return html_of(self)

    def compiled(self, threads: int = 1) -> "CompiledMechanics":
        """Return the same mechanics compiled, which takes seconds once; needs a C compiler.

        Args:
            threads: How many threads share the work of large batches.

        Raises:
            kindsl.dynamics.evaluation.compiling.CompileError: There is no compiler, or it fails.
            SingularInertiaError: If nothing resists a motion in any configuration.
        """
        from kindsl.dynamics.evaluation.compiled import CompiledMechanics

        return CompiledMechanics(self.bodies, threads)


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
        skeleton = skeleton_of(model, edges, StrictReader(values))
        return Mechanism(bodies_of(_moving(skeleton)))
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
