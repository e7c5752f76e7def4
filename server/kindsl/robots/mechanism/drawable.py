"""The drawable part of a document: its skeleton, whatever the ids."""

from collections.abc import Mapping

from kindsl.language.semantics.model import Model
from kindsl.robots.mechanism.errors import ModelError
from kindsl.robots.mechanism.numbering import numbered_by_tree, require_base
from kindsl.robots.mechanism.skeleton import Skeleton, skeleton_of
from kindsl.robots.mechanism.strict_reading import StrictReader


def drawable_skeleton(model: Model, values: Mapping[str, float]) -> Skeleton:
    """Return the bodies that the base carries, numbered parents first.

    Args:
        model: A document's model.
        values: Of parameters by name, and of constants by `<name>`.

    Raises:
        UnboundParameterError: A parameter has no value.
        ModelError: There is no base, a value is missing, or a name stands for two things.
    """
    try:
        return skeleton_of(model, numbered_by_tree(model), StrictReader(values))
    except ValueError as error:
        raise (
            error if isinstance(error, ModelError) else ModelError(str(error), require_base(model))
        ) from error
