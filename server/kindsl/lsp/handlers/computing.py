"""`kindsl.compute`: numbers about a robot, as `kindsl compute` gives them."""

from typing import TYPE_CHECKING, Any

from kindsl.lsp.session.view import View
from kindsl.lsp.wire.errors import RequestFailed

if TYPE_CHECKING:
    from kindsl.mechanism.build import Mechanism
    from kindsl.reports.computation import Request

_GRAVITY = [0.0, 0.0, -9.81]
_OURS = ("gravity", "forward", "parameters", "configurations")


def computed(view: View, options: object) -> dict[str, Any]:
    """Return poses, inertia and forces in some configurations.

    Args:
        view: The document.
        options: None for the zero configuration; a configuration (`q`, `qd`, ...); an array of
            them; or an object with `configurations`. An object may also have `gravity` (three
            numbers), `forward` (from forces to accelerations) and `parameters` (by name).

    Raises:
        RequestFailed: The options or the document make no sense; says why.
    """
    try:
        from kindsl.reports.computation import compute

        mechanism = view.analysis.mechanism(parameters=_own(options, "parameters", {}))
        return compute(view.analysis, mechanism, _request(mechanism, options)).as_json()
    except ModuleNotFoundError as error:
        hint = "install it with: pip install 'kindsl[numpy]'"
        raise RequestFailed(f"the computation needs {error.name}; {hint}") from None
    except (ValueError, TypeError) as error:
        raise RequestFailed(str(error)) from None


def _request(mechanism: "Mechanism", options: object) -> "Request":
    from kindsl.reports.computation import Request
    from kindsl.reports.motions import Robot, motions_from

    gravity = _own(options, "gravity", _GRAVITY)
    if not isinstance(gravity, list) or len(gravity) != 3:
        raise ValueError("'gravity' must be three numbers")
    robot = Robot(mechanism.bodies.joint_names, mechanism.bodies.is_floating)
    motions = tuple(motions_from(_configurations(options), robot))
    x, y, z = map(float, gravity)
    return Request(motions, (x, y, z), bool(_own(options, "forward", False)))


def _configurations(options: object) -> object:
    if not isinstance(options, dict):
        return {} if options is None else options
    if "configurations" in options:
        return options["configurations"]
    return {key: value for key, value in options.items() if key not in _OURS}


def _own(options: object, name: str, default: Any) -> Any:
    return options.get(name, default) if isinstance(options, dict) else default
