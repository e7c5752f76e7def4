"""The messages to a page, and their content.

`messages.d.ts` of the page is written from this file
(`python -m kindsl.frontends.preview.message_types`).
A message is the value of its `type` at its `path`, the place in the scene that it speaks of:
`/kindsl/TREE/GROUP/NAME/CATEGORY/MARK`; a later one of the same type and path replaces it.

`set_object`, `set_transform` and `delete` are meshcat's. Lengths are in metres, angles in radians,
masses in kilograms. A matrix has 16 numbers, column by column, and maps coordinates of the thing
that it places to those of what carries it.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar, Literal, TypeAlias

from kindsl.language.semantics.declarations import ValueKind
from kindsl.mechanics.rigid.joint_kind import JointKind
from kindsl.mechanics.rigid.pose import Vector3
from kindsl.robots.scene.geometry import Shape
from kindsl.robots.scene.picture import PictureState
from kindsl.robots.scene.solids import Look

# A value with all parameters zero, and the factor of each parameter by name.
Affine: TypeAlias = tuple[float, tuple[tuple[str, float], ...]]
ROOT = "/kindsl"


@dataclass(frozen=True, slots=True)
class SetObject:
    """Draw a shape.

    Attributes:
        path: Of the mark.
        object: The shape, in meshcat's form.
    """

    type: ClassVar[Literal["set_object"]] = "set_object"
    path: str
    object: Shape


@dataclass(frozen=True, slots=True)
class SetTransform:
    """Place a shape.

    Attributes:
        path: Of the mark.
        matrix: Places and stretches the mark in the frame of its link, joint or frame.
    """

    type: ClassVar[Literal["set_transform"]] = "set_transform"
    path: str
    matrix: tuple[float, ...]


@dataclass(frozen=True, slots=True)
class Delete:
    """Forget a path and all below it.

    Attributes:
        path: The highest that is gone.
    """

    type: ClassVar[Literal["delete"]] = "delete"
    path: str


@dataclass(frozen=True, slots=True)
class ModelMessage:
    """The robot as a whole, at its zero configuration.

    Attributes:
        name: The document's.
        is_floating: Whether its base moves freely.
        size: Diagonal of the box around all bodies, metres.
        center: Middle of that box in the base's frame, metres.
        ground: Height of the ground in the base's frame, metres.
        unit: Radius to draw bodies with, metres; marks are made for a radius of 1.
        density: That most of its links have, kg/m^3.
        path: Constant.
    """

    type: ClassVar[Literal["model"]] = "model"
    name: str
    is_floating: bool
    size: float
    center: Vector3
    ground: float
    unit: float
    density: float
    path: str = f"{ROOT}/model"


@dataclass(frozen=True, slots=True)
class LinkMessage:
    """A link's numbers, the base's among them.

    Attributes:
        path: Of the link in its tree.
        name: In the document.
        index: 0 for the base; parents come before their children.
        joint: Name of the supporting joint, empty for the base.
        mass: Kilograms.
        com: Centre of mass in the link's frame, metres.
        inertia: Tensor about the centre of mass in the link's axes, row by row, kg m^2.
        is_consistent: Whether a rigid body with such an inertia exists.
        lacks: Why mass, centre of mass or moments are not known; empty where they are.
        anchor: Where its name stands in its frame, metres.
        ends: Where it reaches to in its frame, metres.
    """

    type: ClassVar[Literal["link"]] = "link"
    path: str
    name: str
    index: int
    joint: str
    mass: float
    com: Vector3
    inertia: tuple[float, ...]
    is_consistent: bool
    lacks: str
    anchor: Vector3
    ends: tuple[Vector3, ...]


@dataclass(frozen=True, slots=True)
class Core:
    """A superquadric of uniform density.

    Attributes:
        center: In the link's frame, metres.
        axes: Three right-handed unit vectors in the link's axes, one after another; the last is
            the pole.
        semi_axes: Along these, metres.
        gyration: Radii of gyration along these, metres; what is drawn has them exactly.
        exponents: Along meridians and along parallels: 1 is round, near 0 is square.
        density: kg/m^3.
        shell: How much smaller a shell of the robot's usual density is that has the same mass and
            inertia, as a factor; 1 where the solid is as dense.
    """

    center: Vector3
    axes: tuple[float, ...]
    semi_axes: Vector3
    gyration: Vector3
    exponents: tuple[float, float]
    density: float
    shell: float


@dataclass(frozen=True, slots=True)
class DoubtRow:
    """A defect of a body, or a possible one.

    Attributes:
        word: A short name of it.
        code: The rule that reports it.
        sentence: For people.
    """

    word: str
    code: str
    sentence: str


@dataclass(frozen=True, slots=True)
class Bone:
    """A strut from a link's origin.

    Attributes:
        name: Of the joint or frame that it goes to.
        end: In the link's frame, metres.
    """

    name: str
    end: Vector3


@dataclass(frozen=True, slots=True)
class SolidMessage:
    """A link as a body: the uniform solid with its inertia, and bones to its joints.

    Attributes:
        path: Of the body in its tree.
        name: The link's.
        core: The solid; None where there is none to be drawn.
        look: `glass` would hide the robot, `doubtful` and `impossible` are judged.
        doubts: Defects, proved or possible, the gravest first.
        is_oversized: Whether it is too large to be drawn unless asked for.
        bones: To its joints.
        radius: Of the bones, metres.
        strut: From a bone to the centre of mass, two points in the link's frame; else empty.
        drum: Radius of the supporting joint's drum, metres.
        is_shaded: Whether a shade tells it from its parent.
    """

    type: ClassVar[Literal["solid"]] = "solid"
    path: str
    name: str
    core: Core | None
    look: Look
    doubts: tuple[DoubtRow, ...]
    is_oversized: bool
    bones: tuple[Bone, ...]
    radius: float
    strut: tuple[Vector3, ...]
    drum: float
    is_shaded: bool


@dataclass(frozen=True, slots=True)
class JointMessage:
    """A joint and its place.

    Attributes:
        path: Of the joint in its tree.
        name: In the document.
        index: That of the link that it supports.
        kind: It turns about its z, or slides along it.
        predecessor: Name of the parent link.
        successor: Name of the child link.
        placement: Its frame in the parent link's frame.
        is_guess: Whether its place is in part a guess.
    """

    type: ClassVar[Literal["joint"]] = "joint"
    path: str
    name: str
    index: int
    kind: JointKind
    predecessor: str
    successor: str
    placement: tuple[float, ...]
    is_guess: bool


@dataclass(frozen=True, slots=True)
class FrameMessage:
    """An optional frame and its place.

    Attributes:
        path: Of the frame in its tree.
        name: In the document, after the link's name and a dot where the name is taken.
        link: Name of the link that it is attached to.
        placement: Its place in the link's frame.
        is_guess: Whether its place is in part a guess.
    """

    type: ClassVar[Literal["frame"]] = "frame"
    path: str
    name: str
    link: str
    placement: tuple[float, ...]
    is_guess: bool


@dataclass(frozen=True, slots=True)
class LimitsMessage:
    """The limits of a joint.

    Attributes:
        path: Of these limits.
        name: The joint's.
        minimum: Radians or metres; None where there is none.
        maximum: Radians or metres; None where there is none.
    """

    type: ClassVar[Literal["limits"]] = "limits"
    path: str
    name: str
    minimum: float | None
    maximum: float | None


@dataclass(frozen=True, slots=True)
class ValueMessage:
    """The position of a joint.

    Attributes:
        path: Of this value.
        name: The joint's.
        value: Radians or metres.
    """

    type: ClassVar[Literal["value"]] = "value"
    path: str
    name: str
    value: float


@dataclass(frozen=True, slots=True)
class PoseMessage:
    """A pose that the configuration names.

    Attributes:
        path: Of this pose.
        name: In the configuration.
        joints: Positions by the names of joints, radians or metres; the others are zero.
    """

    type: ClassVar[Literal["pose"]] = "pose"
    path: str
    name: str
    joints: Mapping[str, float]


@dataclass(frozen=True, slots=True)
class TrajectoryMessage:
    """A motion to be played.

    Attributes:
        name: Of its file.
        text: The file's, CSV or JSON.
        path: Constant.
    """

    type: ClassVar[Literal["trajectory"]] = "trajectory"
    name: str
    text: str
    path: str = f"{ROOT}/trajectory"


@dataclass(frozen=True, slots=True)
class ParameterMessage:
    """A parameter's row in the panel; its numbers are in metres, radians or kg, kg m, kg m^2.

    Attributes:
        path: Of this row.
        index: Its place among the document's parameters.
        name: In the document.
        kind: The quantity that it measures.
        value: That is drawn.
        is_guess: Whether that value is one because there is none.
        is_bound: Whether a configuration gives it its value.
        minimum: Of its slider.
        maximum: Of its slider.
        has_range: Whether a configuration gives both of these.
        is_overridden: Whether the value was set in the page.
    """

    type: ClassVar[Literal["parameter"]] = "parameter"
    path: str
    index: int
    name: str
    kind: ValueKind
    value: float
    is_guess: bool
    is_bound: bool
    minimum: float
    maximum: float
    has_range: bool
    is_overridden: bool


@dataclass(frozen=True, slots=True)
class FormulaMessage:
    """A place as a formula of parameters, for pages without a server.

    Attributes:
        path: Of this formula.
        group: Name of the group that is placed.
        name: Of the joint or frame.
        link: Name of the link that it is attached to.
        translation: In the link's frame, a formula for each of x, y, z, metres.
        rotation: Intrinsic angles about x, y, z, a formula for each, radians.
        rod: Path of the link's mark that reaches there.
        end: Path of the mark at that rod's end.
    """

    type: ClassVar[Literal["formula"]] = "formula"
    path: str
    group: Literal["joints", "frames"]
    name: str
    link: str
    translation: tuple[Affine, ...]
    rotation: tuple[Affine, ...]
    rod: str
    end: str


@dataclass(frozen=True, slots=True)
class FindingMessage:
    """A finding of the linter, in the list over the picture.

    Attributes:
        path: Of this finding.
        index: Its place in the list, the worst first.
        code: Of the rule: `KD301`.
        severity: `error`, `warning`, `info` or `hint`.
        message: For people.
        line: Counts from 1.
        column: Counts from 1, in code points.
    """

    type: ClassVar[Literal["finding"]] = "finding"
    path: str
    index: int
    code: str
    severity: str
    message: str
    line: int
    column: int


@dataclass(frozen=True, slots=True)
class StatusMessage:
    """The picture's relation to the document.

    Attributes:
        state: See there; `gone` if the document cannot be read.
        message: A sentence on the state, for people; empty if all is well.
        total: How many findings there are, listed or not.
        counts: How many there are of each severity that occurs.
        label: Name of the document.
        mass: Of all bodies that count, as far as known, kilograms.
        lacks: Why that is not all; empty where it is.
        is_former: Whether an earlier version is drawn.
        path: Constant.
    """

    type: ClassVar[Literal["status"]] = "status"
    state: PictureState | Literal["gone"]
    message: str
    total: int
    counts: Mapping[str, int]
    label: str
    mass: float
    lacks: str
    is_former: bool
    path: str = f"{ROOT}/status"


@dataclass(frozen=True, slots=True)
class HighlightMessage:
    """The thing at the editor's cursor.

    Attributes:
        kind: `link`, `joint` or `frame`; empty for nothing.
        name: In the document; empty for nothing.
        path: Constant.
    """

    type: ClassVar[Literal["highlight"]] = "highlight"
    kind: str
    name: str
    path: str = f"{ROOT}/highlight"


@dataclass(frozen=True, slots=True)
class GhostMessage:
    """The robot that stands behind the document's.

    Attributes:
        kind: The version that was last saved, another robot that is compared, or what an edit that
            is planned would make.
        name: Of its file; empty if it has none.
        path: Constant.
    """

    type: ClassVar[Literal["ghost"]] = "ghost"
    kind: Literal["saved", "other", "planned"]
    name: str = ""
    path: str = f"{ROOT}/ghost"


@dataclass(frozen=True, slots=True)
class OtherMessage:
    """Another description of the robot that can be compared.

    Attributes:
        path: Of this one.
        index: Its place in the list.
        name: Of its file.
        is_chosen: Whether it is compared now.
    """

    type: ClassVar[Literal["other"]] = "other"
    path: str
    index: int
    name: str
    is_chosen: bool


@dataclass(frozen=True, slots=True)
class DifferenceRow:
    """A number that is another in the other file.

    Attributes:
        kind: `link`, `joint` or `frame`.
        name: In the document, or of the link that it belongs to.
        owner: Whose number it is, as its file calls it.
        quantity: `mass`, `CoM x`, `Ixx`, `x`, `rx`, ...
        unit: Of both values.
        here: In the document.
        there: In the other file.
        message: For people, with the lines.
        line: In the document, counts from 1; 0 where it does not stand there.
    """

    kind: str
    name: str
    owner: str
    quantity: str
    unit: str
    here: float
    there: float
    message: str
    line: int


@dataclass(frozen=True, slots=True)
class ComparisonMessage:
    """The result of comparing the document with another file.

    Attributes:
        own: What to call the document.
        other: What to call the other file.
        verdict: In words; why it cannot be compared where it cannot.
        is_equal: Whether the mechanics are equal.
        rows: The numbers that differ.
        structure: What else differs, one sentence each.
        conventions: What differs without any meaning for the mechanics, one sentence each.
        path: Constant.
    """

    type: ClassVar[Literal["comparison"]] = "comparison"
    own: str
    other: str
    verdict: str
    is_equal: bool
    rows: tuple[DifferenceRow, ...]
    structure: tuple[str, ...]
    conventions: tuple[str, ...]
    path: str = f"{ROOT}/comparison"


@dataclass(frozen=True, slots=True)
class VisualMessage:
    """A shape that another description gives a link for drawing.

    Attributes:
        path: Of this shape.
        link: Name of the link.
        form: What it is.
        size: Factors of a mesh along its axes; sides of a box, radius and length of a cylinder
            along z, radius of a sphere, metres.
        matrix: Its frame in the link's.
        file: The name of a mesh's file at the server, which tells its format; else empty.
    """

    type: ClassVar[Literal["visual"]] = "visual"
    path: str
    link: str
    form: Literal["mesh", "box", "cylinder", "sphere"]
    size: tuple[float, ...]
    matrix: tuple[float, ...]
    file: str


@dataclass(frozen=True, slots=True)
class MeshDataMessage:
    """The content of a mesh's file, for pages without a server.

    Attributes:
        path: Of this file.
        file: Its name in `visual` messages.
        data: Its bytes in base 64.
    """

    type: ClassVar[Literal["mesh_data"]] = "mesh_data"
    path: str
    file: str
    data: str


@dataclass(frozen=True, slots=True)
class MeshesMessage:
    """The description whose meshes can be drawn.

    Attributes:
        name: Of its file.
        is_loaded: Whether they have been asked for, so that `visual` messages are there.
        problems: What is left out and why, one sentence each.
        path: Constant.
    """

    type: ClassVar[Literal["meshes"]] = "meshes"
    name: str
    is_loaded: bool
    problems: tuple[str, ...]
    path: str = f"{ROOT}/meshes"


@dataclass(frozen=True, slots=True)
class EditingMessage:
    """The permission to edit the document from the page.

    Attributes:
        revision: Of the text that is shown; to be sent back with what is dragged.
        path: Constant.
    """

    type: ClassVar[Literal["editing"]] = "editing"
    revision: int
    path: str = f"{ROOT}/editing"


@dataclass(frozen=True, slots=True)
class HandleRow:
    """One number of a thing.

    Attributes:
        component: `x y z rx ry rz`.
        value: Metres or radians, None where it has none.
        text: As written in the document.
        symbol: The parameter or constant that carries it, empty where it is a plain number.
        moves_along: Other places that the symbol moves: `joint 'knee' x`.
        locked: Why it cannot be changed, empty where it can.
    """

    component: str
    value: float | None
    text: str
    symbol: str
    moves_along: tuple[str, ...]
    locked: str


@dataclass(frozen=True, slots=True)
class HandlesMessage:
    """The numbers of what is grasped.

    Attributes:
        kind: `joint`, `frame` or `com`.
        name: In the document; of a centre of mass the link's.
        revision: Of the text that they are of.
        frame: Optional frame along whose axes a centre of mass is written, empty for its link's.
        components: Three of a centre of mass, else six.
        can_mirror: Whether its link has a mirror image that the document lacks.
        path: Constant.
    """

    type: ClassVar[Literal["handles"]] = "handles"
    kind: str
    name: str
    revision: int
    frame: str
    components: tuple[HandleRow, ...]
    can_mirror: bool = False
    path: str = f"{ROOT}/handles"


@dataclass(frozen=True, slots=True)
class DraggedMessage:
    """The result of a handle's move.

    Attributes:
        phase: That the page asked for: `move`, `drop` or `cancel`.
        component: `x y z rx ry rz`.
        text: The number as it is or would be written.
        value: That number, metres or radians.
        reason: Why not; empty if nothing was in the way.
        written: Whether the document was changed.
        warning: Which body it makes impossible; empty for none.
        path: Constant.
    """

    type: ClassVar[Literal["dragged"]] = "dragged"
    phase: str
    component: str
    text: str
    value: float
    reason: str
    written: bool
    warning: str = ""
    path: str = f"{ROOT}/dragged"


@dataclass(frozen=True, slots=True)
class PlanMessage:
    """The preview of a gesture.

    Attributes:
        gesture: That the page asked for.
        title: Its title, in the imperative; empty if it cannot be.
        reason: Why not; empty if nothing is in the way.
        path: Constant.
    """

    type: ClassVar[Literal["plan"]] = "plan"
    gesture: str
    title: str
    reason: str
    path: str = f"{ROOT}/plan"


@dataclass(frozen=True, slots=True)
class WrittenMessage:
    """The result of an accepted gesture.

    Attributes:
        gesture: That the page asked for.
        title: Its title, in the imperative.
        reason: Why nothing was written; empty if it was.
        path: Constant.
    """

    type: ClassVar[Literal["written"]] = "written"
    gesture: str
    title: str
    reason: str
    path: str = f"{ROOT}/written"


@dataclass(frozen=True, slots=True)
class LinesMessage:
    """Lines that the user may add to a file.

    Attributes:
        text: The lines.
        path: Constant.
    """

    type: ClassVar[Literal["lines"]] = "lines"
    text: str
    path: str = f"{ROOT}/lines"


Part: TypeAlias = (
    SetObject | SetTransform | Delete | ModelMessage | LinkMessage | SolidMessage | JointMessage
    | FrameMessage | LimitsMessage | ValueMessage | PoseMessage | ParameterMessage
    | TrajectoryMessage | FormulaMessage | GhostMessage | OtherMessage | ComparisonMessage
    | VisualMessage | MeshDataMessage | MeshesMessage
    | FindingMessage | StatusMessage | HighlightMessage | EditingMessage | HandlesMessage
    | DraggedMessage | PlanMessage | WrittenMessage | LinesMessage
)  # fmt: skip


@dataclass(frozen=True, slots=True)
class Change:
    """All that a page is told at once; it shows nothing of it before it has taken all of it.

    Attributes:
        is_whole: Whether this is the whole state: what it does not mention is gone.
        parts: In the order in which they are to be taken.
    """

    type: ClassVar[Literal["change"]] = "change"
    is_whole: bool
    parts: tuple[Part, ...]
