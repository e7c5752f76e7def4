"""The way from a model and parameter values to mechanics."""

from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING

from kindsl.language.semantics.model import Model
from kindsl.language.semantics.parameters import JointProperties
from kindsl.language.text.display import html_of
from kindsl.mechanics.dynamics.bodies import Drives
from kindsl.mechanics.dynamics.evaluation.mechanics import Mechanics
from kindsl.robots.mechanism.bodies import bodies_of, drives_of
from kindsl.robots.mechanism.errors import ModelError
from kindsl.robots.mechanism.linkage import Linkage
from kindsl.robots.mechanism.numbering import require_base
from kindsl.robots.mechanism.reading import whole_linkage

if TYPE_CHECKING:
    from kindsl.mechanics.dynamics.evaluation.compiled import CompiledMechanics


class Mechanism(Mechanics):
    """The mechanics of a document.

    Attributes:
        linkage: Its bodies in plain numbers.
    """

    __slots__ = ("linkage",)

    def __init__(self, linkage: Linkage, drives: Drives | None = None) -> None:
        super().__init__(replace(bodies_of(linkage), drives=drives))
        self.linkage = linkage

    def __repr__(self) -> str:
        base = "floating" if self.bodies.is_floating else "fixed"
        joints = "1 joint" if self.n_joints == 1 else f"{self.n_joints} joints"
        return f"<kindsl.Mechanism: {base} base '{self.bodies.base_name}', {joints}>"

    def _repr_html_(self) -> str | None:
        """Return the HTML for a notebook."""
        return html_of(self)

    def compiled(self, threads: int = 1) -> "CompiledMechanics":
        """Return the same mechanics compiled, which takes seconds once; needs a C compiler.

        Args:
            threads: How many threads share the work of large batches.

        Raises:
            kindsl.CompileError: There is no compiler, or it fails; tells what to install.
            SingularInertiaError: If nothing resists a motion in any configuration.
        """
        from kindsl.mechanics.dynamics.evaluation.compiled import CompiledMechanics

        return CompiledMechanics(self.bodies, threads)


def mechanism_of(
    model: Model, values: Mapping[str, float], joints: Mapping[str, JointProperties] | None = None
) -> Mechanism:
    """Return the mechanics of a model: its bodies and joints as arrays.

    Args:
        model: A model without defects in its tree.
        values: Of parameters by name, and of constants by `<name>`.
        joints: What is told of joints besides, by their names: rotors and friction count.

    Raises:
        UnboundParameterError: A parameter has no value; names all of them.
        ModelError: The model is no kinematic tree with regular numbering.
    """
    linkage = whole_linkage(model, values)
    try:
        return Mechanism(linkage, drives_of(linkage.joint_names, joints or {}))
    except ValueError as error:
        raise ModelError(str(error), require_base(model)) from error
