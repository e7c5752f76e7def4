"""Parts of an SDF beyond poses and masses: a note on each."""

from collections.abc import Iterator
from typing import Any

from kindsl.language.text.phrases import counted
from kindsl.mechanics.dynamics.quantities import STANDARD_GRAVITY
from kindsl.robots.interchange.format import drawings_dropped, gravity_dropped, mimic_dropped
from kindsl.robots.interchange.sdf.elements import is_true, name_of, numbers_in

_ELSEWHERE = (
    ("plugin", "plugin"),
    ("sensor", "sensor"),
    ("light", "light"),
    ("gripper", "gripper"),
    ("particle_emitter", "particle emitter"),
)


def world_losses(root: Any) -> Iterator[str]:
    """Yield what is dropped of a world: its gravity, where it is another, and what it includes."""
    if n := len(root.findall("world/include")):
        yield f"{counted(n, 'included model')} dropped: not read"
    gravity = root.find("world/gravity")
    if gravity is not None:
        numbers = tuple(numbers_in(gravity, 3))
        if numbers != STANDARD_GRAVITY:
            yield gravity_dropped(numbers)


def losses(model: Any) -> Iterator[str]:
    """Yield what is dropped."""
    links, joints = model.findall("link"), model.findall("joint")
    yield from drawings_dropped(model)
    if n := len(model.findall("joint/axis/dynamics[spring_stiffness]")):
        yield f"springs of {counted(n, 'joint')} dropped: not supported"
    if is_true(model, "static") and any(joint.get("type") != "fixed" for joint in joints):
        yield "the model is static: its joints can move here"
    if n := sum(
        (link.findtext("gravity") or "").strip().lower() in ("0", "false") for link in links
    ):
        yield f"gravity, which {counted(n, 'link')} did without, acts on all links"
    if n := len(model.findall("link/inertial[fluid_added_mass]")):
        yield f"added mass of the fluid around {counted(n, 'link')} dropped: not supported"
    for joint in joints:
        for mimic in joint.findall("axis/mimic")[:1]:
            yield mimic_dropped(name_of(joint), mimic.get("joint") or "?")
    for tag, noun in _ELSEWHERE:
        if n := sum(1 for _ in model.iter(tag)):
            yield f"{counted(n, noun)} dropped: not supported"
