"""From a transforms document to the pairs of frames that code is generated for."""

from collections.abc import Sequence
from dataclasses import replace

from kindsl.language.semantics.model import Model
from kindsl.language.semantics.transforms import LINK_PREFIX, frame_names, unknown_frames
from kindsl.language.syntax.transforms_text import FramePair, read_transforms
from kindsl.language.text.lines import LineIndex
from kindsl.language.text.nearest import hint, nearest_name
from kindsl.mechanics.dynamics.generation.robot import PlacedFrame, Robot
from kindsl.mechanics.dynamics.generation.vectors import EYE
from kindsl.products.codegen.library import GenerationError, Wanted


def wanted_pairs(text: str, model: Model, robot: Robot) -> Wanted:
    """Return the pairs that a transforms document lists, each once.

    Raises:
        GenerationError: The document is broken, or names a frame that the robot has not.
    """
    document = read_transforms(text)
    for wrong in (*document.defects, *unknown_frames(document, model)):
        line, column = LineIndex(text).place(wrong.start)
        raise GenerationError(f"transforms document, {line}:{column}: {wrong.message}")
    base = PlacedFrame(robot.base_name, 0, EYE, [0.0, 0.0, 0.0])
    by_name = {target.name: target for target in (*robot.placed, base)}
    joint_frames = (robot.joint_frame(joint) for joint in robot.tree.links())
    placed = {frame.name: frame for frame in joint_frames}
    # A link may have the name of a joint's frame: its own is `fr_` and its name.
    placed |= {
        name: by_name[there] for name, there in frame_names(model).items() if there in by_name
    }

    def pairs(listed: tuple[FramePair, ...]) -> tuple[tuple[PlacedFrame, PlacedFrame], ...]:
        texts = dict.fromkeys((base.text, target.text) for base, target in listed)
        return tuple(
            (replace(placed[base], name=base), replace(placed[target], name=target))
            for base, target in texts
        )

    return Wanted(pairs(document.transforms), pairs(document.jacobians))


def restricted(robot: Robot, wanted: Wanted, names: Sequence[str]) -> tuple[Robot, Wanted]:
    """Return a robot and pairs of frames with the poses and Jacobians of some frames only.

    Args:
        wanted: Pairs of frames.
        names: Links and frames, a link's own frame also as `fr_` and its name, and frames of pairs.

    Raises:
        GenerationError: The robot has not one of them.
    """
    links = {f"{LINK_PREFIX}{name}": name for name in robot.link_names}
    known = {target.name for target in robot.targets}
    of_pairs = _names(wanted)
    chosen = {name if name in known else links.get(name, name) for name in names}
    for name in without_pairs(wanted, sorted(chosen - known)):
        close = hint(nearest_name(name, [*known, *links, *of_pairs]))
        raise GenerationError(f"--frames: the robot has no frame '{name}'{close}")
    bodies = {robot.base_name, *robot.link_names}
    listed = {*chosen, *(f"{LINK_PREFIX}{name}" for name in chosen & bodies)}
    frames = tuple(target for target in robot.targets if target.name in chosen)
    kept = (
        tuple(p for p in pairs if not listed.isdisjoint((p[0].name, p[1].name))) for pairs in wanted
    )
    return replace(robot, chosen=frames), Wanted(*kept)


def without_pairs(wanted: Wanted, names: Sequence[str]) -> list[str]:
    """Return which of some links and frames no pair has."""
    of_pairs = _names(wanted)
    return [name for name in names if of_pairs.isdisjoint((name, f"{LINK_PREFIX}{name}"))]


def _names(wanted: Wanted) -> set[str]:
    return {frame.name for pairs in wanted for pair in pairs for frame in pair}
