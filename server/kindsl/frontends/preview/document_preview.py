"""One document's preview: from an analysis and the sliders' values to the state of its pages."""

import asyncio
import math
from collections.abc import Callable, Mapping, Sequence
from typing import NamedTuple

from kindsl.frontends.preview.changes import Messages, keyed
from kindsl.frontends.preview.channel import Channel, Tab
from kindsl.frontends.preview.comparing import (
    LAST_SAVED,
    OtherRobot,
    ShownComparison,
    compared,
    document_robot,
    other_messages,
    twin_robots,
)
from kindsl.frontends.preview.findings import finding_messages, status_message
from kindsl.frontends.preview.meshes import (
    LinkMeshes,
    MeshSource,
    link_meshes,
    offered,
    twin_source,
)
from kindsl.judgement.analysis.analysis import Analysis
from kindsl.judgement.analysis.body_doubts import body_doubts
from kindsl.judgement.analysis.diagnostics import Diagnostic
from kindsl.judgement.analysis.settings import pose_named
from kindsl.robots.interchange.mesh_files import MeshFile
from kindsl.robots.mechanism.linkage import Linkage
from kindsl.robots.scene.messages import (
    GhostMessage,
    HighlightMessage,
    ParameterMessage,
    PoseMessage,
    TrajectoryMessage,
    ValueMessage,
    path_of,
)
from kindsl.robots.scene.parameters import parameter_messages
from kindsl.robots.scene.picture import Picture, PictureState, picture
from kindsl.robots.scene.robot import ghost_messages, robot_messages, solid_messages
from kindsl.robots.scene.solids import Doubts

# More joints or parameters than any robot has.
MOST_VALUES = 10_000


class MadeBeside(NamedTuple):
    """What takes longer than a picture may.

    Attributes:
        comparison: With the description that is chosen, None if there is none.
        meshes: None if none are to be drawn.
        doubts: What is doubtful about the bodies as values from the page make them, None without.
    """

    comparison: ShownComparison | None = None
    meshes: LinkMeshes | None = None
    doubts: Doubts | None = None


class ShownVersion(NamedTuple):
    """The picture of a version.

    Attributes:
        given: The values that it was made with.
        picture: Which bodies, and in what state.
        robot: Their messages but for their solids, None without bodies.
        solids: Their solids, None without bodies.
        doubts: What is doubtful about them in `solids`.
        parameters: The rows of the parameters.
        poses: The poses of the configuration.
    """

    given: dict[str, float]
    picture: Picture
    robot: Messages | None
    solids: Messages | None
    doubts: Doubts
    parameters: list[ParameterMessage]
    poses: list[PoseMessage]


class DocumentPreview:
    """The pages of one document.

    Attributes:
        key: Of the document, as its editor or command knows it.
        channel: The state and the tabs.
        analysis: The document as last shown, None before.
        findings: Its findings, or those of an earlier version until they are known.
        newest: The version that was last asked for, maybe not yet shown.
        turn: Held while a version is drawn.
        revision: How many versions have been shown.
        on_change: Called when a version is shown, or values of parameters are others.
        recompare: Called when what is compared or judged has changed; has `beside` made and shown.
        mesh_files: The meshes that pages may load, by name.
    """

    def __init__(self, label: str, key: str = "") -> None:
        self.key = key
        self.channel = Channel()
        self.analysis: Analysis | None = None
        self.findings: Sequence[Diagnostic] = ()
        self.newest: Analysis | None = None
        self.turn = asyncio.Lock()
        self.revision = 0
        self.on_change: list[Callable[[], None]] = []
        self.recompare: Callable[[], None] = lambda: self.show_beside(self.beside())
        self._label = label
        self._joints: dict[str, float] = {}
        self._parameters: dict[str, float] = {}
        self._last_good: Picture | None = None
        self._ghost: Linkage | None = None
        self._planned: Linkage | None = None
        self._shown: tuple[Analysis, ShownVersion] | None = None
        self._saved: OtherRobot | None = None
        self._offered: list[OtherRobot] = []
        self._chosen = ""
        self._compared: Linkage | None = None
        self._mesh_source: MeshSource | None = None
        self._wants_meshes = False
        self.mesh_files: dict[str, MeshFile] = {}

    def show(self, analysis: Analysis, findings: Sequence[Diagnostic]) -> None:
        """Show a version and its findings; values that were set by sliders stay."""
        self.put(analysis)
        self.list_findings(findings)

    def drawing(
        self, analysis: Analysis, findings: Sequence[Diagnostic] | None = None
    ) -> ShownVersion:
        """Return the picture of a version; changes nothing, so any thread may ask.

        Args:
            findings: Its findings; None while they are not known, then the listed ones count.
        """
        given, model, settings = self._given(analysis), analysis.model, analysis.settings
        listed = self.findings
        doubts = self._known_doubts(listed) if findings is None else body_doubts(analysis, findings)
        drawn = picture(model, given, self._last_good)
        robot, solids, guessed = None, None, drawn.guesses
        if drawn.skeleton is not None:
            name = str(model.name)
            shown = name, drawn.skeleton, guessed, settings.joints, drawn.unknown
            robot = keyed(robot_messages(*shown))  # Thousands, which the loop would wait for.
            solids = keyed(solid_messages(drawn.skeleton, doubts, drawn.unknown))
        rows = parameter_messages(model, settings.bindings, self._parameters, guessed.values)
        poses = [
            PoseMessage(path_of("poses", n), n, joints) for n, joints in settings.poses.items()
        ]
        return ShownVersion(given, drawn, robot, solids, doubts, rows, poses)

    def put(self, analysis: Analysis, drawing: ShownVersion | None = None) -> None:
        """Show a version, using its drawing if there is one; earlier findings stay listed."""
        self.analysis = analysis
        self._planned = None
        is_current = drawing is not None and drawing.given == self._given(analysis)
        self._put(analysis, drawing if drawing and is_current else self.drawing(analysis))
        self._show_status(self.findings)
        self.revision += 1
        self._changed()

    @property
    def typed(self) -> Mapping[str, float]:
        """Values of parameters that were set in the page."""
        return self._parameters

    def try_out(self, trial: Analysis, findings: Sequence[Diagnostic]) -> None:
        """Show a trial and its findings; the current version is kept for `put_back`."""
        self._put(trial, self.drawing(trial, findings))
        self._list(findings, trial.text)

    def put_back(self) -> None:
        """Show the current version again after a trial."""
        if self.analysis is not None:
            self._put(self.analysis, self.drawing(self.analysis))
            self._list(self.findings, self.analysis.text)

    def show_plan(self, planned: Analysis | None) -> None:
        """Draw a planned version as a ghost; None removes it."""
        self._planned = None if planned is None else self.drawing(planned).picture.skeleton
        self._draw_ghost()

    def list_findings(self, findings: Sequence[Diagnostic]) -> None:
        """List the findings of the version that is shown."""
        self.findings = findings
        self._list(findings, "" if self.analysis is None else self.analysis.text)
        self._doubt(self._known_doubts(findings))

    def keep_as_ghost(self) -> None:
        """Let the document as it is stand behind later versions and typed values."""
        saved = self.analysis
        self._ghost = self._last_skeleton
        if saved is None:
            return
        if self._parameters:
            own = picture(saved.model, saved.context.values, self._last_good)
            self._ghost = self._last_skeleton if own.state is PictureState.BROKEN else own.skeleton
        self._saved = document_robot(LAST_SAVED, lambda: saved)
        self._draw_ghost()
        self._offer()

    def lose(self, message: str) -> None:
        """Say that the document cannot be read; its last picture stays until it can."""
        self.analysis = None
        self._show_status(self.findings, message)

    def compare(self, other: OtherRobot) -> None:
        """Offer another description, and compare this document with it."""
        self._offered.append(other)
        self.choose_other(other.name)

    def choose_other(self, name: str) -> None:
        """Compare with another description that is offered; with none for an empty name."""
        self._chosen = name
        self._offer()

    def draw_meshes(self, source: MeshSource) -> None:
        """Draw the meshes of another description on the links."""
        self._mesh_source = source
        self.show_meshes()

    def show_meshes(self) -> None:
        """Draw the meshes that are offered."""
        self._wants_meshes = True
        self._offer()

    def beside(self) -> MadeBeside:
        """Return the comparison, meshes and doubts that are asked for; any thread may ask."""
        if self._shown is None:
            return MadeBeside()
        analysis, (given, drawn, *_) = self._shown
        skeleton = drawn.skeleton
        if skeleton is None or drawn.is_former:
            return MadeBeside()
        values = drawn.guesses.beside(given)
        other = self._others().get(self._chosen)
        source = self._meshes_of() if self._wants_meshes else None
        tried = analysis.changed((), self._parameters)
        return MadeBeside(
            other and compared(self._label, analysis, values, skeleton, other),
            source and link_meshes(source, analysis.model, values, skeleton),
            body_doubts(tried, tried.findings) if self._parameters else None,
        )

    def show_beside(self, found: MadeBeside) -> None:
        """Show a comparison, meshes and doubts; of a broken document the last ones stay."""
        comparison, meshes, doubts = found
        if doubts is not None and self._parameters:
            self._doubt(doubts)
        if meshes is not None:
            self.mesh_files = meshes.files
            self.channel.replace("meshes", meshes.messages)
        if comparison is not None and comparison.message.other == self._chosen:
            self._compared = comparison.ghost
            self.channel.replace("comparison", (comparison.message,))
        elif not self._chosen:
            self._compared = None
            self.channel.replace("comparison", ())
        self._draw_ghost()

    def set_joint(self, name: str, value: float, sender: Tab | None = None) -> None:
        """Move a joint to a position, radians or metres."""
        if math.isfinite(value) and _has_room(self._joints, name):
            self._joints[name] = value
            message = ValueMessage(path_of("values", name), name, value)
            self.channel.put("joints", message, sender)

    def take_pose(self, name: str) -> None:
        """Put all joints into a pose of the configuration.

        Raises:
            PoseError: There is none of that name for this robot.
        """
        assert self.analysis is not None
        joints = [str(joint.name) for joint in self.analysis.model.joints]
        pose = pose_named(self.analysis.settings, name, joints)
        for joint in joints:
            self.set_joint(joint, pose.get(joint, 0.0))

    def play(self, name: str, text: str) -> None:
        """Offer a motion, the text of a file, to be played."""
        self.channel.replace("trajectory", (TrajectoryMessage(name, text),))

    def set_parameters(self, values: Mapping[str, float | None]) -> None:
        """Give parameters values, or their own back for None; draws once."""
        before = dict(self._parameters)
        for name, value in values.items():
            if value is None:
                self._parameters.pop(name, None)
            elif math.isfinite(value) and _has_room(self._parameters, name):
                self._parameters[name] = value
        if before != self._parameters:
            self.put_back()
            self._changed()

    def adopt(self, joints: Mapping[str, float], parameters: Mapping[str, float]) -> None:
        """Take over the values of a page that was there before this server, where none are set."""
        for name, value in joints.items():
            if name not in self._joints:
                self.set_joint(name, value)
        self.set_parameters({**parameters, **self._parameters})

    def highlight(self, kind: str, name: str) -> None:
        """Light up a link, joint or frame; nothing for an empty name."""
        self.channel.replace("highlight", (HighlightMessage(kind, name),))

    def _changed(self) -> None:
        for call in self.on_change:
            call()

    def _given(self, analysis: Analysis) -> dict[str, float]:
        return {**analysis.context.values, **self._parameters}

    @property
    def _last_skeleton(self) -> Linkage | None:
        return self._last_good.skeleton if self._last_good is not None else None

    def _others(self) -> dict[str, OtherRobot]:
        """Return what can be compared, by name."""
        twins = twin_robots(self._shown[0]) if self._shown is not None else []
        saved = [self._saved] if self._saved is not None else []
        return {other.name: other for other in (*self._offered, *twins, *saved)}

    def _offer(self) -> None:
        """List what can be compared, and compare anew."""
        others = self._others()
        self._chosen = self._chosen if self._chosen in others else ""
        self.channel.replace("others", other_messages(others.values(), self._chosen))
        source = self._meshes_of()
        if source is None or not self._wants_meshes:
            self.channel.replace("meshes", () if source is None else offered(source))
        is_compared = self._chosen or self._compared is not None
        if is_compared or self._parameters or (source and self._wants_meshes):
            self.recompare()

    def _meshes_of(self) -> MeshSource | None:
        twins = self._shown[0].settings.twins if self._shown is not None else ()
        return self._mesh_source or twin_source(twins)

    def _put(self, analysis: Analysis, drawing: ShownVersion) -> None:
        if drawing.picture.state is not PictureState.BROKEN:
            self._last_good = drawing.picture
        self._shown = analysis, drawing
        self._draw_ghost()
        if drawing.robot is not None and drawing.solids is not None:
            self.channel.replace("robot", drawing.robot)
            self.channel.replace("solids", drawing.solids)
        self.channel.replace("parameters", drawing.parameters)
        self.channel.replace("poses", drawing.poses)
        self._offer()

    def _list(self, findings: Sequence[Diagnostic], text: str) -> None:
        self._show_status(findings)
        self.channel.replace("findings", finding_messages(findings, text))

    def _known_doubts(self, findings: Sequence[Diagnostic]) -> Doubts:
        """Return the doubts of findings; beside values from the page those that are shown."""
        if self._parameters and self._shown is not None:
            return self._shown[1].doubts
        return {} if self.analysis is None else body_doubts(self.analysis, findings)

    def _doubt(self, doubts: Doubts) -> None:
        """Draw the bodies by what is doubtful about them."""
        if self._shown is None or self._shown[1].doubts == doubts:
            return
        analysis, drawing = self._shown
        self._shown = analysis, drawing._replace(doubts=doubts)
        if drawing.picture.skeleton is not None:
            bodies = drawing.picture.skeleton, doubts, drawing.picture.unknown
            self.channel.replace("solids", solid_messages(*bodies))

    def _show_status(self, findings: Sequence[Diagnostic], lost: str = "") -> None:
        drawn = self._shown[1].picture if self._shown is not None else None
        if drawn is not None or lost:
            status = status_message(drawn, findings, self._label, lost)
            self.channel.replace("status", (status,))

    def _draw_ghost(self) -> None:
        present, ghost, kind = self._last_skeleton, self._planned, GhostMessage("planned")
        if ghost is None and self._compared is not None:
            ghost, kind = self._compared, GhostMessage("other", self._chosen)
        else:
            ghost, kind = (ghost, kind) if ghost else (self._ghost, GhostMessage("saved"))
            if ghost and present and _placed(ghost) == _placed(present):
                ghost = None
        self.channel.replace("ghost", (kind, *ghost_messages(ghost)) if ghost else ())


def _has_room(values: dict[str, float], name: str) -> bool:
    """Return whether a value may be kept: whatever a page sends, memory stays bounded."""
    return name in values or len(values) < MOST_VALUES


def _placed(skeleton: Linkage) -> tuple[object, ...]:
    """Return the places of a mechanism's bodies, equal if two mechanisms cover each other."""
    frames = [(frame.name, frame.pose.translation) for frame in skeleton.frames]
    return (
        *(skeleton.link_names, skeleton.joint_names, skeleton.joint_kinds, skeleton.parents),
        *(skeleton.placements, frames),
    )
