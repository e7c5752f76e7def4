"""An SDF as a document that is judged where it stands.

The links, joints and frames of a model, and of the models in it, are its islands; names of inner
models stand before theirs. Poses are relative to frames that may be anywhere, so that what a joint
connects is known of the whole document only.
"""

from collections.abc import Iterator, Mapping, Sequence
from functools import partial
from typing import Any

from kindsl.language.semantics.declarations import FixedAxes, Inertia, Joint, Pose, Vector
from kindsl.language.semantics.expressions import Expression
from kindsl.language.semantics.places import Place
from kindsl.language.syntax.document import SyntaxDocument
from kindsl.language.syntax.vocabulary import MOMENTS
from kindsl.language.text.nearest import hint, nearest_word
from kindsl.mechanics.rigid.pose import IDENTITY
from kindsl.robots.interchange.format import FormatError
from kindsl.robots.interchange.robot_island import RobotIsland
from kindsl.robots.interchange.sdf.elements import (
    SdfError,
    defect,
    is_true,
    name_of,
    pose_of,
    text_of,
)
from kindsl.robots.interchange.sdf.frame_graph import WORLD, FrameGraph
from kindsl.robots.interchange.sdf.joint_properties import joint_properties
from kindsl.robots.interchange.sdf.nesting import NAMED, flatten
from kindsl.robots.interchange.sdf.sdf_reading import carried, mass_of
from kindsl.robots.interchange.xml_document import (
    Connection,
    Flaw,
    XmlDocument,
    pieces_around,
    xml_document,
)
from kindsl.robots.interchange.xml_reading import JOINT_KINDS, TENSOR, XmlElement, parsed_xml

_DEFAULT = "1.0"
_TYPES = (*JOINT_KINDS, "ball", "gearbox", "revolute2", "screw", "universal")


class SdfIsland(RobotIsland):
    """A link, joint or frame of an SDF, or what is around them."""

    __slots__ = ()

    has_attributes, limit = False, "axis/limit"

    def inertia_in(self, inertial: XmlElement, owner: str) -> Inertia | None:
        """Return an inertia, None where the simulator computes it."""
        if (inertial.get("auto") or "").lower() in ("1", "true"):
            return None
        tensor = inertial.find("inertia")
        moments: dict[str, Expression] = {}
        for name, theirs in zip(MOMENTS, TENSOR, strict=True):
            is_product = theirs[1] != theirs[2]
            found = self._number_in(inertial, tensor, theirs, -1 if is_product else 1)
            if found is not None:
                moments[name] = found
        mass = self._number_in(inertial, inertial, "mass", 1)
        return self.inertia_of(inertial, owner, mass, moments)

    def axis(self) -> list[Expression]:
        """Return the numbers of a joint's axis, none if they are not written in its own frame."""
        told = self.element.find("axis") if self.element is not None else None
        is_of_model = told is not None and told.find("use_parent_model_frame") is not None
        xyz = None if told is None or is_of_model else told.find("xyz")
        return [] if xyz is None or xyz.get("expressed_in") else self.numbers_within(xyz)

    def _number_in(self, at: Any, parent: Any, tag: str, sign: int) -> Expression | None:
        """Return the number of a child; SDFormat's default is 1, and 0 of a product."""
        child = None if parent is None else parent.find(tag)
        if child is not None:
            found = self.numbers_within(child, sign)
            return found[0] if len(found) == 1 else None
        if sign < 0:
            return self.zeros(at, 1)[0]
        return self.constants(at, (_DEFAULT,))[0]

    def pose_in(self, parent: Any) -> Pose:
        """Return the pose that an element gives in its `<pose>`, whatever that is relative to."""
        pose = parent.find("pose")
        at = parent if pose is None else pose
        found = [] if pose is None else self.numbers_within(pose)
        try:
            read = pose_of(parent)
        except FormatError:
            read, found = IDENTITY, []
        if len(found) != 6 or "degrees" in at.attrib:
            return self.turned_pose(at, found[:3] if len(found) >= 6 else [], read.rotation)
        x, y, z, rx, ry, rz = found
        node = self.block("vector", at)
        return Pose(Vector(node, self, (x, y, z)), FixedAxes(node, self, (rx, ry, rz)))


def _of_elements(text: str, root: Any, former: SyntaxDocument | None) -> XmlDocument:
    own = (each for model, prefix in _models(root) for each in _elements(model, prefix))
    islands = SdfIsland.made_of(pieces_around(text, own), former)
    document = XmlDocument(islands, former)
    flaws: list[Flaw] = []
    if root.tag != "sdf":
        at = Place(islands[0], root.offset, root.offset + len(root.tag) + 1)
        message = f"not an SDF: its root element is <{root.tag}>, not <sdf>"
        flaws.append(Flaw("KD001", message, at))
    joints = {str(j.name): j for island in islands for j in island.declared().joints}
    connections: list[Connection] = []
    wrong: dict[tuple[int, str], SdfError] = {}
    # What is in inner models moves into the outer one, which the islands must not see.
    for model, prefix in _models(parsed_xml(text)):
        included = list(model.iter("include"))
        is_merged = any(each.get("merge") for each in included)
        for found in _connections(model, prefix, joints, root.get("version") or ""):
            if isinstance(found, SdfError):
                # What is in an included model is not known here.
                if found.missing and (is_merged or (included and "::" in found.missing)):
                    continue
                wrong[found.element.offset, found.sentence] = found
            else:
                connections.append(found)
    told = {error.missing or error: error for error in reversed(wrong.values()) if error.code}
    flaws += _once(document, [*reversed(told.values())])
    document.flaws, document.connections = tuple(flaws), tuple(connections)
    return document


def _once(document: XmlDocument, errors: Sequence[SdfError]) -> Iterator[Flaw]:
    """Yield errors as flaws; what lacks a name that another element has is told there."""
    repeated = [e for e in errors if e.code in ("KD102", "KD103")]
    lost = [e for e in errors if e.missing and not e.is_misspelt]
    is_clear = len(repeated) == len(lost) == 1
    for error in errors:
        meant = hint(lost[0].missing) if is_clear and error is repeated[0] else ""
        if not is_clear or error is not lost[0]:
            yield document.flaw(error.code, f"{error.sentence}{meant}", error.element.offset)


def _models(root: Any) -> list[tuple[Any, str]]:
    """Return the models that are in no other one, with what stands before their names.

    Nothing stands before those of the only one that is not static.
    """
    models = [*root.findall("model"), *root.findall("world/model")]
    moving = [model for model in models if not is_true(model, "static")]
    plain = moving if len(moving) == 1 else models if len(models) == 1 else []
    return [(m, "" if m in plain else f"{m.get('name')}::") for m in models]


def _elements(model: Any, prefix: str) -> Iterator[tuple[Any, str]]:
    """Yield the links, joints and frames of a model and of those in it, in their order."""
    for child in model:
        if child.tag == "model":
            yield from _elements(child, f"{prefix}{child.get('name') or ''}::")
        elif child.tag in NAMED:
            yield child, prefix


def _connections(
    model: Any, prefix: str, joints: Mapping[str, Joint], version: str
) -> Iterator[Connection | SdfError]:
    """Yield what the joints of a model connect, or what is wrong with one or with a mass."""
    try:
        flatten(model)
    except SdfError as error:
        yield error
        return
    graph = None
    while graph is None:
        try:
            graph = FrameGraph(model, version)
        except SdfError as error:
            yield error
            if error.element not in list(model):
                return
            model.remove(error.element)
    for element in (*model.iterfind("link"), *model.iterfind("frame")):
        try:
            graph.model_T(name_of(element), element)
            mass_of(element)
        except SdfError as error:
            yield error
    for element in model.iterfind("joint"):
        kind = element.get("type") or ""
        if kind not in _TYPES:
            meant = hint(nearest_word(kind, _TYPES))
            yield defect(element, f"has the unknown type '{kind}'{meant}", "KD001")
        joint = joints.get(f"{prefix}{element.get('name')}")
        try:
            if joint is not None:
                yield _connection(element, joint, graph, prefix)
            joint_properties(element)  # Its limits are read when the robot is.
        except SdfError as error:
            yield error


def _connection(element: Any, joint: Joint, graph: FrameGraph, prefix: str) -> Connection:
    kind = element.get("type")
    parent, child = (graph.link_of(text_of(element, end), element) for end in ("parent", "child"))
    link = carried(element, 0, parent, child, graph)
    return Connection(
        joint,
        parent if parent == WORLD else f"{prefix}{parent}",
        f"{prefix}{child}",
        kind == "fixed",
        None if link.joint_kind == "fixed" else link.axis,
        link.parent_T_joint.then(link.joint_T_link),
        link.joint_T_link.inverse(),
        is_told=False,
    )


# Takes a text, and returns the document of an SDF; see there.
sdf_document = partial(xml_document, of_elements=_of_elements)
