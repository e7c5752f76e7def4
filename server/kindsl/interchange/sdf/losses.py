"""What an SDF says beyond poses and masses: told, one sentence each."""

from collections.abc import Iterator
from typing import Any

from kindsl.interchange.format import limits_dropped
from kindsl.interchange.sdf.elements import name_of
from kindsl.text.words import counted

_ELSEWHERE = (
    ("plugin", "plugin"),
    ("sensor", "sensor"),
    ("light", "light"),
    ("gripper", "gripper"),
    ("particle_emitter", "particle emitter"),
)


def losses(model: Any) -> Iterator[str]:
    """Yield what is dropped."""
    links, joints = model.findall("link"), model.findall("joint")
    drawn = sum(
        link.find("visual") is not None or link.find("collision") is not None for link in links
    )
    if drawn:
        yield f"visuals and collisions of {counted(drawn, 'link')} dropped"
    if n_limited := sum(joint.find("axis/limit") is not None for joint in joints):
        yield limits_dropped(n_limited)
    if n_damped := sum(joint.find("axis/dynamics") is not None for joint in joints):
        damped = counted(n_damped, "joint")
        yield f"damping, friction and springs of {damped} dropped: not supported"
    for joint in joints:
        mimic = joint.find("axis/mimic")
        if mimic is not None:
            other = mimic.get("joint") or "?"
            yield f"the joint '{name_of(joint)}' mimics '{other}': it is now independent"
    for tag, noun in _ELSEWHERE:
        if n := sum(1 for _ in model.iter(tag)):
            yield f"{counted(n, noun)} dropped: not supported"
