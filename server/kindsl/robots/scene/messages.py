"""The messages to a page, and their content.

`messages.d.ts` of the page is written from this file (`python -m generating.message_types`).
A message is the value of its `type` at its `path`, the place in the scene that it speaks of:
`/kindsl/TREE/GROUP/NAME/CATEGORY/MARK`; a later one of the same type and path replaces it. Names
are those in the document. `set_object`, `set_transform` and `delete` are meshcat's.
"""

import re
from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import Annotated, ClassVar, Literal, NamedTuple, TypeAlias, dataclass_transform
from urllib.parse import quote

from kindsl.language.semantics.declarations import ValueKind
from kindsl.mechanics.rigid.joint_kind import JointKind
from kindsl.mechanics.rigid.pose import Vector3
from kindsl.robots.scene.geometry import Shape
from kindsl.robots.scene.picture import PictureState
from kindsl.robots.scene.size import Segment
from kindsl.robots.scene.solids import Doubt, Look

ROOT = "/kindsl"

Metres: TypeAlias = Annotated[float, "metres"]
Position: TypeAlias = Annotated[Vector3, "metres"]
Kilograms: TypeAlias = Annotated[float, "kilograms"]
Density: TypeAlias = Annotated[float, "kilograms per cubic metre"]
# Of a joint or a handle, by its kind.
Travel: TypeAlias = Annotated[float, "radians or metres"]
# Of a parameter, by its kind.
Quantity: TypeAlias = Annotated[float, "metres, radians or kg, kg m, kg m^2"]
Matrix: TypeAlias = Annotated[tuple[float, ...], "16 numbers, column by column"]
Sentence: TypeAlias = Annotated[str, "for people"]
# A value with all parameters zero, and the factor of each parameter by name.
Affine: TypeAlias = tuple[float, tuple[tuple[str, float], ...]]


@dataclass_transform(frozen_default=True)
class Message:
    """A frozen dataclass whose `type` is its name without `Message`: `set_object`."""

    type: ClassVar[str]

    def __init_subclass__(cls) -> None:
        dataclass(frozen=True)(cls)
        words = cls.__name__.removesuffix("Message")
        cls.type = re.sub(r"\B([A-Z])", r"_\1", words).lower()


class PlacedMessage(Message):
    """A message of which there are several of a type, each at its path."""

    path: str


class SetObject(PlacedMessage):
    """Draw a shape."""

    object: Annotated[Shape, "in meshcat's form"]


class SetTransform(PlacedMessage):
    """Place and stretch a mark in the frame of its link, joint or frame."""

    matrix: Matrix


class Delete(PlacedMessage):
    """Forget a path and all below it."""


class ModelMessage(Message):
    """The robot as a whole, at its zero configuration."""

    name: str
    is_floating: Annotated[bool, "whether its base moves freely"]
    size: Annotated[Metres, "diagonal of the box around all bodies"]
    center: Annotated[Position, "middle of that box in the base's frame"]
    ground: Annotated[Metres, "height of the ground in the base's frame"]
    unit: Annotated[Metres, "radius to draw bodies with; marks are made for a radius of 1"]
    density: Annotated[Density, "of most of its links"]
    path: str = f"{ROOT}/model"


class LinkMessage(PlacedMessage):
    """A link's numbers, the base's among them; points are in its frame."""

    name: str
    index: Annotated[int, "0 for the base; parents come before their children"]
    joint: Annotated[str, "the supporting joint, empty for the base"]
    mass: Kilograms
    com: Annotated[Position, "centre of mass"]
    inertia: Annotated[tuple[float, ...], "about the CoM in the link's axes, row by row, kg m^2"]
    is_consistent: Annotated[bool, "whether a rigid body with such an inertia exists"]
    lacks: Annotated[str, "why mass, CoM or moments are not known; empty where they are"]
    anchor: Annotated[Position, "where its name stands"]
    ends: Annotated[tuple[Vector3, ...], "where it reaches to, metres"]


class Core(NamedTuple):
    """A superquadric of uniform density."""

    center: Annotated[Position, "in the link's frame"]
    axes: Annotated[tuple[float, ...], "three right-handed unit vectors; the last is the pole"]
    semi_axes: Annotated[Position, "along the axes"]
    gyration: Annotated[Position, "radii of gyration along the axes, as drawn exactly"]
    exponents: Annotated[
        tuple[float, float], "along meridians and parallels: 1 is round, near 0 is square"
    ]
    density: Density
    shell: Annotated[
        float,
        "scale of a shell of the robot's usual density that has the same mass and inertia; 1 where "
        "the solid is as dense",
    ]


class SolidMessage(PlacedMessage):
    """A link as a body: the uniform solid with its inertia, and bones to its joints."""

    name: Annotated[str, "the link's"]
    core: Annotated[Core | None, "null where there is no solid to draw"]
    look: Annotated[Look, "`glass` would hide the robot, `doubtful` and `impossible` are judged"]
    doubts: Annotated[tuple[Doubt, ...], "what the linter says of it, the gravest first"]
    is_oversized: Annotated[bool, "whether it is too large to be drawn unless asked for"]
    bones: Annotated[tuple[Segment, ...], "to its joints and frames"]
    radius: Annotated[Metres, "of the bones"]
    strut: Annotated[tuple[Vector3, ...], "from a bone to the CoM, two points; else empty"]
    drum: Annotated[Metres, "radius of the supporting joint's drum"]
    is_shaded: Annotated[bool, "whether a shade tells it from its parent"]


class JointMessage(PlacedMessage):
    """A joint and its place; it turns about its z axis or slides along it."""

    name: str
    index: Annotated[int, "of the link that it supports"]
    kind: JointKind
    predecessor: Annotated[str, "the parent link"]
    successor: Annotated[str, "the child link"]
    placement: Annotated[Matrix, "its frame in the parent link's frame"]
    is_guess: Annotated[bool, "whether its place is in part a guess"]


class FrameMessage(PlacedMessage):
    """An optional frame and its place."""

    name: Annotated[str, "after the link's name and a dot where the name is taken"]
    link: Annotated[str, "the link that it is attached to"]
    placement: Annotated[Matrix, "its place in the link's frame"]
    is_guess: Annotated[bool, "whether its place is in part a guess"]


class LimitsMessage(PlacedMessage):
    """The limits of a joint; null where there is none."""

    name: str
    minimum: Travel | None
    maximum: Travel | None


class ValueMessage(PlacedMessage):
    """The position of a joint."""

    name: str
    value: Travel


class PoseMessage(PlacedMessage):
    """A pose that the configuration names."""

    name: str
    joints: Annotated[Mapping[str, Travel], "positions by joint; the other joints are at zero"]


class TrajectoryMessage(Message):
    """A motion to be played."""

    name: Annotated[str, "of its file"]
    text: Annotated[str, "of its file, CSV or JSON"]
    path: str = f"{ROOT}/trajectory"


class ParameterMessage(PlacedMessage):
    """A parameter's row in the panel."""

    index: Annotated[int, "its place among the document's parameters"]
    name: str
    kind: ValueKind
    value: Annotated[Quantity, "as drawn"]
    is_guess: Annotated[bool, "whether the value is a guess because there is none"]
    is_bound: Annotated[bool, "whether a configuration gives it its value"]
    minimum: Annotated[Quantity, "of its slider"]
    maximum: Annotated[Quantity, "of its slider"]
    has_range: Annotated[bool, "whether a configuration gives minimum and maximum"]
    is_overridden: Annotated[bool, "whether the value was set in the page"]


class FormulaMessage(PlacedMessage):
    """A place as a formula of parameters, for pages without a server."""

    group: Literal["joints", "frames"]
    name: str
    link: Annotated[str, "the link that it is attached to"]
    translation: Annotated[tuple[Affine, ...], "x, y, z in the link's frame, metres"]
    rotation: Annotated[tuple[Affine, ...], "intrinsic angles about x, y, z, radians"]
    rod: Annotated[str, "path of the link's mark that reaches there"]
    end: Annotated[str, "path of the mark at that rod's end"]


class FindingMessage(PlacedMessage):
    """A finding of the linter, in the list over the picture."""

    index: Annotated[int, "its place in the list, the worst first"]
    code: Annotated[str, "of the rule: `KD301`"]
    severity: Annotated[str, "`error`, `warning`, `info` or `hint`"]
    message: Sentence
    line: Annotated[int, "counts from 1"]
    column: Annotated[int, "counts from 1, in code points"]


class StatusMessage(Message):
    """The picture's relation to the document."""

    state: Annotated[PictureState | Literal["gone"], "`gone` if the document cannot be read"]
    message: Annotated[Sentence, "on the state; empty if all is well"]
    total: Annotated[int, "number of findings, listed or not"]
    counts: Annotated[Mapping[str, int], "number of findings by severity"]
    label: Annotated[str, "name of the document"]
    mass: Annotated[Kilograms, "of all bodies that count, as far as known"]
    lacks: Annotated[str, "why that is not all; empty where it is"]
    is_former: Annotated[bool, "whether an earlier version is drawn"]
    path: str = f"{ROOT}/status"


class HighlightMessage(Message):
    """The thing at the editor's cursor; empty for nothing."""

    kind: Annotated[str, "`link`, `joint` or `frame`"]
    name: str
    path: str = f"{ROOT}/highlight"


class GhostMessage(Message):
    """The robot that stands behind the document's: as last saved, another, or as planned."""

    kind: Literal["saved", "other", "planned"]
    name: Annotated[str, "of its file; empty if it has none"] = ""
    path: str = f"{ROOT}/ghost"


class OtherMessage(PlacedMessage):
    """Another description of the robot that can be compared."""

    index: Annotated[int, "its place in the list"]
    name: Annotated[str, "of its file"]
    is_chosen: Annotated[bool, "whether it is compared now"]


class DifferenceRow(NamedTuple):
    """A number that differs in the other file."""

    kind: Annotated[str, "`link`, `joint` or `frame`"]
    name: Annotated[str, "in the document, or of the link that it belongs to"]
    owner: Annotated[str, "whose number it is, as its file calls it"]
    quantity: Annotated[str, "`mass`, `CoM x`, `Ixx`, `x`, `rx`, ..."]
    unit: Annotated[str, "of both values"]
    here: Annotated[float, "in the document"]
    there: Annotated[float, "in the other file"]
    message: Annotated[Sentence, "with the lines"]
    line: Annotated[int, "in the document, counts from 1; 0 where it does not stand there"]


class ComparisonMessage(Message):
    """The result of comparing the document with another file."""

    own: Annotated[str, "name of the document"]
    other: Annotated[str, "name of the other file"]
    verdict: Annotated[str, "in words; why it cannot be compared where it cannot"]
    is_equal: Annotated[bool, "whether the mechanics are equal"]
    rows: Annotated[tuple[DifferenceRow, ...], "the numbers that differ"]
    structure: Annotated[tuple[str, ...], "other differences, one sentence each"]
    conventions: Annotated[
        tuple[str, ...], "differences without any meaning for the mechanics, one sentence each"
    ]
    path: str = f"{ROOT}/comparison"


class VisualMessage(PlacedMessage):
    """A shape that another description gives a link for drawing."""

    link: str
    form: Literal["mesh", "box", "cylinder", "sphere"]
    size: Annotated[
        tuple[float, ...],
        "factors of a mesh along its axes; sides of a box, radius and length of a cylinder along "
        "z, radius of a sphere, metres",
    ]
    matrix: Annotated[Matrix, "its frame in the link's"]
    file: Annotated[str, "name of a mesh's file at the server, with its suffix; else empty"]


class MeshDataMessage(PlacedMessage):
    """The content of a mesh's file, for pages without a server."""

    file: Annotated[str, "its name in `visual` messages"]
    data: Annotated[str, "its bytes in base 64"]


class MeshesMessage(Message):
    """The description whose meshes can be drawn."""

    name: Annotated[str, "of its file"]
    is_loaded: Annotated[bool, "whether they have been asked for, so that there are `visual`s"]
    problems: Annotated[tuple[str, ...], "what is left out and why, one sentence each"]
    path: str = f"{ROOT}/meshes"


class EditingMessage(Message):
    """The permission to edit the document from the page."""

    revision: Annotated[int, "of the text that is shown; sent back with each drag"]
    path: str = f"{ROOT}/editing"


class Handle(NamedTuple):
    """One number of a thing."""

    component: Annotated[str, "`x y z rx ry rz`"]
    value: Annotated[Travel | None, "null where it has none"]
    text: Annotated[str, "as written in the document"]
    symbol: Annotated[str, "parameter or constant that carries it, empty for a plain number"] = ""
    moves_along: Annotated[tuple[str, ...], "other places that the symbol moves"] = ()
    locked: Annotated[str, "why it cannot be changed, empty where it can"] = ""


class HandlesMessage(Message):
    """The numbers of the thing that is grasped."""

    kind: Annotated[str, "`joint`, `frame` or `com`"]
    name: Annotated[str, "of a centre of mass the link's"]
    revision: Annotated[int, "of the text that they are of"]
    frame: Annotated[str, "optional frame along whose axes a CoM is written, empty for its link's"]
    components: Annotated[tuple[Handle, ...], "three of a centre of mass, else six"]
    can_mirror: Annotated[bool, "whether its link has a counterpart that the document lacks"] = (
        False
    )
    path: str = f"{ROOT}/handles"


class DraggedMessage(Message):
    """The result of a handle's move."""

    phase: Annotated[str, "as requested: `move`, `drop` or `cancel`"]
    component: Annotated[str, "`x y z rx ry rz`"]
    text: Annotated[str, "the number as it is or would be written"]
    value: Annotated[Travel, "of that number"]
    reason: Annotated[str, "why not; empty if nothing was in the way"]
    written: Annotated[bool, "whether the document was changed"]
    warning: Annotated[str, "which body becomes impossible; empty for none"] = ""
    path: str = f"{ROOT}/dragged"


class PlanMessage(Message):
    """The preview of a gesture."""

    gesture: Annotated[str, "as requested"]
    title: Annotated[str, "in the imperative; empty if it cannot be done"]
    reason: Annotated[str, "why not; empty if nothing is in the way"]
    path: str = f"{ROOT}/plan"


class WrittenMessage(Message):
    """The result of an accepted gesture."""

    gesture: Annotated[str, "as requested"]
    title: Annotated[str, "in the imperative"]
    reason: Annotated[str, "why nothing was written; empty if it was"]
    path: str = f"{ROOT}/written"


class LinesMessage(Message):
    """Lines that the user may add to a file."""

    text: str
    path: str = f"{ROOT}/lines"


class RefusedMessage(Message):
    """The answer to a message that is no request."""

    reason: Sentence
    path: str = f"{ROOT}/refused"


Part: TypeAlias = (
    SetObject | SetTransform | Delete | ModelMessage | LinkMessage | SolidMessage | JointMessage
    | FrameMessage | LimitsMessage | ValueMessage | PoseMessage | ParameterMessage
    | TrajectoryMessage | FormulaMessage | GhostMessage | OtherMessage | ComparisonMessage
    | VisualMessage | MeshDataMessage | MeshesMessage
    | FindingMessage | StatusMessage | HighlightMessage | EditingMessage | HandlesMessage
    | DraggedMessage | PlanMessage | WrittenMessage | LinesMessage | RefusedMessage
)  # fmt: skip


class Change(Message):
    """One atomic update of the page."""

    is_whole: Annotated[bool, "whether this is the whole state, and all else is gone"]
    parts: Annotated[tuple[Part, ...], "in the order in which they are to be taken"]


@lru_cache(maxsize=1 << 15)
def path_of(*elements: str) -> str:
    """Return the path of named elements; a name can hold any character."""
    return "/".join((ROOT, *(quote(element, safe="") for element in elements)))
