"""Poses of links, joints and frames of an SDF model: a graph of relative poses."""

import re
from typing import Any

from kindsl.language.text.nearest import hint, nearest_name
from kindsl.mechanics.rigid.pose import IDENTITY, RigidPose
from kindsl.robots.interchange.sdf.elements import SdfError, defect, name_of, pose_of, text_of

MODEL = "__model__"
WORLD = "world"
_SAME_NAME = {"link": "KD102", "joint": "KD103", "frame": "KD104"}
_CIRCLE = "KD527"
_BEFORE_1_5 = re.compile(r"1\.0*[0-4]")


class FrameGraph:
    """The named frames of a model, all in the model's frame.

    Attributes:
        has_axes_in_model: Whether the version has axes of joints in the model's frame.
        world_T_model: The model's frame in the world.

    Raises:
        FormatError: On construction, if a name stands for two things; when asked, if a frame is
            relative to what there is not, or to itself.
    """

    def __init__(self, model: Any, version: str) -> None:
        self.has_axes_in_model = _BEFORE_1_5.fullmatch(version) is not None
        self._elements: dict[str, Any] = {}
        for element in model.iterfind("*"):
            if element.tag in ("link", "joint", "frame"):
                name = name_of(element)
                if name in self._elements:
                    line = self._elements[name].sourceline
                    what = f"has the name of an element in line {line}"
                    raise defect(element, what, _SAME_NAME[element.tag])
                self._elements[name] = element
        first = model.find("link")
        self._canonical = model.get("canonical_link") or (
            name_of(first) if first is not None else ""
        )
        self.world_T_model = IDENTITY
        self.world_T_model = self._placed(model)

    def world_T(self, name: str, asking: Any) -> RigidPose:
        """Return the pose of a frame in the world's."""
        return self.world_T_model.then(self.model_T(name, asking))

    def model_T(self, name: str, asking: Any) -> RigidPose:
        """Return the pose of a frame in the model's."""
        T = IDENTITY
        seen: list[str] = []
        while name not in (MODEL, WORLD):
            if name in seen:
                raise self._circle(seen[seen.index(name) :])
            seen.append(name)
            asking = element = self._element(name, asking, "KD107")
            T = pose_of(element).then(T)
            name = reference_of(element)
        return T if name == MODEL else self.world_T_model.inverse().then(T)

    def link_of(self, name: str, asking: Any) -> str:
        """Return the link, or the world, that a frame is attached to."""
        seen: set[str] = set()
        while name != WORLD:
            if name in seen:
                raise defect(asking, f"is attached to itself through '{name}'", _CIRCLE)
            seen.add(name)
            if name == MODEL:
                return self._canonical
            element = self._element(name, asking, "KD105")
            if element.tag == "link":
                return name
            is_joint = element.tag == "joint"
            name = text_of(element, "child") if is_joint else element.get("attached_to") or MODEL
        return WORLD

    def placing(self, joint: Any) -> Any:
        """Return the element whose pose says where a joint is: its own, else that it is given in.

        Of a joint without a pose of its own that is the child's, or what the child is given in.
        """
        element = joint
        while pose_of(element) == IDENTITY:
            name = reference_of(element)
            if name in (MODEL, WORLD):
                return joint
            element = self._element(name, joint, "KD107")
            if element is joint:
                break
        return element

    def _placed(self, model: Any) -> RigidPose:
        """Return where a model is, which its pose says of one of its frames, itself or another."""
        pose = model.find("pose")
        reference = "" if pose is None else pose.get("relative_to") or ""
        if reference not in ("", WORLD):
            raise defect(pose, f"is relative to '{reference}' of the world, which is not supported")
        named = model.get("placement_frame") or MODEL
        return pose_of(model).then(self.model_T(named, model).inverse())

    def _circle(self, names: list[str]) -> SdfError:
        """Return the error for poses that are relative to each other, told of the same one."""
        first = names.index(min(names))
        way = [*names[first:], *names[:first], names[first]]
        what = f"has a pose that is relative to itself: {' -> '.join(way)}"
        return defect(self._elements[way[0]], what, _CIRCLE)

    def _element(self, name: str, asking: Any, code: str) -> Any:
        if name not in self._elements:
            meant = nearest_name(name, self._elements)
            error = defect(asking, f"names '{name}', which does not exist{hint(meant)}", code)
            error.missing, error.is_misspelt = name, meant is not None
            raise error
        return self._elements[name]


def reference_of(element: Any) -> str:
    """Return what an element's pose is relative to."""
    pose = element.find("pose")
    if pose is not None and pose.get("relative_to"):
        return str(pose.get("relative_to"))
    if element.tag == "joint":
        return text_of(element, "child")
    return str(element.get("attached_to") or MODEL) if element.tag == "frame" else MODEL
