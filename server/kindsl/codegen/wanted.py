"""From a transforms document to the pairs of frames that code is generated for."""

from kindsl.codegen.library import GenerationError, Wanted
from kindsl.dynamics.generation.robot import PlacedFrame, Robot
from kindsl.dynamics.generation.vectors import EYE
from kindsl.semantics.model import Model
from kindsl.semantics.transforms import frame_names, unknown_frames
from kindsl.syntax.transforms_text import Pair, read_transforms
from kindsl.text.lines import LineIndex


def wanted_pairs(text: str, model: Model, robot: Robot) -> Wanted:
    """Return the pairs that a transforms document lists, each once.

    Raises:
        GenerationError: The document is broken, or names a frame that the robot has not.
    """
    document = read_transforms(text)
    for wrong in (*document.defects, *unknown_frames(document, model)):
        line, column = LineIndex(text).position(wrong.start)
        raise GenerationError(f"--transforms, {line + 1}:{column + 1}: {wrong.message}")
    names = frame_names(model)
    placed = {target.name: target for target in robot.targets}
    placed[robot.base_name] = PlacedFrame(robot.base_name, 0, EYE, [0.0, 0.0, 0.0])

    def pairs(listed: tuple[Pair, ...]) -> tuple[tuple[PlacedFrame, PlacedFrame], ...]:
        texts = dict.fromkeys((base.text, target.text) for base, target in listed)
        return tuple(
            (_named(placed[names[base]], base), _named(placed[names[target]], target))
            for base, target in texts
        )

    return Wanted(pairs(document.transforms), pairs(document.jacobians))


def _named(frame: PlacedFrame, name: str) -> PlacedFrame:
    return PlacedFrame(name, frame.body, frame.R, frame.r)
