"""The knowledge of a rule besides the document: targets, bindings, ranges."""

from collections.abc import Callable, Iterable, Mapping
from functools import cached_property
from typing import TYPE_CHECKING

from kindsl.language.semantics.model import Model
from kindsl.language.semantics.parameters import Binding, values_of

if TYPE_CHECKING:
    from kindsl.robots.comparison.mechanical import ComparedTwin

ROBCOGEN = "robcogen"
ROBCOGEN2 = "robcogen2"
TARGETS = (ROBCOGEN, ROBCOGEN2)
ZERO_FOR_ROBCOGEN2 = 5e-6

CompareTwins = Callable[[Mapping[str, float]], "Iterable[ComparedTwin]"]


class Context:
    """The surroundings of a check.

    Attributes:
        bindings: Values given to parameters from outside the document, with their ranges.
        values: Value of each bound parameter by name, and of each constant by `<name>`.
    """

    def __init__(
        self,
        targets: frozenset[str],
        bindings: Mapping[str, Binding],
        model: Model,
        twins: CompareTwins = lambda _: (),
        twins_key: object = (),
    ) -> None:
        self.targets = targets
        self.bindings = bindings
        given = {name: binding.value for name, binding in bindings.items()}
        self.values = values_of(model.parameters, model.constants, given)
        # It outlives no model, but models keep it: one that it kept would be freed late.
        self._compare_twins, self._twins_key = twins, twins_key

    @cached_property
    def twins(self) -> "tuple[ComparedTwin, ...]":
        """Other files of the same robot, compared with the document."""
        return tuple(self._compare_twins(self.values))

    @cached_property
    def key(self) -> tuple[object, ...]:
        """The dependencies of a result that uses values."""
        return (
            self.targets,
            tuple(sorted(self.values.items())),
            tuple(sorted(self.bindings.items())),
            self._twins_key,
        )
