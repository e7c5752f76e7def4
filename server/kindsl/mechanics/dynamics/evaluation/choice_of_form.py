"""Chooses the form that answers soonest."""

import math
from collections.abc import Callable
from functools import partial

from kindsl.mechanics.dynamics.bodies import Bodies
from kindsl.mechanics.dynamics.evaluation import readable_form as readable
from kindsl.mechanics.dynamics.evaluation.generated_form import GeneratedForm
from kindsl.mechanics.dynamics.evaluation.path_form import PathForm
from kindsl.mechanics.dynamics.evaluation.request import Request
from kindsl.mechanics.dynamics.quantities import Quantity
from kindsl.mechanics.spatial.arrays import Array

# More links take longer to generate code for than anyone wants to wait.
MOST_LINKS_TO_GENERATE_FOR = 30
# Of longer chains, these quantities' code grows with the number of links only, and so many
# configurations take longer in any other form than code takes to generate.
LINEAR: frozenset[Quantity] = frozenset(
    {"poses", "inverse_dynamics", "gravity_torque", "bias_torque"}
)
WORTH_GENERATING = 3000
# The readable form's time for one configuration is that of so many in the path form.
WORTH_READABLE = 50


class Forms:
    """All forms of one mechanism.

    Attributes:
        generated: The form whose ready functions may be called directly.
    """

    __slots__ = ("_generates_code", "_path", "_readable", "generated")

    def __init__(self, bodies: Bodies, *, generates_code: bool = True) -> None:
        self._generates_code = generates_code
        self.generated = GeneratedForm(bodies)
        self._readable = partial(readable.evaluate, bodies)
        self._path: PathForm | None = None

    def evaluate(self, request: Request) -> Array:
        """Return a quantity's entries in one row per configuration, shape (..., entries).

        Raises:
            SingularInertiaError, ZeroDivisionError, numpy.linalg.LinAlgError: If nothing resists a
                motion; or the result holds values that are not finite.
        """
        return self._chosen(request.quantity, math.prod(request.batch_shape))(request)

    def _chosen(self, quantity: Quantity, size: int) -> Callable[[Request], Array]:
        is_short = self.generated.bodies.n_links <= MOST_LINKS_TO_GENERATE_FOR
        is_worth_it = is_short or (quantity in LINEAR and size >= WORTH_GENERATING)
        if self._generates_code and is_worth_it:
            return self.generated.evaluate
        if size >= WORTH_READABLE and quantity != "joint_space_inertia":
            return self._readable
        if self._path is None:
            self._path = PathForm(self.generated.bodies)
        return self._path.evaluate
