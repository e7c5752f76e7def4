"""The shapes that a URDF gives its links for drawing."""

from collections.abc import Iterator
from typing import Any, Literal, NamedTuple

from kindsl.mechanics.rigid.pose import RigidPose
from kindsl.robots.interchange.format import FormatError
from kindsl.robots.interchange.urdf.checking import checked, numbers_of
from kindsl.robots.interchange.urdf.urdf_reading import pose_of_origin

Form = Literal["mesh", "box", "cylinder", "sphere"]
_SIZES: dict[Form, tuple[tuple[str, int], ...]] = {
    "box": (("size", 3),),
    "cylinder": (("radius", 1), ("length", 1)),
    "sphere": (("radius", 1),),
}


class LinkVisual(NamedTuple):
    """A shape of a link.

    Attributes:
        link: The link's name.
        link_T_visual: Its frame in the link's.
        form: What it is.
        size: Factors of a mesh along its axes; sides of a box, radius and length of a cylinder,
            radius of a sphere, metres.
        file: A mesh's address as written, else empty.
    """

    link: str
    link_T_visual: RigidPose
    form: Form
    size: tuple[float, ...]
    file: str = ""


def visuals_of_urdf(content: bytes | str) -> list[LinkVisual]:
    """Return the visuals of a URDF; one whose numbers are none is left out.

    Raises:
        FormatError: It is no URDF.
    """
    links = checked(content)[0].findall("link")
    visuals = ((link, visual) for link in links for visual in link.findall("visual"))
    return [found for link, visual in visuals for found in _read(str(link.get("name")), visual)]


def _read(link: str, visual: Any) -> Iterator[LinkVisual]:
    try:
        pose = pose_of_origin(visual.find("origin"))
        for shape in visual.findall("geometry/*"):
            if shape.tag == "mesh" and shape.get("filename"):
                yield LinkVisual(link, pose, "mesh", _scale(shape), str(shape.get("filename")))
            elif shape.tag in _SIZES:
                numbers = (numbers_of(shape, *size) for size in _SIZES[shape.tag])
                size = tuple(value for group in numbers for value in group)
                yield LinkVisual(link, pose, shape.tag, size)
    except FormatError:
        return


def _scale(mesh: Any) -> tuple[float, ...]:
    return (1.0, 1.0, 1.0) if mesh.get("scale") is None else tuple(numbers_of(mesh, "scale", 3))
